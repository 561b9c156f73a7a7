//! `choice`: one or several of the listed answers.
//!
//! The student types the letter that is printed, `b`, the word, `overdamped`, or its beginning where no
//! other option begins so; several are joined by commas, `a, c`. A letter is always the printed one, also
//! where an option has it as its `id`. Options are shuffled by the seed unless `shuffle = false`.
//! With `several`, each option that is rightly chosen or rightly left out counts, less one for each
//! that is wrong; with `ranking`, the options in the right order are asked.
//!
//! ```toml
//! [[part]]
//! kind    = "choice"
//! id      = "regime"
//! ask     = "The motion is"
//! options = [
//!   { id = "underdamped", text = "underdamped", right = "zeta < 1" },
//!   { id = "overdamped", text = "overdamped", right = "zeta > 1", feedback = "Compare $c^2$ with $4mk$." },
//! ]
//! ```

mod formula;
mod marker;

use std::sync::{Arc, OnceLock};

use self::marker::{Chosen, Options};
use super::{Answer, AnswerError, Asked, Blank, Choosable, Choosing, Context, Declare, Marker};
use crate::document::Document;
use crate::quantity::{Absent, NodeId};
use crate::response::{Phrase, Senses, Wording};
use crate::source::{Data, Table, Text, Value};

#[derive(Debug)]
struct ChoiceAnswer {
    options: Vec<Choosable>,
    /// As they stand in the file.
    sources: Vec<String>,
    rights: Vec<Right>,
    feedback: Vec<Option<Document>>,
    /// The words of the question.
    asked: Wording,
    /// As they are compared with responses, once one was marked.
    compared: OnceLock<Arc<Options>>,
    is_several: bool,
    is_ranking: bool,
    shuffles: bool,
}

/// Whether an option is right.
#[derive(Debug)]
enum Right {
    Always(bool),
    If(NodeId),
}

/// Reads the keys of a part that belong to this kind; what is wrong is noted.
pub(crate) fn read(part: &Table<'_>, declare: &mut dyn Declare) -> Option<Box<dyn Answer>> {
    part.required("options");
    let is_several = part.boolean("several").unwrap_or(false);
    let is_ranking = part.boolean("ranking").unwrap_or(false);
    let shuffles = part.boolean("shuffle").unwrap_or(true);
    let (mut options, mut sources) = (Vec::<Choosable>::new(), Vec::new());
    let (mut rights, mut feedback) = (Vec::new(), Vec::new());
    for table in part.tables("options") {
        let id = table.required_text("id");
        let source = table.required_text("text");
        let text = source.as_ref().map(|text| declare.text(text));
        sources.extend(source.map(|source| source.value));
        rights.push(right(&table, declare)?);
        feedback.push(table.text("feedback").map(|text| declare.text(&text)));
        table.finish();
        let (id, text) = (id?, text?);
        if options.iter().any(|option| option.id == id.value) {
            declare.find(&AnswerError::OptionTwice(id.value.clone()), &id);
            return None;
        }
        options.push(Choosable { id: id.value, text });
    }
    let place = Text {
        value: String::new(),
        span: part.span(),
    };
    if !(2..=26).contains(&options.len()) {
        declare.find(
            &AnswerError::Options("a choice has from 2 to 26 options"),
            &place,
        );
        return None;
    }
    let has_right = rights
        .iter()
        .any(|right| !matches!(right, Right::Always(false)));
    if !has_right && !is_ranking && !is_several {
        declare.find(&AnswerError::Options("no option is right"), &place);
        return None;
    }
    Some(Box::new(ChoiceAnswer {
        options,
        sources,
        rights,
        feedback,
        asked: part
            .text("ask")
            .map(|ask| Wording::of(&ask.value))
            .unwrap_or_default(),
        compared: OnceLock::new(),
        is_several,
        is_ranking,
        shuffles,
    }))
}

fn right(table: &Table<'_>, declare: &mut dyn Declare) -> Option<Right> {
    match table.value("right") {
        None => Some(Right::Always(false)),
        Some(Value {
            data: Data::Boolean(right),
            ..
        }) => Some(Right::Always(*right)),
        Some(value) => {
            let text = table.as_formula("right", value)?;
            declare.condition("option", &text).map(Right::If)
        }
    }
}

impl ChoiceAnswer {
    /// The options as responses are compared with them: the same for all data.
    fn compared(&self) -> Options {
        let options = self.options.iter();
        let ids = options.clone().map(|option| option.id.clone()).collect();
        let texts: Vec<String> = options
            .map(|option| option.text.plain(&no_fills()))
            .collect();
        let words: Vec<Phrase> = texts.iter().map(|text| Phrase::of_printed(text)).collect();
        let sources = self.sources.iter().map(|text| Phrase::unfolded(text));
        let named = words.iter().zip(&self.options);
        let named = named.map(|(own, option)| (own, option.id.as_str()));
        Options {
            ids,
            senses: Senses::of(named, self.asked.clone()),
            words,
            sources: sources.collect(),
            texts,
            feedback: self.feedback.clone(),
        }
    }

    fn manner(&self) -> Choosing {
        match (self.is_ranking, self.is_several) {
            (true, _) => Choosing::Ranking,
            (false, true) => Choosing::Several,
            (false, false) => Choosing::One,
        }
    }
}

impl Answer for ChoiceAnswer {
    fn kind(&self) -> crate::answer::AnswerKind {
        crate::answer::AnswerKind::Choice
    }

    fn blank(&self) -> Blank {
        Blank::of(Asked::Choice(self.manner()))
    }

    fn keys(&self) -> Vec<NodeId> {
        let conditions = self.rights.iter().filter_map(|right| match right {
            Right::If(node) => Some(*node),
            Right::Always(_) => None,
        });
        conditions.collect()
    }

    fn options(&self) -> &[Choosable] {
        &self.options
    }

    fn always_right(&self) -> Option<usize> {
        let mut right = (0..self.rights.len())
            .filter(|place| matches!(self.rights[*place], Right::Always(true)));
        right.next().filter(|_| right.next().is_none())
    }

    fn choosing(&self) -> Option<Choosing> {
        Some(self.manner())
    }

    fn shuffles(&self) -> bool {
        self.shuffles
    }

    fn read_mistake(
        &mut self,
        _number: usize,
        answer: &Value,
        part: &Table<'_>,
        declare: &mut dyn Declare,
    ) -> Option<Vec<NodeId>> {
        // A wrong option bears its feedback itself; nothing is computed for it.
        let text = part.as_text("answer", answer)?;
        declare.find(&AnswerError::NoOption(text.value.clone()), &text);
        None
    }

    fn prepare<'t>(&self, context: &Context<'t>) -> Result<Box<dyn Marker + 't>, Absent> {
        let right = self
            .rights
            .iter()
            .map(|right| match right {
                Right::Always(right) => Ok(*right),
                Right::If(node) => context.evaluation.holds(*node),
            })
            .collect::<Result<Vec<_>, _>>()?;
        let order = if context.order.len() == self.options.len() {
            context.order.clone()
        } else {
            (0..self.options.len()).collect()
        };
        Ok(Box::new(Chosen {
            options: Arc::clone(self.compared.get_or_init(|| Arc::new(self.compared()))),
            right,
            order,
            is_several: self.is_several,
            is_ranking: self.is_ranking,
        }))
    }
}

fn no_fills() -> Vec<crate::document::Filling> {
    Vec::new()
}
