//! A session: exercises part by part, answers, hints, solutions.

use vibank::answer::{Marking, Verdict};
use vibank::bank::{Part, Passage};
use vibank::grade::{self, Grade};
use vibank::message::Language;
use vibank::scene::{Data, Scene, Shown};
use vibank::solution::Solution;
use vibank::worksheet::{headings, letter};

use super::log::Log;
use crate::cli::screen::{Screen, Tone};
use crate::cli::{Failure, counted};

/// A session and what came out so far.
pub(crate) struct Session {
    screen: Screen,
    log: Log,
    right: usize,
    right_at_once: usize,
    asked: usize,
    /// Whether what comes before the solutions of the parts of this exercise is still to be shown.
    is_principle_due: bool,
}

/// Where to go on after a part or an exercise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SessionEnd {
    Part,
    Exercise,
    Session,
}

/// What was typed.
enum TypedLine {
    Answer(String),
    Hint,
    Solution,
    Pass,
    PassExercise,
    Help,
    Nothing,
    Quit,
}

/// How the student can go on; every answer is possible but these.
const HELP: &str = "? hint   ! answer and solution   > next part   >> next exercise   quit";

impl Session {
    pub(crate) fn begin(screen: Screen, log: Log) -> Self {
        Self {
            screen,
            log,
            right: 0,
            right_at_once: 0,
            asked: 0,
            is_principle_due: true,
        }
    }

    pub(crate) fn welcome(&self, items: usize, seed: u64) {
        let exercises = counted(items, "exercise");
        let words = format!("{exercises} to choose from (session {seed}). Type your answer, or:");
        self.screen.say(Tone::Faint, "", &words);
        self.screen.say(Tone::Faint, "  ", HELP);
    }

    pub(crate) fn finish(&self) {
        if self.asked > 0 {
            let words = format!(
                "{} of {} right, {} of them at once.",
                self.right,
                counted(self.asked, "part"),
                self.right_at_once
            );
            Screen::gap();
            self.screen.say(Tone::Bold, "", &words);
        }
    }

    /// Asks an exercise part by part, marks what is typed, and shows the solution.
    pub(crate) fn exercise(&mut self, solution: &Solution<'_>) -> Result<SessionEnd, Failure> {
        let template = solution.template();
        let scene = Scene::of(solution, Data::Both).in_words();
        self.is_principle_due = !template.solution.is_empty();
        Screen::gap();
        self.screen.say(Tone::Bold, "", &template.about.title);
        self.screen
            .say(Tone::Faint, "", &solution.instance().identity());
        Screen::gap();
        self.screen
            .say(Tone::Plain, "", &text(&scene.passage(&template.statement)));
        let mut answered: Vec<(usize, String)> = Vec::new();
        let asked: Vec<usize> = (0..template.parts.len())
            .filter(|place| solution.asks(*place))
            .collect();
        for (heading, place) in headings(template, &asked).iter().zip(asked.iter().copied()) {
            if let Some((letter, group)) = heading.opened() {
                Screen::gap();
                let words = format!("{letter}) {}", passage(&scene, &group.text));
                self.screen.say(Tone::Plain, "", &words);
            }
            self.question(&scene, &heading.letter, place);
            if template.parts[place].answer.kind().is_by_hand() {
                self.work(&scene, &template.parts[place], place)?;
                continue;
            }
            match self.part(&scene, &heading.letter, place, &mut answered)? {
                SessionEnd::Part => {}
                SessionEnd::Exercise => return Ok(SessionEnd::Exercise),
                SessionEnd::Session => return Ok(SessionEnd::Session),
            }
        }
        Ok(SessionEnd::Exercise)
    }

    fn question(&self, scene: &Scene<'_, '_>, own: &str, place: usize) {
        let solution = scene.solution();
        let part = &solution.template().parts[place];
        let options = part.answer.options();
        Screen::gap();
        let words = crate::cli::show::called(own, scene, part);
        self.screen.say(Tone::Plain, "", &words);
        let order = solution.order(place).into_iter().enumerate();
        for (at, option) in order.filter(|_| !options.is_empty()) {
            let words = format!(
                "{}  {}",
                letter(at),
                options[option].text.plain(&Vec::new())
            );
            self.screen.say(Tone::Plain, "   ", &words);
        }
        let line = crate::cli::show::answer_line(scene, place);
        self.screen.say(Tone::Faint, "   ", &line);
    }

    /// One part, until it is right or passed.
    fn part(
        &mut self,
        scene: &Scene<'_, '_>,
        letter: &str,
        place: usize,
        answered: &mut Vec<(usize, String)>,
    ) -> Result<SessionEnd, Failure> {
        let solution = scene.solution();
        let part = &solution.template().parts[place];
        let (mut hints, mut attempts) = (0, 0);
        loop {
            match self.read(letter)? {
                TypedLine::Nothing => {}
                TypedLine::Help => self.screen.say(Tone::Faint, "   ", HELP),
                TypedLine::Hint => hints = self.hint(scene, part, hints),
                TypedLine::Pass => return Ok(SessionEnd::Part),
                TypedLine::PassExercise => return Ok(SessionEnd::Exercise),
                TypedLine::Quit => return Ok(SessionEnd::Session),
                TypedLine::Solution => {
                    self.solution(scene, part, place);
                    self.asked += usize::from(attempts == 0);
                    return Ok(SessionEnd::Part);
                }
                TypedLine::Answer(response) => {
                    let earlier = answered.iter().map(|(place, own)| (*place, own.as_str()));
                    let grade = Grade::mark(solution, earlier.chain([(place, response.as_str())]));
                    let marking = grade.part(place).expect("the response was marked");
                    self.log
                        .note(solution.instance(), &part.id, &response, marking, hints)?;
                    self.feedback(solution, place, marking);
                    if marking.verdict == Verdict::Unreadable {
                        continue;
                    }
                    self.asked += usize::from(attempts == 0);
                    attempts += 1;
                    answered.retain(|(own, _)| *own != place);
                    answered.push((place, response));
                    if marking.verdict == Verdict::Right {
                        self.right += 1;
                        self.right_at_once += usize::from(attempts == 1 && hints == 0);
                        return Ok(SessionEnd::Part);
                    }
                }
            }
        }
    }

    /// Work on paper, which the student compares with the solution: it counts for nothing.
    fn work(&mut self, scene: &Scene<'_, '_>, part: &Part, place: usize) -> Result<(), Failure> {
        let words =
            "Do it on paper; it is not marked here. Enter shows the solution to compare with.";
        self.screen.say(Tone::Faint, "   ", words);
        self.screen.ask("> ")?;
        self.solution(scene, part, place);
        for row in part.answer.rubric() {
            let words = format!(
                "{}: {}",
                grade::rounded(row.points),
                row.text.plain(&Vec::new()).trim()
            );
            self.screen.say(Tone::Plain, "     ", &words);
        }
        Ok(())
    }

    fn feedback(&self, solution: &Solution<'_>, place: usize, marking: &Marking) {
        let (tone, sign) = match marking.verdict {
            Verdict::Right => (Tone::Good, "✓"),
            Verdict::Partial => (Tone::Unsure, "◐"),
            Verdict::Wrong => (Tone::Bad, "✗"),
            Verdict::Unreadable | Verdict::Missing => (Tone::Unsure, "?"),
        };
        if let Some(reading) = &marking.reading {
            let words = format!("read as {}", reading.math.plain());
            self.screen.say(Tone::Faint, "   ", &words);
        }
        self.screen.say(
            tone,
            "   ",
            &format!("{sign} {}", Language::English.heading(marking.verdict)),
        );
        if !marking.remarks.is_empty() {
            for remark in grade::remarks(solution, place, marking, Language::English) {
                self.screen.say(Tone::Plain, "     ", &remark.plain());
            }
        }
    }

    /// The next hint; how many were given.
    fn hint(&self, scene: &Scene<'_, '_>, part: &Part, given: usize) -> usize {
        match part.hints.get(given) {
            Some(hint) => {
                let count = part.hints.len();
                let words = format!("hint {} of {count}: {}", given + 1, passage(scene, hint));
                self.screen.say(Tone::Plain, "   ", &words);
                given + 1
            }
            None => {
                let words = "There are no more hints; `!` shows the answer.";
                self.screen.say(Tone::Faint, "   ", words);
                given
            }
        }
    }

    fn solution(&mut self, scene: &Scene<'_, '_>, part: &Part, place: usize) {
        match scene.key(place) {
            Ok(Some(key)) => {
                let words = format!("= {}", key.plain());
                self.screen.say(Tone::Bold, "   ", &words);
            }
            Ok(None) => {}
            Err(_) if part.answer.kind().is_by_hand() => {}
            Err(absent) => self.screen.say(Tone::Plain, "   ", &absent.to_string()),
        }
        if std::mem::take(&mut self.is_principle_due) {
            let principle = passage(scene, &scene.solution().template().solution);
            self.screen.say(Tone::Plain, "   ", &principle);
        }
        for worked in part.worked() {
            self.screen.say(Tone::Plain, "   ", &passage(scene, worked));
        }
    }

    fn read(&self, letter: &str) -> Result<TypedLine, Failure> {
        let Some(text) = self.screen.ask(&format!("{letter}> "))? else {
            return Ok(TypedLine::Quit);
        };
        Ok(match text.as_str() {
            "" => TypedLine::Nothing,
            "?" | "hint" => TypedLine::Hint,
            "!" | "solution" => TypedLine::Solution,
            ">" | "next" | "skip" => TypedLine::Pass,
            ">>" => TypedLine::PassExercise,
            "help" => TypedLine::Help,
            "quit" | "exit" | ":q" => TypedLine::Quit,
            answer => TypedLine::Answer(answer.to_owned()),
        })
    }
}

fn passage(scene: &Scene<'_, '_>, passage: &Passage) -> String {
    text(&scene.passage(passage))
}

fn text(shown: &[Shown<'_>]) -> String {
    let pieces = shown
        .iter()
        .map(|piece| piece.document.plain(&piece.fillings).trim_end().to_owned());
    pieces.collect::<Vec<_>>().join("\n\n")
}
