//! The author's proof: an item's known results, and the two routes to each of its quantities.
//!
//! A known result is a response that has to be right, and a number in it has to agree to half a unit
//! of its last written digit. A quantity with a second route has to agree with it over many draws.

use super::Solution;
use crate::answer::{AnswerKind, KeyValue, Verdict, complex_number};
use crate::bank::{Check, Expected, Template, Units};
use crate::diagnostic::{Code, Diagnose, Finding, Label};
use crate::expr::{Form, Name, Precise, Shape, Undefined, Value};
use crate::instance::{Instance, InstanceError};
use crate::numerics::Complex;
use crate::quantity::{Absent, Evaluation, NodeId};
use crate::response::{Folded, Passage};
use crate::seed::Seed;
use crate::source::Span;
use crate::unit::{Decimal, Quantity, Unit};
use crate::work;

/// What does not agree with the item.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
enum Disproof {
    #[error("`{id}` comes out as {found}, expected {expected}")]
    Number {
        id: String,
        expected: String,
        found: String,
        after: String,
    },
    #[error("`{id}` gives {found} numbers, expected {expected}")]
    Count {
        id: String,
        expected: usize,
        found: usize,
    },
    #[error("`{id}` has no value for these data: {reason}")]
    Absent { id: String, reason: String },
    #[error("this response to `{id}` is {verdict}, expected right")]
    Response {
        id: String,
        verdict: &'static str,
        after: String,
    },
    #[error("`{id}` cannot be checked by this: {reason}")]
    Unreadable { id: String, reason: String },
    #[error("the data of this check cannot be set: {0}")]
    Data(String),
    #[error("`{quantity}` is {first} by its formula and {second} by its `verify`, for seed {seed}")]
    Routes {
        item: String,
        quantity: String,
        first: f64,
        second: f64,
        seed: u64,
    },
    #[error("{reason}")]
    Draws { reason: String },
    #[error("`{label}`: {reason}")]
    Steps { label: String, reason: String },
    #[error("checking this item over {seeds} draws takes more than {limit} million steps")]
    Work { limit: u64, seeds: u64 },
}

/// Numbers of two routes agree within this share of their size, beyond their error bounds.
const ROUNDING: f64 = 1e-9;
/// Times at which two functions are compared, in seconds.
const TIMES: [f64; 8] = [0.0, 0.001, 0.011, 0.13, 0.37, 1.1, 1.9, 5.3];

/// What of an item's known results does not hold.
fn known_results(template: &Template) -> Vec<Finding> {
    let mut findings = Vec::new();
    for check in &template.checks {
        let set: Vec<(String, String)> = check
            .given
            .iter()
            .map(|(place, value)| {
                let name = template.parameters[*place].name.to_string();
                (name, value.to_string())
            })
            .collect();
        let set: Vec<(&str, &str)> = set
            .iter()
            .map(|(name, value)| (name.as_str(), value.as_str()))
            .collect();
        let solution = Instance::of(template, None, &set).map(Solution::of);
        for expected in &check.expect {
            let result = match &solution {
                Ok(solution) => compare(solution, check, expected),
                Err(error) => Err(Disproof::Data(error.to_string())),
            };
            findings.extend(
                result
                    .err()
                    .map(|error| at(&error, template, expected.response.span)),
            );
        }
    }
    findings
}

/// All that disproves an item, over this many draws.
///
/// The work is bounded as a whole; where an item takes more, a finding says so in place of what was found with it.
pub fn findings(template: &Template, seeds: u64) -> Vec<Finding> {
    let limit = MAX_WORK.max(seeds.saturating_mul(WORK_OF_A_SEED));
    let found = work::within(limit, || {
        let mut findings = known_results(template);
        findings.extend(data(template));
        findings.extend(values(template));
        findings.extend(routes(template, seeds));
        findings
    });
    if found.is_exhausted {
        let limit = limit / 1_000_000;
        return vec![at(&Disproof::Work { limit, seeds }, template, Span::NONE)];
    }
    found.value
}

/// Units of work of a check: a second or two, of which an item that comes with the program takes a hundredth.
const MAX_WORK: u64 = 100_000_000;

/// Units of work that each draw of a longer check adds.
const WORK_OF_A_SEED: u64 = 500_000;

/// Whether data can be drawn at all, or a constraint never holds.
fn data(template: &Template) -> Option<Finding> {
    let error = Instance::draw(template, Seed::new(0)).err()?;
    let place = match &error {
        InstanceError::Constraints { broken, .. } => broken.first().map_or(Span::NONE, |worst| {
            definition(template, &Name::new(&*worst.0))
        }),
        _ => Span::NONE,
    };
    let reason = error.to_string();
    Some(at(&Disproof::Draws { reason }, template, place))
}

/// What takes too long for the data of the source, also where it is a mistake, which would be left out in silence.
fn values(template: &Template) -> Vec<Finding> {
    let evaluation = Instance::of_source(template).evaluation();
    let is_bound = |reason| matches!(reason, Undefined::TooLong | Undefined::NoConvergence);
    let too_long = |node: NodeId| match evaluation.value(node) {
        Err(Absent::Undefined { label, absence }) if is_bound(absence.reason) => {
            Some(Disproof::Steps {
                label: label.to_string(),
                reason: absence.to_string(),
            })
        }
        _ => None,
    };
    // What is computed after the one that took all would be blamed for it.
    let first = template.graph.ids().find_map(too_long);
    first
        .iter()
        .map(|error| at(error, template, Span::NONE))
        .collect()
}

/// Where the two routes to a quantity differ, over this many draws: each quantity once.
fn routes(template: &Template, seeds: u64) -> Vec<Finding> {
    let mut doubted: Vec<NodeId> = Vec::new();
    let mut findings = Vec::new();
    for seed in 0..seeds {
        let Ok(instance) = Instance::draw(template, Seed::new(seed)) else {
            break;
        };
        let evaluation = instance.evaluation();
        for (node, info) in &template.quantities {
            let Some(verify) = info.verify else { continue };
            if doubted.contains(node) {
                continue;
            }
            if let Some(Difference { first, second, .. }) =
                differ(&evaluation, *node, verify).filter(|difference| difference.share > ROUNDING)
            {
                doubted.push(*node);
                let quantity = info.name.to_string();
                let error = Disproof::Routes {
                    item: template.id.to_string(),
                    quantity,
                    first,
                    second,
                    seed,
                };
                findings.push(at(&error, template, definition(template, &info.name)));
            }
        }
    }
    findings
}

/// Where a quantity is declared: the line that begins with its name.
fn definition(template: &Template, name: &Name) -> Span {
    let text = &*template.source.text;
    let name = name.as_str();
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let rest = line
            .strip_prefix(name)
            .or_else(|| line.strip_prefix("[quantities.")?.strip_prefix(name));
        if rest.is_some_and(|rest| rest.trim_start().starts_with(['=', ']'])) {
            return Span::new(start, start + line.trim_end().len());
        }
        start += line.len();
    }
    Span::NONE
}

/// The finding at this place of the file.
fn at(error: &Disproof, template: &Template, place: Span) -> Finding {
    let mut finding = Finding::of(error, &template.source);
    for label in &mut finding.labels {
        label.span = place;
    }
    finding
}

fn compare(solution: &Solution<'_>, check: &Check, expected: &Expected) -> Result<(), Disproof> {
    let id = expected.id.value.as_str();
    let template = solution.template();
    let part = template.place(id);
    let node = template.graph.find(&Name::new(id));
    let quantity = node
        .and_then(|node| Some((node, template.info(node)?)))
        .filter(|(_, info)| info.units.is_some());
    let is_integer =
        part.is_some_and(|place| template.parts[place].answer.kind() == AnswerKind::Integer);
    if let (Some((node, info)), Some(written), false) =
        (quantity, written(&expected.response.value), is_integer)
        && let Some(found) = numbers(solution.evaluation(), node, &check.at)
    {
        let found = found.map_err(|absent| Disproof::Absent {
            id: id.to_owned(),
            reason: absent.to_string(),
        })?;
        return agree(id, check, &written, &found, info.units.as_ref());
    }
    if let Some((node, info)) = quantity
        && let Some(Units::One(unit)) = &info.units
        && let Ok(value) = solution.evaluation().value(node)
        && value.form() == Form::COMPLEX
        && let Some(written) = complex_number(&expected.response.value, unit)
    {
        return agree_in_the_plane(check, expected, written, value.entry(0), unit);
    }
    let Some(place) = part else {
        return Err(Disproof::Unreadable {
            id: id.to_owned(),
            reason: "it is not a number, and no part asks for it".to_owned(),
        });
    };
    respond(solution, place, check, expected)
}

/// Both parts of a complex number agree to half a unit of the coarsest digit that is written.
fn agree_in_the_plane(
    check: &Check,
    expected: &Expected,
    written: Complex,
    found: Complex,
    unit: &Unit,
) -> Result<(), Disproof> {
    let text = &expected.response.value;
    let numbers = text.split(|sign: char| !sign.is_ascii_digit() && sign != '.');
    let places =
        numbers.filter_map(|number| Some(Decimal::parse(number).ok()?.last_place().to_f64()));
    let half = 0.5 * unit.to_si(places.fold(0.0, f64::max));
    let off = written - found;
    if off.re.abs().max(off.im.abs()) <= half {
        return Ok(());
    }
    Err(Disproof::Number {
        id: expected.id.value.clone(),
        expected: text.clone(),
        found: format!("{} + {}i in SI units", found.re, found.im),
        after: check.source.clone(),
    })
}

/// The response has to be right; of a number also its last digit.
fn respond(
    solution: &Solution<'_>,
    place: usize,
    check: &Check,
    expected: &Expected,
) -> Result<(), Disproof> {
    let id = &expected.id.value;
    let marker = solution.marker(place).map_err(|absent| Disproof::Absent {
        id: id.clone(),
        reason: absent.to_string(),
    })?;
    let part = &solution.template().parts[place];
    if let (KeyValue::Numbers { si, .. }, Some(written)) =
        (marker.key().value, written(&expected.response.value))
        && part.answer.kind() == AnswerKind::Numeric
        && si.len() == written.len()
    {
        let found: Vec<Complex> = si.iter().map(|number| Complex::new(*number, 0.0)).collect();
        let units = part.answer.unit().map(Units::One);
        agree(id, check, &written, &found, units.as_ref())?;
    }
    let folded = Folded::of(&expected.response.value);
    let typed = folded.as_ref().map_or(Passage::default(), Folded::passage);
    match marker.mark(typed).verdict {
        Verdict::Right => Ok(()),
        verdict => Err(Disproof::Response {
            id: id.clone(),
            verdict: verdict.name(),
            after: check.source.clone(),
        }),
    }
}

/// The numbers of a quantity: of a function one for each time; `None` for what is not a number.
fn numbers(
    evaluation: &Evaluation<'_>,
    node: NodeId,
    at: &[Precise],
) -> Option<Result<Vec<Complex>, Absent>> {
    let variables = evaluation.graph().variables(node);
    if variables.is_empty() {
        return Some(evaluation.value(node).map(entries));
    }
    if variables.iter().any(|name| name.as_str() != "t") {
        return None;
    }
    Some(evaluation.function(node).and_then(|function| {
        let values = at.iter().map(|time| function.at(&[*time]));
        let values = values.collect::<Result<Vec<_>, _>>()?;
        Ok(values.iter().flat_map(entries).collect())
    }))
}

fn entries(value: &Value) -> Vec<Complex> {
    let count = match value.shape() {
        Shape::Scalar => 1,
        Shape::Vector(length) => length,
        Shape::Matrix(rows, columns) => rows * columns,
    };
    (0..count).map(|position| value.entry(position)).collect()
}

/// The numbers of an expected value with their unit: `20 rad/s`, `[1, 2] m`, `[[1, 0], [0, 1]] kg`.
fn written(text: &str) -> Option<Vec<Quantity>> {
    let text = text.trim();
    if let Some(parts) = complex(text) {
        return Some(parts);
    }
    if !text.starts_with('[') {
        return Quantity::parse(text).ok().map(|single| vec![single]);
    }
    let (list, unit) = text.split_at(text.rfind(']')? + 1);
    let unit = match unit.trim() {
        "" => Unit::ONE,
        unit => Unit::parse(unit).ok()?,
    };
    let pieces = list.split(['[', ']', ',']).map(str::trim);
    pieces
        .filter(|piece| !piece.is_empty())
        .map(|piece| Some(Quantity::new(Decimal::parse(piece).ok()?, unit)))
        .collect()
}

/// Real and imaginary part of `3 - 4i ohm`.
fn complex(text: &str) -> Option<Vec<Quantity>> {
    let place = text.find('i')?;
    let (number, unit) = (&text[..place], text[place + 1..].trim());
    if !number.ends_with(|last: char| last.is_ascii_digit()) {
        return None;
    }
    let unit = if unit.is_empty() {
        Unit::ONE
    } else {
        Unit::parse(unit).ok()?
    };
    let sign = number.rfind(['+', '-']).unwrap_or(0);
    let (re, im) = number.split_at(sign);
    let part = |text: &str| {
        let text = text.replace(' ', "");
        let decimal = Decimal::parse(text.trim_start_matches('+')).ok()?;
        Some(Quantity::new(decimal, unit))
    };
    let re = if re.trim().is_empty() { "0" } else { re };
    Some(vec![part(re)?, part(im)?])
}

/// Each number agrees to half a unit of its last written digit.
fn agree(
    id: &str,
    check: &Check,
    written: &[Quantity],
    found: &[Complex],
    units: Option<&Units>,
) -> Result<(), Disproof> {
    // A complex number is written as two.
    let pair = match found {
        [single] if written.len() == 2 => [Complex::from(single.re), Complex::from(single.im)],
        _ => [Complex::from(0.0); 2],
    };
    let found = if found.len() == 1 && written.len() == 2 {
        &pair[..]
    } else {
        found
    };
    if written.len() != found.len() {
        return Err(Disproof::Count {
            id: id.to_owned(),
            expected: written.len(),
            found: found.len(),
        });
    }
    for (position, (written, found)) in written.iter().zip(found).enumerate() {
        let declared = match units {
            Some(Units::One(unit)) => *unit,
            Some(Units::Each(units)) => units.get(position).copied().unwrap_or(Unit::ONE),
            None => Unit::ONE,
        };
        let unit = if written.unit.is_one() {
            declared
        } else {
            written.unit
        };
        let si = |value: Decimal| {
            Quantity::new(value, unit)
                .si_for(&declared)
                .map_err(|error| Disproof::Unreadable {
                    id: id.to_owned(),
                    reason: error.to_string(),
                })
        };
        let (expected, last) = (si(written.value)?, si(written.value.last_place())?);
        // The last digit may have been rounded either way, and the unit's factor rounds too.
        let slack = 0.500_001 * last.abs() + 4.0 * f64::EPSILON * expected.abs();
        if (found.re - expected).abs() > slack || found.im.abs() > slack {
            let unit = declared.coherent();
            let shown = |number: f64| format!("{number} {unit}").trim_end().to_owned();
            return Err(Disproof::Number {
                id: id.to_owned(),
                expected: shown(expected),
                found: shown(found.re),
                after: check.source.clone(),
            });
        }
    }
    Ok(())
}

/// How far the two routes to each quantity of an instance differ, as a share of its greatest number.
pub(crate) fn disagreements<'s>(
    solution: &'s Solution<'_>,
) -> impl Iterator<Item = (&'s Name, f64)> {
    let quantities = solution.template().quantities.iter();
    quantities.filter_map(|(node, info)| {
        let difference = differ(solution.evaluation(), *node, info.verify?)?;
        Some((&info.name, difference.share))
    })
}

/// Two numbers that should be equal.
struct Difference {
    first: f64,
    second: f64,
    /// Their difference by the size of what is compared.
    share: f64,
}

/// The two numbers in which two routes differ most; what does not exist is not compared.
fn differ(evaluation: &Evaluation<'_>, first: NodeId, second: NodeId) -> Option<Difference> {
    let times = TIMES.map(|time| Precise::new(time, 0.0, 0.0));
    let values = |node| numbers(evaluation, node, &times).and_then(Result::ok);
    let (first, second) = (values(first)?, values(second)?);
    if first.len() != second.len() {
        return None;
    }
    let size = first
        .iter()
        .chain(&second)
        .fold(0.0_f64, |size, number| size.max(number.abs()));
    let share = |a: Complex, b: Complex| {
        let difference = (a - b).abs();
        if difference == 0.0 {
            0.0
        } else {
            difference / size
        }
    };
    let apart = |sign: f64| {
        let pairs = first.iter().zip(&second);
        pairs
            .map(|(a, b)| Difference {
                first: a.re,
                second: b.re,
                share: share(*a, *b * sign),
            })
            .max_by(|a, b| a.share.total_cmp(&b.share))
    };
    // Shapes are compared up to their sign.
    let is_shape = first.len() > 1;
    let (same, opposite) = (apart(1.0)?, apart(-1.0)?);
    Some(if is_shape && opposite.share < same.share {
        opposite
    } else {
        same
    })
}

impl Diagnose for Disproof {
    fn code(&self) -> Code {
        match self {
            Self::Routes { .. } => Code::CHECK_ROUTES,
            Self::Draws { .. } => Code::CHECK_DRAWS,
            Self::Steps { .. } | Self::Work { .. } => Code::SIZE,
            _ => Code::CHECK_EXPECTED,
        }
    }

    fn labels(&self) -> Vec<Label> {
        let text = match self {
            Self::Number { after, .. } | Self::Response { after, .. } => {
                format!("after {after}")
            }
            _ => String::new(),
        };
        let span = Span::NONE;
        vec![Label { span, text }]
    }

    fn help(&self) -> Option<String> {
        let help = match self {
            Self::Number { .. } | Self::Response { .. } => {
                "mend the formula, or the expected value if the source is wrong, and say so in `notes`"
            }
            Self::Count { .. } => {
                "give one number for each entry, for a function one for each time in `at`"
            }
            Self::Absent { .. } => "give data in `given` for which it exists",
            Self::Unreadable { .. } => "give a number with its unit, or a response to a part",
            Self::Draws { .. } => {
                "widen the constraints, or the ranges of the parameters that stand in them"
            }
            Self::Steps { .. } | Self::Work { .. } => {
                "write integrals and roots in closed form, or keep them out of each other and away from singular ends"
            }
            Self::Data(_) => "give each parameter a value that it can have",
            Self::Routes {
                item,
                quantity,
                seed,
                ..
            } => {
                return Some(format!(
                    "compare both for these data: `vibank solve {item} --seed {seed} --want {quantity}`"
                ));
            }
        };
        Some(help.to_owned())
    }
}
