//! What the boxes of a platform hold of a question: for each part the ranges or options that it is marked by, or why there
//! are none. All formats begin here.

use super::Unfit;
use crate::answer::{AnswerKind, Band, Choosing, KeyValue};
use crate::bank::Group;
use crate::numerics::Rational;
use crate::scene::Scene;
use crate::worksheet::{SheetQuestion, headings};

/// A part of a question.
#[derive(Clone, Debug)]
pub(crate) struct HeldPart<'t> {
    /// What it is called: `a`, or `c2` for a blank of a group.
    pub(crate) letter: String,
    /// The group whose blank it is.
    pub(crate) group: Option<&'t Group>,
    /// Whether what its group has in common is shown before it.
    pub(crate) opens: bool,
    /// Its place in the item.
    pub(crate) place: usize,
    /// The points that can be reached.
    pub(crate) points: Rational,
    /// Whether a person marks it wherever it is asked.
    is_by_hand: bool,
}

/// How a part is marked.
pub(crate) enum Held {
    /// For each number that is asked its ranges, of which the first that fits counts.
    Numbers(Vec<Vec<Band>>),
    /// The options in the order of the sheet, one of which is right.
    Choice(Vec<Choosable>),
}

/// An option.
pub(crate) struct Choosable {
    /// Its place among the options of the item.
    pub(crate) place: usize,
    pub(crate) is_right: bool,
}

/// The parts of a question, sorted.
#[derive(Default)]
pub(crate) struct Sorted<'t> {
    /// Those that a platform marks.
    pub(crate) fit: Vec<(HeldPart<'t>, Held)>,
    /// Those that it cannot mark.
    pub(crate) unfit: Vec<HeldPart<'t>>,
}

impl<'t> HeldPart<'t> {
    /// The letter of its group.
    pub(crate) fn group_letter(&self) -> &str {
        self.letter
            .trim_end_matches(|sign: char| sign.is_ascii_digit())
    }

    /// The same as a question of its own.
    pub(crate) fn alone(&self) -> Self {
        Self {
            opens: true,
            ..self.clone()
        }
    }

    /// The group that is begun with it.
    pub(crate) fn opened(&self) -> Option<&'t Group> {
        self.group.filter(|_| self.opens)
    }

    /// Whether it is a blank of the group of another part.
    fn is_beside(&self, other: &HeldPart<'_>) -> bool {
        self.group.is_some() && self.group_letter() == other.group_letter()
    }
}

impl Held {
    /// How many boxes it takes.
    pub(crate) fn boxes(&self) -> usize {
        match self {
            Self::Numbers(values) => values.len(),
            Self::Choice(_) => 1,
        }
    }
}

impl<'t> Sorted<'t> {
    /// Sorts the parts of a question; what does not fit is added to a list, each once.
    pub(crate) fn of(
        scene: &Scene<'_, 't>,
        question: &SheetQuestion<'t>,
        unfit: &mut Vec<Unfit>,
    ) -> Self {
        let template = scene.solution().template();
        let mut sorted = Self::default();
        let parts = question.parts.iter().zip(&question.points);
        let headings = headings(template, &question.parts);
        for (heading, (place, points)) in headings.into_iter().zip(parts) {
            let mut asked = HeldPart {
                letter: heading.letter,
                group: heading.group,
                opens: true,
                place: *place,
                points: *points,
                is_by_hand: template.parts[*place].answer.kind().is_by_hand(),
            };
            match held(scene, *place) {
                Ok(held) => {
                    let before = sorted.fit.last();
                    asked.opens = before.is_none_or(|(before, _)| !asked.is_beside(before));
                    sorted.fit.push((asked, held));
                }
                Err(reason) => {
                    let found = Unfit {
                        item: template.id.as_str().to_owned(),
                        part: template.parts[*place].id.clone(),
                        reason,
                    };
                    if !asked.is_by_hand && !unfit.contains(&found) {
                        unfit.push(found);
                    }
                    let before = sorted.unfit.last();
                    asked.opens = before.is_none_or(|before| !asked.is_beside(before));
                    sorted.unfit.push(asked);
                }
            }
        }
        sorted
    }

    /// Those that become essays: what a person marks anyway, and where it is wished all that do not fit.
    pub(crate) fn essays(&self, all: bool) -> Vec<HeldPart<'t>> {
        let essays = self.unfit.iter();
        essays
            .filter(|asked| all || asked.is_by_hand)
            .cloned()
            .collect()
    }

    /// The letters of the boxes, in order: where a part has several, its letter comes as often.
    pub(crate) fn letters(&self) -> String {
        let letters = self
            .fit
            .iter()
            .flat_map(|(asked, held)| std::iter::repeat_n(asked.letter.clone(), held.boxes()));
        letters.collect::<Vec<_>>().join(" ")
    }

    /// The weight of each box of each part: integers in the ratio of the points.
    pub(crate) fn weights(&self) -> Vec<u64> {
        let shares: Vec<(u64, u64)> = self
            .fit
            .iter()
            .map(|(asked, held)| {
                let whole = |part: i128| u64::try_from(part).unwrap_or(1);
                let bottom = whole(asked.points.denominator()) * held.boxes().max(1) as u64;
                (whole(asked.points.numerator()), bottom)
            })
            .collect();
        let common = shares.iter().fold(1, |common, (_, bottom)| {
            common / gcd(common, *bottom) * bottom
        });
        let whole: Vec<u64> = shares
            .iter()
            .map(|(top, bottom)| top * (common / bottom))
            .collect();
        let divisor = whole.iter().copied().fold(0, gcd).max(1);
        whole.iter().map(|own| own / divisor).collect()
    }
}

/// How a part is marked, or why a platform cannot mark it.
fn held(scene: &Scene<'_, '_>, place: usize) -> Result<Held, &'static str> {
    let solution = scene.solution();
    let part = &solution.template().parts[place];
    match part.answer.kind() {
        AnswerKind::Choice => match part.answer.choosing() {
            Some(Choosing::Ranking) => Err("an order of options"),
            Some(Choosing::Several) => {
                Err("several options, whose marks differ from those of platforms")
            }
            _ => Ok(Held::Choice(options(scene, place))),
        },
        AnswerKind::Numeric | AnswerKind::Integer => {
            let marker = solution
                .marker(place)
                .map_err(|_| "a key that does not exist for some data")?;
            let bands = marker.bands();
            if bands.is_empty() {
                return Err("complex numbers, or numbers in any order");
            }
            Ok(Held::Numbers(bands))
        }
        AnswerKind::Formula => Err("a formula"),
        AnswerKind::Equation => Err("an equation"),
        AnswerKind::Function => Err("a function"),
        AnswerKind::Matrix => Err("a matrix"),
        AnswerKind::ModeShape => Err("mode shapes"),
        AnswerKind::Interval => Err("an interval"),
        AnswerKind::Work => Err("work on paper"),
    }
}

/// The options of a choice in the order of the sheet.
fn options(scene: &Scene<'_, '_>, place: usize) -> Vec<Choosable> {
    let solution = scene.solution();
    let options = solution.template().parts[place].answer.options();
    let right = match solution.key(place).map(|key| &key.value) {
        Ok(KeyValue::Options { ids, .. }) => ids.clone(),
        _ => Vec::new(),
    };
    let option = |place: usize| Choosable {
        place,
        is_right: right.contains(&options[place].id),
    };
    solution.order(place).into_iter().map(option).collect()
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}
