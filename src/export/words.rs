//! The texts of a question as HTML, alike for all platforms.

use std::fmt::Write;

use super::Wish;
use super::held::HeldPart;
use super::pictures::Pictures;
use crate::answer::{Band, Criterion};
use crate::bank::share_in_group;
use crate::document::{Document, Filling, Formulas};
use crate::math::{Display, Math};
use crate::message::{Language, Phrase};
use crate::numerics::Rational;
use crate::scene::{Scene, Shown};
use crate::worksheet::{Sheet, SheetQuestion};

/// The texts of one question.
pub(crate) struct QuestionWords<'s, 'c> {
    pub(crate) scene: Scene<'s, 'c>,
    /// The code of its variant.
    code: String,
    /// Its number in the export, which tells apart questions of one item.
    number: usize,
    /// How often the item stands on the sheet up to this question.
    time: usize,
    formulas: Formulas,
    language: Language,
    tag: String,
    /// Where the platform has the files of the question.
    folder: &'static str,
}

impl<'s, 'c> QuestionWords<'s, 'c> {
    pub(crate) fn of(
        sheet: &Sheet<'_>,
        question: &'s SheetQuestion<'c>,
        number: usize,
        wish: &Wish,
        folder: &'static str,
    ) -> Self {
        let scope = format!("m-{}-{}", sheet.variant, question.number);
        let item = &question.solution.template().id;
        let time = sheet
            .questions
            .iter()
            .filter(|own| own.number <= question.number)
            .filter(|own| own.solution.template().id == *item)
            .count();
        Self {
            number,
            time,
            scene: Scene::of(&question.solution, wish.data)
                .spoken(wish.spoken())
                .within(scope),
            code: sheet.variant.to_string(),
            formulas: wish.formulas,
            language: wish.spoken(),
            tag: wish.language.clone(),
            folder,
        }
    }

    /// Where a question comes from: item, code, number, and the letter of the part of each of its boxes.
    pub(crate) fn origin(&self, letters: &str) -> String {
        let item = self.scene.solution().template().id.as_str();
        format!("{item} {} {} {letters}", self.code, self.number)
    }

    /// A name of the question with its data that standards for identifiers allow.
    pub(crate) fn identifier(&self) -> String {
        let item = self.scene.solution().template().id.as_str();
        let name = format!("q.{}.{}", item.replace('/', "."), self.code);
        match self.time {
            0 | 1 => name,
            time => format!("{name}.{time}"),
        }
    }

    /// Title of the item, without markup.
    pub(crate) fn title(&self) -> &'s str {
        &self.scene.solution().template().about.title
    }

    fn html(&self, pictures: &mut Pictures, shown: &[Shown<'_>]) -> String {
        pictures.html(self.folder, self.formulas, self.language.voice(), shown)
    }

    /// A formula within a line.
    pub(crate) fn math(&self, math: &Math) -> String {
        let mut out = String::new();
        let voice = self.language.voice();
        self.formulas.write(&mut out, math, Display::Inline, voice);
        out
    }

    /// A text of one paragraph, without the marks of a paragraph.
    fn line(&self, document: &Document) -> String {
        let mut out = String::new();
        if !document.is_empty() {
            let voice = self.language.voice();
            let none = Vec::<Filling>::new();
            document.write_html_line_with(&mut out, &none, self.formulas, voice);
        }
        out
    }

    /// The statement with its figure.
    pub(crate) fn statement(&self, pictures: &mut Pictures) -> String {
        let template = self.scene.solution().template();
        let mut out = self.html(pictures, &self.scene.passage(&template.statement));
        if !template.statement.places_figure()
            && let Some(picture) = self.scene.picture()
        {
            let image = pictures.image(self.folder, &picture.svg);
            let caption = self.line(&template.caption);
            let _ = write!(out, "<p>{image}</p>");
            if !caption.is_empty() {
                let _ = write!(out, "<p><small>{caption}</small></p>");
            }
        }
        out
    }

    /// The letter of a part and its question; before the first one of a group, what its blanks have in common.
    pub(crate) fn ask(&self, asked: &HeldPart<'c>, pictures: &mut Pictures) -> String {
        let mut out = String::new();
        if let Some(group) = asked.opened() {
            let words = self.html(pictures, &self.scene.passage(&group.text));
            let letter = asked.group_letter();
            let _ = write!(out, "<p><strong>{letter})</strong></p>{words}");
        }
        let part = &self.scene.solution().template().parts[asked.place];
        let words = self.html(pictures, &self.scene.passage(&part.ask));
        let _ = write!(out, "<p><strong>{})</strong></p>{words}", asked.letter);
        out
    }

    /// The symbol that is asked for and an equals sign, where there is one.
    pub(crate) fn lead(&self, place: usize) -> String {
        let lead = self.scene.lead(place);
        lead.map_or_else(String::new, |lead| format!("{} ", self.math(&lead)))
    }

    /// The unit that is printed after a box, and that the box takes a number alone.
    pub(crate) fn unit(&self, place: usize) -> String {
        let part = &self.scene.solution().template().parts[place];
        let unit = part.answer.unit();
        unit.map_or_else(String::new, |unit| self.behind(&self.math(&unit.math())))
    }

    /// A unit as it comes after a box.
    pub(crate) fn behind(&self, unit: &str) -> String {
        let only = self.language.phrase(&Phrase::NumberOnly);
        format!(" {unit} <small>{only}</small>")
    }

    /// The language of the question, as a tag.
    pub(crate) fn language(&self) -> &str {
        match self.tag.as_str() {
            "" => self.language.code(),
            tag => tag,
        }
    }

    /// An option of a choice.
    pub(crate) fn option(&self, place: usize, option: usize) -> String {
        let part = &self.scene.solution().template().parts[place];
        self.line(&part.answer.options()[option].text)
    }

    /// What is said to a number that is a named mistake.
    pub(crate) fn feedback(&self, place: usize, band: &Band, pictures: &mut Pictures) -> String {
        let part = &self.scene.solution().template().parts[place];
        let mistake = band.mistake.and_then(|number| part.mistakes.get(number));
        mistake.map_or_else(String::new, |mistake| {
            self.html(pictures, &self.scene.passage(&mistake.feedback))
        })
    }

    /// The worked solution, with the key of each part.
    pub(crate) fn worked<'a>(
        &self,
        parts: impl Iterator<Item = &'a HeldPart<'c>>,
        pictures: &mut Pictures,
    ) -> String
    where
        'c: 'a,
    {
        let before = self.principle(pictures);
        before + &self.worked_parts(parts, pictures)
    }

    /// What comes before the solutions of the parts.
    pub(crate) fn principle(&self, pictures: &mut Pictures) -> String {
        let template = self.scene.solution().template();
        self.html(pictures, &self.scene.passage(&template.solution))
    }

    /// The solutions of parts, with their keys.
    pub(crate) fn worked_parts<'a>(
        &self,
        parts: impl Iterator<Item = &'a HeldPart<'c>>,
        pictures: &mut Pictures,
    ) -> String
    where
        'c: 'a,
    {
        let template = self.scene.solution().template();
        let mut out = String::new();
        for asked in parts {
            if let Some(group) = asked.opened() {
                out.push_str(&self.html(pictures, &self.scene.passage(&group.solution)));
            }
            let _ = write!(out, "<p><strong>{})</strong> ", asked.letter);
            if let Ok(Some(key)) = self.scene.key(asked.place) {
                out.push_str(&self.math(&key));
            }
            out.push_str("</p>");
            let part = &template.parts[asked.place];
            out.push_str(&self.rubric(part.answer.rubric(), asked.points));
            out.push_str(&self.html(pictures, &self.scene.passage(&part.solution)));
        }
        out
    }

    /// The first hints of all parts, then the second ones, and so on; those of a group once.
    pub(crate) fn hints(&self, parts: &[&HeldPart<'c>], pictures: &mut Pictures) -> Vec<String> {
        let template = self.scene.solution().template();
        let count = |asked: &&HeldPart<'_>| template.parts[asked.place].hints.len();
        let most = parts.iter().map(count).max().unwrap_or(0);
        (0..most)
            .map(|number| {
                let mut out = String::new();
                for asked in parts {
                    let shared = asked.group.filter(|group| number < group.hints.len());
                    let letter = match shared {
                        Some(_) if !asked.opens => continue,
                        Some(_) => asked.group_letter(),
                        None => &asked.letter,
                    };
                    if let Some(hint) = template.parts[asked.place].hints.get(number) {
                        let words = self.html(pictures, &self.scene.passage(hint));
                        let _ = write!(out, "<p><strong>{letter})</strong></p>{words}");
                    }
                }
                out
            })
            .collect()
    }

    /// What the points of a part are given for, for whoever marks it; empty where no person does.
    fn rubric(&self, rows: &[Criterion], points: Rational) -> String {
        if rows.is_empty() {
            return String::new();
        }
        let [head, given_for] =
            [Phrase::Points, Phrase::GivenFor].map(|phrase| self.language.phrase(&phrase));
        let weights: Vec<Rational> = rows.iter().map(|row| row.points).collect();
        let mut out = format!("<table><tr><th>{head}</th><th>{given_for}</th></tr>");
        for (row, points) in rows.iter().zip(share_in_group(points, &weights)) {
            let points = (points.to_f64() * 100.0).round() / 100.0;
            let mark = self.scene.solution().mark().char();
            let points = points.to_string().replace('.', &mark.to_string());
            let words = self.line(&row.text);
            let _ = write!(out, "<tr><td>{points}</td><td>{words}</td></tr>");
        }
        out.push_str("</table>");
        out
    }
}
