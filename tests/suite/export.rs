//! Exports for course platforms: read back by a reader of the notation that knows nothing of the writer, and compared with
//! the grader.

use crate::BANK;
use vibank::export::{Canvas, Export, Moodle, Qti, Version, Wish};
use vibank::response::Passage;
use vibank::seed::{Seed, Streams};
use vibank::source::Source;
use vibank::worksheet::{Blueprint, Plan, Sheet, SheetQuestion, headings};

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
    while let Some(at) = rest.find('&') {
        out.push_str(&rest[..at]);
        let (code, behind) = rest[at + 1..].split_once(';').expect("an entity ends");
        out.push(
            match code.strip_prefix('#') {
                Some(code) => code.parse().ok().and_then(char::from_u32),
                None => (code == "amp").then_some('&'),
            }
            .expect("a character"),
        );
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

/// The place among the parts that are asked of the one with this letter.
fn position(question: &SheetQuestion<'_>, letter: &str) -> usize {
    let headings = headings(question.solution.template(), &question.parts);
    let found = headings.iter().position(|own| own.letter == letter);
    found.expect("a part has this letter")
}

/// What the grader gives for a number typed into a part, in the unit that is printed there.
fn graded(question: &SheetQuestion<'_>, place: usize, typed: f64) -> f64 {
    let unit = question.solution.template().parts[place].answer.unit();
    let unit = unit.map_or_else(String::new, |unit| format!(" {unit}"));
    let marker = question.solution.marker(place).expect("it has a key");
    let marking = marker.mark(Passage::of(&format!("{typed:e}{unit}")));
    marking.credit.share().to_f64()
}

/// Numbers around each bound of a blank.
fn at_bounds(blank: &Blank) -> Vec<f64> {
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
    }
    typed
}

/// Numbers anywhere near the ranges of a blank, drawn from a stream of its own.
fn anywhere(blank: &Blank, stream: &str) -> Vec<f64> {
    let mut stream = Streams::of(Seed::new(1), "cloze").named(stream);
    let mut typed = Vec::new();
    for (value, ..) in blank.ranges() {
        for width in [1.0, 0.04].repeat(6) {
            let share = stream.below(1 << 40) as f64 / (1_u64 << 40) as f64;
            typed.push(value * (1.0 + width * (share - 0.5)));
        }
    }
    typed
}

/// Calls for each question of the whole bank in some variants.
fn each_question(variants: u64, mut call: impl FnMut(&Sheet<'_>, &SheetQuestion<'_>)) {
    let catalogue = &*BANK;
    let ids: Vec<String> = catalogue
        .items()
        .map(|item| item.id.as_str().to_owned())
        .collect();
    for id in ids {
        let text = format!("title = 'T'\nseed = 5\nvariants = 1\n[[question]]\nitem = '{id}'\n");
        let source = Source::new(id, text);
        let blueprint = Blueprint::read(&source).expect("a blueprint");
        let plan = Plan::of(&blueprint, catalogue, None).expect("a plan");
        for index in 0..variants {
            let sheet = Sheet::draw(&plan, plan.variant(index, 0), None).expect("it can be drawn");
            call(&sheet, &sheet.questions[0]);
        }
    }
}

/// The file with one question, in the category `a/b` of a chapter `c`.
fn exported(sheet: &Sheet<'_>, question: &SheetQuestion<'_>, wish: Wish) -> String {
    let mut moodle = Box::new(Moodle::new(wish));
    moodle.category(&["c", "a/b"]);
    moodle.add(sheet, question, question.number);
    String::from_utf8(moodle.finish().expect("a file")).expect("text")
}

#[test]
fn numbers_are_marked_by_moodle_as_by_the_grader() {
    let (mut compared, mut random) = (0, 0);
    let mut differ = Vec::new();
    each_question(1, |sheet, question| {
        let xml = exported(sheet, question, Wish::default());
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
            let template = question.solution.template();
            let drawn = anywhere(blank, &format!("{} {place}", template.id));
            let drawn = drawn.into_iter().map(|typed| (typed, true));
            let typed = at_bounds(blank).into_iter().map(|typed| (typed, false));
            for (typed, is_random) in typed.chain(drawn) {
                if typed.abs() > farthest {
                    continue;
                }
                random += i32::from(is_random);
                let (here, there) = (blank.share(typed), graded(question, *place, typed));
                compared += 1;
                // Whole percents.
                if (here - there).abs() > 0.005 {
                    let part = &template.parts[*place].id;
                    differ.push(format!(
                        "{}/{part}: {typed:e} gets {here}, of the grader {there}",
                        template.id.as_str()
                    ));
                }
            }
        }
    });
    assert!(random > 10_000, "{random} of {compared}");
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
        let wish = Wish {
            title: "T ]]> & <b>".to_owned(),
            has_essays: true,
            ..Wish::default()
        };
        let xml = exported(sheet, question, wish);
        assert!(
            xml.contains("$course$/top/T ]]&gt; &amp; &lt;b&gt;/c/a//b"),
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

/// The content of the first element of this name.
fn element<'x>(xml: &'x str, name: &str) -> &'x str {
    let (_, behind) = xml.split_once(&format!("<{name}>")).expect(name);
    behind.split_once(&format!("</{name}>")).expect(name).0
}

/// What Moodle takes for a typed number with a unit: the number, by the factor of the first unit that is its text.
fn converted(question: &str, number: f64, unit: &str) -> Option<f64> {
    let mut units = question.split("<unit>").skip(1);
    let found = units.find(|own| element(own, "unit_name") == unit)?;
    let factor: f64 = element(found, "multiplier").parse().expect("a factor");
    Some(number / factor)
}

#[test]
fn units_are_read_by_moodle_as_by_the_grader() {
    let mut compared = 0;
    each_question(1, |sheet, question| {
        let wish = Wish {
            has_units: true,
            ..Wish::default()
        };
        let xml = exported(sheet, question, wish);
        let Some((_, numerical)) = xml.split_once("<question type=\"numerical\">") else {
            return;
        };
        let letter = element(numerical, "idnumber").rsplit(' ').next();
        let place = question.parts[position(question, letter.expect("a letter"))];
        let ranges: Vec<(f64, f64, f64)> = numerical
            .split("<answer fraction=\"")
            .skip(1)
            .map(|answer| {
                let (share, rest) = answer.split_once('"').expect("a share");
                let number = |text: &str| text.parse::<f64>().expect("a number");
                (
                    number(element(rest, "text")),
                    number(element(rest, "tolerance")),
                    number(share) / 100.0,
                )
            })
            .collect();
        let marker = question.solution.marker(place).expect("it has a key");
        let units: Vec<&str> = numerical
            .split("<unit_name>")
            .skip(1)
            .filter_map(|unit| unit.split('<').next())
            .collect();
        assert!(units.len() > 1, "{}", sheet.variant);
        for unit in units {
            let (value, half, _) = ranges[0];
            // Far enough from the ends that the rounding of a conversion does not matter.
            for offset in [0.0, 0.9, -0.9, 1.1, -1.1] {
                let wanted = value + offset * half;
                let own = wanted / converted(numerical, 1.0, unit).expect("it is listed");
                let there = converted(numerical, own, unit).expect("it is listed");
                let fits = |(value, half, _): &&(f64, f64, f64)| (there - value).abs() <= *half;
                let share = ranges.iter().find(fits).map_or(0.0, |(_, _, share)| *share);
                let marking = marker.mark(Passage::of(&format!("{own:e} {unit}")));
                let graded = marking.credit.share().to_f64();
                compared += 1;
                assert!(
                    (share - graded).abs() <= 0.005,
                    "{own:e} {unit}: {share} there, {graded} of the grader"
                );
            }
        }
    });
    assert!(compared > 100, "{compared}");
}

#[test]
fn each_blank_names_its_part_and_what_it_says_is_read_back() {
    each_question(1, |sheet, question| {
        let xml = exported(sheet, question, Wish::default());
        for question in questions(&xml) {
            let name = element(element(question, "name"), "text");
            let origin = name.rsplit_once('[').expect("an origin").1;
            let mut words = origin.trim_end_matches(']').split(' ').skip(1);
            assert_eq!(words.next(), Some(sheet.variant.to_string().as_str()));
            assert_eq!(words.next(), Some("1"));
            let text = body(question);
            assert_eq!(words.count(), blanks(text).len(), "{origin}");
            assert!(text.contains(origin.trim_end_matches(']')));
            // Nothing within a blank is written as it is that the notation gives a meaning.
            for blank in text
                .split('{')
                .skip(1)
                .filter(|own| own.contains("NUMERICAL:"))
            {
                let blank = &blank[..blank.find('}').expect("it ends")];
                assert!(!blank.contains(['/', '"', '\\']), "{blank}");
            }
            for blank in blanks(text) {
                for alternative in &blank.alternatives {
                    let opened = alternative.feedback.matches("<p>").count();
                    assert_eq!(alternative.feedback.matches("</p>").count(), opened);
                }
            }
        }
    });
}

#[test]
fn no_sign_of_the_words_is_taken_for_a_tag() {
    let (mut less, mut options) = (0, 0);
    for formulas in [
        vibank::document::Formulas::MathMl,
        vibank::document::Formulas::Tex,
    ] {
        each_question(1, |sheet, question| {
            let wish = Wish {
                formulas,
                has_essays: true,
                ..Wish::default()
            };
            let xml = exported(sheet, question, wish);
            // Moodle's reports cut a text where a letter comes after the sign.
            for behind in xml.split("&lt;").skip(1) {
                less += 1;
                assert!(
                    behind.starts_with(' '),
                    "{}",
                    &behind[..behind.len().min(40)]
                );
            }
            // What is left of a blank when its entities are decoded is HTML in which they are still written as such.
            for blank in questions(&xml)
                .into_iter()
                .flat_map(|own| blanks(body(own)))
            {
                for alternative in &blank.alternatives {
                    let texts = [&alternative.answer, &alternative.feedback];
                    options += texts.iter().filter(|text| text.contains("&lt; ")).count();
                    for text in texts {
                        let is_tag = |behind: &str| {
                            behind
                                .starts_with(|next: char| next.is_ascii_alphabetic() || next == '/')
                        };
                        assert!(text.split('<').skip(1).all(is_tag), "{text}");
                    }
                }
            }
        });
    }
    assert!(less > 20 && options > 0, "{less} {options}");
}

#[test]
fn essays_are_not_drawn_in_place_of_boxes() {
    let mut export = Box::new(Moodle::new(Wish {
        title: "Bank".to_owned(),
        has_essays: true,
        ..Wish::default()
    }));
    each_question(2, |sheet, question| {
        export.category(&[question.solution.template().id.as_str()]);
        export.add(sheet, question, question.number);
    });
    let xml = String::from_utf8(export.finish().unwrap()).unwrap();
    let (mut path, mut kinds) = (String::new(), std::collections::BTreeMap::new());
    for question in xml.split("<question type=\"").skip(1) {
        let kind = question.split('"').next().unwrap();
        if kind == "category" {
            element(question, "text").clone_into(&mut path);
        } else {
            let known = kinds.entry(path.clone()).or_insert(kind == "essay");
            assert_eq!(*known, kind == "essay", "{path}");
        }
    }
    assert!(kinds.values().any(|is_essay| *is_essay));
}

#[test]
fn formulas_can_be_tex() {
    let mut formulas = 0;
    each_question(1, |sheet, question| {
        let wish = Wish {
            formulas: vibank::document::Formulas::Tex,
            has_essays: true,
            ..Wish::default()
        };
        let xml = exported(sheet, question, wish);
        assert!(!xml.contains("<math"));
        assert_eq!(xml.matches("\\(").count(), xml.matches("\\)").count());
        formulas += xml.matches("\\(").count();
    });
    assert!(formulas > 1000, "{formulas}");
}

/// The files of an archive.
fn unpacked(bytes: Vec<u8>) -> std::collections::BTreeMap<String, String> {
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(bytes)).expect("an archive");
    let mut files = std::collections::BTreeMap::new();
    for place in 0..archive.len() {
        let mut file = archive.by_index(place).expect("a file");
        let name = file.name().expect("a name").into_owned();
        let mut text = String::new();
        std::io::Read::read_to_string(&mut file, &mut text).expect("text");
        files.insert(name, text);
    }
    files
}

/// Name, attributes, and the words up to the next tag.
type Element = (String, Vec<(String, String)>, String);

/// The elements of well-formed XML.
fn elements(xml: &str) -> Vec<Element> {
    let (mut found, mut open) = (Vec::new(), Vec::new());
    let mut rest = xml
        .strip_prefix("<?xml version=\"1.0\" encoding=\"UTF-8\"?>")
        .expect("a head");
    let mut ids = std::collections::BTreeSet::new();
    while let Some(at) = rest.find('<') {
        let end = at + rest[at..].find('>').expect("a tag ends");
        let tag = &rest[at + 1..end];
        let words = &rest[end + 1..];
        let words = &words[..words.find('<').unwrap_or(words.len())];
        rest = &rest[end + 1..];
        for entity in words.split('&').skip(1) {
            let (name, _) = entity.split_once(';').expect("an entity ends");
            assert!(
                ["amp", "lt", "gt", "quot", "#39"].contains(&name),
                "&{name};"
            );
        }
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop().as_deref(), Some(name));
            continue;
        }
        let (tag, is_closed) = match tag.strip_suffix('/') {
            Some(tag) => (tag, true),
            None => (tag, false),
        };
        let (name, mut behind) = tag.split_once(' ').unwrap_or((tag, ""));
        let mut attributes: Vec<(String, String)> = Vec::new();
        while !behind.trim().is_empty() {
            let (own, value) = behind.split_once("=\"").expect("an attribute");
            let (value, next) = value.split_once('"').expect("its value");
            assert!(!attributes.iter().any(|(known, _)| known == own.trim()));
            attributes.push((own.trim().to_owned(), value.to_owned()));
            behind = next;
        }
        for (own, value) in &attributes {
            assert!(own != "id" || ids.insert(value.clone()), "{value} twice");
        }
        if !is_closed {
            open.push(name.to_owned());
        }
        found.push((name.to_owned(), attributes, words.to_owned()));
    }
    assert!(open.is_empty(), "{open:?}");
    found
}

fn attribute<'e>(element: &'e (String, Vec<(String, String)>, String), name: &str) -> &'e str {
    let mut attributes = element.1.iter();
    let found = attributes.find(|(own, _)| own == name);
    &found
        .unwrap_or_else(|| panic!("{} has no {name}", element.0))
        .1
}

/// The ranges of a box of an item of QTI 2 as a player goes through them: lower end, upper end, points.
fn conditions(item: &str, field: &str) -> Vec<(f64, f64, f64)> {
    let mut ranges = Vec::new();
    let (_, processing) = item
        .split_once("<responseProcessing>")
        .expect("it is marked");
    for condition in processing.split("<response").skip(1) {
        if !condition.contains(&format!("<gte><variable identifier=\"{field}\"/>"))
            && !condition.contains(&format!("<gte>\n<variable identifier=\"{field}\"/>"))
        {
            continue;
        }
        let numbers: Vec<f64> = condition
            .split("<baseValue baseType=\"float\">")
            .skip(1)
            .map(|own| {
                own.split('<')
                    .next()
                    .and_then(|own| own.parse().ok())
                    .expect("a number")
            })
            .collect();
        let [low, high, points] = numbers[..] else {
            panic!("{condition}");
        };
        ranges.push((low, high, points));
    }
    ranges
}

#[test]
fn numbers_are_marked_by_players_of_qti_as_by_the_grader() {
    let mut compared = 0;
    each_question(1, |sheet, question| {
        let mut qti = Box::new(Qti::new(Wish::default(), Version::V21));
        qti.add(sheet, question, question.number);
        let files = unpacked(qti.finish().expect("a package"));
        let Some((_, item)) = files.iter().find(|(name, _)| name.ends_with("/item.xml")) else {
            return;
        };
        assert!(
            !item.contains("<equal "),
            "players read tolerances differently"
        );
        let headings = headings(question.solution.template(), &question.parts);
        for (position, place) in question.parts.iter().enumerate() {
            let marker = question.solution.marker(*place).expect("it has a key");
            if marker.bands().len() != 1 {
                continue;
            }
            let points = question.points[position].to_f64();
            let ranges = conditions(item, &headings[position].letter);
            assert_eq!(ranges.len(), marker.bands()[0].len());
            let farthest = ranges.iter().fold(0.0, |far: f64, (low, high, _)| {
                far.max(low.abs()).max(high.abs())
            });
            for (low, high, _) in &ranges {
                let (middle, half) = (f64::midpoint(*low, *high), (high - low) / 2.0);
                let mut typed = vec![middle, middle * 0.7, middle * 1.3];
                for side in [-1.0, 1.0] {
                    typed.extend([1.0 - 1e-9, 1.0 + 1e-9].map(|near| middle + side * half * near));
                }
                // Half a range of one number is nothing.
                typed.retain(|typed| half > 0.0 || *typed == middle);
                for typed in typed {
                    if typed.abs() > farthest {
                        continue;
                    }
                    let fits = |(low, high, _): &&(f64, f64, f64)| *low <= typed && typed <= *high;
                    let there = ranges.iter().find(fits).map_or(0.0, |(_, _, own)| *own);
                    let here = points * graded(question, *place, typed);
                    compared += 1;
                    assert!(
                        (here - there).abs() < 1e-9,
                        "{typed:e}: {there}, grader {here}"
                    );
                }
            }
        }
    });
    assert!(compared > 2_000, "{compared}");
}

#[test]
fn packages_are_whole_in_each_version() {
    let wish = Wish {
        title: "T & \"<b>\"".to_owned(),
        has_essays: true,
        ..Wish::default()
    };
    let qti = |version| -> Box<dyn Export> { Box::new(Qti::new(wish.clone(), version)) };
    let mut packages = [
        (Some(Version::V21), qti(Version::V21)),
        (Some(Version::V22), qti(Version::V22)),
        (Some(Version::V30), qti(Version::V30)),
        (None, Box::new(Canvas::new(wish.clone()))),
    ];
    let mut again = qti(Version::V21);
    let mut last = String::new();
    each_question(3, |sheet, question| {
        let item = question.solution.template().id.to_string();
        let is_new = item != last;
        let all = packages.iter_mut().map(|(_, package)| package);
        for package in all.chain([&mut again]) {
            if is_new {
                package.category(&["c", &item]);
            }
            package.add(sheet, question, question.number);
        }
        last = item;
    });
    let repeated = again.finish().expect("a package");
    for (version, package) in packages {
        let tally = package.tally().clone();
        assert!(tally.questions > 300 && tally.boxes > 300, "{tally:?}");
        let bytes = package.finish().expect("a package");
        if version == Some(Version::V21) {
            assert!(bytes == repeated, "the same bytes");
        }
        let files = unpacked(bytes);
        let manifest = elements(&files["imsmanifest.xml"]);
        let listed: Vec<&str> = manifest
            .iter()
            .filter(|element| element.0 == "file")
            .map(|element| attribute(element, "href"))
            .collect();
        for name in files.keys().filter(|name| *name != "imsmanifest.xml") {
            assert_eq!(
                listed.iter().filter(|own| *own == name).count(),
                1,
                "{name}"
            );
        }
        assert_eq!(listed.len(), files.len() - 1);
        let mut pictures = 0;
        for (name, text) in files.iter().filter(|(name, _)| name.ends_with(".xml")) {
            let all = elements(text);
            for image in all.iter().filter(|element| element.0 == "img") {
                pictures += 1;
                let folder = name.rsplit_once('/').expect("a folder").0;
                assert!(files.contains_key(&format!("{folder}/{}", attribute(image, "src"))));
                assert!(!attribute(image, "alt").is_empty());
            }
            if version.is_some() && name.ends_with("/item.xml") {
                // `responseDeclaration` of version 2 is `qti-response-declaration` in version 3.
                let count = |kind: &str| {
                    let plain =
                        |name: &str| name.replace("qti-", "").replace('-', "").to_lowercase();
                    all.iter()
                        .filter(|element| plain(&element.0) == kind)
                        .count()
                };
                let asked = ["textentry", "choice", "extendedtext"];
                let asked = asked.map(|kind| count(&format!("{kind}interaction")));
                assert_eq!(
                    asked.iter().sum::<usize>(),
                    count("responsedeclaration"),
                    "{name}"
                );
            }
        }
        if version.is_none() {
            let text = &files["assessment/assessment.xml"];
            let shown: std::collections::BTreeSet<&str> = text
                .split("$IMS-CC-FILEBASE$/")
                .skip(1)
                .map(|behind| behind.split("&quot;").next().unwrap_or_default())
                .collect();
            let pictured = files
                .keys()
                .filter_map(|name| name.strip_prefix("web_resources/"));
            for name in pictured {
                pictures += 1;
                assert!(shown.contains(name), "{name}");
            }
            assert_eq!(
                text.matches("$IMS-CC-FILEBASE$/").count(),
                text.matches("$IMS-CC-FILEBASE$/q.").count()
            );
        }
        assert!(pictures > 100, "{pictures}");
    }
}

#[test]
fn canvas_gets_numbers_that_its_rounding_leaves() {
    let mut compared = 0;
    each_question(1, |sheet, question| {
        let mut canvas = Box::new(Canvas::new(Wish::default()));
        canvas.add(sheet, question, question.number);
        let files = unpacked(canvas.finish().expect("a package"));
        let text = &files["assessment/assessment.xml"];
        // What no question shows is not in the package.
        for name in files
            .keys()
            .filter_map(|name| name.strip_prefix("web_resources/"))
        {
            assert!(text.contains(name), "{name}");
        }
        for item in text.split("<item ident=\"").skip(1) {
            let (identifier, item) = item.split_once('"').expect("its end");
            let letter = identifier.rsplit('.').next().expect("a letter");
            let position = position(question, letter);
            let place = question.parts[position];
            if !item.contains("numerical_question") {
                continue;
            }
            let end = |name: &str| -> Vec<f64> {
                let tag = format!("<{name} respident=\"response1\">");
                let found = item.split(&tag).skip(1);
                found
                    .map(|own| {
                        own.split('<')
                            .next()
                            .and_then(|own| own.parse().ok())
                            .expect("a number")
                    })
                    .collect()
            };
            let title = item
                .split_once("title=\"")
                .expect("a title")
                .1
                .split('"')
                .next();
            let scale = title.and_then(|title| title.rsplit_once('*'));
            let scale = scale.map_or(1.0, |(_, scale)| {
                scale.trim_end_matches(']').parse().expect("a scale")
            });
            for (low, high) in end("vargte").into_iter().zip(end("varlte")) {
                let middle = f64::midpoint(low, high);
                assert!(
                    middle == 0.0 || middle.abs() >= 1e-3,
                    "{identifier}: {middle}"
                );
                assert!(
                    high == low || high - low >= 2e-4,
                    "{identifier}: {low} to {high}"
                );
                compared += 1;
                for (typed, share) in [(middle, 1.0), (high + 0.01 * (high - low), 0.0)] {
                    if high > low || share == 1.0 {
                        let given = graded(question, place, typed * scale);
                        assert!((share == 1.0) == (given == 1.0), "{identifier}: {typed}");
                    }
                }
            }
        }
    });
    assert!(compared > 100, "{compared}");
}
