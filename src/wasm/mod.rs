//! The grader in the browser: questions, marks, hints and solutions as JSON.
//!
//! A [`Grader`] holds what a page offers and answers one request at a time. It draws, marks and
//! writes with the same code as the command line, and computes nothing before it is asked for: showing a
//! question computes no key. Items are built when they are first asked for, so that a page opens at once.
//!
//! | request | reply |
//! | --- | --- |
//! | `{"do":"choose","question":0,"from":7}` | `{"code"}`: the first variant from there that is fit to be asked |
//! | `{"do":"show","question":0,"code":"…"}` | `identity`, `statement`, `parts` |
//! | `{"do":"read", … "part":"X","response":"2 m"}` | `reading` and, where there is a doubt, `other`, whatever the key; or `problem` |
//! | `{"do":"mark", … "part":"X","response":"2 m","earlier":{}}` | `verdict`, `credit`, `reading`, `feedback`, `reasons` |
//! | `{"do":"hint", … "part":"X","number":0}` | `html` |
//! | `{"do":"solve", … "part":"X"}` | `key`, `html`, and `moves` where the system can be shown in motion |
//! | `{"do":"move","question":0,"code":"…","run":0}` | `runs`, and of one of them `svg`, `frames`, `seconds`, `symbols`, `shares`, `turns` |
//!
//! Texts are HTML with MathML, whatever they say: nothing in an item or a response becomes markup.
//! A request that cannot be answered gives `{"error": …}`.
//!
//! In the module (`grader.deflate`, built, taken apart and deflated by `build.sh`) the same is behind four functions on bytes; see `memory.rs`.

mod json;
#[cfg(target_arch = "wasm32")]
mod memory;
mod question;
mod request;

use std::cell::{OnceCell, RefCell};
use std::rc::Rc;

use crate::bank::{Compiled, Template};
use crate::instance::Instance;
use crate::math::Voice;
use crate::message::Language;
use crate::scene::Scene;
use crate::seed::{Seed, Variant};
use crate::solution::Solution;
use crate::source::FromJson;
use crate::suitability;
use crate::unit::DecimalMark;
use crate::worksheet::{Practice, PracticeError, PracticeQuestion};

use self::request::{Reply, Request};

/// Answers the requests of one page.
pub struct Grader {
    practice: Practice,
    items: Vec<PageItem>,
    /// What the last request was about, so that a key is prepared once for many answers.
    last: RefCell<Option<Last>>,
}

/// The instance of a question, with what was computed of it.
struct Last {
    question: usize,
    variant: Variant,
    solution: Rc<Solution<'static>>,
}

/// An item of a page, built when it is asked for.
struct PageItem {
    line: String,
    /// It lives as long as the page, which has one grader.
    template: OnceCell<Result<&'static Template, String>>,
}

/// Variants that are tried before one that is not fit is taken after all.
const MAX_TRIES: u64 = 400;

impl Grader {
    /// The grader of a page with these lines.
    ///
    /// # Errors
    ///
    /// [`PracticeError`] if the first line cannot be read; items are read when they are asked for.
    pub fn of(lines: &str) -> Result<Self, PracticeError> {
        let (practice, items) = Practice::read(lines)?;
        let item = |line: &str| PageItem {
            line: line.to_owned(),
            template: OnceCell::new(),
        };
        let items = items.into_iter().map(item).collect();
        Ok(Self {
            practice,
            items,
            last: RefCell::default(),
        })
    }

    /// Answers one request; both are JSON.
    ///
    /// ```
    /// # #[cfg(feature = "render")] {
    /// use vibank::bank::{Catalogue, Compiled, embedded};
    /// use vibank::document::Document;
    /// use vibank::wasm::Grader;
    /// use vibank::worksheet::{Practice, PracticeQuestion};
    ///
    /// let (catalogue, _) = Catalogue::load(embedded());
    /// let item = catalogue.find("ch3/e5-log-decrement").unwrap();
    /// let practice = Practice {
    ///     program: "doc".into(), title: "Practice".into(), instructions: Document::default(),
    ///     language: "en".into(), decimal: '.', doubt: Default::default(), other_form: None, data: Default::default(),
    ///     questions: vec![PracticeQuestion::of(item, 0, "Damping")],
    /// };
    /// let grader = Grader::of(&practice.lines(&[Compiled::of(item)])).unwrap();
    /// let reply = grader.answer(r#"{"do":"choose","question":0,"from":7}"#);
    /// assert!(reply.starts_with(r#"{"code":"#));
    /// # }
    /// ```
    pub fn answer(&self, request: &str) -> String {
        let reply = Request::from_text(request)
            .map_err(|misfit| misfit.to_string())
            .and_then(|request| request::reply(self, &request));
        json::written(&reply.unwrap_or_else(|error| Reply::Refused { error }))
    }

    /// What the page offers.
    pub fn practice(&self) -> &Practice {
        &self.practice
    }

    /// The language of what is said about answers.
    pub(crate) fn language(&self) -> Language {
        Language::of(&self.practice.language).unwrap_or_default()
    }

    /// The words with which formulas are heard.
    pub(crate) fn voice(&self) -> &'static Voice {
        self.language().voice()
    }

    /// A question and its item.
    fn question(&self, number: usize) -> Result<(&PracticeQuestion, &'static Template), String> {
        let question = self.practice.questions.get(number);
        let question = question.ok_or_else(|| format!("there is no question {number}"))?;
        let item = self.items.get(question.place);
        let item =
            item.ok_or_else(|| format!("the item `{}` is not on this page", question.item))?;
        let template = item.template()?;
        Ok((question, template))
    }

    /// The solution of a question for a variant, with what was computed of it for the last request.
    fn solution(&self, number: usize, variant: Variant) -> Result<Rc<Solution<'static>>, String> {
        let mut last = self.last.borrow_mut();
        if let Some(last) = &*last
            && (last.question, last.variant) == (number, variant)
        {
            return Ok(Rc::clone(&last.solution));
        }
        let (question, template) = self.question(number)?;
        let solution = Rc::new(self.draw(question, template, variant)?);
        *last = Some(Last {
            question: number,
            variant,
            solution: Rc::clone(&solution),
        });
        Ok(solution)
    }

    /// The solution of a question for a variant; nothing of it is computed yet.
    fn draw(
        &self,
        question: &PracticeQuestion,
        template: &'static Template,
        variant: Variant,
    ) -> Result<Solution<'static>, String> {
        let set: Vec<(&str, &str)> = question
            .set
            .iter()
            .map(|(name, value)| (name.as_str(), value.as_str()))
            .collect();
        let seed: Seed = variant.item(template.id.as_str(), None);
        let instance =
            Instance::of(template, Some(seed), &set).map_err(|error| error.to_string())?;
        let mark = DecimalMark::of_char(self.practice.decimal).unwrap_or_default();
        Ok(Solution::with_mark(instance, mark).settling(self.practice.doubt))
    }

    fn scene<'s, 't>(&self, solution: &'s Solution<'t>) -> Scene<'s, 't> {
        Scene::of(solution, self.practice.data).spoken(self.language())
    }

    /// The first variant from a number on that is fit to be asked.
    fn choose(&self, number: usize, from: u64) -> Result<Variant, String> {
        let (question, template) = self.question(number)?;
        let variant = |step: u64| {
            Variant::new(from.wrapping_add(step) % Variant::COUNT).expect("it is below the count")
        };
        let mut next_best = None;
        for step in 0..MAX_TRIES {
            let solution = self.draw(question, template, variant(step))?;
            let asked = question::asked(question, &solution);
            if !asked.is_empty() && suitability::judge(&solution, &asked).is_ok() {
                if suitability::judge_methods(&solution, &asked).is_ok() {
                    return Ok(variant(step));
                }
                next_best.get_or_insert(step);
            }
        }
        Ok(variant(next_best.unwrap_or(0)))
    }
}

impl PageItem {
    fn template(&self) -> Result<&'static Template, String> {
        self.template
            .get_or_init(|| -> Result<&'static Template, String> {
                let compiled =
                    Compiled::from_text(&self.line).map_err(|misfit| misfit.to_string())?;
                let template = compiled.template().map_err(|error| error.to_string())?;
                Ok(Box::leak(Box::new(template)))
            })
            .clone()
    }
}
