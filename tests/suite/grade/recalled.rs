//! Answers that others have typed before.

use vibank::answer::{Doubt, Marking, Verdict};
use vibank::bank::{Catalogue, Template};
use vibank::grade;
use vibank::instance::Instance;
use vibank::seed::Seed;
use vibank::solution::Solution;

const ITEM: &str = "ch2/p3-parallel-springs-damper";

/// Right, in several spellings, of one meaning for one policy alone, wrong, and unreadable.
const TYPED: [(&str, &str); 9] = [
    ("omega_n", "sqrt((k1+k2)/m)"),
    ("omega_n", " sqrt((k1+k2)/m) "),
    ("omega_n", "√((k₁ + k₂)/m)"),
    ("omega_n", "sqrt(k1+k2)/m"),
    ("omega_n", "1.000 sqrt((k1+k2)/m)"),
    ("omega_n", "5 rad/s"),
    ("omega_n", "sqrt(("),
    ("eom", "m x'' + c x' + (k1+k2) x = 0"),
    ("eom", "m x'' + c x' + k1 x = 0"),
];

/// The markings of all of these for one instance.
fn marked(template: &Template, seed: u64, doubt: Doubt) -> Vec<Marking> {
    let instance = Instance::draw(template, Seed::new(seed)).expect("an instance");
    let solution = Solution::of(instance).settling(doubt);
    let mark = |(id, typed): &(&str, &str)| {
        let place = template.parts.iter().position(|part| part.has_id(id));
        grade::mark(&solution, place.expect("a part"), typed)
    };
    TYPED.iter().map(mark).collect()
}

#[test]
fn what_others_have_typed_before_changes_no_marking() {
    let bank = || Catalogue::open(vibank::bank::embedded()).0;
    let class = bank();
    let class = class.find(ITEM).expect("the item");
    for seed in 1..4 {
        for doubt in Doubt::ALL {
            let alone = bank();
            let alone = marked(alone.find(ITEM).expect("the item"), seed, doubt);
            assert_eq!(marked(class, seed, doubt), alone, "seed {seed}, {doubt:?}");
            assert_eq!(marked(class, seed, doubt), alone, "seed {seed}, {doubt:?}");
        }
    }
    let right = marked(class, 1, Doubt::Ask);
    let right = right.iter().filter(|own| own.verdict == Verdict::Right);
    assert_eq!(right.count(), 5);
}

/// An equation in letters with the same in values beside it is right for the data of its sheet alone.
#[test]
fn values_of_one_sheet_are_not_right_on_another() {
    const TYPED: &str = "m x'' + c x' + (k1+k2) x = 0, 2 x'' + 4 x' + 50 x = 0";
    let bank = Catalogue::open(vibank::bank::embedded()).0;
    let template = bank.find(ITEM).expect("the item");
    let eom = template.parts.iter().position(|part| part.has_id("eom"));
    for (mass, is_right) in [("2 kg", true), ("3 kg", false)] {
        let set = [
            ("m", mass),
            ("b", "4 N s/m"),
            ("k1", "30 N/m"),
            ("k2", "20 N/m"),
        ];
        let solution = Solution::of(Instance::of(template, None, &set).expect("the data"));
        let marking = grade::mark(&solution, eom.expect("the part"), TYPED);
        let found = marking.verdict == Verdict::Right;
        assert_eq!(found, is_right, "{mass}: {:?}", marking.remarks);
    }
}
