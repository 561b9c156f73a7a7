//! Scenes: what one output shows of an instance, and so what it demands.
//!
//! A scene is the root of demand. Writing a text fills its holes, and each hole asks the solution for
//! what it shows; nothing else is computed. Showing a question computes no key, one part's key
//! computes that part alone.

mod concrete;
mod fill;
mod film;
mod lines;
mod motion;
mod notation;
mod plot;
mod proof;
mod steps;
mod turns;

pub use film::{Moving, Run};
pub use plot::Undrawn;
pub use proof::{underived, undrawn, unfree};
#[cfg(feature = "render")]
pub(crate) use steps::shown_in;

use std::borrow::Cow;

use sha2::{Digest, Sha256};

use crate::answer::AnswerKind;
use crate::bank::{Passage, Piece};
use crate::document::{Document, Filling};
use crate::expr::Name;
use crate::figure::plot::Picture as PlotPicture;
use crate::figure::{FigureData, FreeError, Picture, free_picture};
use crate::math::Math;
use crate::message::{Language, Phrase};
use crate::quantity::Absent;
use crate::solution::Solution;
use crate::unit::DecimalMark;

/// How the data of an instance are shown in its statement.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Data {
    /// Symbol and number, *m* = 2.0 kg.
    #[default]
    Both,
    /// Numbers alone.
    Numbers,
    /// Symbols alone.
    Symbols,
}

crate::source::named!(Data, "`both`, `numbers` or `symbols`", {
    "both" => Both,
    "numbers" => Numbers,
    "symbols" => Symbols,
});

/// What one output shows of an instance.
pub struct Scene<'s, 't> {
    solution: &'s Solution<'t>,
    data: Data,
    language: Language,
    is_drawn: bool,
    /// Begins the identities in its figures and plots.
    scope: Option<String>,
}

/// A text that is shown, with what fills its holes.
pub struct Shown<'t> {
    /// The text.
    pub document: Cow<'t, Document>,
    /// What fills its holes.
    pub fillings: Vec<Filling>,
}

/// Letters of a function that a key shows at most.
const MAX_KEY_LENGTH: usize = 120;

impl<'s, 't> Scene<'s, 't> {
    /// A scene of a solution.
    pub fn of(solution: &'s Solution<'t>, data: Data) -> Self {
        Self {
            solution,
            data,
            language: Language::default(),
            is_drawn: true,
            scope: None,
        }
    }

    /// The same on a page that shows other instances, too: the identities in its figures and plots begin with `scope`,
    /// which is letters, digits and hyphens.
    #[must_use]
    pub fn within(self, scope: String) -> Self {
        Self {
            scope: Some(scope),
            ..self
        }
    }

    /// The same with what the item does not say itself, such as the steps of derivations, in a language; else in English.
    #[must_use]
    pub fn spoken(self, language: Language) -> Self {
        Self { language, ..self }
    }

    /// The same with figures and plots described in words, for terminals.
    #[must_use]
    pub fn in_words(self) -> Self {
        Self {
            is_drawn: false,
            ..self
        }
    }

    fn nonexistent(&self) -> Math {
        Math::text(self.language.phrase(&Phrase::Nonexistent))
    }

    /// The solution that it shows.
    pub fn solution(&self) -> &'s Solution<'t> {
        self.solution
    }

    /// The beginning of the identities in its figures and plots.
    ///
    /// It follows from what is printed anyway, never from the seed: a sheet is handed out, and a seed that is keyed with
    /// a secret gives its key away.
    fn scope(&self) -> String {
        if let Some(scope) = &self.scope {
            return scope.clone();
        }
        let instance = self.solution.instance();
        let mut hash = Sha256::new();
        for value in instance.values() {
            hash.update(format!(";{value}"));
        }
        let digest = hash.finalize();
        let digest = digest.iter().take(4).map(|byte| format!("{byte:02x}"));
        let item = instance.template().id.as_str().replace('/', "-");
        format!("{item}-{}", digest.collect::<String>())
    }

    /// The pieces of a text whose conditions hold.
    pub fn passage<'p>(&self, passage: &'p Passage) -> Vec<Shown<'p>> {
        let evaluation = self.solution.evaluation();
        passage
            .pieces
            .iter()
            .filter(|piece| {
                piece
                    .when
                    .is_none_or(|when| evaluation.holds(when) == Ok(true))
            })
            .map(|piece| self.piece(piece))
            .collect()
    }

    /// The symbol of the quantity that a part asks for, and an equals sign, or for its range the sign of membership; `None`
    /// where it asks for something else.
    pub fn lead(&self, place: usize) -> Option<Math> {
        let template = self.solution.template();
        let answer = &template.parts[place].answer;
        if let Some(symbol) = answer.ranging() {
            return Some(Math::row([symbol.clone(), Math::relation("∈")]));
        }
        let keys = answer.keys();
        let [key] = keys[..] else {
            return None;
        };
        let info = template.info(key)?;
        Some(Math::row([Math::clone(&info.symbol), Math::relation("=")]))
    }

    /// The key of a part as it is printed: a function of time with the numbers of this instance, all else in its general
    /// form. None where no line can hold it, so that it is left to the solution.
    ///
    /// # Errors
    ///
    /// As [`Solution::key`].
    pub fn key(&self, place: usize) -> Result<Option<Cow<'s, Math>>, Absent> {
        let general = &self.solution.key(place)?.math;
        let own = self.solution.written(place, || self.concrete(place));
        let is_too_long = own.is_some_and(|own| own.plain().chars().count() > MAX_KEY_LENGTH);
        Ok((!is_too_long).then(|| {
            let mut math = self.language.formula(own.unwrap_or(general));
            if self.solution.mark() == DecimalMark::Comma {
                math.to_mut().set_decimal_sign(",");
            }
            math
        }))
    }

    /// The key of a part for which its general form is not what one looks for.
    fn concrete(&self, place: usize) -> Option<Math> {
        let answer = &self.solution.template().parts[place].answer;
        let keys = answer.keys();
        if answer.kind() != AnswerKind::Function || keys.len() != 1 {
            return None;
        }
        let math = concrete::function(self.solution, keys[0])?;
        Some(match answer.unit().filter(|unit| !unit.is_one()) {
            Some(unit) => Math::row([
                math,
                Math::Space(18),
                Math::text("in "),
                unit.coherent().math(),
            ]),
            None => math,
        })
    }

    /// The given data as one printed list, for sheets whose statement shows symbols alone.
    pub fn values(&self) -> Vec<(Math, Math)> {
        let template = self.solution.template();
        template
            .parameters
            .iter()
            .zip(self.solution.instance().values())
            .map(|(parameter, value)| {
                (
                    Math::clone(&parameter.symbol),
                    value.math(self.solution.mark()),
                )
            })
            .collect()
    }

    fn piece<'p>(&self, piece: &'p Piece) -> Shown<'p> {
        let places = piece.document.placeholders().iter().zip(&piece.targets);
        let fillings = places.map(|(place, target)| fill::filling(self, target, place.form));
        let mut shown = Shown {
            document: Cow::Borrowed(&piece.document),
            fillings: fillings.collect(),
        };
        // Data have their sign already; this is for what authors wrote, and for numbers in derived formulas.
        if self.solution.mark() == DecimalMark::Comma {
            shown.document.to_mut().set_decimal_sign(",");
            for filling in &mut shown.fillings {
                filling.set_decimal_sign(",");
            }
        }
        shown
    }

    /// The figure; `None` where the item has none, or where its places have no value for these data.
    pub fn picture(&self) -> Option<Picture> {
        let figure = self.solution.template().figure.as_ref()?;
        self.solution.note_figure();
        figure.picture(self, &self.scope(), &self.language).ok()
    }

    /// The free-body diagrams; `None` where the item has none.
    ///
    /// # Errors
    ///
    /// [`FreeError`] where they do not show the forces of the model for these data.
    pub fn free_picture(&self) -> Option<Result<Picture, FreeError>> {
        let figure = self.solution.template().figure.as_ref()?;
        let id = format!("{}-free", self.scope());
        figure
            .has_free()
            .then(|| free_picture(figure, self, &id, &self.language))
    }

    /// The motions that can be shown for these data.
    pub fn runs(&self) -> Vec<Run> {
        film::runs(self)
    }

    /// A motion with its pictures; nothing where there is none for these data. `id` begins all identities in it.
    pub fn moving(&self, run: Run, id: &str) -> Option<Moving> {
        film::moving(self, run, id)
    }

    /// The figure with both extremes of a mode, numbered from 0; `None` where the item has no such mode for these data.
    pub fn mode_picture(&self, number: usize) -> Option<Picture> {
        motion::picture(self, number)
    }

    /// A plot of the item, drawn for these data.
    ///
    /// # Errors
    ///
    /// [`Undrawn`].
    pub fn plot(&self, name: &str) -> Result<PlotPicture, Undrawn> {
        plot::picture(self, name)
    }
}

impl FigureData for Scene<'_, '_> {
    fn number(&self, name: &Name) -> Option<f64> {
        let node = self.solution.template().graph.find(name)?;
        self.solution.evaluation().real(node).ok()
    }

    fn value(&self, name: &Name) -> Option<Math> {
        let template = self.solution.template();
        let node = template.graph.find(name)?;
        let info = template.info(node).filter(|info| info.units.is_some())?;
        Some(fill::value(self, node, info))
    }
}
