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

/// How responses of each kind were read is shown with the decimal sign of the sheet.
#[test]
fn readings_keep_to_a_decimal_comma() {
    const ITEM: &str = include_str!("../../fixtures/kinds/item.toml");
    let (catalogue, _) = vibank::bank::Catalogue::load([
        ("bank.toml", "format = 1\ntitle = 'Kinds'\n"),
        ("kinds/_chapter.toml", "title = 'Kinds'\n"),
        ("kinds/item.toml", ITEM),
    ]);
    let item = catalogue.items().next().expect("one item");
    let solution = Solution::with_mark(Instance::of_source(item), DecimalMark::Comma);
    let place = |id: &str| item.parts.iter().position(|part| part.id == id);
    for (id, typed) in [
        ("omega_n", "1,5 rad/s"),
        ("both", "5,25 rad/s; 8 rad/s"),
        ("Z", "3,5 - 4i ohm"),
        ("formula", "0.5*sqrt(k/m)"),
        ("K", "[[1.5*k, 0], [0, k]]"),
        ("range", "mu > 0.125"),
        ("motion", "0,25*cos(1,5*t)"),
        (
            "general",
            "x1 = A*cos(0.5*t) + B*sin(0.5*t); x2 = C*cos(t) + D*sin(t)",
        ),
        ("eom1", "m*x1'' + 1.5*k*x1 = 0"),
        ("u1", "[1; 0,618]"),
    ] {
        let Some(place) = place(id) else {
            panic!(
                "no part `{id}`: {:?}",
                item.parts.iter().map(|part| &part.id).collect::<Vec<_>>()
            );
        };
        let marking = vibank::grade::mark(&solution, place, typed);
        let reading = marking
            .reading
            .unwrap_or_else(|| panic!("{typed}: {:?}", marking.remarks));
        let echo = vibank::grade::echo(&solution, place, typed).expect("it can be read");
        for shown in [reading.math.plain(), echo.reading.math.plain()] {
            assert!(
                !has_decimal_point(&shown) && shown.contains(','),
                "{typed}: {shown}"
            );
        }
    }
}
