//! The rules of `check` from which an item can be excepted, each by the last word of its code.

use crate::diagnostic::Code;

/// A rule of `check` from which an item can be excepted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Rule(Code);

impl Rule {
    /// All of them.
    pub const ALL: &[Self] = &[
        Self(Code::CHECK_MISTAKE_RIGHT),
        Self(Code::CHECK_MISTAKE_UNMET),
        Self(Code::CHECK_MISTAKES_ALIKE),
        Self(Code::CHECK_METHOD_RIGHT),
        Self(Code::CHECK_FEW_METHODS),
        Self(Code::CHECK_HONEST_WORK),
        Self(Code::CHECK_REFUSED),
        Self(Code::CHECK_DISCLOSED),
        Self(Code::CHECK_VARIANTS_DIFFER),
        Self(Code::CHECK_MANY_QUESTIONS),
        Self(Code::CHECK_SMALL_COMPONENT),
        Self(Code::CHECK_ANSWERS_COINCIDE),
        Self(Code::CHECK_SAME_CHOICE),
        Self(Code::CHECK_OPTION_FORM),
        Self(Code::CHECK_UNUSED_DATUM),
        Self(Code::CHECK_NO_SECOND_ROUTE),
        Self(Code::CHECK_NO_HINT),
        Self(Code::CHECK_NO_SOLUTION),
        Self(Code::CHECK_STILL_FIGURE),
    ];

    /// Those that ask what is drawn.
    #[cfg(feature = "render")]
    const BY_DRAWS: &[Code] = &[
        Code::CHECK_MISTAKE_RIGHT,
        Code::CHECK_MISTAKE_UNMET,
        Code::CHECK_MISTAKES_ALIKE,
        Code::CHECK_METHOD_RIGHT,
        Code::CHECK_FEW_METHODS,
        Code::CHECK_HONEST_WORK,
        Code::CHECK_REFUSED,
        Code::CHECK_VARIANTS_DIFFER,
        Code::CHECK_SMALL_COMPONENT,
        Code::CHECK_ANSWERS_COINCIDE,
        Code::CHECK_SAME_CHOICE,
    ];

    /// The rule of this name.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|rule| rule.name() == name)
    }

    /// The rule that raises findings of this code.
    #[cfg(feature = "render")]
    pub(crate) fn of_code(code: Code) -> Option<Self> {
        Self::ALL.iter().copied().find(|rule| rule.0 == code)
    }

    /// Whether it finds the same however many draws are examined.
    #[cfg(feature = "render")]
    pub(crate) fn holds_for_all_draws(self) -> bool {
        !Self::BY_DRAWS.contains(&self.0)
    }

    /// Its name, as exceptions have it.
    pub fn name(self) -> &'static str {
        let name = self.0.name();
        name.split_once("::").map_or(name, |(_, name)| name)
    }
}
