//! Compiled items against the files they were compiled from: the same texts, the same keys, the same marks.

use std::fmt::Write as _;

use crate::BANK;
use vibank::bank::{Compiled, Template};
use vibank::grade;
use vibank::instance::Instance;
use vibank::math::Voice;
use vibank::scene::{Data, Scene};
use vibank::seed::{Seed, Variant};
use vibank::solution::Solution;

/// Everything that can be shown of an instance, in one text.
fn shown(template: &Template, seed: Seed) -> String {
    let Ok(instance) = Instance::draw(template, seed) else {
        return "no instance".to_owned();
    };
    let solution = Solution::of(instance);
    let scene = Scene::of(&solution, Data::Both);
    let mut out = solution.instance().identity();
    let show = |out: &mut String, passage| {
        for piece in scene.passage(passage) {
            piece
                .document
                .write_html(out, &piece.fillings, Voice::ENGLISH);
        }
    };
    show(&mut out, &template.statement);
    show(&mut out, &template.solution);
    for (place, part) in template.parts.iter().enumerate() {
        show(&mut out, &part.ask);
        show(&mut out, &part.solution);
        part.hints.iter().for_each(|hint| show(&mut out, hint));
        part.mistakes
            .iter()
            .for_each(|mistake| show(&mut out, &mistake.feedback));
        for option in part.answer.options() {
            option
                .text
                .write_html(&mut out, &Vec::new(), Voice::ENGLISH);
        }
        let key = solution.marker(place).map(|marker| marker.key());
        // `Debug` of a number is the shortest text that reads back to the same bits.
        let _ = writeln!(out, "{key:?}");
        if let Ok(key) = key {
            let response = key.math.plain();
            let _ = writeln!(out, "{:?}", grade::mark(&solution, place, &response));
        }
    }
    out
}

#[test]
fn a_compiled_item_shows_and_marks_as_its_file_does() {
    let catalogue = &*BANK;
    for template in catalogue.items() {
        let json = serde_json::to_string(&Compiled::of(template)).expect("it is plain data");
        let compiled: Compiled = serde_json::from_str(&json).expect("it was written so");
        let written = serde_json::to_string(&compiled).expect("it is plain data");
        assert!(written == json, "{}", template.id);
        let again = compiled.template().expect("it was a template before");
        for index in 0..2 {
            let seed = Variant::of(Seed::new(9), index, 0, None).item(template.id.as_str(), None);
            let (from_file, from_page) = (shown(template, seed), shown(&again, seed));
            assert!(from_file == from_page, "{}: seed {seed}", template.id);
        }
    }
}

#[test]
fn what_is_no_compiled_item_is_refused() {
    let catalogue = super::small_bank();
    let json = serde_json::to_string(&Compiled::of(catalogue.items().next().unwrap()))
        .expect("plain data");
    let broken = json.replace("\"texts\":[", "\"texts\":[],\"others\":[");
    let compiled: Compiled = serde_json::from_str(&broken).expect("it has the form");
    let error = compiled.template().expect_err("its texts are gone");
    assert!(error.to_string().contains("not a compiled item"), "{error}");
}
