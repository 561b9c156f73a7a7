//! What a page asks, and the replies.

use std::rc::Rc;

use serde::Serialize;
use serde_json::{Map, Value as Json};

use super::Grader;
use super::question::{Insertion, ShownOption, asked, figure, html, insertions, options, shape};
use crate::answer::{Choosing, Credit, Marking, Reason, Verdict};
use crate::bank::{Passage, Template};
use crate::grade::{self, Grade, Sheet};
use crate::math::Display;
use crate::scene::Run;
use crate::seed::Variant;
use crate::solution::Solution;
use crate::source::{Fields, FromJson, Misfit, named};
use crate::worksheet::{Heading, headings};

/// What a page asks of the grader; a question is its place on the page, a code that of a variant.
pub(crate) enum Request {
    /// A variant that is fit to be asked.
    Choose { question: usize, from: u64 },
    /// The statement and what is asked.
    Show { question: usize, code: String },
    /// How a response is read.
    Read {
        question: usize,
        code: String,
        part: String,
        response: String,
    },
    /// The marks of a response.
    Mark {
        question: usize,
        code: String,
        part: String,
        response: String,
        earlier: Map<String, Json>,
    },
    /// The hint of this number, from 0.
    Hint {
        question: usize,
        code: String,
        part: String,
        number: usize,
    },
    /// The key and the worked solution of a part.
    Solve {
        question: usize,
        code: String,
        part: String,
    },
    /// The system in motion; the first of the motions that it has, or that of a number.
    Move {
        question: usize,
        code: String,
        run: usize,
    },
}

/// What is asked for.
#[derive(Clone, Copy)]
enum Do {
    Choose,
    Show,
    Read,
    Mark,
    Hint,
    Solve,
    Move,
}

named!(Do, "`choose`, `show`, `read`, `mark`, `hint`, `solve` or `move`", {
    "choose" => Choose,
    "show" => Show,
    "read" => Read,
    "mark" => Mark,
    "hint" => Hint,
    "solve" => Solve,
    "move" => Move,
});

impl FromJson for Request {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        let mut fields = Fields::of(json)?;
        let what = fields.take("do")?;
        let question = fields.take("question")?;
        let request = match what {
            Do::Choose => Self::Choose {
                question,
                from: fields.take("from")?,
            },
            Do::Show => Self::Show {
                question,
                code: fields.take("code")?,
            },
            Do::Read => Self::Read {
                question,
                code: fields.take("code")?,
                part: fields.take("part")?,
                response: fields.take("response")?,
            },
            Do::Mark => Self::Mark {
                question,
                code: fields.take("code")?,
                part: fields.take("part")?,
                response: fields.take("response")?,
                earlier: fields.optional("earlier")?.unwrap_or_default(),
            },
            Do::Hint => Self::Hint {
                question,
                code: fields.take("code")?,
                part: fields.take("part")?,
                number: fields.take("number")?,
            },
            Do::Solve => Self::Solve {
                question,
                code: fields.take("code")?,
                part: fields.take("part")?,
            },
            Do::Move => Self::Move {
                question,
                code: fields.take("code")?,
                run: fields.take("run")?,
            },
        };
        fields.finish()?;
        Ok(request)
    }
}

/// What is replied, a variant for each request.
#[derive(Serialize)]
#[serde(untagged)]
pub(crate) enum Reply {
    Chosen {
        code: String,
    },
    Shown {
        identity: String,
        statement: String,
        parts: Vec<ShownPart>,
    },
    /// A response while it is typed, whatever the key: as it is read, and the other reading where there is a doubt.
    Read {
        reading: String,
        #[serde(skip_serializing_if = "Option::is_none")]
        other: Option<String>,
    },
    /// Why it cannot be read.
    Unread {
        problem: String,
    },
    Marked {
        verdict: Verdict,
        credit: Credit,
        reading: Option<String>,
        si: Option<Vec<f64>>,
        reasons: Vec<String>,
        feedback: String,
    },
    Hint {
        html: String,
    },
    Solved {
        key: String,
        /// The right options of a choice.
        right: Vec<String>,
        html: String,
        /// Whether the system can be shown in motion.
        #[serde(skip_serializing_if = "std::ops::Not::not")]
        moves: bool,
    },
    Moved(Box<Moved>),
    /// A request that cannot be answered.
    Refused {
        error: String,
    },
}

/// A motion of the system, picture by picture.
#[derive(Serialize)]
pub(crate) struct Moved {
    /// All that can be shown, by kind, `start`, `steady` or `mode` with a number.
    runs: Vec<(&'static str, usize)>,
    /// What does not move, with a group for the rest, and what the group holds.
    svg: String,
    frames: Vec<String>,
    seconds: f64,
    symbols: Vec<String>,
    shares: Vec<Vec<f64>>,
    turns: Vec<(String, usize, String)>,
}

/// A group as it is shown before its first blank.
#[derive(Serialize)]
pub(crate) struct ShownGroup {
    letter: String,
    ask: String,
}

/// A part as it is shown.
#[derive(Serialize)]
pub(crate) struct ShownPart {
    id: String,
    /// The identities that it had, under which a page may have kept answers.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    was: Vec<String>,
    letter: String,
    /// The group that begins with it.
    #[serde(skip_serializing_if = "Option::is_none")]
    group: Option<ShownGroup>,
    kind: &'static str,
    ask: String,
    lead: Option<String>,
    unit: Option<String>,
    /// What its answer line says.
    asked: String,
    insertions: Vec<Insertion>,
    hints: usize,
    choosing: Option<&'static str>,
    options: Vec<ShownOption>,
    rows: Option<usize>,
    columns: Option<usize>,
}

/// An instance of a question that is being asked about.
struct AskedInstance<'g> {
    grader: &'g Grader,
    solution: Rc<Solution<'static>>,
    /// The parts that are asked, as places in the item.
    parts: Vec<usize>,
}

/// Answers a request.
pub(crate) fn reply(grader: &Grader, request: &Request) -> Result<Reply, String> {
    match request {
        Request::Choose { question, from } => {
            let variant = grader.choose(*question, *from)?;
            Ok(Reply::Chosen {
                code: variant.to_string(),
            })
        }
        Request::Show { question, code } => Ok(AskedInstance::of(grader, *question, code)?.show()),
        Request::Read {
            question,
            code,
            part,
            response,
        } => AskedInstance::of(grader, *question, code)?.read(part, response),
        Request::Mark {
            question,
            code,
            part,
            response,
            earlier,
        } => AskedInstance::of(grader, *question, code)?.mark(part, response, earlier),
        Request::Hint {
            question,
            code,
            part,
            number,
        } => AskedInstance::of(grader, *question, code)?.hint(part, *number),
        Request::Solve {
            question,
            code,
            part,
        } => AskedInstance::of(grader, *question, code)?.solve(part),
        Request::Move {
            question,
            code,
            run,
        } => AskedInstance::of(grader, *question, code)?.moving(*run),
    }
}

impl<'g> AskedInstance<'g> {
    fn of(grader: &'g Grader, number: usize, code: &str) -> Result<Self, String> {
        let variant: Variant = code.parse().map_err(|error| format!("`{code}`: {error}"))?;
        let solution = grader.solution(number, variant)?;
        let parts = asked(grader.question(number)?.0, &solution);
        Ok(Self {
            grader,
            solution,
            parts,
        })
    }

    fn template(&self) -> &'static Template {
        self.solution.template()
    }

    /// The place of a part in the item.
    fn place(&self, id: &str) -> Result<usize, String> {
        let parts = &self.template().parts;
        let place = self.parts.iter().find(|place| parts[**place].has_id(id));
        place
            .copied()
            .ok_or_else(|| format!("`{id}` is not asked here"))
    }

    fn texts(&self, passage: &'static Passage) -> String {
        html(
            &self.grader.scene(&self.solution).passage(passage),
            self.grader.voice(),
        )
    }

    fn show(&self) -> Reply {
        let template = self.template();
        let headings = headings(template, &self.parts);
        let parts = headings.iter().zip(&self.parts);
        Reply::Shown {
            identity: self.solution.instance().identity(),
            statement: self.texts(&template.statement) + &self.figure(),
            parts: parts.map(|(own, place)| self.part(own, *place)).collect(),
        }
    }

    /// The figure after the statement, where the statement does not place it itself.
    fn figure(&self) -> String {
        let template = self.template();
        if template.statement.places_figure() {
            return String::new();
        }
        let picture = self.grader.scene(&self.solution).picture();
        picture.map_or_else(String::new, |picture| {
            figure(&picture, &template.caption, self.grader.voice())
        })
    }

    fn part(&self, heading: &Heading<'static>, place: usize) -> ShownPart {
        let part = &self.template().parts[place];
        let scene = self.grader.scene(&self.solution);
        let blank = part.answer.blank();
        let unit = blank.unit_behind();
        let voice = self.grader.voice();
        let said = self.grader.language().blank(&blank);
        let (rows, columns) = shape(part, self.template()).unzip();
        ShownPart {
            id: part.id.clone(),
            was: part.was.clone(),
            letter: heading.letter.clone(),
            group: heading.opened().map(|(letter, group)| ShownGroup {
                letter: letter.to_owned(),
                ask: self.texts(&group.text),
            }),
            kind: part.answer.kind().name(),
            ask: self.texts(&part.ask),
            lead: scene
                .lead(place)
                .map(|math| math.mathml(Display::Inline, voice)),
            unit: unit.map(|unit| unit.math().mathml(Display::Inline, voice)),
            asked: said.html(&Vec::new(), voice),
            insertions: insertions(&blank, voice),
            hints: part.hints.len(),
            choosing: part.answer.choosing().map(Choosing::name),
            options: options(&self.solution, place, voice),
            rows,
            columns,
        }
    }

    fn read(&self, id: &str, response: &str) -> Result<Reply, String> {
        let place = self.place(id)?;
        Ok(match grade::echo(&self.solution, place, response) {
            Ok(echo) => Reply::Read {
                reading: echo
                    .reading
                    .math
                    .mathml(Display::Inline, self.grader.voice()),
                other: echo
                    .other
                    .map(|other| other.mathml(Display::Inline, self.grader.voice())),
            },
            Err(why) => Reply::Unread {
                problem: self.feedback(place, &Marking::unreadable(why)),
            },
        })
    }

    fn mark(&self, id: &str, response: &str, earlier: &Map<String, Json>) -> Result<Reply, String> {
        let place = self.place(id)?;
        let mut responses = vec![(place, response)];
        for (part, response) in earlier {
            if let (Ok(before), Some(response)) = (self.place(part), response.as_str())
                && before < place
            {
                responses.push((before, response));
            }
        }
        let share = self.grader.practice.other_form;
        let sheet = Sheet {
            asked: &self.parts,
            other_form: share.and_then(|share| Credit::read(&share.to_string())),
        };
        let grade = Grade::mark_on(&self.solution, &sheet, responses);
        let marking = grade.part(place).ok_or("the part was not marked")?;
        let reading = marking.reading.as_ref();
        Ok(Reply::Marked {
            verdict: marking.verdict,
            credit: marking.credit,
            reading: reading
                .map(|reading| reading.math.mathml(Display::Inline, self.grader.voice())),
            si: reading.map(|reading| reading.answered.si()),
            reasons: marking.reasons().iter().map(Reason::code).collect(),
            feedback: self.feedback(place, marking),
        })
    }

    fn feedback(&self, place: usize, marking: &Marking) -> String {
        grade::remarks(&self.solution, place, marking, self.grader.language())
            .iter()
            .map(|remark| remark.document.html(&remark.fillings, self.grader.voice()))
            .collect()
    }

    fn hint(&self, id: &str, number: usize) -> Result<Reply, String> {
        let part = &self.template().parts[self.place(id)?];
        let hint = part.hints.get(number);
        let hint = hint.ok_or_else(|| format!("`{id}` has no hint {number}"))?;
        Ok(Reply::Hint {
            html: self.texts(hint),
        })
    }

    fn solve(&self, id: &str) -> Result<Reply, String> {
        let place = self.place(id)?;
        let part = &self.template().parts[place];
        let key = match self.solution.marker(place).map(|marker| marker.key()) {
            Ok(key) => Some(key),
            Err(_) if part.answer.kind().is_by_hand() => None,
            Err(absent) => return Err(absent.to_string()),
        };
        let right = match key.as_ref().map(|key| &key.value) {
            Some(crate::answer::KeyValue::Options { ids, .. }) => ids.clone(),
            _ => Vec::new(),
        };
        // What comes before the solutions of the parts stands with the first of them.
        let before = if self.parts.first() == Some(&place) {
            self.texts(&self.template().solution)
        } else {
            String::new()
        };
        let moves = self.template().figure.as_ref();
        Ok(Reply::Solved {
            moves: moves.is_some_and(|figure| figure.moves()),
            key: key.map_or_else(String::new, |key| {
                let math = self.grader.language().formula(&key.math);
                math.mathml(Display::Inline, self.grader.voice())
            }),
            right,
            html: part
                .worked()
                .fold(before, |html, passage| html + &self.texts(passage)),
        })
    }

    fn moving(&self, number: usize) -> Result<Reply, String> {
        let scene = self.grader.scene(&self.solution);
        let runs = scene.runs();
        let run = runs.get(number).copied();
        let moving = run.and_then(|run| scene.moving(run, "moving"));
        let moving = moving.ok_or("it does not move for these data")?;
        // Three decimals are finer than a pixel of the trace.
        let short = |share: f64| (share * 1e3).round() / 1e3;
        let shares = moving.shares.into_iter();
        Ok(Reply::Moved(Box::new(Moved {
            runs: runs
                .iter()
                .map(|run| match run {
                    Run::Start => ("start", 0),
                    Run::Steady => ("steady", 0),
                    Run::Mode(mode) => ("mode", mode + 1),
                })
                .collect(),
            svg: moving.film.svg,
            frames: moving.film.frames,
            seconds: moving.seconds,
            symbols: moving
                .symbols
                .iter()
                .map(|symbol| symbol.mathml(Display::Inline, self.grader.voice()))
                .collect(),
            shares: shares
                .map(|own| own.into_iter().map(short).collect())
                .collect(),
            turns: moving
                .turns
                .into_iter()
                .map(|(time, place, value)| {
                    (
                        time,
                        place,
                        value.mathml(Display::Inline, self.grader.voice()),
                    )
                })
                .collect(),
        })))
    }
}
