//! `vibank course`

use std::path::PathBuf;

use vibank::bank;
use vibank::output::{self, Pages, Run};
use vibank::worksheet::Paper;

use super::bank::BankArgument;
use super::files::{self, Access};
use super::press::Press;
use super::{Failure, Outcome};

/// Print the course as one PDF: five chapters with their figures, plots and worked examples.
///
/// It is printed by `vibank-press`.
///
/// Example: vibank course --out course.pdf
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The file to write.
    #[arg(short, long, value_name = "FILE", default_value = "course.pdf")]
    out: PathBuf,
    /// The size of its pages.
    #[arg(long, value_enum, default_value_t)]
    paper: Size,
}

#[derive(Clone, Copy, Default, clap::ValueEnum)]
enum Size {
    /// 210 mm by 297 mm.
    #[default]
    A4,
    /// The paper of North America, 8.5 in by 11 in.
    Letter,
}

const TITLE: &str = "Vibrations: a course";

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let press = Press::find().map_err(|missing| missing.failure("the course"))?;
    let catalogue = BankArgument::default().catalogue()?;
    let paper = match arguments.paper {
        Size::A4 => Paper::A4,
        Size::Letter => Paper::Letter,
    };
    let chapters = bank::course();
    let text = text(&chapters, &catalogue, paper)?;
    let file = press.page(text, &[]);
    let file = file.map_err(|why| Failure::new(format!("the course was not printed: {why}")))?;
    files::write(&arguments.out, &file, Access::Usual)?;
    println!(
        "{}: {} chapters, {} kB",
        arguments.out.display(),
        chapters.len(),
        file.len().div_ceil(1000)
    );
    Ok(Outcome::Done)
}

/// The course in the notation of the press.
fn text(
    chapters: &[(&str, &str)],
    catalogue: &bank::Catalogue,
    paper: Paper,
) -> Result<String, Failure> {
    let writer = output::writer("pdf").ok_or_else(|| Failure::new("there is no format `pdf`"))?;
    let run = Run::plain(TITLE, "en", '.').with_paper(paper);
    let pages = Pages::new(writer, run, &[]).map_err(Failure::of)?;
    let texts: Vec<&str> = chapters.iter().map(|(_, text)| *text).collect();
    let body = output::textbook_body(&pages, &texts, catalogue);
    let body = body.map_err(|(place, error)| {
        let name = chapters.get(place).map_or("", |(name, _)| name);
        Failure::new(format!("`{name}`, {error}"))
    })?;
    let begin = pages.begin("").map_err(Failure::of)?;
    let end = pages.end().map_err(Failure::of)?;
    Ok(format!("{begin}{body}{end}"))
}
