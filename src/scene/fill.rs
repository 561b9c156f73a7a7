//! What fills the holes of a text.

use super::concrete;
use super::notation::{NumberNotation, Symbols};
use super::{Data, Scene};
use crate::bank::{Part, QuantityInfo, Target, Units};
use crate::document::{Filling, Form};
use crate::expr::{Equation, Expr, Field, Kind, Path, Shape, Value};
use crate::figure::Picture;
use crate::math::Math;
use crate::message::{Language, Phrase};
use crate::quantity::NodeId;
use crate::unit::{Decimal, Quantity, Unit};

impl Scene<'_, '_> {
    pub(crate) fn filling(&self, target: &Target, form: Form) -> Filling {
        let mut filling = self.unworded(target, form);
        if self.language == Language::English {
            return filling;
        }
        let formulas: Vec<&mut Math> = match &mut filling {
            Filling::Math(math) => vec![math],
            Filling::Steps(steps) => {
                let lines = steps.iter_mut().flat_map(|step| &mut step.lines);
                lines.flatten().collect()
            }
            Filling::Figure(_) => Vec::new(),
        };
        for math in formulas {
            *math = self.language.formula(math).into_owned();
        }
        filling
    }

    fn unworded(&self, target: &Target, form: Form) -> Filling {
        match target {
            Target::Node(node) => self.node(*node, form),
            Target::Figure => self.shown(self.picture()),
            Target::Free => self.shown(self.free_picture().and_then(Result::ok)),
            Target::Mode(number) => self.shown(self.mode_picture(*number)),
            Target::Plot(name) => self.drawn_plot(name),
            Target::Model(path) => Filling::Math(self.offered(path)),
            Target::Derivation(path) => self.steps(path),
            Target::Nothing => Filling::words("?"),
        }
    }

    /// A picture, or what it shows in words where nothing is drawn.
    fn shown(&self, picture: Option<Picture>) -> Filling {
        match picture {
            Some(picture) if self.is_drawn => Filling::Figure(picture.svg),
            Some(picture) => Filling::words(self.language.phrase(&Phrase::Figure(&picture.alt))),
            None => Filling::Figure(String::new()),
        }
    }

    /// A formula or the equations of a model, in the symbols of the item.
    fn offered(&self, path: &Path) -> Math {
        let notation = Symbols(self.solution);
        let Some((model, quantity)) = self.solution.template().graph.offered(path) else {
            return nothing();
        };
        if let Ok(formula) = model.formula(quantity) {
            return formula.typeset(&notation);
        }
        let sides = |equation: &Equation| {
            [
                equation.left.typeset(&notation),
                Math::relation("="),
                equation.right.typeset(&notation),
            ]
        };
        match model.equations(quantity).as_deref() {
            Ok([one]) => Math::row(sides(one)),
            Ok(several) => {
                let row = |equation: &Equation| {
                    let [left, sign, right] = sides(equation);
                    vec![left, Math::row([sign, right])]
                };
                Math::aligned(several.iter().map(row).collect())
            }
            Err(_) => nothing(),
        }
    }

    fn node(&self, node: NodeId, form: Form) -> Filling {
        let Some(info) = self.solution.template().info(node) else {
            return Filling::words("?");
        };
        let math = match form {
            Form::Name => {
                return Filling::words(info.title.as_deref().unwrap_or(info.name.as_str()));
            }
            Form::Worked => return self.worked(node, info),
            Form::Symbol => Math::clone(&info.symbol),
            Form::Value => self.value(node, info),
            Form::Number => self.number(node, info),
            Form::Unit => unit(info).map_or_else(nothing, |unit| unit.math()),
            Form::Given => self.given(node, info),
            Form::Formula => self.formula(node),
            Form::Substituted => self.substituted(node),
            Form::Equation => {
                let formula = [
                    Math::clone(&info.symbol),
                    Math::relation("="),
                    self.formula(node),
                ];
                Math::row(
                    formula
                        .into_iter()
                        .chain([Math::relation("="), self.value(node, info)]),
                )
            }
        };
        Filling::Math(math)
    }

    fn given(&self, node: NodeId, info: &QuantityInfo) -> Math {
        match self.data {
            Data::Numbers => self.value(node, info),
            Data::Symbols => Math::clone(&info.symbol),
            Data::Both => Math::row([
                Math::clone(&info.symbol),
                Math::relation("="),
                self.value(node, info),
            ]),
        }
    }

    /// The number with its unit; a function of time as its formula with numbers.
    pub(crate) fn value(&self, node: NodeId, info: &QuantityInfo) -> Math {
        if let Some(place) = info.parameter {
            return self.solution.instance().values()[place].math(self.solution.mark());
        }
        if !self.solution.template().graph.variables(node).is_empty() {
            return concrete::function(self.solution, node).unwrap_or_else(nothing);
        }
        match self.solution.evaluation().value(node) {
            Ok(value) => self.printed(value, info, true),
            Err(_) => self.nonexistent(),
        }
    }

    /// The value of a number in the unit of the part that asks for it, where that is another than its own.
    pub(crate) fn value_as_asked(&self, node: NodeId, info: &QuantityInfo) -> Option<Math> {
        let template = self.solution.template();
        let asks = |part: &&Part| match part.answer.keys()[..] {
            [key] if key == node => true,
            [key] => {
                let key = template.graph.expr(key).map(Expr::kind);
                matches!(key, Some(Kind::Name(name)) if *name == info.name)
            }
            _ => false,
        };
        let mut asked = template.parts.iter().filter(asks);
        let unit = asked.find_map(|part| part.answer.unit())?;
        let value = self.solution.evaluation().value(node).ok()?;
        let is_other = Some(unit) != self::unit(info) && value.shape() == Shape::Scalar;
        is_other.then(|| self.entry(value, 0, info, Some(unit), Some(unit)))
    }

    fn number(&self, node: NodeId, info: &QuantityInfo) -> Math {
        if let Some(place) = info.parameter {
            return self.solution.instance().values()[place]
                .value
                .math(self.solution.mark());
        }
        match self.solution.evaluation().value(node) {
            Ok(value) => self.printed(value, info, false),
            Err(_) => self.nonexistent(),
        }
    }

    fn formula(&self, node: NodeId) -> Math {
        let expr = self.solution.template().graph.expr(node);
        expr.map_or_else(nothing, |expr| expr.typeset(&Symbols(self.solution)))
    }

    fn substituted(&self, node: NodeId) -> Math {
        let expr = self.solution.template().graph.expr(node);
        expr.map_or_else(nothing, |expr| {
            concrete::concrete(self.solution, expr).typeset(&NumberNotation(self.solution))
        })
    }

    /// A value in its units, arranged as it is.
    fn printed(&self, value: &Value, info: &QuantityInfo, has_unit: bool) -> Math {
        let common = match &info.units {
            Some(Units::One(unit)) => Some(*unit),
            _ => None,
        };
        let one = match (value.shape(), common) {
            (Shape::Scalar, unit) => unit.or_else(|| entry_unit(info, 0)),
            (_, unit) => unit,
        };
        let body = match value.shape() {
            Shape::Scalar => return self.entry(value, 0, info, one.filter(|_| has_unit), one),
            Shape::Vector(length) => {
                let entries = (0..length).map(|at| self.cell(value, at, info, one));
                let list = separated(entries);
                if length == 1 {
                    list
                } else {
                    list.in_parentheses()
                }
            }
            Shape::Matrix(rows, columns) => {
                let row = |row: usize| {
                    (0..columns)
                        .map(|column| self.cell(value, row * columns + column, info, one))
                        .collect()
                };
                Math::matrix((0..rows).map(row).collect())
            }
        };
        match one.filter(|unit| has_unit && !unit.is_one()) {
            Some(unit) => Math::row([body, Math::thin_space(), unit.math()]),
            None => body,
        }
    }

    /// An entry of a vector or matrix: without unit if one serves for all.
    fn cell(&self, value: &Value, at: usize, info: &QuantityInfo, common: Option<Unit>) -> Math {
        let own = entry_unit(info, at);
        self.entry(
            value,
            at,
            info,
            own.filter(|_| common.is_none()),
            common.or(own),
        )
    }

    /// One number: rounded in `unit`, printed with the unit `shown`.
    fn entry(
        &self,
        value: &Value,
        at: usize,
        info: &QuantityInfo,
        shown: Option<Unit>,
        unit: Option<Unit>,
    ) -> Math {
        let entry = value.entry(at);
        let unit = unit.unwrap_or(Unit::ONE);
        let real = |number: f64| {
            Decimal::rounded(unit.of_si(number), u32::from(info.digits)).unwrap_or(Decimal::ZERO)
        };
        let mark = self.solution.mark();
        // A count is printed as one: 3 coils, not 3.00.
        let is_whole = info
            .units
            .as_ref()
            .is_some_and(|units| matches!(units, Units::One(unit) if unit.is_one()))
            && entry.im == 0.0
            && entry.re == entry.re.round()
            && entry.re.abs() < 1e6;
        if value.form().field == Field::Complex {
            let (re, im) = (real(entry.re), real(entry.im));
            let is_sum = entry.re != 0.0 || entry.im == 0.0;
            let real = is_sum.then(|| re.math(mark));
            let body = Math::complex(real, im.is_negative(), im.abs().math(mark));
            let Some(unit) = shown.filter(|unit| !unit.is_one()) else {
                return body;
            };
            let body = if is_sum { body.in_parentheses() } else { body };
            return Math::row([body, Math::thin_space(), unit.math()]);
        }
        let number = if is_whole {
            Decimal::shortest(entry.re).unwrap_or(Decimal::ZERO)
        } else {
            real(entry.re)
        };
        Quantity::new(number, shown.unwrap_or(Unit::ONE)).math(mark)
    }
}

fn unit(info: &QuantityInfo) -> Option<Unit> {
    match info.units.as_ref()? {
        Units::One(unit) => Some(*unit),
        Units::Each(_) => None,
    }
}

fn separated(entries: impl Iterator<Item = Math>) -> Math {
    let mut row = Vec::new();
    for entry in entries {
        if !row.is_empty() {
            row.push(Math::punctuation(","));
        }
        row.push(entry);
    }
    Math::row(row)
}

/// No formula.
fn nothing() -> Math {
    Math::Row(Vec::new())
}

/// The unit in which one component is declared.
fn entry_unit(info: &QuantityInfo, at: usize) -> Option<Unit> {
    match info.units.as_ref()? {
        Units::One(unit) => Some(*unit),
        Units::Each(units) => units.get(at).copied(),
    }
}
