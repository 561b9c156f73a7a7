//! An item of QTI 2 and 3: one question with its data, a box for each value.
//!
//! <https://www.imsglobal.org/question/>. Numbers are compared with both ends of each range: `equal` with a tolerance is
//! read differently by players.

use super::Version;
use super::xml::Xml;
use crate::answer::{Band, Credit};
use crate::export::cloze::number;
use crate::export::held::{Choosable, Held, HeldPart, Sorted};
use crate::export::pictures::Pictures;
use crate::export::words::QuestionWords;
use crate::numerics::Rational;

/// A box of an item.
struct ItemBox<'h> {
    /// Its identifier in the item: `a`, or `a.2` where a part has several.
    identifier: String,
    asked: &'h HeldPart<'h>,
    /// What it is worth.
    points: f64,
    marked: BoxMarking<'h>,
}

/// How a box is marked.
enum BoxMarking<'h> {
    Number(&'h [Band]),
    Choice(&'h [Choosable]),
}

/// The item with the parts that fit.
pub(crate) fn marked<'c>(
    words: &QuestionWords<'_, 'c>,
    sorted: &Sorted<'c>,
    identifier: &str,
    version: Version,
    pictures: &mut Pictures,
) -> String {
    let fields = fields(sorted);
    let title = format!("{} [{}]", words.title(), words.origin(&sorted.letters()));
    let mut xml = begin(identifier, &title, words.language(), version);
    for field in &fields {
        declare(&mut xml, field);
    }
    let remarks = remarks(words, &fields, pictures);
    let most = sum(sorted.fit.iter().map(|(asked, _)| asked));
    outcomes(&mut xml, most);
    if !remarks.is_empty() {
        let attributes = [
            ("identifier", "FEEDBACK"),
            ("cardinality", "multiple"),
            ("baseType", "identifier"),
        ];
        xml.empty("outcomeDeclaration", &attributes);
    }
    xml.open("itemBody", &[]);
    xml.html(&words.statement(pictures));
    for (asked, _) in &sorted.fit {
        xml.html(&words.ask(asked, pictures));
        write_boxes(&mut xml, words, asked, &fields);
    }
    let origin = words.origin(&sorted.letters());
    xml.html(&format!("<p><small>{origin}</small></p>"));
    let asked = sorted.fit.iter().map(|(asked, _)| asked);
    scorer(&mut xml, &words.worked(asked, pictures), version);
    xml.close();
    xml.open("responseProcessing", &[]);
    for field in &fields {
        process(&mut xml, field, &remarks);
    }
    xml.close();
    for (name, html) in &remarks {
        let attributes = [
            ("outcomeIdentifier", "FEEDBACK"),
            ("showHide", "show"),
            ("identifier", name.as_str()),
        ];
        xml.open("modalFeedback", &attributes);
        xml.content(html);
        xml.close();
    }
    xml.close();
    xml.out
}

/// The item with parts that a person marks.
pub(crate) fn essay<'c>(
    words: &QuestionWords<'_, 'c>,
    parts: &[HeldPart<'c>],
    identifier: &str,
    version: Version,
    pictures: &mut Pictures,
) -> String {
    let letters: Vec<&str> = parts.iter().map(|asked| asked.letter.as_str()).collect();
    let origin = words.origin(&letters.join(" "));
    let title = format!("{} (essay) [{origin}]", words.title());
    let mut xml = begin(identifier, &title, words.language(), version);
    for letter in &letters {
        let attributes = [
            ("identifier", *letter),
            ("cardinality", "single"),
            ("baseType", "string"),
        ];
        xml.empty("responseDeclaration", &attributes);
    }
    outcomes(&mut xml, sum(parts.iter()));
    xml.open("itemBody", &[]);
    xml.html(&words.statement(pictures));
    for asked in parts {
        xml.html(&words.ask(asked, pictures));
        let attributes = [
            ("responseIdentifier", asked.letter.as_str()),
            ("expectedLines", "8"),
        ];
        xml.empty("extendedTextInteraction", &attributes);
    }
    xml.html(&format!("<p><small>{origin}</small></p>"));
    scorer(&mut xml, &words.worked(parts.iter(), pictures), version);
    xml.close();
    xml.close();
    xml.out
}

fn sum<'a>(parts: impl Iterator<Item = &'a HeldPart<'a>>) -> f64 {
    let add = |sum: Rational, asked: &HeldPart<'_>| sum.checked_add(asked.points).unwrap_or(sum);
    parts.fold(Rational::ZERO, add).to_f64()
}

/// What each of the boxes of a part is worth: equal shares in thousandths of a point, of which the first ones get what is
/// left. Players round scores to three decimals, so that thirds would not add up to the whole.
fn shares(points: Rational, boxes: usize) -> Vec<f64> {
    // Three decimals, as players round.
    const STEPS: i128 = 1000;
    let count = boxes.max(1) as i128;
    let steps = Rational::new(STEPS, 1).and_then(|steps| points.checked_mul(steps));
    let Some(steps) = steps.filter(|steps| steps.is_integer()) else {
        return vec![points.to_f64() / count as f64; boxes.max(1)];
    };
    let (each, left) = (steps.numerator() / count, steps.numerator() % count);
    (0..count)
        .map(|place| (each + i128::from(place < left)) as f64 / STEPS as f64)
        .collect()
}

fn fields<'h>(sorted: &'h Sorted<'_>) -> Vec<ItemBox<'h>> {
    let mut fields = Vec::new();
    for (asked, held) in &sorted.fit {
        let letter = asked.letter.clone();
        let mut shares = shares(asked.points, held.boxes()).into_iter();
        let mut add = |identifier: String, marked| {
            fields.push(ItemBox {
                identifier,
                asked,
                points: shares.next().unwrap_or_default(),
                marked,
            });
        };
        match held {
            Held::Choice(options) => add(letter, BoxMarking::Choice(options)),
            Held::Numbers(values) => match &values[..] {
                [bands] => add(letter, BoxMarking::Number(bands)),
                values => {
                    for (place, bands) in values.iter().enumerate() {
                        add(format!("{letter}.{}", place + 1), BoxMarking::Number(bands));
                    }
                }
            },
        }
    }
    fields
}

fn begin(identifier: &str, title: &str, language: &str, version: Version) -> Xml {
    let mut xml = Xml::new(version);
    let location = version.location();
    let attributes = [
        ("xmlns", version.namespace()),
        ("xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"),
        ("xsi:schemaLocation", &location),
        ("identifier", identifier),
        ("title", title),
        ("adaptive", "false"),
        ("timeDependent", "false"),
        ("xml:lang", language),
    ];
    xml.open("assessmentItem", &attributes);
    xml
}

fn declare(xml: &mut Xml, field: &ItemBox<'_>) {
    let (kind, right) = match &field.marked {
        BoxMarking::Number(bands) => ("float", bands.first().map(|band| number(band.value))),
        BoxMarking::Choice(options) => {
            let right = options.iter().find(|own| own.is_right);
            ("identifier", right.map(|own| option(own.place)))
        }
    };
    let attributes = [
        ("identifier", field.identifier.as_str()),
        ("cardinality", "single"),
        ("baseType", kind),
    ];
    xml.open("responseDeclaration", &attributes);
    if let Some(right) = right {
        xml.open("correctResponse", &[]);
        xml.words("value", &[], &right);
        xml.close();
    }
    xml.close();
}

fn outcomes(xml: &mut Xml, most: f64) {
    for (name, value) in [("SCORE", 0.0), ("MAXSCORE", most)] {
        let attributes = [
            ("identifier", name),
            ("cardinality", "single"),
            ("baseType", "float"),
        ];
        xml.open("outcomeDeclaration", &attributes);
        xml.open("defaultValue", &[]);
        xml.words("value", &[], &number(value));
        xml.close();
        xml.close();
    }
}

/// Key and worked solution for whoever marks.
fn scorer(xml: &mut Xml, html: &str, version: Version) {
    let attributes = [("view", "scorer"), ("use", "scoring")];
    // Version 2.1 does not say what the block is for.
    let count = if version == Version::V21 { 1 } else { 2 };
    xml.open("rubricBlock", &attributes[..count]);
    xml.content(html);
    xml.close();
}

/// The identifier of an option, which does not depend on its place on the sheet.
fn option(place: usize) -> String {
    format!("option.{}", place + 1)
}

fn write_boxes(
    xml: &mut Xml,
    words: &QuestionWords<'_, '_>,
    asked: &HeldPart<'_>,
    fields: &[ItemBox<'_>],
) {
    let own = |field: &&ItemBox<'_>| field.asked.place == asked.place;
    let own: Vec<&ItemBox<'_>> = fields.iter().filter(own).collect();
    if let [field] = own[..]
        && let BoxMarking::Choice(options) = field.marked
    {
        let attributes = [
            ("responseIdentifier", field.identifier.as_str()),
            ("shuffle", "false"),
            ("maxChoices", "1"),
        ];
        xml.open("choiceInteraction", &attributes);
        for own in options {
            xml.open("simpleChoice", &[("identifier", &option(own.place))]);
            xml.html(&words.option(asked.place, own.place));
            xml.close();
        }
        xml.close();
        return;
    }
    xml.html("<p>");
    xml.html(&words.lead(asked.place));
    for (place, field) in own.iter().enumerate() {
        if place > 0 {
            xml.html(", ");
        }
        let attributes = [
            ("responseIdentifier", field.identifier.as_str()),
            ("expectedLength", "12"),
        ];
        xml.empty("textEntryInteraction", &attributes);
    }
    let unit = words.unit(asked.place);
    if !unit.is_empty() {
        xml.html(&unit);
    }
    xml.html("</p>");
}

/// The remarks on named mistakes, by identifier.
fn remarks(
    words: &QuestionWords<'_, '_>,
    fields: &[ItemBox<'_>],
    pictures: &mut Pictures,
) -> Vec<(String, String)> {
    let mut all = Vec::new();
    for field in fields {
        let BoxMarking::Number(bands) = field.marked else {
            continue;
        };
        for (place, band) in bands.iter().enumerate() {
            let html = words.feedback(field.asked.place, band, pictures);
            if !html.is_empty() {
                all.push((remark(field, place), html));
            }
        }
    }
    all
}

fn remark(field: &ItemBox<'_>, band: usize) -> String {
    format!("{}.remark.{band}", field.identifier)
}

/// Adds what a box is worth to the score: the first range that fits counts.
fn process(xml: &mut Xml, field: &ItemBox<'_>, remarks: &[(String, String)]) {
    xml.open("responseCondition", &[]);
    let variable = [("identifier", field.identifier.as_str())];
    match &field.marked {
        BoxMarking::Choice(_) => {
            xml.open("responseIf", &[]);
            xml.open("match", &[]);
            xml.empty("variable", &variable);
            xml.empty("correct", &variable);
            xml.close();
            score(xml, field.points);
            xml.close();
        }
        BoxMarking::Number(bands) => {
            for (place, band) in bands.iter().enumerate() {
                let test = if place == 0 {
                    "responseIf"
                } else {
                    "responseElseIf"
                };
                xml.open(test, &[]);
                xml.open("and", &[]);
                let ends = [
                    ("gte", band.value - band.half),
                    ("lte", band.value + band.half),
                ];
                for (comparison, end) in ends {
                    xml.open(comparison, &[]);
                    xml.empty("variable", &variable);
                    xml.words("baseValue", &[("baseType", "float")], &number(end));
                    xml.close();
                }
                xml.close();
                score(xml, field.points * share(band.credit));
                let name = remark(field, place);
                if remarks.iter().any(|(own, _)| *own == name) {
                    say(xml, &name);
                }
                xml.close();
            }
        }
    }
    xml.close();
}

fn share(credit: Credit) -> f64 {
    credit.share().to_f64()
}

fn score(xml: &mut Xml, points: f64) {
    xml.open("setOutcomeValue", &[("identifier", "SCORE")]);
    xml.open("sum", &[]);
    xml.empty("variable", &[("identifier", "SCORE")]);
    xml.words("baseValue", &[("baseType", "float")], &number(points));
    xml.close();
    xml.close();
}

fn say(xml: &mut Xml, name: &str) {
    xml.open("setOutcomeValue", &[("identifier", "FEEDBACK")]);
    xml.open("multiple", &[]);
    xml.empty("variable", &[("identifier", "FEEDBACK")]);
    xml.words("baseValue", &[("baseType", "identifier")], name);
    xml.close();
    xml.close();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_thousandths_that_add_up() {
        let of = |points: &str, boxes| shares(Rational::from_decimal(points).unwrap(), boxes);
        assert_eq!(of("1", 3), [0.334, 0.333, 0.333]);
        assert_eq!(of("2", 2), [1.0, 1.0]);
        assert_eq!(of("0.25", 2), [0.125, 0.125]);
        assert_eq!(of("1.5", 1), [1.5]);
        assert_eq!(of("0.0005", 1), [0.0005]);
    }
}
