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
use super::pictures::Pictures;
use crate::answer::{Band, Choosing, Kind};
use crate::document::{Document, Filling};
use crate::math::{Display, escape};
use crate::numerics::Rational;
use crate::scene::{Data, Scene};
use crate::worksheet::{Heading, Sheet, SheetQuestion, headings};

/// Where Moodle has the files of a question.
const FILES: &str = "@@PLUGINFILE@@/";

/// A file of questions while it is written.
pub struct Moodle {
    out: String,
    /// The uppermost category.
    title: String,
    data: Data,
    has_essays: bool,
    questions: usize,
    blanks: usize,
    unfit: Vec<Unfit>,
}

/// A part that the platform cannot mark.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unfit {
    /// Its item.
    pub item: String,
    /// The part.
    pub part: String,
    /// Why.
    pub reason: &'static str,
}

/// A part by its place in the item, and what it is called.
type Called<'t> = (Heading<'t>, usize);

/// How a part is asked.
enum Blank {
    /// Blanks for numbers.
    Numbers(Vec<Vec<Alternative>>),
    /// One of several options.
    Choice(Vec<Alternative>),
}

impl Moodle {
    /// A file in whose uppermost category this title stands; with `has_essays`, parts that do not fit become essays.
    pub fn new(title: &str, data: Data, has_essays: bool) -> Self {
        let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<quiz>\n");
        let path = step(title);
        category(&mut out, &path);
        Self {
            out,
            title: path,
            data,
            has_essays,
            questions: 0,
            blanks: 0,
            unfit: Vec::new(),
        }
    }

    /// Adds a category for the variants of a question; questions that follow belong to it.
    pub fn category(&mut self, name: &str) {
        let path = format!("{}/{}", self.title, step(name));
        category(&mut self.out, &path);
    }

    /// Adds a question of a sheet.
    pub fn add(&mut self, sheet: &Sheet<'_>, question: &SheetQuestion<'_>) {
        let solution = &question.solution;
        let template = solution.template();
        let scope = format!("m-{}-{}", sheet.variant, question.number);
        let scene = Scene::of(solution, self.data).within(scope);
        let mut pictures = Pictures::default();
        let mut body = statement(&scene, &mut pictures);
        let mut essays = Vec::new();
        let mut has_blanks = false;
        let weights = weights(question, &scene);
        let headings = headings(template, &question.parts);
        let mut opened = None;
        for ((heading, place), weight) in headings.iter().zip(&question.parts).zip(&weights) {
            let part = &template.parts[*place];
            match blank(&scene, *place, &mut pictures) {
                Ok(blank) => {
                    has_blanks = true;
                    self.blanks += 1;
                    ask(
                        &mut body,
                        &scene,
                        (heading, *place),
                        &mut opened,
                        &mut pictures,
                    );
                    write_blank(&mut body, &scene, *place, *weight, &blank);
                }
                Err(reason) => {
                    let unfit = Unfit {
                        item: template.id.as_str().to_owned(),
                        part: part.id.clone(),
                        reason,
                    };
                    if !self.unfit.contains(&unfit) {
                        self.unfit.push(unfit);
                    }
                    essays.push((heading.clone(), *place));
                }
            }
        }
        let origin = format!("{} {}", template.id.as_str(), sheet.variant);
        if has_blanks {
            let _ = write!(body, "<p><small>{origin}</small></p>");
            let parts: Vec<Called<'_>> = headings
                .into_iter()
                .zip(question.parts.iter().copied())
                .collect();
            let worked = worked(&scene, &parts, &mut pictures);
            let hints = hints(&scene, &parts, &mut pictures);
            let name = format!("{} [{origin}]", template.about.title);
            self.question("cloze", &name, &origin, &body, &pictures, |out| {
                text(out, "generalfeedback", &worked);
                out.push_str("    <penalty>0.3333333</penalty>\n    <hidden>0</hidden>\n");
                for hint in hints {
                    text(out, "hint", &hint);
                }
            });
        }
        if self.has_essays && !essays.is_empty() {
            self.essay(&scene, question, &essays, &origin);
        }
    }

    /// The parts that ranges and options cannot mark, as one essay with the keys for whoever marks it.
    fn essay(
        &mut self,
        scene: &Scene<'_, '_>,
        question: &SheetQuestion<'_>,
        parts: &[Called<'_>],
        origin: &str,
    ) {
        let template = question.solution.template();
        let mut pictures = Pictures::default();
        let mut body = statement(scene, &mut pictures);
        let mut points = Rational::ZERO;
        let mut opened = None;
        for (heading, place) in parts {
            ask(
                &mut body,
                scene,
                (heading, *place),
                &mut opened,
                &mut pictures,
            );
            let asked = question.parts.iter().zip(&question.points);
            let own = asked
                .filter(|(own, _)| *own == place)
                .map(|(_, points)| *points);
            points = own.fold(points, |sum, own| sum.checked_add(own).unwrap_or(sum));
        }
        let _ = write!(body, "<p><small>{origin}</small></p>");
        let mut of_solution = Pictures::default();
        let worked = worked(scene, parts, &mut of_solution);
        let name = format!("{} (essay) [{origin}]", template.about.title);
        let number = format!("{origin} essay");
        self.question("essay", &name, &number, &body, &pictures, |out| {
            let _ = writeln!(out, "    <defaultgrade>{}</defaultgrade>", points.to_f64());
            out.push_str("    <penalty>0</penalty>\n    <hidden>0</hidden>\n");
            out.push_str("    <responseformat>editor</responseformat>\n    <responserequired>1</responserequired>\n");
            out.push_str("    <responsefieldlines>15</responsefieldlines>\n    <attachments>0</attachments>\n");
            html(out, "graderinfo", &worked, &of_solution);
            text(out, "responsetemplate", "");
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
        self.questions += 1;
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

    /// How many questions were written.
    pub fn questions(&self) -> usize {
        self.questions
    }

    /// How many parts became blanks.
    pub fn blanks(&self) -> usize {
        self.blanks
    }

    /// The parts that the platform cannot mark, each once.
    pub fn unfit(&self) -> &[Unfit] {
        &self.unfit
    }

    /// The file.
    pub fn finish(mut self) -> String {
        self.out.push_str("</quiz>\n");
        self.out
    }
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

/// An element that holds HTML.
fn text(out: &mut String, element: &str, content: &str) {
    html(out, element, content, &Pictures::default());
}

/// An element that holds HTML with the files of its figures.
fn html(out: &mut String, element: &str, content: &str, pictures: &Pictures) {
    let _ = write!(out, "    <{element} format=\"html\"><text><![CDATA[");
    // The one sequence that ends the section is cut in two.
    out.push_str(&content.replace("]]>", "]]]]><![CDATA[>"));
    out.push_str("]]></text>");
    for (name, svg) in &pictures.files {
        let _ = write!(
            out,
            "\n      <file name=\"{name}\" path=\"/\" encoding=\"base64\">{}</file>",
            STANDARD.encode(svg)
        );
    }
    let _ = writeln!(out, "</{element}>");
}

/// The statement with its figure.
fn statement(scene: &Scene<'_, '_>, pictures: &mut Pictures) -> String {
    let template = scene.solution().template();
    let mut out = pictures.html(FILES, &scene.passage(&template.statement));
    if !template.statement.places_figure()
        && let Some(picture) = scene.picture()
    {
        let image = pictures.image(FILES, &picture.svg);
        let caption = line(&template.caption);
        let _ = write!(out, "<p>{image}</p>");
        if !caption.is_empty() {
            let _ = write!(out, "<p><small>{caption}</small></p>");
        }
    }
    out
}

/// A text of one paragraph, without the marks of a paragraph.
fn line(document: &Document) -> String {
    let mut out = String::new();
    if !document.is_empty() {
        document.write_html_line(&mut out, &Vec::<Filling>::new());
    }
    out
}

/// The letter of a part and its question; before the first one of a group, what its blanks have in common.
fn ask<'t>(
    out: &mut String,
    scene: &Scene<'_, '_>,
    (heading, place): (&Heading<'t>, usize),
    opened: &mut Option<&'t str>,
    pictures: &mut Pictures,
) {
    let part = &scene.solution().template().parts[place];
    let own = heading.group.map(|group| group.id.as_str());
    if let Some(group) = heading.group.filter(|_| *opened != own) {
        let asked = pictures.html(FILES, &scene.passage(&group.text));
        let letter = heading.group_letter();
        let _ = write!(out, "<p><strong>{letter})</strong></p>{asked}");
    }
    *opened = own;
    let asked = pictures.html(FILES, &scene.passage(&part.ask));
    let _ = write!(out, "<p><strong>{})</strong></p>{asked}", heading.letter);
}

/// How a part is asked, or why it cannot be.
fn blank(
    scene: &Scene<'_, '_>,
    place: usize,
    pictures: &mut Pictures,
) -> Result<Blank, &'static str> {
    let solution = scene.solution();
    let part = &solution.template().parts[place];
    match part.answer.kind() {
        Kind::Choice => match part.answer.choosing() {
            Some(Choosing::Ranking) => Err("an order of options"),
            Some(Choosing::Several) => Err("several options, whose marks differ from Moodle's"),
            _ => Ok(Blank::Choice(options(scene, place))),
        },
        Kind::Numeric | Kind::Integer => {
            let marker = solution
                .marker(place)
                .map_err(|_| "a key that does not exist for some data")?;
            let bands = marker.bands();
            if bands.is_empty() {
                return Err("complex numbers, or numbers in any order");
            }
            let mut alternative = |band: &Band| {
                let mistake = band.mistake.and_then(|number| part.mistakes.get(number));
                let feedback = mistake
                    .map(|mistake| pictures.html(FILES, &scene.passage(&mistake.feedback)))
                    .unwrap_or_default();
                Alternative::range(band, feedback)
            };
            let values = bands
                .iter()
                .map(|bands| bands.iter().map(&mut alternative).collect());
            Ok(Blank::Numbers(values.collect()))
        }
        Kind::Formula => Err("a formula"),
        Kind::Equation => Err("an equation"),
        Kind::Function => Err("a function"),
        Kind::Matrix => Err("a matrix"),
        Kind::ModeShape => Err("mode shapes"),
        Kind::Interval => Err("an interval"),
    }
}

/// The options of a choice in the order of the sheet.
fn options(scene: &Scene<'_, '_>, place: usize) -> Vec<Alternative> {
    let solution = scene.solution();
    let options = solution.template().parts[place].answer.options();
    let right = match solution.key(place).map(|key| &key.value) {
        Ok(crate::answer::KeyValue::Options { ids, .. }) => ids.clone(),
        _ => Vec::new(),
    };
    let order = solution.order(place).into_iter();
    order
        .map(|at| {
            let option = &options[at];
            Alternative::option(&line(&option.text), right.contains(&option.id))
        })
        .collect()
}

fn write_blank(out: &mut String, scene: &Scene<'_, '_>, place: usize, weight: u64, blank: &Blank) {
    out.push_str("<p>");
    match blank {
        Blank::Numbers(values) => {
            if let Some(lead) = scene.lead(place) {
                let _ = write!(out, "{} ", lead.mathml(Display::Inline));
            }
            let written: Vec<String> = values
                .iter()
                .map(|alternatives| cloze::numerical(weight, alternatives))
                .collect();
            out.push_str(&written.join(", "));
            let part = &scene.solution().template().parts[place];
            if let Some(unit) = part.answer.unit() {
                let _ = write!(out, " {}", unit.math().mathml(Display::Inline));
            }
        }
        Blank::Choice(alternatives) => out.push_str(&cloze::choice(weight, alternatives)),
    }
    out.push_str("</p>");
}

/// The weights of the blanks of each part, which are integers in the ratio of the points.
fn weights(question: &SheetQuestion<'_>, scene: &Scene<'_, '_>) -> Vec<u64> {
    let blanks = |place: &usize| {
        let marker = scene.solution().marker(*place);
        marker.map_or(1, |marker| marker.bands().len().max(1)) as u64
    };
    let shares: Vec<(u64, u64)> = question
        .points
        .iter()
        .zip(&question.parts)
        .map(|(points, place)| {
            let whole = |part: i128| u64::try_from(part).unwrap_or(1);
            let bottom = whole(points.denominator()) * blanks(place);
            (whole(points.numerator()), bottom)
        })
        .collect();
    let common = shares.iter().fold(1, |common, (_, bottom)| {
        common / gcd(common, *bottom) * bottom
    });
    let whole: Vec<u64> = shares
        .iter()
        .map(|(top, bottom)| top * (common / bottom))
        .collect();
    let divisor = whole.iter().copied().fold(0, gcd).max(1);
    whole.iter().map(|own| own / divisor).collect()
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The worked solution, with the key of each part.
fn worked(scene: &Scene<'_, '_>, parts: &[Called<'_>], pictures: &mut Pictures) -> String {
    let template = scene.solution().template();
    let mut out = pictures.html(FILES, &scene.passage(&template.solution));
    let mut opened = None;
    for (heading, place) in parts {
        let own = heading.group.map(|group| group.id.as_str());
        if let Some(group) = heading.group.filter(|_| opened != own) {
            out.push_str(&pictures.html(FILES, &scene.passage(&group.solution)));
        }
        opened = own;
        let _ = write!(out, "<p><strong>{})</strong> ", heading.letter);
        if let Ok(Some(key)) = scene.key(*place) {
            out.push_str(&key.mathml(Display::Inline));
        }
        out.push_str("</p>");
        out.push_str(&pictures.html(FILES, &scene.passage(&template.parts[*place].solution)));
    }
    out
}

/// The first hints of all parts, then the second ones, and so on; those of a group once.
fn hints(scene: &Scene<'_, '_>, parts: &[Called<'_>], pictures: &mut Pictures) -> Vec<String> {
    let template = scene.solution().template();
    let most = parts
        .iter()
        .map(|(_, place)| template.parts[*place].hints.len())
        .max();
    (0..most.unwrap_or(0))
        .map(|number| {
            let mut out = String::new();
            let mut opened = None;
            for (heading, place) in parts {
                let shared = heading.group.filter(|group| number < group.hints.len());
                let group = heading.group.map(|group| group.id.as_str());
                let is_repeated = shared.is_some() && opened == group;
                opened = group;
                let letter = match shared {
                    Some(_) => heading.group_letter(),
                    None => &heading.letter,
                };
                let hint = template.parts[*place].hints.get(number);
                if let Some(hint) = hint.filter(|_| !is_repeated) {
                    let words = pictures.html(FILES, &scene.passage(hint));
                    let _ = write!(out, "<p><strong>{letter})</strong></p>{words}");
                }
            }
            out
        })
        .collect()
}
