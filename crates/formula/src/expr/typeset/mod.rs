//! Formulas as typeset mathematics, and as text in their own language.
//!
//! [`Expr::typeset`] makes a [`Math`] tree; how names are set is up to a [`Notation`], which also puts
//! numbers in for names. `Display` writes the language in which formulas are read.

mod call;
mod product;
mod text;

use crate::expr::{Constant, Expr, Kind, Name, Operator, Path, Relation};
use vibank_notation::{Class, Math};

/// How names stand in a formula.
pub trait Notation {
    /// The symbol of a name, or the value substituted for it.
    fn name(&self, name: &Name) -> Symbol;

    /// The symbol of a quantity of a model.
    fn path(&self, path: &Path) -> Symbol {
        let last = path.names().last().map_or("", Name::as_str);
        Symbol::letter(vibank_notation::symbol(last))
    }
}

/// The symbols that names stand for by themselves: `omega_n` is ω with the subscript n.
#[derive(Clone, Copy, Debug, Default)]
pub struct PlainNotation;

impl Notation for PlainNotation {
    fn name(&self, name: &Name) -> Symbol {
        Symbol::letter(vibank_notation::symbol(name.as_str()))
    }
}

/// What stands for a name in a typeset formula.
#[derive(Clone, Debug, PartialEq)]
pub struct Symbol {
    /// How it is set.
    pub math: Math,
    /// What its neighbours have to know of it.
    pub kind: SymbolKind,
}

/// How something stands beside its neighbours in a product or under a power.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SymbolKind {
    /// A symbol: factors stand side by side.
    Letter,
    /// A number: a dot keeps it apart from a number before it.
    Number,
    /// A number with a sign in front: parentheses within a product.
    Negative,
    /// A number with a unit: a dot keeps it apart from its neighbours, parentheses under a power.
    Quantity,
    /// A value with a sign in front: parentheses in every product and under a power, none where it stands alone.
    NegativeQuantity,
}

impl Symbol {
    /// A symbol.
    pub fn letter(math: Math) -> Self {
        Self {
            math,
            kind: SymbolKind::Letter,
        }
    }
}

/// How tightly a piece of typeset mathematics holds together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Hold {
    /// A condition or a case.
    Loose,
    /// Terms with signs between them.
    Sum,
    /// A sign in front.
    Sign,
    /// Factors.
    Product,
    /// A fraction or a function with its argument: no base of a power.
    Fraction,
    /// A base with an exponent.
    Power,
    /// One symbol, or whatever stands in delimiters.
    Atom,
}

/// A typeset piece.
#[derive(Clone, Debug)]
struct SetPiece {
    math: Math,
    hold: Hold,
}

impl SetPiece {
    fn new(math: Math, hold: Hold) -> Self {
        Self { math, hold }
    }

    fn atom(math: Math) -> Self {
        Self::new(math, Hold::Atom)
    }

    /// In parentheses, if it holds together less than its place asks for.
    fn at_least(self, least: Hold) -> Math {
        if self.hold >= least {
            self.math
        } else {
            self.math.fenced("(", ")")
        }
    }
}

pub(crate) fn formula(expr: &Expr, notation: &dyn Notation) -> Math {
    Setter { notation }.piece(expr).math
}

/// Sets formulas in a notation.
struct Setter<'a> {
    notation: &'a dyn Notation,
}

impl Setter<'_> {
    fn math(&self, expr: &Expr) -> Math {
        self.piece(expr).math
    }

    fn piece(&self, expr: &Expr) -> SetPiece {
        match expr.kind() {
            Kind::Number(value) => number(*value),
            Kind::Measure(value, unit) => {
                let number = number(*value).at_least(Hold::Product);
                SetPiece::new(
                    Math::row([number, Math::Space(3), unit.math()]),
                    Hold::Product,
                )
            }
            Kind::Constant(constant) => SetPiece::atom(constant_symbol(*constant)),
            Kind::Name(name) => of_symbol(self.notation.name(name)),
            Kind::Path(path) => of_symbol(self.notation.path(path)),
            Kind::Prime(inner, order) => self.prime(inner, *order),
            Kind::Index(inner, indices) => self.index(inner, indices),
            Kind::Negate(inner) => {
                let operand = self.piece(inner).at_least(Hold::Product);
                SetPiece::new(Math::row([Math::prefix("−"), operand]), Hold::Sign)
            }
            Kind::Binary(Operator::Add, a, b) => self.sum(a, "+", b),
            Kind::Binary(Operator::Subtract, a, b) => self.sum(a, "−", b),
            Kind::Binary(Operator::Multiply | Operator::Divide, ..) => product::product(self, expr),
            Kind::Binary(Operator::Power, base, exponent) => self.power(base, exponent),
            Kind::Compare(operands, relations) => self.comparison(operands, relations),
            Kind::And(a, b) => self.joined(a, "and", b),
            Kind::Or(a, b) => self.joined(a, "or", b),
            Kind::Not(inner) => {
                let operand = self.piece(inner).at_least(Hold::Sum);
                SetPiece::new(Math::row([Math::text("not "), operand]), Hold::Loose)
            }
            Kind::If(..) => self.cases(expr),
            Kind::Call(function, arguments) => call::call(self, *function, arguments),
            Kind::At(inner, values) => call::at(self, inner, values),
            Kind::Diff(inner, names) => call::partial_derivative(self, inner, names),
            Kind::Root(inner, name, low, high) => {
                let name = Expr::name(name.clone());
                call::applied(
                    self,
                    "root",
                    &[inner.clone(), name, low.clone(), high.clone()],
                )
            }
            Kind::Integral(inner, name, from, to) => call::integral(self, inner, name, from, to),
            Kind::Array(entries) => self.array(entries),
        }
    }

    fn sum(&self, a: &Expr, sign: &str, b: &Expr) -> SetPiece {
        let left = self.piece(a).at_least(Hold::Sum);
        let right = self.piece(b).at_least(Hold::Product);
        SetPiece::new(
            Math::row(flat(left).into_iter().chain([Math::binary(sign), right])),
            Hold::Sum,
        )
    }

    fn prime(&self, inner: &Expr, order: u8) -> SetPiece {
        if let Kind::Name(_) = inner.kind() {
            return SetPiece::atom(self.math(inner).derivative(u32::from(order)));
        }
        let marks = "′".repeat(usize::from(order));
        let base = self.piece(inner).at_least(Hold::Atom);
        let marks = Math::operator(marks, Class::Ordinary);
        SetPiece::new(base.with_sup(marks), Hold::Power)
    }

    fn index(&self, inner: &Expr, indices: &[Expr]) -> SetPiece {
        let base = self.piece(inner).at_least(Hold::Atom);
        let base = match &base {
            Math::Script { sub: Some(_), .. } => base.fenced("(", ")"),
            _ => base,
        };
        let are_digits = indices.iter().all(|index| {
            let value = index.as_number();
            value.is_some_and(|value| value.is_integer() && (0..10).contains(&value.numerator()))
        });
        let indices = indices.iter().map(|index| self.math(index));
        let separator = (!are_digits).then(|| Math::punctuation(","));
        SetPiece::atom(base.with_sub(separated(indices, separator.as_ref())))
    }

    fn power(&self, base: &Expr, exponent: &Expr) -> SetPiece {
        if let Some(piece) = call::power_of_call(self, base, exponent) {
            return piece;
        }
        let bottom = self.base(base);
        let top = match exponent.kind() {
            Kind::Binary(Operator::Divide, a, b) if a.size() == 1 && b.size() == 1 => Math::row([
                self.math(a),
                Math::operator("/", Class::Ordinary),
                self.math(b),
            ]),
            _ => self.math(exponent),
        };
        SetPiece::new(bottom.with_sup(top), Hold::Power)
    }

    /// What may bear an exponent.
    fn base(&self, expr: &Expr) -> Math {
        let kind = match expr.kind() {
            Kind::Name(name) => self.notation.name(name).kind,
            Kind::Path(path) => self.notation.path(path).kind,
            _ => SymbolKind::Letter,
        };
        let piece = self.piece(expr);
        match (kind, &piece.math) {
            (SymbolKind::Quantity | SymbolKind::Negative | SymbolKind::NegativeQuantity, _)
            | (_, Math::Script { sup: Some(_), .. }) => piece.math.fenced("(", ")"),
            _ => piece.at_least(Hold::Atom),
        }
    }

    fn comparison(&self, operands: &[Expr], relations: &[Relation]) -> SetPiece {
        let mut row = vec![self.piece(&operands[0]).at_least(Hold::Sum)];
        for (relation, operand) in relations.iter().zip(&operands[1..]) {
            row.push(Math::relation(relation_symbol(*relation)));
            row.push(self.piece(operand).at_least(Hold::Sum));
        }
        SetPiece::new(Math::row(row), Hold::Loose)
    }

    fn joined(&self, a: &Expr, word: &str, b: &Expr) -> SetPiece {
        let side = |expr: &Expr| match expr.kind() {
            Kind::And(..) | Kind::Or(..) | Kind::If(..) => self.math(expr).fenced("(", ")"),
            _ => self.math(expr),
        };
        let row = [side(a), Math::text(format!(" {word} ")), side(b)];
        SetPiece::new(Math::row(row), Hold::Loose)
    }

    /// `if` and what follows in its `else` as one list of cases.
    fn cases(&self, expr: &Expr) -> SetPiece {
        let (mut rows, mut rest) = (Vec::new(), expr);
        while let Kind::If(condition, first, second) = rest.kind() {
            let condition = Math::row([Math::text("if "), self.math(condition)]);
            rows.push(vec![self.math(first), condition]);
            rest = second;
        }
        rows.push(vec![self.math(rest), Math::text("otherwise")]);
        SetPiece::new(Math::cases(rows), Hold::Loose)
    }

    /// A vector as a column, an array of arrays as a matrix.
    fn array(&self, entries: &[Expr]) -> SetPiece {
        let rows = entries.iter().map(|entry| match entry.kind() {
            Kind::Array(row) => row.iter().map(|entry| self.math(entry)).collect(),
            _ => vec![self.math(entry)],
        });
        SetPiece::atom(Math::matrix(rows.collect()))
    }
}

fn of_symbol(symbol: Symbol) -> SetPiece {
    let hold = match symbol.kind {
        SymbolKind::Letter | SymbolKind::Number => Hold::Atom,
        SymbolKind::Negative | SymbolKind::NegativeQuantity => Hold::Sign,
        SymbolKind::Quantity => Hold::Product,
    };
    SetPiece::new(symbol.math, hold)
}

/// An integer or a decimal that ends soon as it is; any other as a fraction.
fn number(value: vibank_dynamics::numerics::Rational) -> SetPiece {
    // A longer decimal reads worse than its fraction.
    const MAX_DIGITS: usize = 12;
    let magnitude = match text::decimal(value.abs()) {
        Some(digits) if value.is_integer() || digits.len() <= MAX_DIGITS => {
            SetPiece::atom(Math::number(digits))
        }
        _ => {
            let part = |part: i128| Math::number(part.to_string());
            let fraction = Math::fraction(part(value.abs().numerator()), part(value.denominator()));
            SetPiece::new(fraction, Hold::Fraction)
        }
    };
    if value.is_negative() {
        return SetPiece::new(Math::row([Math::prefix("−"), magnitude.math]), Hold::Sign);
    }
    magnitude
}

fn constant_symbol(constant: Constant) -> Math {
    match constant {
        Constant::Pi => Math::letter('π'),
        Constant::E => Math::upright("e"),
        Constant::ImaginaryUnit => Math::upright("i"),
        Constant::Infinity => Math::operator("∞", Class::Ordinary),
    }
}

fn relation_symbol(relation: Relation) -> &'static str {
    match relation {
        Relation::Less => "<",
        Relation::LessOrEqual => "≤",
        Relation::Greater => ">",
        Relation::GreaterOrEqual => "≥",
        Relation::Equal => "=",
        Relation::NotEqual => "≠",
    }
}

/// The pieces of a row, so that a chain of sums is one row.
fn flat(math: Math) -> Vec<Math> {
    match math {
        Math::Row(pieces) => pieces,
        other => vec![other],
    }
}

/// Pieces with a separator between them.
fn separated(pieces: impl Iterator<Item = Math>, separator: Option<&Math>) -> Math {
    let mut row = Vec::new();
    for piece in pieces {
        if !row.is_empty() {
            row.extend(separator.cloned());
        }
        row.push(piece);
    }
    Math::row(row)
}
