//! English.

mod blank;
pub(crate) mod derivation;
mod misfit;
pub(crate) mod picture;
mod unreadable;

pub(crate) use self::blank::blank;
use self::misfit::misfit;

use crate::answer::{
    Close, Coefficient, Decades, Fault, Linearity, Negated, Note, Remark, Scaling, Shape, Slip,
    Term, TermKind, Terms, TwoPi, Verdict,
};
use crate::document::{Block, Document, Inline};
use crate::math::Math;
use crate::message::ByHand;
use crate::unit::DecimalMark;

/// What is said of a remark.
pub(crate) fn say(remark: &Remark) -> Option<Document> {
    Some(Document::sentence(&match remark {
        Remark::Mistake(_) => return None,
        Remark::Option(text) => return Some(text.clone()),
        Remark::Followed(symbols) => return Some(followed(symbols)),
        Remark::Slip(slip) => self::slip(slip),
        Remark::Dimension(misfit) => self::misfit(misfit),
        Remark::Unreadable(unreadable) => unreadable::unreadable(unreadable),
        Remark::Note(note) => self::note(note),
    }))
}

/// What is said of a verdict alone.
pub(crate) fn verdict(verdict: Verdict) -> Document {
    Document::sentence(match verdict {
        Verdict::Right => "Right.",
        Verdict::Partial => "Partly right.",
        Verdict::Wrong => "This is not the answer.",
        Verdict::Unreadable => "This could not be read.",
        Verdict::Missing => "There is no answer.",
    })
}

/// A verdict in short.
pub(crate) fn heading(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Right => "Right",
        Verdict::Partial => "Partly right",
        Verdict::Wrong => "Not right",
        Verdict::Unreadable => "Could not be read",
        Verdict::Missing => "No answer",
    }
}

/// Of an answer that nobody could read yet.
pub(crate) const UNDECIDED: &str = "Not yet decided";

/// What a person did with a response.
pub(crate) fn by_hand(what: &ByHand) -> String {
    match what {
        ByHand::Open => "This part has not been marked yet.".to_owned(),
        ByHand::Marked => "Marked by your teacher.".to_owned(),
        ByHand::ReadAs => "Your teacher read your answer as it was meant:".to_owned(),
        ByHand::Unclear => {
            "The file of responses does not say clearly what was answered here.".to_owned()
        }
        ByHand::Accepted => "Your teacher accepts this answer.".to_owned(),
        ByHand::Shared => "Your teacher gives a share of the points for this answer.".to_owned(),
        ByHand::FullMarks => "All students have the points of this part.".to_owned(),
        ByHand::Rescaled => {
            "This part does not count; the other parts share its points.".to_owned()
        }
        ByHand::LeftOut => "This part does not count.".to_owned(),
        ByHand::Charged { points, is_one } => {
            let noun = if *is_one { "point" } else { "points" };
            format!("A wrong choice costs {points} {noun}.")
        }
        ByHand::Row {
            given: Some(given),
            most,
        } => format!("{given} of {most}: "),
        ByHand::Row { given: None, most } => format!("at most {most}: "),
    }
}

/// A slip in short, by the code of its reason.
pub(crate) fn slip_in_short(code: &str) -> Option<&'static str> {
    Some(match code {
        "dimension" => "wrong dimension",
        "two-pi" => "a factor 2π between angular frequency and frequency",
        "power-of-ten" => "a power of ten or a prefix",
        "sign" => "the sign",
        "near" => "near the key, but outside the tolerance",
        "scale" => "right up to the scale",
        "figures" => "significant figures",
        "angle-unit" => "degrees and radians",
        _ => return None,
    })
}

fn followed(symbols: &[Math]) -> Document {
    let text = |words: &str| Inline::Text(words.to_owned());
    let mut words = vec![text(
        "Counted as a follow-through: it is right for your own ",
    )];
    if symbols.is_empty() {
        words.push(text("equation"));
    }
    for (at, symbol) in symbols.iter().enumerate() {
        match at {
            0 => {}
            at if at + 1 == symbols.len() => words.push(text(" and ")),
            _ => words.push(text(", ")),
        }
        words.push(Inline::Math(symbol.clone()));
    }
    words.push(text("."));
    Document::of(vec![Block::Paragraph(words)], Vec::new())
}

fn note(note: &Note) -> String {
    match note {
        Note::TakenIn(unit) => format!("Taken in {}.", unit.text()),
        Note::TakenAs { taken, other } => {
            format!("This can be read as {taken} or as {other}; it was taken as {taken}.")
        }
        Note::Figures { asked, typed: None } => {
            format!("A decimal with {asked} significant figures is asked for.")
        }
        Note::Figures {
            asked,
            typed: Some((number, has)),
        } => format!("{asked} significant figures are asked for, `{number}` has {has}."),
        Note::JouleForMoment(unit) => {
            format!(
                "The joule is kept for energies: write this in {}.",
                unit.text()
            )
        }
        Note::RightBut(misfit) => format!("Right, but: {}", self::misfit(misfit)),
        Note::LettersCarryUnits(unit) => format!("Letters carry their units: omit `{unit}`."),
        Note::RightTogether => "Right together with the other equations.".to_owned(),
        Note::OthersBelongElsewhere => {
            "Right; the other equations belong to the other parts.".to_owned()
        }
        Note::OtherForm => {
            "Right, but not in the form that is asked for; see the line for the answer.".to_owned()
        }
        Note::WithValues => {
            "Right with the values of this sheet; with letters it holds for all values.".to_owned()
        }
        Note::ByTextbooks => {
            "Right, with symbols that the question does not have as textbooks define them; say what they are."
                .to_owned()
        }
        Note::RoundedNumbers => {
            "Right; its numbers are rounded, and are asked for exactly.".to_owned()
        }
        Note::ConstantsToSpare { needed, found } => {
            format!("Right; {needed} constants would do, this has {found}.")
        }
    }
}

#[expect(clippy::too_many_lines, reason = "a table")]
fn slip(slip: &Slip) -> String {
    match slip {
        Slip::TwoPi(slip) => return two_pi(slip),
        Slip::PowerOfTen(Decades::Function(unit)) => {
            return format!(
                "The digits fit, the power of ten does not: a function in another unit than {} needs its unit.",
                unit.text()
            );
        }
        Slip::AngleUnit(unit) => {
            return format!("The number fits in another unit of angle, not in {}.", unit.text());
        }
        Slip::OutsideInterval(ends) => {
            let [low, high] = **ends;
            return format!(
                "The direction is right; give the angle from {} to {}.",
                low.math(DecimalMark::Point).plain(),
                high.math(DecimalMark::Point).plain()
            );
        }
        Slip::Entries(places) => return entries(places),
        Slip::Shapes(shapes) => {
            let sentences: Vec<String> = shapes.iter().map(shape).collect();
            return sentences.join(" ");
        }
        Slip::Fewer {
            typed,
            found,
            needed,
        } => return fewer(*typed, *found, *needed),
        Slip::Terms(terms) => return self::terms(terms),
        Slip::Counted {
            right,
            of,
            surplus,
            is_order_wrong,
        } => {
            let verb = if *right == 1 { "is" } else { "are" };
            let are_right = format!("{right} of {of} values {verb} right");
            return match surplus {
                Some(given) => format!("{are_right}, but {given} are given."),
                None if *is_order_wrong && right == of => {
                    "The values are right, their order is not.".to_owned()
                }
                None if *is_order_wrong => format!("{are_right}, but in another order."),
                None => format!("{are_right}."),
            };
        }
        Slip::TooFewConstants { found, needed } => {
            return format!(
                "This satisfies the equations, but has {found} of the {needed} free constants of a general solution. A letter of the question counts as its datum."
            );
        }
        Slip::CountedComplex { right, of } => return format!("{right} of {of} are right."),
        Slip::PowerOfTen(Decades::Prefix) => {
            "The digits fit, the power of ten does not: check the prefixes."
        }
        Slip::PowerOfTen(Decades::Percent) => {
            "The digits fit: a value in percent needs its sign, `%`."
        }
        Slip::Sign(negated) => match negated {
            Negated::Whole => "The sign is wrong.",
            Negated::Number => "The magnitude fits, the sign does not.",
            Negated::Angle => "The angle fits with the other sign.",
            Negated::Imaginary => "The sign of the imaginary part is wrong.",
            Negated::Entries => "All signs are reversed.",
        },
        Slip::PhaseInDegrees => {
            "The phase is in degrees: write it in radians, or with the sign °."
        }
        Slip::Near(close) => match close {
            Close::Rounding => {
                "Close, but outside the tolerance: a step was rounded too far, or something small is missing."
            }
            Close::RoundedFormula => {
                "It is nearly right: give the numbers in it exactly, as fractions, roots or multiples of π."
            }
            Close::Function => {
                "With these data it comes near, but as a formula it differs: something small is missing or wrong."
            }
            Close::Ends => {
                "The bounds are right; look again at which of them belong to the interval."
            }
        },
        Slip::Scale(Scaling::First) => {
            "The shape is right; scale it so that its first component is 1."
        }
        Slip::Scale(Scaling::Mass) => "The shape is right; scale it so that its modal mass is 1.",
        Slip::Angle => "The magnitude fits, the angle does not.",
        Slip::UnequalSides => "The sides of this statement are not equal.",
        Slip::NotInteger => "An integer is asked for.",
        Slip::NoValueForData => "This has no value for data for which there is an answer.",
        Slip::NoValueOnSpan => "This has no value somewhere on the span.",
        Slip::NoValueAtTimes => "This has no value at some times.",
        Slip::Zero => "This is zero.",
        Slip::Factor => "It is off by a constant factor: look at each number and at each term.",
        Slip::RunsAway => {
            "It begins as it should, but departs later: look at the frequency and the decay."
        }
        Slip::CommonFactor => "All entries are off by one factor.",
        Slip::OtherOrder => "These are the entries for the coordinates in another order.",
        Slip::Reversed => "The order is right, but it begins at the wrong end.",
        Slip::CountOfIntervals => "Look again at how many intervals there are.",
        Slip::DependentShapes => {
            "These shapes are multiples of one another; independent ones are asked for."
        }
        Slip::NoMotion => "A shape with all components zero is not a motion.",
        Slip::Unsatisfied => {
            "This does not satisfy the equations of motion for all values of its constants."
        }
        Slip::NotGeneral => {
            "This satisfies the equations, but its constants cannot meet every initial state: it is not general."
        }
        Slip::NotFactors => {
            "This satisfies the equations, but each constant has to be a factor of its own or a phase, to meet \
             every initial state."
        }
        Slip::OtherEquation => {
            "This follows from the equations of motion, but it is not the one asked for here, and with \
             the other answers it does not make up all of them."
        }
        Slip::Tautology => "This holds for any motion: it says nothing about this one.",
    }
    .to_owned()
}

fn two_pi(slip: &TwoPi) -> String {
    match slip {
        TwoPi::Formula => "It is off by a factor of 2π.".to_owned(),
        TwoPi::Frequency => {
            "It is off by a factor of 2π: angular frequencies and frequencies in hertz differ by it."
                .to_owned()
        }
        TwoPi::Number => {
            "Off by a factor of 2π: an angular frequency ω in rad/s is 2π times the frequency f in Hz."
                .to_owned()
        }
        TwoPi::Cycles { typed, asked } => format!(
            "Off by a factor of 2π: `{}` counts cycles, the answer is in {}.",
            typed.text(),
            asked.text()
        ),
        TwoPi::Wave => {
            "Off by a factor of 2π: the argument of the sine and the cosine takes the angular frequency ω in rad/s, \
             2π times the frequency f in Hz."
                .to_owned()
        }
    }
}

fn entries(places: &[(usize, usize)]) -> String {
    match places {
        [one] => format!("The entry {} is wrong.", entry(*one)),
        many => {
            let places: Vec<String> = many.iter().map(|place| entry(*place)).collect();
            format!("The entries {} are wrong.", places.join(", "))
        }
    }
}

fn entry((row, column): (usize, usize)) -> String {
    format!("({row}, {column})")
}

fn shape(shape: &Shape) -> String {
    match shape {
        Shape::OfMode { found, asked } => format!(
            "This is the shape of mode {found}, not of mode {asked}; the modes count from the lowest frequency."
        ),
        Shape::Reversed => {
            "The magnitudes fit, but look again at which parts move against each other.".to_owned()
        }
        Shape::Wrong(mode) => format!("The shape of mode {mode} is wrong."),
    }
}

fn fewer(typed: usize, found: usize, needed: usize) -> String {
    if typed > found {
        let verb = if found == 1 { "is" } else { "are" };
        return format!(
            "Right as far as it goes, but of these equations only {found} {verb} independent; {needed} are asked for."
        );
    }
    format!("Right as far as it goes: {needed} independent equations are asked for.")
}

fn terms(terms: &Terms) -> String {
    let mut sentences: Vec<String> = Vec::new();
    if let Some(equation) = terms.equation {
        sentences.push(format!("Equation {equation}:"));
    }
    sentences.extend(
        terms
            .faults
            .iter()
            .map(|(term, fault)| of_term(term, fault)),
    );
    let last = terms.linearity.map(|linearity| match linearity {
        Linearity::Due => {
            "It is right as it stands, but it still has to be linearized for small motions."
        }
        Linearity::Surplus => {
            "This holds for small motions alone; the equation is asked for without that approximation."
        }
        Linearity::WrongForLarge => {
            "It is right for small motions alone: look at how it depends on large ones."
        }
        Linearity::DueBesides if terms.faults.is_empty() => {
            "It is not right yet, and it has to be linearized for small motions as well."
        }
        Linearity::DueBesides => "It has to be linearized for small motions as well.",
    });
    sentences.extend(last.map(str::to_owned));
    sentences.join(" ")
}

fn of_term(term: &Term, fault: &Fault) -> String {
    let name = name(term);
    match fault {
        Fault::Missing => format!("The {name} is missing."),
        Fault::Surplus => format!("There should be no {name}."),
        Fault::Sign => format!("The sign of the {name} is wrong."),
        Fault::Coefficient(Coefficient::Number) => {
            format!("The number in front of the {name} is wrong.")
        }
        Fault::Coefficient(Coefficient::Other) => {
            format!("The coefficient of the {name} is wrong.")
        }
        Fault::Coefficient(Coefficient::Data { missed, surplus }) => {
            let data = |data: &[(String, Option<String>)]| {
                let named = data.iter().map(|(symbol, title)| match title {
                    Some(title) => format!("{symbol} ({title})"),
                    None => symbol.clone(),
                });
                listed(&named.collect::<Vec<_>>())
            };
            match (missed.is_empty(), surplus.is_empty()) {
                (_, true) => format!("The {name} misses {}.", data(missed)),
                (true, false) => format!("The {name} should not contain {}.", data(surplus)),
                (false, false) => format!(
                    "The {name} misses {} and should not contain {}.",
                    data(missed),
                    data(surplus)
                ),
            }
        }
    }
}

fn name(term: &Term) -> String {
    let kind = match term.kind {
        TermKind::Exciting => "exciting term",
        TermKind::Inertia => "inertia term",
        TermKind::Friction => "friction term",
        TermKind::Damping => "damping term",
        TermKind::Stiffness => "stiffness term",
        TermKind::Other => "term",
    };
    match &term.unknown {
        Some(unknown) => format!("{kind} (in {unknown})"),
        None => format!("{kind} without {}", listed(&term.without)),
    }
}

/// Names with commas and a last `and`.
fn listed<T: AsRef<str>>(names: &[T]) -> String {
    super::listed(names, "and")
}
