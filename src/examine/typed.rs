//! Answers as a student types them: numbers in the unit that is printed, rounded; functions and formulas in letters.

use crate::answer::{AnswerKind, KeyValue};
use crate::bank::{MistakeAnswer, Template};
use crate::expr::{
    Expr, Field, Kind, Name, Relation, Shape, Substitution, Value, differentiate, fold,
};
use crate::numerics::Rational;
use crate::quantity::{Evaluation, Graph, Method, NodeId};
use crate::response::Passage;
use crate::solution::Solution;
use crate::unit::{Decimal, Unit};

/// A value in the unit of an answer, each number rounded to this many figures.
pub(crate) fn value(value: &Value, unit: Option<Unit>, figures: u32) -> Option<String> {
    let behind = unit.map_or(String::new(), |unit| format!(" {unit}"));
    let own = unit.unwrap_or(Unit::ONE);
    let number = |si: f64| rounded(own.of_si(si), figures);
    if value.form().field == Field::Complex {
        let all: Option<Vec<String>> = (0..value.shape().len())
            .map(|at| {
                let entry = value.entry(at);
                let (re, im) = (number(entry.re)?, number(entry.im.abs())?);
                let sign = if entry.im < 0.0 { '-' } else { '+' };
                Some(format!("({re} {sign} {im}i){behind}"))
            })
            .collect();
        return Some(all?.join("; "));
    }
    let numbers = value.numbers().iter().map(|si| number(*si));
    let numbers = numbers.collect::<Option<Vec<String>>>()?;
    Some(match value.shape() {
        Shape::Matrix(_, columns) => {
            let rows = numbers
                .chunks(columns)
                .map(|row| format!("[{}]", row.join(", ")));
            format!("[{}]{behind}", rows.collect::<Vec<_>>().join(", "))
        }
        _ => {
            let each = numbers.iter().map(|number| format!("{number}{behind}"));
            each.collect::<Vec<_>>().join("; ")
        }
    })
}

/// The components of mode shapes.
fn shapes(value: &Value, figures: u32) -> Option<String> {
    let numbers = value.numbers().iter().map(|si| rounded(*si, figures));
    let numbers = numbers.collect::<Option<Vec<String>>>()?;
    let width = match value.shape() {
        Shape::Matrix(_, columns) => columns,
        shape => shape.len(),
    };
    let each = numbers
        .chunks(width.max(1))
        .map(|shape| format!("({})", shape.join(", ")));
    Some(each.collect::<Vec<_>>().join("; "))
}

fn rounded(number: f64, figures: u32) -> Option<String> {
    if number == 0.0 {
        return Some("0".to_owned());
    }
    Decimal::rounded(number, figures).map(|decimal| decimal.to_string())
}

/// A named mistake for these data, in the ways in which it may be typed; the first that can be read is taken.
pub(crate) fn mistake(solution: &Solution<'_>, place: usize, number: usize) -> Vec<String> {
    let template = solution.template();
    let part = &template.parts[place];
    let Some(mistaken) = solution.mistaken(place, number) else {
        return Vec::new();
    };
    let figures = part.answer.figures();
    let kind = part.answer.kind();
    if let Some(kept) = part.answer.kept_mistake(number) {
        return vec![without_units(&kept)];
    }
    if let Some(typed) = solution
        .marker(place)
        .ok()
        .and_then(|marker| marker.typed_mistake(number))
    {
        return vec![typed];
    }
    match (kind, &part.mistakes[number].answer) {
        (AnswerKind::Function, MistakeAnswer::Formulas(nodes)) => {
            let node = nodes.first().copied();
            let typed = node.and_then(|node| function(solution.evaluation(), node, None, FINE));
            typed.into_iter().collect()
        }
        (AnswerKind::Function, MistakeAnswer::Replaced(replaced)) => {
            let evaluation = solution.evaluation();
            let with = replaced
                .iter()
                .map(|(old, new)| Some((*old, evaluation.value(*new).ok()?.clone())));
            let with: Option<Vec<_>> = with.collect();
            let other = with.map(|with| evaluation.replacing(with));
            let key = part.answer.keys().first().copied();
            let typed = other
                .zip(key)
                .and_then(|(other, key)| function(&other, key, None, FINE));
            typed.into_iter().collect()
        }
        (AnswerKind::Formula | AnswerKind::Matrix, MistakeAnswer::Formulas(nodes)) => {
            let graph = &template.graph;
            nodes
                .iter()
                .flat_map(|node| letters(graph, &formula(graph, *node)))
                .collect()
        }
        (AnswerKind::Formula, MistakeAnswer::Replaced(replaced)) => {
            let graph = &template.graph;
            let key = part.answer.keys().first().and_then(|key| graph.expr(*key));
            let put = replaced
                .iter()
                .map(|(old, new)| (Name::new(graph.label(*old)), formula(graph, *new)));
            let put = put.fold(Substitution::new(), |put, (name, expr)| {
                put.with(name, expr)
            });
            let inlined =
                key.map(|key| inlined(graph, key, &|name| put_has(replaced, graph, name)));
            let changed = inlined.and_then(|key| put.apply(&key).ok());
            changed.map_or(Vec::new(), |changed| letters(graph, &changed))
        }
        _ => {
            let Some(given) = mistaken.values.first() else {
                return Vec::new();
            };
            let ways = match (kind, mistaken.unit) {
                (AnswerKind::ModeShape, _) => vec![shapes(given, FINE)],
                (AnswerKind::Integer, _) => vec![value(given, None, 12)],
                // What is given in another unit is typed without one, or with the wrong one.
                (_, Some(unit)) => {
                    let numbers = given.numbers().iter().map(|si| unit.of_si(*si)).collect();
                    let bare = Value::new(given.form(), numbers, given.bounds().to_vec());
                    vec![
                        bare.and_then(|bare| value(&bare, None, figures)),
                        value(given, Some(unit), figures),
                    ]
                }
                (_, None) => vec![value(given, part.answer.unit(), figures)],
            };
            ways.into_iter().flatten().collect()
        }
    }
}

fn put_has(replaced: &[(NodeId, NodeId)], graph: &Graph, name: &Name) -> bool {
    replaced
        .iter()
        .any(|(old, _)| graph.label(*old) == name.as_str())
}

/// The formula of a node; that of a datum is its name.
fn formula(graph: &Graph, node: NodeId) -> Expr {
    graph
        .expr(node)
        .cloned()
        .unwrap_or_else(|| Expr::name(graph.label(node)))
}

/// A text in which numbers have no units, `1[m]`, which serve the check of dimensions and nobody types.
fn without_units(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(at) = rest.find('[') {
        let is_behind_number = rest[..at].ends_with(|last: char| last.is_ascii_digit());
        let end = rest[at..].find(']').map(|end| at + end + 1);
        match end.filter(|_| is_behind_number) {
            Some(end) => {
                out.push_str(&rest[..at]);
                rest = &rest[end..];
            }
            None => {
                out.push_str(&rest[..=at]);
                rest = &rest[at + 1..];
            }
        }
    }
    out.push_str(rest);
    out
}

/// Figures of what has to be distinguished from the key by itself, not by its rounding.
pub(crate) const FINE: u32 = 7;

/// A formula as it stands, and in data alone.
fn letters(graph: &Graph, expr: &Expr) -> Vec<String> {
    let in_data = inlined(graph, expr, &|_| false);
    let mut all = vec![
        without_units(&expr.to_string()),
        without_units(&in_data.to_string()),
    ];
    all.retain(|text| is_typable(text));
    all.dedup();
    all
}

/// Whether there is nothing in a formula that no student types.
fn is_typable(text: &str) -> bool {
    ![
        "if ", "floor(", "ceil(", "model.", "models.", "at(", "root(",
    ]
    .iter()
    .any(|word| text.contains(word))
}

/// A formula with those of quantities in place of their names, but for those to keep.
fn inlined(graph: &Graph, expr: &Expr, keep: &dyn Fn(&Name) -> bool) -> Expr {
    let mut expr = expr.clone();
    for _ in 0..MAX_STEPS {
        let names = expr.names().free;
        let put: Vec<(Name, Expr)> = names
            .iter()
            .filter(|variable| variable.order == 0 && !keep(&variable.name))
            .filter_map(|variable| {
                let node = graph.find(&variable.name)?;
                Some((variable.name.clone(), graph.expr(node)?.clone()))
            })
            .collect();
        if put.is_empty() {
            break;
        }
        let put = put
            .into_iter()
            .fold(Substitution::new(), |put, (name, own)| put.with(name, own));
        match put.apply(&expr) {
            Ok(changed) => expr = changed,
            Err(_) => break,
        }
    }
    expr
}

/// No chain of quantities that is worth typing is longer.
const MAX_STEPS: usize = 20;

/// A function of time with rounded numbers in SI units for everything but functions; `method` may take its formula
/// wrongly. None where nobody can type it.
pub(crate) fn function(
    evaluation: &Evaluation<'_>,
    key: NodeId,
    method: Option<&Method>,
    figures: u32,
) -> Option<String> {
    let graph = evaluation.graph();
    let writing = Writing {
        evaluation,
        own: &|node| match method.filter(|method| method.step == node) {
            Some(method) => method.formula().or(graph.expr(node)),
            None => graph.expr(node),
        },
        figures,
    };
    let expr = writing.written((writing.own)(key)?, 0)?;
    let text = without_measures(&expr).to_string();
    is_typable(&text).then_some(text)
}

/// How a function of time is written out for these data.
struct Writing<'e, 'g> {
    evaluation: &'e Evaluation<'g>,
    /// The formula of a quantity.
    own: &'e dyn Fn(NodeId) -> Option<&'e Expr>,
    figures: u32,
}

impl Writing<'_, '_> {
    /// A formula with numbers for data, with the formulas of functions, of cases the one that the data choose, and with
    /// its derivatives carried out: what is left is a function of time alone. None where it is nothing of this kind.
    fn written(&self, expr: &Expr, depth: usize) -> Option<Expr> {
        let graph = self.evaluation.graph();
        let inside = |inner: &Expr| self.written(inner, depth);
        match expr.kind() {
            _ if depth > MAX_STEPS => None,
            Kind::Name(name) => match graph.find(name) {
                Some(node) if graph.variables(node).is_empty() => {
                    number(self.evaluation.real(node).ok()?, self.figures)
                }
                Some(node) => self.written((self.own)(node)?, depth + 1),
                None => Some(expr.clone()),
            },
            Kind::Prime(inner, order) => std::iter::repeat_n(TIME, usize::from(*order))
                .fold(inside(inner), |inner, time| {
                    differentiate(&inner?, time).ok()
                }),
            Kind::Diff(inner, by) => by.iter().fold(inside(inner), |inner, name| {
                differentiate(&inner?, name).ok()
            }),
            Kind::If(condition, then, otherwise) => {
                match holds(&without_measures(&inside(condition)?)) {
                    Some(true) => inside(then),
                    Some(false) => inside(otherwise),
                    None => None,
                }
            }
            _ => expr
                .try_map_children(&mut |child| inside(child).ok_or(()))
                .ok(),
        }
    }
}

/// The name of time in formulas.
const TIME: &str = "t";

/// Whether a comparison of two pure numbers holds; none for any other condition.
fn holds(condition: &Expr) -> Option<bool> {
    let Kind::Compare(operands, relations) = condition.kind() else {
        return None;
    };
    let ([left, right], [relation]) = (&operands[..], &relations[..]) else {
        return None;
    };
    let order = fold(left)?.cmp(&fold(right)?);
    Some(match relation {
        Relation::Less => order.is_lt(),
        Relation::LessOrEqual => order.is_le(),
        Relation::Greater => order.is_gt(),
        Relation::GreaterOrEqual => order.is_ge(),
        Relation::Equal => order.is_eq(),
        Relation::NotEqual => order.is_ne(),
    })
}

/// A formula with numbers in SI units in place of those with units.
fn without_measures(expr: &Expr) -> Expr {
    if let Kind::Measure(value, unit) = expr.kind()
        && let Some(number) = number(unit.to_si(value.to_f64()), FINE)
    {
        return number;
    }
    let changed: Result<Expr, std::convert::Infallible> =
        expr.try_map_children(&mut |child| Ok(without_measures(child)));
    let Ok(changed) = changed;
    changed
}

fn number(si: f64, figures: u32) -> Option<Expr> {
    if si == 0.0 {
        return Some(Expr::number(Rational::ZERO));
    }
    let text = Decimal::rounded(si, figures)?.to_string();
    Rational::from_decimal(&text).map(Expr::number)
}

/// What a wrong method gives for a part, as it is typed; none where it gives nothing.
pub(crate) fn by_method(solution: &Solution<'_>, place: usize, method: &Method) -> Option<String> {
    let template = solution.template();
    let part = &template.parts[place];
    let key = *part.answer.keys().first()?;
    let evaluation = solution.evaluation();
    match part.answer.kind() {
        AnswerKind::Function => {
            if method.formula().is_some() && !evaluation.graph().variables(method.step).is_empty() {
                return function(evaluation, key, Some(method), FINE);
            }
            function(&method.evaluation(evaluation).ok()?, key, None, FINE)
        }
        AnswerKind::Numeric | AnswerKind::Integer => {
            let wrong = method.evaluation(evaluation).ok()?;
            let wrong = wrong.value(key).ok()?;
            let right = evaluation.value(key).ok()?;
            if same(wrong, right) {
                return None;
            }
            let figures = match part.answer.kind() {
                AnswerKind::Integer => 12,
                _ => part.answer.figures(),
            };
            value(wrong, part.answer.unit(), figures)
        }
        _ => None,
    }
}

/// Whether two values are the same but for rounding in the machine, or one of them is not a number.
fn same(a: &Value, b: &Value) -> bool {
    // Far above what the formulas of an item lose in binary64, far below the last figure that anybody types.
    const ROUNDING: f64 = 1e-9;
    let size = b
        .numbers()
        .iter()
        .fold(0.0_f64, |size, number| size.max(number.abs()));
    let pairs = || a.numbers().iter().zip(b.numbers());
    a.numbers().iter().any(|number| !number.is_finite())
        || a.numbers().len() == b.numbers().len()
            && pairs().all(|(a, b)| (a - b).abs() <= ROUNDING * size)
}

/// What other parts that ask for numbers in the same unit ask for: an answer in the wrong place.
pub(crate) fn of_others(solution: &Solution<'_>, place: usize) -> Vec<(String, String)> {
    let template = solution.template();
    let answer = &template.parts[place].answer;
    let own = answer
        .keys()
        .first()
        .and_then(|key| solution.evaluation().value(*key).ok());
    let Some(own) = own.filter(|_| answer.kind() == AnswerKind::Numeric) else {
        return Vec::new();
    };
    let others = template.parts.iter().enumerate().filter(|(other, part)| {
        *other != place
            && part.answer.kind() == AnswerKind::Numeric
            && solution.asks(*other)
            && part.answer.unit().unwrap_or(Unit::ONE).dimension()
                == answer.unit().unwrap_or(Unit::ONE).dimension()
    });
    others
        .filter_map(|(_, part)| {
            let given = solution
                .evaluation()
                .value(*part.answer.keys().first()?)
                .ok()?;
            let is_alike = given.form() == own.form() && !same(given, own);
            let typed = value(given, answer.unit(), answer.figures()).filter(|_| is_alike)?;
            Some((format!("the answer to part `{}`", part.id), typed))
        })
        .collect()
}

/// The key of a part with one term or factor wrong, in letters: all ways, each with what is wrong.
pub(crate) fn in_letters(solution: &Solution<'_>, place: usize) -> Vec<(String, String)> {
    let part = &solution.template().parts[place];
    let Ok(marker) = solution.marker(place) else {
        return Vec::new();
    };
    let label = part.id.as_str();
    match (part.answer.kind(), marker.key().value) {
        (AnswerKind::Formula, KeyValue::Formula { text, .. }) => {
            let Ok(expr) = Expr::read(&text) else {
                return Vec::new();
            };
            let all = crate::quantity::variations(label, &expr).into_iter();
            all.map(|(slip, changed)| (slip.to_string(), changed.to_string()))
                .filter(|(_, text)| is_typable(text))
                .collect()
        }
        (AnswerKind::Equation, _) => {
            let Some(equations) = marker.equations(Passage::default()) else {
                return Vec::new();
            };
            let mut all = Vec::new();
            for (at, equation) in equations.key.iter().enumerate() {
                let whole = |changed: String| {
                    let others = equations.key.iter().enumerate().map(|(other, own)| {
                        if other == at {
                            changed.clone()
                        } else {
                            format!("{} = {}", own.left, own.right)
                        }
                    });
                    others.collect::<Vec<_>>().join("; ")
                };
                for (slip, left) in crate::quantity::variations(label, &equation.left) {
                    all.push((
                        slip.to_string(),
                        whole(format!("{left} = {}", equation.right)),
                    ));
                }
                for (slip, right) in crate::quantity::variations(label, &equation.right) {
                    all.push((
                        slip.to_string(),
                        whole(format!("{} = {right}", equation.left)),
                    ));
                }
            }
            all.retain(|(_, text)| is_typable(text));
            all
        }
        _ => Vec::new(),
    }
}

/// Honest work on a part: every quantity on the way is rounded to the figures that are asked for, and the answer too.
pub(crate) fn honestly(
    solution: &Solution<'_>,
    place: usize,
    template: &Template,
) -> Option<String> {
    let part = &template.parts[place];
    let key = *part.answer.keys().first()?;
    let figures = part.answer.figures().max(MIN_FIGURES);
    let graph = &template.graph;
    let mut steps = graph.steps(key);
    // From the data on, so that each step takes the rounded values of those before it.
    steps.sort_by_key(|step| graph.steps(*step).len());
    let mut evaluation = solution.evaluation().replacing(Vec::new());
    for step in steps {
        if !graph.variables(step).is_empty() {
            continue;
        }
        let Ok(value) = evaluation.value(step) else {
            continue;
        };
        // Nobody rounds a number of coils or of periods.
        let is_exact = value.as_boolean().is_some()
            || value.numbers().iter().all(|number| number.fract() == 0.0);
        if is_exact {
            continue;
        }
        let numbers =
            value
                .numbers()
                .iter()
                .map(|number| match Decimal::rounded(*number, figures) {
                    Some(decimal) => decimal.to_f64(),
                    None => *number,
                });
        let rounded = Value::new(
            value.form(),
            numbers.collect(),
            vec![0.0; value.numbers().len()],
        )?;
        evaluation = evaluation.replacing(vec![(step, rounded)]);
    }
    match part.answer.kind() {
        AnswerKind::Function => function(&evaluation, key, None, figures),
        AnswerKind::Numeric => value(
            evaluation.value(key).ok()?,
            part.answer.unit(),
            part.answer.figures(),
        ),
        _ => None,
    }
}

/// Figures in which one works at least.
const MIN_FIGURES: u32 = 3;
