//! The suite: everything of vibank that spans more than one file, one module per concern.
#![allow(
    clippy::unwrap_used,
    clippy::disallowed_methods,
    clippy::too_many_lines,
    reason = "a test may panic, reads its own files, and tells its story in one piece"
)]

#[cfg(feature = "render")]
mod answer;
#[cfg(feature = "render")]
mod bank;
#[cfg(feature = "cli")]
mod book;
#[cfg(feature = "render")]
mod bounds;
#[cfg(feature = "cli")]
mod cli;
#[cfg(feature = "render")]
mod compiled;
#[cfg(feature = "render")]
mod course;
#[cfg(feature = "cli")]
mod examples;
#[cfg(feature = "render")]
mod export;
#[cfg(feature = "render")]
mod fairness;
#[cfg(feature = "render")]
mod figures;
mod free_bodies;
mod generated;
#[cfg(feature = "render")]
mod grade;
mod layers;
mod mechanics;
mod motion;
mod numerics;
#[cfg(feature = "render")]
mod page;
mod physics;
#[cfg(feature = "render")]
mod plots;
#[cfg(feature = "cli")]
mod prose;
#[cfg(feature = "render")]
mod protocol;
#[cfg(feature = "render")]
mod text;
#[cfg(feature = "render")]
mod trace;

/// The bank of the program: an item is read once, whichever test asks it first.
#[cfg(feature = "render")]
static BANK: std::sync::LazyLock<vibank::bank::Catalogue> =
    std::sync::LazyLock::new(|| vibank::bank::Catalogue::open(vibank::bank::embedded()).0);

/// The small bank of the tests, without a finding.
#[cfg(feature = "render")]
fn small_bank() -> vibank::bank::Catalogue {
    let (catalogue, findings) = vibank::bank::Catalogue::load([
        ("bank.toml", include_str!("../fixtures/bank/bank.toml")),
        (
            "free/_chapter.toml",
            include_str!("../fixtures/bank/free/_chapter.toml"),
        ),
        (
            "free/spring-mass.toml",
            include_str!("../fixtures/bank/free/spring-mass.toml"),
        ),
        (
            "free/damped-block.toml",
            include_str!("../fixtures/bank/free/damped-block.toml"),
        ),
        (
            "friction/_chapter.toml",
            include_str!("../fixtures/bank/friction/_chapter.toml"),
        ),
        (
            "friction/half-cycles.toml",
            include_str!("../fixtures/bank/friction/half-cycles.toml"),
        ),
    ]);
    assert!(findings.is_empty(), "{findings:?}");
    catalogue
}
