//! The tables of words, other languages beside English: a spelling is one row of one table.

mod around;
mod choices;
mod functions;
mod joints;
mod marks;
mod numbers;
mod programs;
mod ranges;
mod remarks;
mod signs;

pub(crate) use self::around::{
    ASIDES, CORRECTIONS, LEADS, METHODS, REASONS, SEALS, SOURCES, TRAILS, WITHDRAWALS,
};
pub(crate) use self::choices::{
    ANNOUNCEMENTS, CLAUSES, DENIALS, DOUBTS, FILLERS, JOINTS, PREFIXES, RUNS_OF_WORDS, STRESSES,
    SUFFIXES, SYNONYMS, THINGS, TURNS,
};
pub(crate) use self::functions::{
    ALIASES, BARE, FUNCTIONS, INFINITY, POWERS, Powered, RATES_IN_WORDS, ROOTS, SPOKEN_ROOTS,
    is_function,
};
pub(crate) use self::joints::{CONCLUDING, CONCLUSIONS, JOINING, PLACES, STATEMENTS};
pub(crate) use self::marks::{CONJUGATES, ROOTED_UNITS};
pub(crate) use self::numbers::{COUNTS, FACTORS, PARTS};
pub(crate) use self::programs::{EQUATIONS, LISTS, MODULES, NUMBERS};
pub(crate) use self::ranges::{
    CONDITIONS, ENDS, INSIDE, LIMITS, ONWARDS, RANGES, RANKS, UNBOUNDED, WITHIN,
};
pub(crate) use self::remarks::{COUNTING, OF_MINUS, OTHER_VALUES, REMARKS, TURNING};
pub(crate) use self::signs::{Between, HALF_PI, LETTERS, PER_MILLE, PERCENT, VERBS, WORDS};
