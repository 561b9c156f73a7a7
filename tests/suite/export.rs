//! Exports for course platforms: read back by a reader of the notation that knows nothing of the writer, and compared with
//! the grader.

use vibank::bank::{Catalogue, embedded};
use vibank::export::Moodle;
use vibank::scene::Data;
use vibank::source::Source;
use vibank::worksheet::{Blueprint, Plan, Sheet, SheetQuestion};

/// One alternative of a blank as Moodle reads it.
#[derive(Debug)]
struct Alternative {
    share: f64,
    answer: String,
    feedback: String,
}

/// A blank as Moodle reads it.
#[derive(Debug)]
struct Blank {
    weight: u64,
    kind: String,
    alternatives: Vec<Alternative>,
}

/// The blanks of a text: `{weight:KIND:alternative~alternative}`; within, `#` begins the feedback unless it is part of an
/// entity, and entities are decoded at the end.
fn blanks(text: &str) -> Vec<Blank> {
    let mut found = Vec::new();
    let mut rest = text;
    while let Some(at) = rest.find('{') {
        rest = &rest[at + 1..];
        let Some((weight, behind)) = rest.split_once(':') else {
            break;
        };
        let (Ok(weight), Some((kind, behind))) = (weight.parse(), behind.split_once(':')) else {
            continue;
        };
        let end = behind.find('}').expect("a blank ends");
        let alternatives = behind[..end].split('~').map(alternative).collect();
        found.push(Blank {
            weight,
            kind: kind.to_owned(),
            alternatives,
        });
        rest = &behind[end..];
    }
    found
}

fn alternative(text: &str) -> Alternative {
    let (share, text) = match text.strip_prefix('%') {
        Some(text) => {
            let (share, text) = text.split_once('%').expect("a share");
            (share.parse::<f64>().expect("a number") / 100.0, text)
        }
        None => match text.strip_prefix('=') {
            Some(text) => (1.0, text),
            None => (0.0, text),
        },
    };
    let cut =
        (0..text.len()).find(|at| text.as_bytes()[*at] == b'#' && !text[..*at].ends_with('&'));
    let (answer, feedback) = match cut {
        Some(at) => (&text[..at], &text[at + 1..]),
        None => (text, ""),
    };
    Alternative {
        share,
        answer: decoded(answer),
        feedback: decoded(feedback),
    }
}

fn decoded(html: &str) -> String {
    let mut out = String::new();
    let mut rest = html;
    while let Some(at) = rest.find("&#") {
        out.push_str(&rest[..at]);
        let (code, behind) = rest[at + 2..].split_once(';').expect("an entity ends");
        let code = code.parse().ok().and_then(char::from_u32);
        out.push(code.expect("a character"));
        rest = behind;
    }
    out.push_str(rest);
    out
}

impl Blank {
    /// The range of each alternative of a blank for numbers.
    fn ranges(&self) -> impl Iterator<Item = (f64, f64, f64)> + '_ {
        self.alternatives.iter().map(|own| {
            let (value, half) = own.answer.split_once(':').expect("a tolerance");
            let number = |text: &str| text.parse().expect("a number");
            (number(value), number(half), own.share)
        })
    }

    /// The share that a number gets: that of the first alternative that it fits.
    fn share(&self, typed: f64) -> f64 {
        let mut ranges = self.ranges();
        ranges
            .find(|(value, half, _)| (typed - value).abs() <= *half)
            .map_or(0.0, |(_, _, share)| share)
    }
}

/// The texts of the questions of a file, and the elements that hold their files.
fn questions(xml: &str) -> Vec<&str> {
    let mut found = xml.split("<question type=\"cloze\">").skip(1);
    let mut all = Vec::new();
    for question in &mut found {
        let (question, _) = question.split_once("</question>").expect("it ends");
        all.push(question);
    }
    all
}

fn body(question: &str) -> &str {
    let (_, behind) = question.split_once("<questiontext").expect("a text");
    let (_, behind) = behind.split_once("<![CDATA[").expect("its content");
    behind.split_once("]]>").expect("its end").0
}

/// What the grader gives for a number typed into a part, in the unit that is printed there.
fn graded(question: &SheetQuestion<'_>, place: usize, typed: f64) -> f64 {
    let unit = question.solution.template().parts[place].answer.unit();
    let unit = unit.map_or_else(String::new, |unit| format!(" {unit}"));
    let marker = question.solution.marker(place).expect("it has a key");
    let marking = marker.mark(&format!("{typed:e}{unit}"));
    marking.credit.share().to_f64()
}

/// Numbers that are typed into each blank: around each bound, and anywhere near.
fn trials(blank: &Blank) -> Vec<f64> {
    let mut typed = Vec::new();
    for (value, half, _) in blank.ranges() {
        typed.push(value);
        for side in [-1.0, 1.0] {
            for nearly in [1.0 - 1e-9, 1.0 + 1e-9] {
                if half > 0.0 {
                    typed.push(value + side * half * nearly);
                }
            }
        }
        // A sequence that covers the neighbourhood evenly, by the golden ratio.
        for step in 1..=8 {
            let share = (f64::from(step) * 0.618_033_988_749_895).fract();
            typed.push(value * (0.5 + share));
        }
    }
    typed
}

/// Calls for each question of the whole bank in some variants.
fn each_question(variants: u64, mut call: impl FnMut(&Sheet<'_>, &SheetQuestion<'_>)) {
    let (catalogue, _) = Catalogue::load(embedded());
    let ids: Vec<String> = catalogue
        .items()
        .map(|item| item.id.as_str().to_owned())
        .collect();
    for id in ids {
        let text = format!("title = 'T'\nseed = 5\nvariants = 1\n[[question]]\nitem = '{id}'\n");
        let source = Source::new(id, text);
        let blueprint = Blueprint::read(&source).expect("a blueprint");
        let plan = Plan::of(&blueprint, &catalogue, None).expect("a plan");
        for index in 0..variants {
            let sheet = Sheet::draw(&plan, plan.variant(index, 0), None).expect("it can be drawn");
            call(&sheet, &sheet.questions[0]);
        }
    }
}

#[test]
fn numbers_are_marked_by_moodle_as_by_the_grader() {
    let mut compared = 0;
    let mut differ = Vec::new();
    each_question(1, |sheet, question| {
        let mut moodle = Moodle::new("T", Data::default(), false);
        moodle.add(sheet, question);
        let xml = moodle.finish();
        let Some(text) = questions(&xml).first().map(|question| body(question)) else {
            return;
        };
        let numbers = |blank: &Blank| blank.kind == "NUMERICAL";
        let mut blanks = blanks(text).into_iter().filter(numbers);
        for place in &question.parts {
            let marker = question.solution.marker(*place).expect("it has a key");
            let bands = marker.bands();
            let own: Vec<Blank> = blanks.by_ref().take(bands.len()).collect();
            assert_eq!(own.len(), bands.len(), "a blank for each number");
            // Several values of one part are marked together by the grader.
            let [blank] = &own[..] else {
                continue;
            };
            assert!(blank.weight > 0);
            // Of an angle a few whole turns are listed, where the grader takes any.
            let ends = blank.ranges().map(|(value, half, _)| value.abs() + half);
            let farthest = ends.fold(0.0, f64::max);
            for typed in trials(blank) {
                if typed.abs() > farthest {
                    continue;
                }
                let (here, there) = (blank.share(typed), graded(question, *place, typed));
                compared += 1;
                // Whole percents.
                if (here - there).abs() > 0.005 {
                    let template = question.solution.template();
                    let part = &template.parts[*place].id;
                    differ.push(format!(
                        "{}/{part}: {typed:e} gets {here}, of the grader {there}",
                        template.id.as_str()
                    ));
                }
            }
        }
    });
    assert!(compared > 10_000, "{compared}");
    assert!(
        differ.is_empty(),
        "{} of {compared}\n{}",
        differ.len(),
        differ[..differ.len().min(40)].join("\n")
    );
}

#[test]
fn exported_files_are_whole() {
    let mut pictures = 0;
    each_question(3, |sheet, question| {
        let mut moodle = Moodle::new("T ]]> & <b>", Data::default(), true);
        moodle.category("a/b");
        moodle.add(sheet, question);
        let xml = moodle.finish();
        assert!(
            xml.contains("$course$/top/T ]]&gt; &amp; &lt;b&gt;/a//b"),
            "{}",
            &xml[..400]
        );
        for element in ["question", "questiontext", "text", "file"] {
            let opened = xml.matches(&format!("<{element}>")).count()
                + xml.matches(&format!("<{element} ")).count();
            let closed = xml.matches(&format!("</{element}>")).count();
            assert_eq!(opened, closed, "{element}");
        }
        for question in xml.split("<question ").skip(1) {
            let named: Vec<&str> = question
                .split("<file name=\"")
                .skip(1)
                .filter_map(|file| file.split('"').next())
                .collect();
            for name in &named {
                pictures += 1;
                assert!(
                    question.contains(&format!("@@PLUGINFILE@@/{name}\" alt=\"")),
                    "{name}"
                );
            }
            for used in question.split("@@PLUGINFILE@@/").skip(1) {
                let used = used.split('"').next().expect("a name");
                assert!(named.contains(&used), "{used} has no file");
            }
            assert!(!question.contains("alt=\"\""), "a picture has no words");
        }
        for text in questions(&xml) {
            for blank in blanks(body(text)) {
                let right = blank.alternatives.iter().filter(|own| own.share == 1.0);
                assert!(right.count() >= 1, "{blank:?}");
                assert!(blank.alternatives.iter().all(|own| !own.answer.is_empty()));
                assert!(
                    blank
                        .alternatives
                        .iter()
                        .all(|own| !own.feedback.contains('~'))
                );
            }
        }
    });
    assert!(pictures > 100, "{pictures}");
}
