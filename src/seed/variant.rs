//! The seed of one sheet.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use super::Seed;
use super::code::{self, CodeError};
use super::digest::{HashedField, Secret, derive};

/// The seed of one variant: what its sheet's code says.
///
/// It has 40 bits, so that a code has eight characters and one to check them. Among 1,000 variants two
/// would be drawn alike once in two million blueprints, and those who make sheets look for repeats.
/// A longer code would protect nothing: what keeps a key secret is the [`Secret`], not the code.
///
/// It prints as its code and is read from it, in any case, with or without hyphens.
///
/// # Examples
///
/// ```
/// use vibank::seed::{Seed, Variant};
///
/// let variant = Variant::of(Seed::new(2026), 0, 0, None);
/// let code = variant.to_string();
/// assert_eq!(code.len(), "XXX-XXX-XXX".len());
/// assert_eq!(code.to_lowercase().parse(), Ok(variant));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
pub struct Variant(u64);

impl Variant {
    /// How many variants there are: 2⁴⁰.
    pub const COUNT: u64 = 1 << 40;

    /// The variant with this number, if it is below [`Variant::COUNT`].
    pub fn new(number: u64) -> Option<Self> {
        (number < Self::COUNT).then_some(Self(number))
    }

    /// The variant at place `index` of a blueprint with the seed `seed`.
    ///
    /// Each further `attempt`, from 0, gives another one, for those who choose among variants.
    pub fn of(seed: Seed, index: u64, attempt: u64, secret: Option<&Secret>) -> Self {
        let fields = [
            HashedField::Text("vibank 1 variant"),
            HashedField::Number(seed.number()),
            HashedField::Number(index),
            HashedField::Number(attempt),
        ];
        Self(derive(&fields, secret) >> 24)
    }

    /// The variant of a student of a class list: it follows from the identity alone, wherever in the list it stands.
    ///
    /// Each further `attempt`, from 0, gives another one.
    ///
    /// ```
    /// use vibank::seed::{Seed, Variant};
    ///
    /// let of = |id: &str| Variant::of_student(Seed::new(2026), id, 0, None);
    /// assert_ne!(of("17"), of("18"));
    /// ```
    pub fn of_student(seed: Seed, id: &str, attempt: u64, secret: Option<&Secret>) -> Self {
        let fields = [
            HashedField::Text("vibank 1 student"),
            HashedField::Number(seed.number()),
            HashedField::Text(id),
            HashedField::Number(attempt),
        ];
        Self(derive(&fields, secret) >> 24)
    }

    /// Who goes first where two students of a class list would get what only one can have: the lower rank.
    ///
    /// It follows from the identity, so that the order of the rows means nothing.
    pub fn rank(seed: Seed, id: &str, secret: Option<&Secret>) -> u64 {
        let fields = [
            HashedField::Text("vibank 1 rank"),
            HashedField::Number(seed.number()),
            HashedField::Text(id),
        ];
        derive(&fields, secret)
    }

    /// Its 64 bits as a number.
    pub const fn number(self) -> u64 {
        self.0
    }

    /// The seed of the item `item` in this variant.
    pub fn item(self, item: &str, secret: Option<&Secret>) -> Seed {
        Seed::new(derive(
            &[
                HashedField::Text("vibank 1 item"),
                HashedField::Number(self.0),
                HashedField::Text(item),
            ],
            secret,
        ))
    }
}

impl fmt::Display for Variant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&code::write(self.0))
    }
}

impl FromStr for Variant {
    type Err = CodeError;

    fn from_str(text: &str) -> Result<Self, CodeError> {
        code::read(text).map(Self)
    }
}

impl From<Variant> for String {
    fn from(variant: Variant) -> Self {
        code::write(variant.0)
    }
}

impl TryFrom<String> for Variant {
    type Error = CodeError;

    fn try_from(text: String) -> Result<Self, CodeError> {
        text.parse()
    }
}

/// Frozen: the codes on sheets depend on these numbers, which were computed apart from this code.
#[cfg(test)]
mod tests {
    use super::*;

    const ITEM: &str = "ch2/p1-pinned-bar-block";

    #[test]
    fn variants_and_item_seeds_are_frozen() {
        for (index, attempt, number, code, item) in [
            (
                0,
                0,
                127_760_029_647,
                "3PZ-HEN-YFB",
                3_944_318_304_586_255_462,
            ),
            (
                1,
                0,
                73_264_767_584,
                "247-EQ8-K0Y",
                11_160_769_320_779_001_021,
            ),
            (0, 1, 480_908_350_267, "DZW-5Y4-SVJ", 5_133_847_293_266_853),
        ] {
            let variant = Variant::of(Seed::new(2026), index, attempt, None);
            assert_eq!(
                (variant.number(), variant.to_string().as_str()),
                (number, code)
            );
            assert_eq!(variant.item(ITEM, None), Seed::new(item));
        }
    }

    #[test]
    fn keyed_variants_and_item_seeds_are_frozen() {
        let secret = Secret::new(b"correct horse battery staple\n").unwrap();
        let variant = Variant::of(Seed::new(2026), 0, 0, Some(&secret));
        assert_eq!(variant.number(), 791_707_950_624);
        assert_eq!(
            variant.item(ITEM, Some(&secret)),
            Seed::new(13_315_167_042_510_114_139)
        );
        assert_ne!(variant.item(ITEM, None), variant.item(ITEM, Some(&secret)));
    }

    #[test]
    fn variants_of_students_are_frozen() {
        let secret = Secret::new(b"correct horse battery staple\n").unwrap();
        let seed = Seed::new(2026);
        for (id, attempt, plain, keyed) in [
            ("17", 0, 549_599_083_366, 10_682_325_688),
            ("17", 1, 20_614_334_365, 904_158_744_053),
            ("Noether", 0, 717_571_920_994, 725_695_665_671),
        ] {
            let of = |secret| Variant::of_student(seed, id, attempt, secret).number();
            assert_eq!(
                (of(None), of(Some(&secret))),
                (plain, keyed),
                "{id} {attempt}"
            );
        }
        let rank = |secret| Variant::rank(seed, "17", secret);
        assert_eq!(rank(None), 12_726_727_404_351_534_609);
        assert_eq!(rank(Some(&secret)), 17_925_984_975_129_265_588);
    }

    #[test]
    fn a_secret_is_not_shown() {
        let secret = Secret::new(b"correct horse battery staple").unwrap();
        assert!(!format!("{secret:?}").contains("horse"));
    }

    #[test]
    fn stored_as_a_code() {
        let variant = Variant::new(127_760_029_647).unwrap();
        assert_eq!(serde_json::to_string(&variant).unwrap(), "\"3PZ-HEN-YFB\"");
        assert_eq!(
            serde_json::from_str::<Variant>("\"3PZ-HEN-YFB\"").unwrap(),
            variant
        );
        assert_eq!(Variant::new(Variant::COUNT), None);
    }
}
