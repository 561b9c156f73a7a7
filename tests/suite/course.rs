//! Packages for course platforms.

use std::io::{Cursor, Read};

use crate::BANK;
use vibank::bank::{Catalogue, Compiled, Template};
use vibank::course::{Package, first_variant};
use vibank::output::{Scorm, scorm};
use vibank::source::Source;
use vibank::worksheet::{Blueprint, Feedback, Plan, Practice, Rules, Worked};

fn made(catalogue: &Catalogue, title: &str) -> (Practice, Vec<Compiled>) {
    let all: Vec<&Template> = catalogue.items().collect();
    Practice::of_items(catalogue, &all, title)
}

fn unpacked(package: &[u8], name: &str) -> String {
    let mut archive = zip::ZipArchive::new(Cursor::new(package)).unwrap();
    let mut text = String::new();
    archive
        .by_name(name)
        .unwrap()
        .read_to_string(&mut text)
        .unwrap();
    text
}

#[test]
fn a_package_is_an_archive_of_the_same_bytes_with_its_version_in_the_manifest() {
    let catalogue = super::small_bank();
    let (practice, items) = made(&catalogue, "Springs & <dampers>");
    let package = Package::of(&practice, &items, &Rules::default(), 1);
    for (version, named) in [(Scorm::V12, "1.2"), (Scorm::V2004, "2004 4th Edition")] {
        let bytes = scorm(&practice, &items, &package, version).unwrap();
        assert!(bytes == scorm(&practice, &items, &package, version).unwrap());
        let manifest = unpacked(&bytes, "imsmanifest.xml");
        assert!(manifest.contains(&format!("<schemaversion>{named}</schemaversion>")));
        assert!(
            manifest.contains("Springs &amp; &lt;dampers&gt;"),
            "{manifest}"
        );
        let page = unpacked(&bytes, "index.html");
        assert!(page.contains("class Course") && page.contains("script-src 'sha256-"));
        assert_eq!(
            page.matches("<script").count(),
            6,
            "one more than on its own"
        );
    }
}

#[test]
fn a_package_is_known_by_its_title_and_seed_or_its_id() {
    let catalogue = super::small_bank();
    let (practice, items) = made(&catalogue, "One");
    let of = |seed, id: Option<&str>| {
        let rules = Rules {
            id: id.map(str::to_owned),
            ..Rules::default()
        };
        Package::of(&practice, &items, &rules, seed)
    };
    assert_eq!(of(1, None), of(1, None));
    assert_ne!(of(1, None).id, of(2, None).id);
    assert_eq!(of(2, Some("week-3")).id, "week-3");
    assert_eq!(
        of(1, None).digest,
        of(2, None).digest,
        "the questions are the same"
    );
    let (mut fewer, _) = made(&catalogue, "One");
    fewer.questions.pop();
    let fewer = Package::of(&fewer, &items, &Rules::default(), 1);
    assert_ne!(fewer.digest, of(1, None).digest);
}

#[test]
fn a_package_whose_state_may_not_fit_is_refused_with_the_numbers() {
    let catalogue = super::small_bank();
    let (mut practice, items) = made(&catalogue, "Long");
    let once = practice.questions.clone();
    let mut parts = Package::of(&practice, &items, &Rules::default(), 1).parts();
    assert!(parts > 0);
    let package = loop {
        let package = Package::of(&practice, &items, &Rules::default(), 1);
        parts = package.parts();
        // 16 characters and 4 for each part.
        if 16 + 4 * parts > 4_096 {
            break package;
        }
        assert_eq!(Scorm::V12.room().fit(package.parts()), Ok(16 + 4 * parts));
        practice.questions.extend(once.iter().cloned());
    };
    let refused = Scorm::V12
        .room()
        .fit(package.parts())
        .unwrap_err()
        .to_string();
    let needed = 16 + 4 * parts;
    let said = format!("{parts} parts need {needed} characters of state, and SCORM 1.2 keeps 4096");
    assert_eq!(refused, said);
    assert!(Scorm::V2004.room().fit(package.parts()).is_ok());
}

#[test]
fn texts_that_are_never_shown_are_not_in_an_item() {
    let catalogue = &*BANK;
    let mut emptied = 0;
    for item in catalogue.items() {
        let silent = Compiled::of(item).silenced(&["solution", "feedback"]);
        let template = silent.template().unwrap();
        assert!(template.solution.is_empty(), "{}", item.id);
        assert_eq!(template.parts.len(), item.parts.len());
        for (part, whole) in template.parts.iter().zip(&item.parts) {
            assert!(part.solution.is_empty());
            assert!(
                part.mistakes
                    .iter()
                    .all(|mistake| mistake.feedback.is_empty())
            );
            assert_eq!(
                part.mistakes.len(),
                whole.mistakes.len(),
                "they still count"
            );
            assert_eq!(part.hints.len(), whole.hints.len());
            emptied += usize::from(!whole.solution.is_empty());
        }
    }
    assert!(emptied > 100, "{emptied}");
}

#[test]
fn learners_and_questions_have_numbers_of_their_own() {
    let numbers: std::collections::BTreeSet<u64> = (0..2_000)
        .map(|learner| first_variant("p", "ch3/e5-log-decrement", &learner.to_string()))
        .collect();
    assert_eq!(numbers.len(), 2_000);
    // Half of them are in the upper half, within four standard deviations.
    let upper = numbers.iter().filter(|number| **number >= 1 << 39).count();
    assert!((910..=1_090).contains(&upper), "{upper}");
    assert_ne!(first_variant("p", "a", "1"), first_variant("p", "b", "1"));
    assert_ne!(first_variant("p", "a", "1"), first_variant("q", "a", "1"));
}

#[test]
fn rules_are_read_and_wrong_ones_have_their_places() {
    let base = "title = 'T'\nseed = 1\nvariants = 1\n[[question]]\nitem = 'ch3/e5-log-decrement'\npoints = 5\n";
    let read =
        |page: &str| Blueprint::read(&Source::new("b.toml", format!("{base}[page]\n{page}")));
    let rules =
        read("pass = '60 %'\nattempts = 3\nfeedback = 'never'\nsolution = 'never'\nid = 'a.b-1'\n");
    let rules = rules.unwrap().rules;
    assert_eq!((rules.pass, rules.attempts), (Some(0.6), Some(3)));
    assert_eq!(
        (rules.feedback, rules.solution),
        (Feedback::Never, Worked::Never)
    );
    for wrong in [
        "pass = '0 %'",
        "pass = 0.6",
        "attempts = 0",
        "feedback = 'later'",
        "id = 'a b'",
        "due = 1",
    ] {
        let findings = read(wrong).unwrap_err();
        assert!(
            findings[0].to_string().contains("b.toml:8"),
            "{wrong}: {}",
            findings[0]
        );
    }
    let catalogue = &*BANK;
    let blueprint = read("").unwrap();
    let plan = Plan::of(&blueprint, catalogue, None).unwrap();
    let (practice, _) = Practice::of_plan(&plan, catalogue);
    let points: f64 = practice.questions[0]
        .weights
        .iter()
        .map(|part| part.points)
        .sum();
    assert!(
        (points - 5.0).abs() < 1e-12,
        "the points of the blueprint: {points}"
    );
}
