//! `mode-shape`: the shape of a mode, or a basis of the modes of one frequency.
//!
//! The student types `(1, 0.618)`, `[1; -2]`, `(1, 2)/sqrt(12m)` or `[1, (1 + sqrt(5))/2]`; any scale and sign is right
//! unless `normalization` asks for one: `mass` for shapes with unit modal mass, `first` for a first component of 1. A
//! shape that is right in another scale has half the credit. Several vectors, `(1, -1, 0), (0, 1, -1)` or the rows or
//! columns of a matrix, are asked by several modes: each has to lie in the space of its mode, those of one frequency
//! have to be independent, and each that is right has its share of the credit. Where frequencies repeat, any shape of
//! that frequency is right. The tolerance is an angle, a hundredth of a radian unless stated, a tenth of that for each
//! figure above three in which the key is printed. A shape of another mode of the model is recognized as such.
//!
//! ```toml
//! [[part]]
//! kind          = "mode-shape"
//! key           = "u1"
//! mode          = 1
//! normalization = "any"         # or "mass", "first"
//! ask           = "Find the shape of the first mode."
//! ```

mod marker;
mod modes;
mod read;
mod span;

use std::sync::Arc;

use self::marker::Prepared;
use self::modes::AskedModes;
use self::span::{lies_in, vectors};
use super::letters::Allowed;
use super::matrix::Written;
use super::meaning::{Meaning, Prefer};
use super::{Answer, AnswerError, Blank, Context, Declare, Marker, Role, ShapeScale, Tolerance};
use crate::expr::{Expr, Field, Name, Shape};
use crate::quantity::{Absent, NodeId};
use crate::response::Lexicon;
use crate::source::Table;
use crate::unit::Unit;

/// The scale in which components are to be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum AskedScale {
    Any,
    Mass,
    First,
}

#[derive(Debug)]
struct AskedMode {
    key: NodeId,
    asked: AskedModes,
    tolerance: Option<Tolerance>,
    /// Significant figures of the work.
    figures: u32,
    digits: u32,
    setup: Arc<Setup>,
}

#[derive(Debug)]
pub(crate) struct Setup {
    scale: AskedScale,
    written: Written,
    units: Vec<Unit>,
    /// The symbols of the coordinates, in their order.
    coordinates: Vec<String>,
    meaning: Meaning,
    lexicon: Lexicon,
    /// The letters of its answer line.
    letters: Vec<Expr>,
}

/// Reads the keys of a part that belong to this kind; what is wrong is noted.
pub(crate) fn read(part: &Table<'_>, declare: &mut dyn Declare) -> Option<Box<dyn Answer>> {
    let text = part
        .required("key")
        .and_then(|key| part.as_formula("key", key));
    let asked = AskedModes::read(part, declare);
    let (normalization, tolerance) = (part.text("normalization"), part.text("tolerance"));
    let written = Written::read(part, declare);
    let text = text?;
    let key = declare.formula("key", &text)?;
    let kind = declare.graph().kind(key)?.clone();
    let is_list = matches!(kind.shape(), Shape::Vector(_) | Shape::Matrix(..));
    if kind.field() != Field::Real || !is_list {
        let found = kind.form().to_string();
        declare.find(
            &AnswerError::KeyForm {
                expected: "a vector, or several",
                found,
            },
            &text,
        );
        return None;
    }
    let scale = match normalization.as_ref().map(|text| text.value.as_str()) {
        None | Some("any") => AskedScale::Any,
        Some("mass") => AskedScale::Mass,
        Some("first") => AskedScale::First,
        Some(_) => {
            let text = normalization.unwrap_or(text);
            declare.find(
                &AnswerError::Unread(
                    text.value.clone(),
                    "normalization: `any`, `mass` or `first`",
                ),
                &text,
            );
            return None;
        }
    };
    let radian = Unit::radian();
    let tolerance = match tolerance {
        Some(text) => Some(Tolerance::read(&text, &radian, declare)?),
        None => None,
    };
    let own = Name::new(text.value.as_str());
    let named = declare.graph().find(&own).map(|_| own);
    let allowed = Allowed::read(part, declare, named.as_ref(), false)?;
    let known = declare.known();
    let coordinates = known.iter().filter(|own| own.role == Role::Coordinate);
    let coordinates = coordinates.map(|own| own.symbol.plain()).collect();
    Some(Box::new(AskedMode {
        key,
        asked: asked?,
        tolerance,
        figures: u32::from(declare.figures()),
        digits: u32::from(declare.digits_of(key)),
        setup: Arc::new(Setup {
            scale,
            written,
            units: declare.units_of(key),
            coordinates,
            meaning: Meaning::of(declare, Prefer::Quantities),
            letters: allowed.letters(),
            lexicon: allowed.lexicon,
        }),
    }))
}

impl Answer for AskedMode {
    fn kind(&self) -> crate::answer::AnswerKind {
        crate::answer::AnswerKind::ModeShape
    }

    fn blank(&self) -> Blank {
        let Setup {
            written,
            letters,
            lexicon,
            ..
        } = &*self.setup;
        let form = super::Asked::ModeShape {
            entries: written.entries(),
            scale: match self.setup.scale {
                AskedScale::Any => ShapeScale::Any,
                AskedScale::Mass => ShapeScale::Mass,
                AskedScale::First => ShapeScale::First,
            },
            are_several: self.asked.numbers.len() > 1,
        };
        written.describe(Blank::of(form), (letters, lexicon), (None, self.digits))
    }

    fn keys(&self) -> Vec<NodeId> {
        vec![self.key]
    }

    fn prepare<'t>(&self, context: &Context<'t>) -> Result<Box<dyn Marker + 't>, Absent> {
        let evaluation = &*context.evaluation;
        let key = evaluation.value(self.key)?.clone();
        let angle = match &self.tolerance {
            Some(tolerance) => tolerance.half_width(1.0, || 0.0, self.figures, evaluation),
            // Fewer figures in print do not make a coarser question.
            None => 0.01 * crate::numerics::powi(10.0, 3 - self.figures.max(3) as i32),
        };
        let width = match key.shape() {
            Shape::Matrix(_, columns) => columns,
            _ => key.numbers().len(),
        };
        let mistakes = context.mistakes.iter().filter_map(|mistaken| {
            let value = mistaken.values.first()?;
            Some((
                mistaken.number,
                vectors(value.numbers(), width),
                mistaken.credit,
            ))
        });
        let keys = vectors(key.numbers(), width);
        let modes = self.asked.modes(evaluation);
        // A key in other coordinates than those of the model stands for itself.
        let modes = modes.filter(|modes| {
            keys.len() == self.asked.numbers.len()
                && keys.iter().zip(&self.asked.numbers).all(|(key, number)| {
                    let space = modes.space(*number);
                    space.iter().all(|shape| shape.len() == width) && lies_in(key, &space, 1e-6)
                })
        });
        Ok(Box::new(Prepared {
            setup: Arc::clone(&self.setup),
            key,
            keys,
            numbers: self.asked.numbers.clone(),
            modes,
            angle,
            digits: self.digits,
            mistakes: mistakes.collect(),
            data: self.setup.meaning.data(evaluation),
            mark: context.mark,
        }))
    }
}
