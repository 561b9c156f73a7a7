//! QTI 1.2 as Canvas reads it: each number and each choice is a question of its own.
//!
//! Canvas marks one number a question, gives no half credit for it, and rounds what it compares to four decimals, so that
//! small values are asked in a smaller unit.

use std::fmt::Write;

use super::Version;
use super::xml::Xml;
use crate::answer::{Band, Credit};
use crate::course::archive;
use crate::export::cloze::number;
use crate::export::held::{Choosable, Held, HeldPart, Sorted};
use crate::export::pictures::Pictures;
use crate::export::words::QuestionWords;
use crate::export::{Export, ExportTally, Unfit, Wish};
use crate::math::Math;
use crate::unit::Unit;
use crate::worksheet::{Sheet, SheetQuestion};

/// Where Canvas has the files of a package.
const FILES: &str = "$IMS-CC-FILEBASE$/";

/// Below these, values and half-widths lose digits to the rounding to four decimals.
const SMALLEST: [f64; 2] = [1e-3, 1e-4];

/// Prefixes of units by thousands, and how many of such units are one.
const PREFIXES: [(&str, f64); 6] = [
    ("", 1.0),
    ("m", 1e3),
    ("µ", 1e6),
    ("n", 1e9),
    ("p", 1e12),
    ("f", 1e15),
];

/// A package for Canvas while it is made.
pub struct Canvas {
    wish: Wish,
    tally: ExportTally,
    groups: Vec<QuestionGroup>,
    pictures: Vec<(String, String)>,
}

/// The variants of a question; of each part one is drawn.
struct QuestionGroup {
    title: String,
    /// The letter of the part and the variants.
    parts: Vec<(String, Vec<String>)>,
}

/// How small values are asked: how often they are divided by a thousand, and the unit for that.
struct UnitScale {
    thousandths: usize,
    /// Of what is printed after the box, as HTML.
    unit: String,
}

impl Canvas {
    /// An empty package.
    pub fn new(wish: Wish) -> Self {
        Self {
            wish,
            tally: ExportTally::default(),
            groups: Vec::new(),
            pictures: Vec::new(),
        }
    }

    fn push(&mut self, letter: String, item: String) {
        if self.groups.is_empty() {
            self.category(&[]);
        }
        self.tally.questions += 1;
        let last = self.groups.len() - 1;
        let parts = &mut self.groups[last].parts;
        match parts.iter_mut().find(|(own, _)| *own == letter) {
            Some((_, items)) => items.push(item),
            None => parts.push((letter, vec![item])),
        }
    }

    /// A question for one part.
    fn question<'c>(
        &mut self,
        words: &QuestionWords<'_, 'c>,
        common: &Common,
        asked: &HeldPart<'c>,
        marked: &CanvasMarking<'_>,
        pictures: &mut Pictures,
    ) {
        let asked = &asked.alone();
        let letter = asked.letter.clone();
        let identifier = format!("{}.{letter}", words.identifier());
        let mut body = common.statement.clone();
        body.push_str(&words.ask(asked, pictures));
        let mut named = letter.clone();
        let kind = match marked {
            CanvasMarking::Number(_, scale) => {
                let lead = words.lead(asked.place);
                let _ = write!(body, "<p>{lead}…{}</p>", words.behind(&scale.unit));
                if scale.thousandths > 0 {
                    let _ = write!(named, "*1e-{}", 3 * scale.thousandths);
                }
                "numerical_question"
            }
            CanvasMarking::Choice(_) => "multiple_choice_question",
            CanvasMarking::Essay => "essay_question",
        };
        let origin = words.origin(&named);
        let _ = write!(body, "<p><small>{origin}</small></p>");
        let own = words.worked_parts(std::iter::once(asked), pictures);
        let worked = format!("{}{own}", common.principle);
        let mut xml = Xml::new(Version::V21);
        xml.out.clear();
        let title = format!("{} [{origin}]", words.title());
        xml.open("item", &[("ident", &identifier), ("title", &title)]);
        metadata(&mut xml, kind, asked);
        xml.open("presentation", &[]);
        material(&mut xml, &body);
        present(&mut xml, words, asked, marked);
        xml.close();
        xml.open("resprocessing", &[]);
        xml.open("outcomes", &[]);
        let score = [
            ("maxvalue", "100"),
            ("minvalue", "0"),
            ("varname", "SCORE"),
            ("vartype", "Decimal"),
        ];
        xml.empty("decvar", &score);
        xml.close();
        process(&mut xml, marked);
        xml.close();
        xml.open("itemfeedback", &[("ident", "general_fb")]);
        xml.open("flow_mat", &[]);
        material(&mut xml, &worked);
        xml.close();
        xml.close();
        xml.close();
        self.push(letter, xml.out);
    }

    fn assessment(&self) -> String {
        let mut xml = Xml::new(Version::V21);
        let namespace = "http://www.imsglobal.org/xsd/ims_qtiasiv1p2";
        xml.open("questestinterop", &[("xmlns", namespace)]);
        let attributes = [("ident", "assessment"), ("title", self.wish.title.as_str())];
        xml.open("assessment", &attributes);
        xml.open("section", &[("ident", "root_section")]);
        for (number, group) in self.groups.iter().enumerate() {
            for (letter, items) in &group.parts {
                let identifier = format!("group.{}.{letter}", number + 1);
                let title = format!("{} {letter})", group.title);
                xml.open("section", &[("ident", &identifier), ("title", &title)]);
                xml.open("selection_ordering", &[]);
                xml.open("selection", &[]);
                xml.words("selection_number", &[], "1");
                xml.close();
                xml.close();
                items.iter().for_each(|item| xml.out.push_str(item));
                xml.close();
            }
        }
        xml.close();
        xml.close();
        xml.close();
        xml.out
    }

    fn manifest(&self) -> String {
        let mut xml = Xml::new(Version::V21);
        let namespace = "http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1";
        let attributes = [("xmlns", namespace), ("identifier", "vibank")];
        xml.open("manifest", &attributes);
        xml.open("metadata", &[]);
        xml.words("schema", &[], "IMS Content");
        xml.words("schemaversion", &[], "1.1.3");
        xml.close();
        xml.empty("organizations", &[]);
        xml.open("resources", &[]);
        xml.open(
            "resource",
            &[("identifier", "assessment"), ("type", "imsqti_xmlv1p2")],
        );
        xml.empty("file", &[("href", "assessment/assessment.xml")]);
        xml.close();
        for (name, _) in &self.pictures {
            let href = format!("web_resources/{name}");
            let attributes = [
                ("identifier", name.as_str()),
                ("type", "webcontent"),
                ("href", href.as_str()),
            ];
            xml.open("resource", &attributes);
            xml.empty("file", &[("href", &href)]);
            xml.close();
        }
        xml.close();
        xml.close();
        xml.out
    }
}

/// What the questions for all parts of an item show alike.
struct Common {
    statement: String,
    /// What comes before the solutions of the parts.
    principle: String,
}

impl Common {
    fn of(words: &QuestionWords<'_, '_>, pictures: &mut Pictures) -> Self {
        Self {
            statement: words.statement(pictures),
            principle: words.principle(pictures),
        }
    }
}

/// How a question is marked.
enum CanvasMarking<'h> {
    Number(&'h [Band], UnitScale),
    Choice(&'h [Choosable]),
    Essay,
}

impl Export for Canvas {
    fn category(&mut self, path: &[&str]) {
        self.groups.push(QuestionGroup {
            title: path.join(": "),
            parts: Vec::new(),
        });
    }

    fn add(&mut self, sheet: &Sheet<'_>, question: &SheetQuestion<'_>, number: usize) {
        let wish = self.wish.clone();
        let words = QuestionWords::of(sheet, question, number, &wish, FILES);
        let mut sorted = Sorted::of(&words.scene, question, &mut self.tally.unfit);
        let mut pictures = Pictures::named(format!("{}-", words.identifier()));
        let mut common = None;
        for (asked, held) in &sorted.fit {
            let marked = match held {
                Held::Choice(options) => CanvasMarking::Choice(options),
                Held::Numbers(values) => match &values[..] {
                    [bands] => {
                        CanvasMarking::Number(bands, UnitScale::of(&words, asked.place, bands))
                    }
                    _ => {
                        let template = words.scene.solution().template();
                        let found = Unfit {
                            item: template.id.as_str().to_owned(),
                            part: template.parts[asked.place].id.clone(),
                            reason: "several numbers, where Canvas takes one",
                        };
                        if !self.tally.unfit.contains(&found) {
                            self.tally.unfit.push(found);
                        }
                        sorted.unfit.push(asked.clone());
                        continue;
                    }
                },
            };
            self.tally.boxes += 1;
            let common = common.get_or_insert_with(|| Common::of(&words, &mut pictures));
            self.question(&words, common, asked, &marked, &mut pictures);
        }
        for asked in &sorted.essays(self.wish.has_essays) {
            let common = common.get_or_insert_with(|| Common::of(&words, &mut pictures));
            self.question(&words, common, asked, &CanvasMarking::Essay, &mut pictures);
        }
        self.pictures.extend(pictures.files);
    }

    fn tally(&self) -> &ExportTally {
        &self.tally
    }

    fn finish(self: Box<Self>) -> std::io::Result<Vec<u8>> {
        let [manifest, assessment] = [self.manifest(), self.assessment()];
        let mut files = vec![
            ("imsmanifest.xml".to_owned(), manifest.as_bytes()),
            (
                "assessment/assessment.xml".to_owned(),
                assessment.as_bytes(),
            ),
        ];
        for (name, svg) in &self.pictures {
            files.push((format!("web_resources/{name}"), svg.as_bytes()));
        }
        archive(files.iter().map(|(name, bytes)| (name.as_str(), *bytes)))
    }
}

impl UnitScale {
    /// The scale at which all digits of what is right survive the rounding.
    fn of(words: &QuestionWords<'_, '_>, place: usize, bands: &[Band]) -> Self {
        let part = &words.scene.solution().template().parts[place];
        let own = part.answer.unit();
        let thousandths = (0..PREFIXES.len())
            .find(|own| {
                let (_, power) = PREFIXES[*own];
                let large = |size: f64, least: f64| size == 0.0 || size * power >= least;
                let right = bands.iter().filter(|band| band.credit == Credit::FULL);
                right.clone().all(|band| {
                    large(band.value.abs(), SMALLEST[0]) && large(band.half, SMALLEST[1])
                })
            })
            .unwrap_or(0);
        if thousandths == 0 {
            let unit = words.unit(place);
            return Self { thousandths, unit };
        }
        let prefixed = own.as_ref().and_then(|own| smaller(own, thousandths));
        let math = prefixed.map_or_else(
            || {
                let power = Math::number(format!("-{}", 3 * thousandths));
                let factor = Math::number("10").with_sup(power);
                match own.filter(|own| !own.is_one()) {
                    Some(own) => Math::row([factor, Math::Space(3), own.math()]),
                    None => factor,
                }
            },
            |unit| unit.math(),
        );
        let unit = format!(" {}", words.math(&math));
        Self { thousandths, unit }
    }

    fn factor(&self) -> f64 {
        PREFIXES[self.thousandths].1
    }
}

/// The unit with a prefix that makes it smaller by this power of a thousand, if there is one.
fn smaller(own: &Unit, thousandths: usize) -> Option<Unit> {
    let wanted = 1.0 / PREFIXES[thousandths].1;
    PREFIXES[1..].iter().find_map(|(prefix, _)| {
        let unit = Unit::parse(&format!("{prefix}{}", own.text())).ok()?;
        let conversion = unit.conversion(own).ok()?;
        let factor = own.of_si(conversion.apply(1.0));
        ((factor / wanted - 1.0).abs() < 1e-12).then_some(unit)
    })
}

fn metadata(xml: &mut Xml, kind: &str, asked: &HeldPart<'_>) {
    let points = number(asked.points.to_f64());
    xml.open("itemmetadata", &[]);
    xml.open("qtimetadata", &[]);
    for (label, entry) in [("question_type", kind), ("points_possible", &points)] {
        xml.open("qtimetadatafield", &[]);
        xml.words("fieldlabel", &[], label);
        xml.words("fieldentry", &[], entry);
        xml.close();
    }
    xml.close();
    xml.close();
}

fn material(xml: &mut Xml, html: &str) {
    xml.open("material", &[]);
    xml.words("mattext", &[("texttype", "text/html")], html);
    xml.close();
}

fn present(
    xml: &mut Xml,
    words: &QuestionWords<'_, '_>,
    asked: &HeldPart<'_>,
    marked: &CanvasMarking<'_>,
) {
    let response = [("ident", "response1"), ("rcardinality", "Single")];
    match marked {
        CanvasMarking::Choice(options) => {
            xml.open("response_lid", &response);
            xml.open("render_choice", &[]);
            for own in *options {
                xml.open("response_label", &[("ident", &option(own))]);
                material(xml, &words.option(asked.place, own.place));
                xml.close();
            }
        }
        CanvasMarking::Number(..) | CanvasMarking::Essay => {
            xml.open("response_str", &response);
            let is_number = matches!(marked, CanvasMarking::Number(..));
            let kind = [("fibtype", "Decimal")];
            xml.open("render_fib", &kind[..usize::from(is_number)]);
            xml.empty("response_label", &[("ident", "answer1")]);
        }
    }
    xml.close();
    xml.close();
}

fn option(own: &Choosable) -> String {
    format!("option.{}", own.place + 1)
}

fn process(xml: &mut Xml, marked: &CanvasMarking<'_>) {
    let response = [("respident", "response1")];
    match marked {
        CanvasMarking::Choice(options) => {
            for own in options.iter().filter(|own| own.is_right) {
                condition(xml, |xml| xml.words("varequal", &response, &option(own)));
            }
        }
        CanvasMarking::Number(bands, scale) => {
            let factor = scale.factor();
            for band in bands.iter().filter(|band| band.credit == Credit::FULL) {
                condition(xml, |xml| {
                    let [low, high] = [band.value - band.half, band.value + band.half];
                    xml.words("vargte", &response, &number(low * factor));
                    xml.words("varlte", &response, &number(high * factor));
                });
            }
        }
        CanvasMarking::Essay => {}
    }
}

fn condition(xml: &mut Xml, test: impl FnOnce(&mut Xml)) {
    xml.open("respcondition", &[("continue", "No")]);
    xml.open("conditionvar", &[]);
    test(xml);
    xml.close();
    xml.words("setvar", &[("action", "Set"), ("varname", "SCORE")], "100");
    xml.close();
}
