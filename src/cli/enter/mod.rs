//! `vibank enter MANIFEST`

mod journal;

use std::path::{Path, PathBuf};

use vibank::answer::Marking;
use vibank::grade;
use vibank::message::Language;
use vibank::scene::{Data, Scene};
use vibank::seed::Variant;
use vibank::solution::Solution;
use vibank::source::nearest;
use vibank::worksheet::{Manifest, PartEntry, VariantEntry};

use self::journal::{Journal, Place};
use super::bank::BankArgument;
use super::grade::{RunItems, manifest, solution};
use super::screen::{Screen, Tone};
use super::{Failure, Outcome, counted, file_kind, show};

/// Type the answers on paper sheets into a file that `vibank grade` takes, sheet by sheet.
///
/// Type the code of a sheet, then its answers, a line each; each is shown as it is read, and nothing is marked.
/// An empty line leaves an answer as it is, `<` goes back, `-` takes an answer away, `>>` ends the sheet, `quit` ends.
/// Each answer is kept as soon as it is typed: start it again to go on.
///
/// Example: vibank enter midterm/manifest.json
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The manifest of the run, or its folder.
    #[arg(value_parser = file_kind::manifest())]
    manifest: PathBuf,
    /// The file of answers; `entered.json` beside the manifest if left out.
    #[arg(short, long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Show codes alone, no names and ids.
    #[arg(long)]
    anonymous: bool,
    #[command(flatten)]
    bank: BankArgument,
}

/// How one can go on.
const HELP: &str = "empty: next   < back   - no answer   >> next sheet   quit";

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let catalogue = arguments.bank.catalogue()?;
    let manifest = manifest(&arguments.manifest)?;
    let beside = arguments.manifest.parent().unwrap_or(Path::new("."));
    let out = arguments.out.clone();
    let out = out.unwrap_or_else(|| beside.join("entered.json"));
    let journal = Journal::open(&out)?;
    let mut desk = Desk {
        items: RunItems::of(std::slice::from_ref(&manifest.items), &catalogue, false),
        screen: Screen::of_stdout(),
        manifest: &manifest,
        is_anonymous: arguments.anonymous,
        journal,
    };
    desk.welcome();
    let result = desk.sheets();
    // Whatever has stopped it, the file has all that was typed.
    desk.journal.write()?;
    result?;
    desk.finish(&out);
    Ok(Outcome::Done)
}

/// What lies before whoever types.
struct Desk<'a> {
    screen: Screen,
    manifest: &'a Manifest,
    is_anonymous: bool,
    items: RunItems<'a>,
    journal: Journal,
}

/// Where to go on.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Next {
    Sheet,
    End,
}

impl Desk<'_> {
    fn welcome(&self) {
        let (known, all) = (self.journal.sheets(), self.manifest.variants.len());
        let words = format!("{known} of {all} sheets have answers. Type a code, then its answers:");
        self.screen.say(Tone::Faint, "", &words);
        self.screen.say(Tone::Faint, "  ", HELP);
    }

    fn finish(&self, out: &Path) {
        let (known, all) = (self.journal.sheets(), self.manifest.variants.len());
        Screen::gap();
        let words = format!("{known} of {all} sheets have answers, in {}", out.display());
        self.screen.say(Tone::Bold, "", &words);
    }

    fn sheets(&mut self) -> Result<(), Failure> {
        loop {
            Screen::gap();
            let Some(typed) = self.screen.ask("code> ")? else {
                return Ok(());
            };
            match typed.as_str() {
                "" => {}
                "quit" | "exit" | ":q" => return Ok(()),
                "help" | "?" => self.screen.say(Tone::Faint, "  ", HELP),
                code => {
                    let Some(sheet) = self.find(code) else {
                        continue;
                    };
                    let next = self.sheet(sheet)?;
                    self.journal.write()?;
                    if next == Next::End {
                        return Ok(());
                    }
                }
            }
        }
    }

    /// The sheet of a code; if there is none, it says why.
    fn find(&self, typed: &str) -> Option<usize> {
        let variants = &self.manifest.variants;
        let code = typed.parse::<Variant>();
        // The code as it is printed, whatever was typed: without hyphens, in small letters, with an O for a
        // zero.
        let shown = code
            .as_ref()
            .map_or_else(|_| typed.to_uppercase(), ToString::to_string);
        let found = variants.iter().position(|variant| variant.code == shown);
        if found.is_some() {
            return found;
        }
        let why = match code {
            Ok(_) => format!("{shown} is not a sheet of this run"),
            Err(error) => error.to_string(),
        };
        let near = nearest(&shown, variants.iter().map(|variant| variant.code.as_str()));
        let near = near.map_or_else(String::new, |near| format!("; did you mean {near}?"));
        self.screen.say(Tone::Bad, "   ", &format!("{why}{near}"));
        None
    }

    fn sheet(&mut self, at: usize) -> Result<Next, Failure> {
        let sheet = &self.manifest.variants[at];
        let parts: usize = sheet
            .questions
            .iter()
            .map(|question| question.parts.len())
            .sum();
        let known = self.journal.of(&sheet.code);
        let known = match known {
            0 => String::new(),
            _ => format!(", {known} answered before"),
        };
        let whose = if self.is_anonymous {
            String::new()
        } else {
            who(sheet)
        };
        let words = format!("{whose}{}{known}", counted(parts, "part"));
        self.screen.say(Tone::Faint, "   ", &words);
        let solutions: Vec<Solution<'_>> = sheet
            .questions
            .iter()
            .map(|question| {
                let head = self.manifest;
                solution(&self.items, question, head.decimal, head.doubt)
            })
            .collect::<Result<_, _>>()?;
        let places: Vec<(usize, usize)> = sheet
            .questions
            .iter()
            .enumerate()
            .flat_map(|(question, own)| (0..own.parts.len()).map(move |part| (question, part)))
            .collect();
        let mut next = 0;
        while let Some((question, part)) = places.get(next).copied() {
            let entry = &sheet.questions[question];
            let place = Place {
                code: sheet.code.clone(),
                question: entry.number,
                part: entry.parts[part].letter.clone(),
            };
            let asked = AskedPart {
                place: &place,
                solution: &solutions[question],
                part: &entry.parts[part],
            };
            let Some(typed) = self.screen.ask(&asked.prompt(self.journal.get(&place)))? else {
                return Ok(Next::End);
            };
            match typed.as_str() {
                "" | ">" => next += 1,
                "<" => next = next.saturating_sub(1),
                ">>" => break,
                "quit" | "exit" | ":q" => return Ok(Next::End),
                "help" => self.screen.say(Tone::Faint, "   ", HELP),
                "-" => {
                    self.journal.set(place, String::new())?;
                    next += 1;
                }
                response => {
                    asked.echo(&self.screen, response);
                    self.journal.set(place, response.to_owned())?;
                    next += 1;
                }
            }
        }
        Ok(Next::Sheet)
    }
}

/// Whose sheet it is, as far as the class list says.
fn who(sheet: &VariantEntry) -> String {
    let Some(student) = &sheet.student else {
        return String::new();
    };
    let words = ["name", "id"]
        .into_iter()
        .filter_map(|name| student.get(name));
    let words: Vec<&str> = words
        .map(String::as_str)
        .filter(|word| !word.is_empty())
        .collect();
    format!("{}: ", words.join(", "))
}

/// A part that is asked for.
struct AskedPart<'a, 't> {
    place: &'a Place,
    solution: &'a Solution<'t>,
    part: &'a PartEntry,
}

impl AskedPart<'_, '_> {
    /// `1a ωₙ = … rad/s [5.2]> `, with what was typed before.
    fn prompt(&self, known: Option<&str>) -> String {
        let Place { question, part, .. } = self.place;
        let scene = Scene::of(self.solution, Data::Both).in_words();
        let place = self.solution.template().place(&self.part.id);
        let line = place.map_or_else(String::new, |place| show::answer_line(&scene, place));
        let known = known.map_or_else(String::new, |known| {
            let known: String = known.chars().filter(|char| !char.is_control()).collect();
            format!(" [{known}]")
        });
        format!("{question}{part}  {line}{known}> ")
    }

    /// How a response is read, or that it cannot be.
    fn echo(&self, screen: &Screen, response: &str) {
        let Some(place) = self.solution.template().place(&self.part.id) else {
            return;
        };
        // Points are read when all is marked.
        if self.solution.template().parts[place]
            .answer
            .kind()
            .is_by_hand()
        {
            return;
        }
        match grade::echo(self.solution, place, response) {
            Ok(echo) => {
                let other = echo.other.map(|other| format!(", or as {}", other.plain()));
                let reading = echo.reading.math.plain();
                let words = format!("read as {reading}{}", other.unwrap_or_default());
                screen.say(Tone::Faint, "      ", &words);
            }
            Err(why) => {
                screen.say(Tone::Unsure, "      ", "could not be read; kept as it is");
                let marking = Marking::unreadable(why);
                for remark in grade::remarks(self.solution, place, &marking, Language::English) {
                    screen.say(Tone::Plain, "      ", &remark.plain());
                }
            }
        }
    }
}
