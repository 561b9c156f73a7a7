//! The decimal sign of a sheet, also in what authors wrote and in what is derived.

use vibank::bank::Passage;
use vibank::document::Filling;
use vibank::instance::Instance;
use vibank::scene::{Data, Scene};
use vibank::solution::Solution;
use vibank::unit::DecimalMark;

/// Whether a digit, a point and a digit follow each other anywhere.
pub(crate) fn has_decimal_point(text: &str) -> bool {
    let signs: Vec<char> = text.chars().collect();
    signs
        .windows(3)
        .any(|own| own[1] == '.' && own[0].is_ascii_digit() && own[2].is_ascii_digit())
}

#[test]
fn formulas_of_the_whole_bank_keep_to_a_decimal_comma() {
    let (mut with_comma, mut with_point) = (0, Vec::new());
    for id in crate::BANK.ids() {
        let item = crate::BANK.find(id.as_str()).expect("the item is sound");
        let solution = Solution::with_mark(Instance::of_source(item), DecimalMark::Comma);
        let scene = Scene::of(&solution, Data::Both);
        let mut check = |what: &str, text: &str| {
            if has_decimal_point(text) {
                with_point.push(format!("{id}, {what}: {text}"));
            }
            with_comma += usize::from(text.contains(','));
        };
        let parts = item.parts.iter();
        let passages: Vec<&Passage> = [&item.statement, &item.solution, &item.notes]
            .into_iter()
            .chain(
                parts.flat_map(|part| [&part.ask, &part.solution].into_iter().chain(&part.hints)),
            )
            .collect();
        for passage in passages {
            for mut piece in scene.passage(passage) {
                for filling in &mut piece.fillings {
                    if matches!(filling, Filling::Figure(_)) {
                        *filling = Filling::words("");
                    }
                }
                check("a text", &piece.document.plain(&piece.fillings));
            }
        }
        for place in 0..item.parts.len() {
            if let Ok(Some(key)) = scene.key(place) {
                check("a key", &key.plain());
            }
        }
    }
    assert!(with_point.is_empty(), "{}", with_point.join("\n"));
    assert!(with_comma > 100);
}
