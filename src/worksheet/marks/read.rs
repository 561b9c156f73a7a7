//! Reading the table.

use super::{Absence, Best, Bound, Direction, Exact, GradeStep, Marks, Rounding};
use crate::diagnostic::{Code, Diagnose, Finding, Label};
use crate::numerics::Rational;
use crate::source::{Data, Span, Table, Value};

/// What is wrong with `[marks]` beyond its form.
#[derive(Clone, Debug, thiserror::Error)]
pub enum MarksError {
    /// An unknown word.
    #[error("`round` cannot be `{0}`")]
    Round(String, Span),
    /// Another unknown word.
    #[error("`absent` cannot be `{0}`")]
    Absent(String, Span),
    /// A direction without a step.
    #[error("`round` says in which direction, and no `step` says to what")]
    NoStep(Span),
    /// Two grades that begin at the same points.
    #[error("`{0}` and `{1}` begin at the same points")]
    SameStep(String, String, Span),
    /// Grades in points beside grades in percent.
    #[error("`scale` has grades in points and grades in percent")]
    Mixed(Span),
    /// Nothing is left for those with few points.
    #[error("no grade begins at 0, so that sheets with few points have none")]
    NoLowest(Span),
    /// A passing mark that is neither a share, nor a number of points, nor a grade of the scale.
    #[error("`pass` is neither a share, nor a number of points, nor a grade of the scale: `{0}`")]
    Pass(String, Option<String>, Span),
    /// A section that has too few questions.
    #[error(
        "{found} questions are in the section `{section}`, of which the best {count} are to count"
    )]
    Section {
        /// The name of the section; empty for the questions that are in none.
        section: String,
        /// How many questions are in it.
        found: usize,
        /// How many of them are to count.
        count: usize,
        /// Where `best` names the section.
        span: Span,
    },
}

impl Diagnose for MarksError {
    fn code(&self) -> Code {
        Code::MARKS
    }

    fn labels(&self) -> Vec<Label> {
        let (Self::Round(_, span)
        | Self::Absent(_, span)
        | Self::NoStep(span)
        | Self::SameStep(_, _, span)
        | Self::Mixed(span)
        | Self::NoLowest(span)
        | Self::Pass(_, _, span)
        | Self::Section { span, .. }) = self;
        vec![Label {
            span: *span,
            text: String::new(),
        }]
    }

    fn help(&self) -> Option<String> {
        Some(match self {
            Self::Round(..) => "it can be nearest, up, down".to_owned(),
            Self::Absent(..) => "it can be left out, zero".to_owned(),
            Self::NoStep(_) => "add a `step`, such as `step = 0.5`".to_owned(),
            Self::SameStep(..) => "give each grade points of its own".to_owned(),
            Self::Mixed(_) => "write all as \"75 %\", or all as points".to_owned(),
            Self::NoLowest(_) => "let the lowest grade begin at 0".to_owned(),
            Self::Pass(_, Some(near), _) => format!("did you mean `{near}`?"),
            Self::Pass(_, None, _) => "write \"50 %\", a number of points, or a grade".to_owned(),
            Self::Section { .. } => {
                "name the section at its questions, `section = \"B\"`, or let fewer count"
                    .to_owned()
            }
        })
    }
}

/// Reads the table; what is wrong is noted with its problems, or returned.
pub(crate) fn read(table: &Table<'_>) -> (Marks, Vec<Finding>) {
    let mut errors = Vec::new();
    let marks = Marks {
        rounding: rounding(table, &mut errors),
        full: positive(table, "full"),
        best: best(table),
        wrong_choice: share(table),
        below_zero: table.boolean("below_zero").unwrap_or(false),
        absent: absent(table, &mut errors),
        scale: scale(table, &mut errors),
        pass: None,
    };
    let pass = table.value("pass");
    let pass = pass.and_then(|value| pass_of(table, value, &marks.scale, &mut errors));
    table.finish_ref();
    let findings = errors.iter();
    let findings = findings.map(|error| Finding::of(error, table.source()));
    (Marks { pass, ..marks }, findings.collect())
}

/// What is wrong with the sections of which the best count, for questions that are in these and not bonus.
pub(crate) fn check(marks: &Marks, sections: &[&str], span: Span) -> Vec<MarksError> {
    let found = |best: &Best| sections.iter().filter(|own| **own == best.section).count();
    let lacking = marks.best.iter().filter(|best| best.count > found(best));
    lacking
        .map(|best| MarksError::Section {
            section: best.section.clone(),
            found: found(best),
            count: best.count,
            span,
        })
        .collect()
}

fn rounding(table: &Table<'_>, errors: &mut Vec<MarksError>) -> Option<Rounding> {
    let step = positive(table, "step");
    let text = table.text("round");
    let direction = match text.as_ref().map(|text| text.value.as_str()) {
        None | Some("nearest") => Direction::Nearest,
        Some("up") => Direction::Up,
        Some("down") => Direction::Down,
        Some(other) => {
            let span = text.as_ref().map_or(Span::NONE, |text| text.span);
            errors.push(MarksError::Round(other.to_owned(), span));
            Direction::Nearest
        }
    };
    if let Some(text) = text.filter(|_| !table.has("step")) {
        errors.push(MarksError::NoStep(text.span));
    }
    step.map(|step| Rounding { step, direction })
}

fn absent(table: &Table<'_>, errors: &mut Vec<MarksError>) -> Absence {
    let text = table.text("absent");
    match text.as_ref().map(|text| text.value.as_str()) {
        None | Some("left out") => Absence::LeftOut,
        Some("zero") => Absence::Zero,
        Some(other) => {
            let span = text.as_ref().map_or(Span::NONE, |text| text.span);
            errors.push(MarksError::Absent(other.to_owned(), span));
            Absence::LeftOut
        }
    }
}

/// A number of points above zero.
fn positive(table: &Table<'_>, key: &'static str) -> Option<Exact> {
    let value = table.value(key)?;
    let number = decimal(value).filter(|number| *number > Rational::ZERO);
    let number = number.or_else(|| table.wrong(key, "a number of points above 0", value));
    number.map(Exact)
}

/// A share of the points of a part that a wrong choice costs.
fn share(table: &Table<'_>) -> Option<Exact> {
    let value = table.value("wrong_choice")?;
    let share = percent(value).or_else(|| decimal(value));
    let share = share.filter(|share| (Rational::ZERO..=Rational::ONE).contains(share));
    let what = "what a wrong choice costs, from 0 to 1 or \"25 %\"";
    share
        .or_else(|| table.wrong("wrong_choice", what, value))
        .map(Exact)
}

/// How many count: a number, or one for each section.
fn best(table: &Table<'_>) -> Vec<Best> {
    let Some(value) = table.value("best") else {
        return Vec::new();
    };
    let of = |section: &str, value: &Value| {
        let count = count_of(value).or_else(|| {
            table.wrong(
                "best",
                "how many questions count, or a table of sections",
                value,
            )
        })?;
        Some(Best {
            section: section.to_owned(),
            count,
        })
    };
    match &value.data {
        Data::Table(entries) => entries
            .iter()
            .filter_map(|entry| of(&entry.key, &entry.value))
            .collect(),
        _ => of("", value).into_iter().collect(),
    }
}

/// How many questions count, if it may be so many.
fn count_of(value: &Value) -> Option<usize> {
    match &value.data {
        Data::Number { number } => number
            .parse()
            .ok()
            .filter(|count| (1..=200).contains(count)),
        _ => None,
    }
}

/// The grades, the best first.
fn scale(table: &Table<'_>, errors: &mut Vec<MarksError>) -> Vec<GradeStep> {
    let Some(value) = table.value("scale") else {
        return Vec::new();
    };
    let Data::Table(entries) = &value.data else {
        return table
            .wrong(
                "scale",
                "a table such as { A = \"80 %\", B = \"0 %\" }",
                value,
            )
            .unwrap_or_default();
    };
    let mut steps: Vec<GradeStep> = Vec::new();
    for entry in entries {
        let from = bound(&entry.value).or_else(|| {
            table.wrong(
                &entry.key,
                "points or a share such as \"75 %\"",
                &entry.value,
            )
        });
        steps.extend(from.map(|from| GradeStep {
            grade: entry.key.clone(),
            from,
        }));
    }
    let shares = steps
        .iter()
        .filter(|step| matches!(step.from, Bound::Share(_)))
        .count();
    if shares != 0 && shares != steps.len() {
        errors.push(MarksError::Mixed(value.span));
        return steps;
    }
    let from = |step: &GradeStep| match step.from {
        Bound::Points(points) | Bound::Share(points) => points,
    };
    steps.sort_by(|a, b| from(b).cmp(&from(a)).then_with(|| a.grade.cmp(&b.grade)));
    for pair in steps
        .windows(2)
        .filter(|pair| from(&pair[0]) == from(&pair[1]))
    {
        let [first, second] = [0, 1].map(|at: usize| pair[at].grade.clone());
        errors.push(MarksError::SameStep(first, second, value.span));
    }
    let lowest = steps.last().map(from);
    if entries.len() == steps.len() && lowest.is_none_or(|lowest| !lowest.0.is_zero()) {
        errors.push(MarksError::NoLowest(value.span));
    }
    steps
}

/// What passes: a share, points, or a grade of the scale.
fn pass_of(
    table: &Table<'_>,
    value: &Value,
    scale: &[GradeStep],
    errors: &mut Vec<MarksError>,
) -> Option<Bound> {
    if let Some(bound) = bound(value) {
        return Some(bound);
    }
    let Data::Text(grade) = &value.data else {
        return table.wrong(
            "pass",
            "a share such as \"50 %\", points, or a grade",
            value,
        );
    };
    if let Some(step) = scale.iter().find(|step| step.grade == *grade) {
        return Some(step.from);
    }
    let names = scale.iter().map(|step| step.grade.as_str());
    let near = crate::source::nearest(grade, names).map(str::to_owned);
    errors.push(MarksError::Pass(grade.clone(), near, value.span));
    None
}

/// Points as a number, or a share as a text with a per cent sign.
fn bound(value: &Value) -> Option<Bound> {
    let points = decimal(value).filter(|points| *points >= Rational::ZERO);
    points
        .map(|points| Bound::Points(Exact(points)))
        .or_else(|| Some(Bound::Share(Exact(percent(value)?))))
}

fn decimal(value: &Value) -> Option<Rational> {
    match &value.data {
        Data::Number { number } => Rational::from_decimal(number),
        _ => None,
    }
}

/// `"75 %"` as a share from 0 to 1.
fn percent(value: &Value) -> Option<Rational> {
    let Data::Text(text) = &value.data else {
        return None;
    };
    let number = text.trim().strip_suffix('%')?.trim();
    let share = Rational::from_decimal(number)?.checked_div(Rational::from(100))?;
    (Rational::ZERO..=Rational::ONE)
        .contains(&share)
        .then_some(share)
}
