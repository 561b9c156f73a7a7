//! `moodle`: Moodle XML, with one cloze question for each question of each variant.
//!
//! Format: <https://docs.moodle.org/en/Moodle_XML_format>. An item with its data is one question, since separate questions
//! that are drawn at random would mix data. What ranges and lists of options cannot mark is left out of it and named, or
//! becomes an essay question with the key for whoever marks it. Variants of one question share a category, from which
//! Moodle draws.

use std::fmt::Write;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use super::cloze::{self, Alternative};
use super::held::{Held, HeldPart, Sorted};
use super::pictures::Pictures;
use super::units::accepted;
use super::words::QuestionWords;
use super::{Export, ExportTally, Wish};
use crate::answer::Band;
use crate::math::escape;
use crate::message::Phrase;
use crate::numerics::Rational;
use crate::unit::Unit;
use crate::worksheet::{Sheet, SheetQuestion};

/// Where Moodle has the files of a question.
const FILES: &str = "@@PLUGINFILE@@/";

/// What Moodle takes off for each try where a quiz allows several.
const PENALTY: &str = "    <penalty>0.3333333</penalty>\n    <hidden>0</hidden>\n";

/// A file of questions for Moodle.
pub struct Moodle {
    out: String,
    wish: Wish,
    tally: ExportTally,
    /// The category of the question that is written.
    path: String,
    /// The category that was written last.
    current: String,
}

impl Export for Moodle {
    fn category(&mut self, path: &[&str]) {
        let steps = path.iter().map(|name| format!("/{}", step(name)));
        self.path = format!("{}{}", step(&self.wish.title), steps.collect::<String>());
    }

    fn add(&mut self, sheet: &Sheet<'_>, question: &SheetQuestion<'_>, number: usize) {
        let words = QuestionWords::of(sheet, question, number, &self.wish, FILES);
        let sorted = Sorted::of(&words.scene, question, &mut self.tally.unfit);
        match single(&words, &sorted).filter(|_| self.wish.has_units) {
            Some((asked, bands, unit)) => self.numerical(&words, asked, bands, &unit),
            None if !sorted.fit.is_empty() => self.cloze(&words, &sorted),
            None => {}
        }
        let essays = sorted.essays(self.wish.has_essays);
        if !essays.is_empty() {
            self.essay(&words, &essays);
        }
    }

    fn tally(&self) -> &ExportTally {
        &self.tally
    }

    fn finish(mut self: Box<Self>) -> std::io::Result<Vec<u8>> {
        self.out.push_str("</quiz>\n");
        Ok(self.out.into_bytes())
    }
}

impl Moodle {
    /// A file in whose uppermost category the title stands.
    pub fn new(wish: Wish) -> Self {
        let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<quiz>\n");
        let path = step(&wish.title);
        category(&mut out, &path);
        Self {
            out,
            wish,
            tally: ExportTally::default(),
            current: path.clone(),
            path,
        }
    }

    /// All parts that fit, as one question with a blank for each value.
    fn cloze<'c>(&mut self, words: &QuestionWords<'_, 'c>, sorted: &Sorted<'c>) {
        let mut pictures = Pictures::default();
        let mut body = words.statement(&mut pictures);
        for ((asked, held), weight) in sorted.fit.iter().zip(sorted.weights()) {
            self.tally.boxes += held.boxes();
            body.push_str(&words.ask(asked, &mut pictures));
            write_blank(&mut body, words, asked.place, held, weight, &mut pictures);
        }
        let origin = words.origin(&sorted.letters());
        let _ = write!(body, "<p><small>{origin}</small></p>");
        let asked: Vec<&HeldPart<'c>> = sorted.fit.iter().map(|(asked, _)| asked).collect();
        let (mut of_worked, mut of_hints) = (Pictures::default(), Pictures::default());
        let worked = words.worked(asked.iter().copied(), &mut of_worked);
        let hints = words.hints(&asked, &mut of_hints);
        let name = format!("{} [{origin}]", words.title());
        self.question("cloze", &name, &origin, &body, &pictures, |out| {
            html(out, "generalfeedback", &worked, &of_worked);
            out.push_str(PENALTY);
            for hint in hints {
                html(out, "hint", &hint, &of_hints);
            }
        });
    }

    /// The one number that is asked, as a question that reads units.
    fn numerical<'c>(
        &mut self,
        words: &QuestionWords<'_, 'c>,
        asked: &HeldPart<'c>,
        bands: &[Band],
        unit: &Unit,
    ) {
        self.tally.boxes += 1;
        let mut pictures = Pictures::default();
        let mut body = words.statement(&mut pictures);
        body.push_str(&words.ask(asked, &mut pictures));
        let with_unit = self.wish.spoken().phrase(&Phrase::NumberAndUnit);
        let _ = write!(body, "<p><small>{with_unit}</small></p>");
        let origin = words.origin(&asked.letter);
        let _ = write!(body, "<p><small>{origin}</small></p>");
        let (mut of_worked, mut of_hints) = (Pictures::default(), Pictures::default());
        let worked = words.worked(std::iter::once(asked), &mut of_worked);
        let hints = words.hints(&[asked], &mut of_hints);
        let answers: Vec<(&Band, String, Pictures)> = bands
            .iter()
            .map(|band| {
                let mut own = Pictures::default();
                let feedback = words.feedback(asked.place, band, &mut own);
                (band, feedback, own)
            })
            .collect();
        let name = format!("{} [{origin}]", words.title());
        self.question("numerical", &name, &origin, &body, &pictures, |out| {
            html(out, "generalfeedback", &worked, &of_worked);
            let _ = writeln!(
                out,
                "    <defaultgrade>{}</defaultgrade>",
                asked.points.to_f64()
            );
            out.push_str(PENALTY);
            for (band, feedback, own) in answers {
                let share = cloze::percent(band.credit);
                let [value, half] = [band.value, band.half].map(cloze::number);
                let _ = writeln!(
                    out,
                    "    <answer fraction=\"{share}\" format=\"moodle_auto_format\"><text>{value}</text>"
                );
                html(out, "feedback", &feedback, &own);
                let _ = writeln!(out, "    <tolerance>{half}</tolerance></answer>");
            }
            write_units(out, unit);
            for hint in hints {
                html(out, "hint", &hint, &of_hints);
            }
        });
    }

    /// The parts that ranges and options cannot mark, as one essay with the keys for whoever marks it.
    fn essay<'c>(&mut self, words: &QuestionWords<'_, 'c>, parts: &[HeldPart<'c>]) {
        let mut pictures = Pictures::default();
        let mut body = words.statement(&mut pictures);
        let mut points = Rational::ZERO;
        for asked in parts {
            body.push_str(&words.ask(asked, &mut pictures));
            points = points.checked_add(asked.points).unwrap_or(points);
        }
        let letters: Vec<&str> = parts.iter().map(|asked| asked.letter.as_str()).collect();
        let origin = words.origin(&letters.join(" "));
        let _ = write!(body, "<p><small>{origin}</small></p>");
        let mut of_worked = Pictures::default();
        let worked = words.worked(parts.iter(), &mut of_worked);
        // After these letters `vibank grade` finds the answers again.
        let places = parts.iter().filter(|_| parts.len() > 1);
        let template: String = places
            .map(|asked| format!("<p>{}) </p>", asked.letter))
            .collect();
        let name = format!("{} (essay) [{origin}]", words.title());
        self.question("essay", &name, &origin, &body, &pictures, |out| {
            let _ = writeln!(out, "    <defaultgrade>{}</defaultgrade>", points.to_f64());
            out.push_str("    <penalty>0</penalty>\n    <hidden>0</hidden>\n");
            out.push_str("    <responseformat>editor</responseformat>\n    <responserequired>1</responserequired>\n");
            out.push_str("    <responsefieldlines>15</responsefieldlines>\n    <attachments>0</attachments>\n");
            html(out, "graderinfo", &worked, &of_worked);
            html(out, "responsetemplate", &template, &Pictures::default());
        });
    }

    fn question(
        &mut self,
        kind: &str,
        name: &str,
        number: &str,
        body: &str,
        pictures: &Pictures,
        more: impl FnOnce(&mut String),
    ) {
        self.tally.questions += 1;
        // Questions are drawn from a category at random: an essay in it would be drawn in place of one with boxes.
        let path = if kind == "essay" {
            let essays = self.wish.spoken().phrase(&Phrase::Essays);
            format!("{}/{}", self.path, step(&essays))
        } else {
            self.path.clone()
        };
        if path != self.current {
            category(&mut self.out, &path);
            self.current = path;
        }
        let out = &mut self.out;
        let _ = writeln!(out, "  <question type=\"{kind}\">");
        out.push_str("    <name><text>");
        escape(out, name);
        out.push_str("</text></name>\n");
        html(out, "questiontext", body, pictures);
        more(out);
        out.push_str("    <idnumber>");
        escape(out, number);
        out.push_str("</idnumber>\n  </question>\n");
    }
}

/// The one number of a question in which nothing else fits, with its unit.
fn single<'w, 'c>(
    words: &QuestionWords<'_, 'c>,
    sorted: &'w Sorted<'c>,
) -> Option<(&'w HeldPart<'c>, &'w [Band], Unit)> {
    let [(asked, Held::Numbers(values))] = &sorted.fit[..] else {
        return None;
    };
    let [bands] = &values[..] else {
        return None;
    };
    let part = &words.scene.solution().template().parts[asked.place];
    let unit = part.answer.unit().filter(|unit| !unit.is_one())?;
    (!bands.is_empty()).then_some((asked, bands, unit))
}

/// The units that a question reads. A unit that is not among them costs the points, and so does a missing one, since
/// Moodle makes no difference between the two.
fn write_units(out: &mut String, unit: &Unit) {
    out.push_str("    <unitgradingtype>1</unitgradingtype>\n    <unitpenalty>1</unitpenalty>\n");
    out.push_str("    <showunits>0</showunits>\n    <unitsleft>0</unitsleft>\n    <units>\n");
    for (text, factor) in accepted(unit) {
        let factor = cloze::number(factor);
        let _ = write!(
            out,
            "      <unit><multiplier>{factor}</multiplier><unit_name>"
        );
        escape(out, &text);
        out.push_str("</unit_name></unit>\n");
    }
    out.push_str("    </units>\n");
}

/// The name of a category: slashes separate categories unless they are doubled.
fn step(name: &str) -> String {
    name.replace('/', "//")
}

fn category(out: &mut String, path: &str) {
    out.push_str("  <question type=\"category\">\n    <category><text>$course$/top/");
    escape(out, path);
    out.push_str("</text></category>\n  </question>\n");
}

/// An element that holds HTML with the files of its figures.
fn html(out: &mut String, element: &str, content: &str, pictures: &Pictures) {
    let _ = write!(out, "    <{element} format=\"html\"><text><![CDATA[");
    // The one sequence that ends the section is cut in two.
    out.push_str(&spaced(content).replace("]]>", "]]]]><![CDATA[>"));
    out.push_str("]]></text>");
    let used = |name: &str| content.contains(&format!("{FILES}{name}\""));
    for (name, svg) in pictures.files.iter().filter(|(name, _)| used(name)) {
        let _ = write!(
            out,
            "\n      <file name=\"{name}\" path=\"/\" encoding=\"base64\">{}</file>",
            STANDARD.encode(svg)
        );
    }
    let _ = writeln!(out, "</{element}>");
}

/// HTML with a space after each sign that is less than. In the text of a question Moodle's reports take `<φ` for a tag,
/// and lose what comes after it: <https://www.php.net/strip_tags>.
pub(super) fn spaced(html: &str) -> String {
    html.replace("&lt;", "&lt; ").replace("&lt;  ", "&lt; ")
}

/// The boxes of a part, what they ask for before them and the unit after.
fn write_blank(
    out: &mut String,
    words: &QuestionWords<'_, '_>,
    place: usize,
    held: &Held,
    weight: u64,
    pictures: &mut Pictures,
) {
    out.push_str("<p>");
    match held {
        Held::Numbers(values) => {
            out.push_str(&words.lead(place));
            let written: Vec<String> = values
                .iter()
                .map(|bands| {
                    let alternatives: Vec<Alternative> = bands
                        .iter()
                        .map(|band| Alternative::range(band, words.feedback(place, band, pictures)))
                        .collect();
                    cloze::numerical(weight, &alternatives)
                })
                .collect();
            out.push_str(&written.join(", "));
            out.push_str(&words.unit(place));
        }
        Held::Choice(options) => {
            let alternatives: Vec<Alternative> = options
                .iter()
                .map(|own| Alternative::option(&words.option(place, own.place), own.is_right))
                .collect();
            out.push_str(&cloze::choice(weight, &alternatives));
        }
    }
    out.push_str("</p>");
}
