//! Solutions: the keys of an instance with their tolerances and named mistakes, each prepared when it is asked for.

mod entry;
pub mod proof;
pub mod request;
mod session;

use std::cell::{Cell, OnceCell};
use std::rc::Rc;
use std::sync::Arc;

pub use entry::{Entry, Nested, Number};
pub use session::Session;

use crate::answer::{Context, Credit, Doubt, Key, Marker, Mistaken, Sampling};
use crate::bank::{Mistake, MistakeAnswer, Part, Template};
use crate::expr::{Expr, Name, Precise, Value};
use crate::instance::Instance;
use crate::math::Math;
use crate::numerics::SortedMap;
use crate::quantity::{Absent, Evaluation, NodeId, Trace};
use crate::seed::Streams;
use crate::unit::DecimalMark;

/// The keys of an instance; nothing is computed before it is asked for.
pub struct Solution<'t> {
    instance: Instance<'t>,
    evaluation: Rc<Evaluation<'t>>,
    /// What formulas are compared at, shared with all solutions that follow from it.
    sampling: Rc<Sampling<'t>>,
    markers: Vec<OnceCell<Result<Box<dyn Marker + 't>, Absent>>>,
    /// What marks the other form of an answer.
    others: Vec<OnceCell<Option<Box<dyn Marker + 't>>>>,
    /// The keys as they are printed, from kinds that have them without what marks.
    alone: Vec<OnceCell<KeyAlone>>,
    /// Those of the others.
    printed: Vec<OnceCell<Result<Key, Absent>>>,
    /// The keys that a scene writes in its own way.
    written: Vec<OnceCell<Option<Math>>>,
    standing: SortedMap<Name, Expr>,
    /// Whether the values of a student stand in for quantities.
    is_following: bool,
    mark: DecimalMark,
    doubt: Doubt,
    is_drawn: Cell<bool>,
}

/// The key as a kind prints it without what marks, if it does.
type KeyAlone = Option<Result<Arc<Key>, Absent>>;

/// An empty cell for each part.
fn cells<T>(template: &Template) -> Vec<OnceCell<T>> {
    template.parts.iter().map(|_| OnceCell::new()).collect()
}

impl<'t> Solution<'t> {
    /// The solution of an instance.
    pub fn of(instance: Instance<'t>) -> Self {
        Self::with_mark(instance, DecimalMark::Point)
    }

    /// The solution of an instance on a sheet with this decimal sign.
    pub fn with_mark(instance: Instance<'t>, mark: DecimalMark) -> Self {
        let evaluation = Rc::new(instance.evaluation());
        let template = instance.template();
        Self {
            markers: cells(template),
            others: cells(template),
            alone: cells(template),
            printed: cells(template),
            written: cells(template),
            instance,
            evaluation,
            sampling: Rc::new(Sampling::new(&template.drawn, || {
                Instance::typical(template).evaluation()
            })),
            standing: SortedMap::new(),
            is_following: false,
            mark,
            doubt: Doubt::default(),
            is_drawn: Cell::new(false),
        }
    }

    /// Settles doubts about responses in this way; without it whoever answers is asked.
    #[must_use]
    pub fn settling(self, doubt: Doubt) -> Self {
        Self {
            markers: cells(self.template()),
            others: cells(self.template()),
            doubt,
            ..self
        }
    }

    /// The same instance with values and formulas of a student standing in for quantities: the keys are
    /// those that follow from them.
    #[must_use]
    pub(crate) fn following(
        &self,
        values: Vec<(NodeId, Value)>,
        formulas: SortedMap<Name, Expr>,
    ) -> Self {
        Self {
            markers: cells(self.template()),
            others: cells(self.template()),
            alone: cells(self.template()),
            printed: cells(self.template()),
            written: cells(self.template()),
            instance: self.instance.clone(),
            evaluation: Rc::new(self.evaluation.replacing(values)),
            sampling: Rc::clone(&self.sampling),
            standing: formulas,
            is_following: true,
            mark: self.mark,
            doubt: self.doubt,
            is_drawn: Cell::new(false),
        }
    }

    /// The instance that it solves.
    pub fn instance(&self) -> &Instance<'t> {
        &self.instance
    }

    /// The template of the instance that it solves.
    pub fn template(&self) -> &'t Template {
        self.instance.template()
    }

    /// The values, each computed when it is asked for.
    pub fn evaluation(&self) -> &Evaluation<'t> {
        &self.evaluation
    }

    /// The decimal sign of the sheet.
    pub fn mark(&self) -> DecimalMark {
        self.mark
    }

    /// Whether a part is asked for these data: its condition holds, and its key exists.
    pub fn asks(&self, place: usize) -> bool {
        let part = &self.template().parts[place];
        let holds = part
            .when
            .is_none_or(|when| self.evaluation.holds(when) == Ok(true));
        holds
            && !part.answer.keys().into_iter().any(|key| {
                self.evaluation
                    .exists_for(key)
                    .is_err_and(|absent| matches!(absent, Absent::NotForTheseData(_)))
            })
    }

    /// The key of a part with all that marks it.
    ///
    /// # Errors
    ///
    /// Why the key does not exist for these data.
    pub fn marker(&self, place: usize) -> Result<&dyn Marker, Absent> {
        let prepared = self.markers[place].get_or_init(|| self.prepare(place));
        prepared.as_ref().map(AsRef::as_ref).map_err(Clone::clone)
    }

    /// The key of a part in its other form, value or formula, with all that marks it but named mistakes; none for
    /// kinds with one form.
    pub(crate) fn other_marker(&self, place: usize) -> Option<&dyn Marker> {
        self.others[place]
            .get_or_init(|| {
                let other = self.template().parts[place].answer.other_form()?;
                let context = Context {
                    mistakes: Vec::new(),
                    ..self.context(place)
                };
                other.prepare(&context).ok()
            })
            .as_deref()
    }

    /// The key of a part as it is printed; what marks is prepared only where the key needs it.
    ///
    /// # Errors
    ///
    /// As [`Self::marker`].
    pub fn key(&self, place: usize) -> Result<&Key, Absent> {
        if let Some(key) = self.key_alone(place) {
            return key.as_deref().map_err(Clone::clone);
        }
        let printed = self.printed[place].get_or_init(|| self.marker(place).map(Marker::key));
        printed.as_ref().map_err(Clone::clone)
    }

    /// The number of the key of a part in SI units, where it is one; nothing is typeset for it.
    pub fn number(&self, place: usize) -> Option<f64> {
        match self.key_alone(place) {
            Some(key) => key.as_ref().ok()?.number(),
            None => self.marker(place).ok()?.number(),
        }
    }

    /// The key of a part from a kind that has it without what marks.
    fn key_alone(&self, place: usize) -> Option<&Result<Arc<Key>, Absent>> {
        let answer = &self.template().parts[place].answer;
        let key = self.alone[place].get_or_init(|| answer.printed(&self.evaluation));
        key.as_ref()
    }

    /// The key of a part as a scene writes it, which it does once.
    pub(crate) fn written(
        &self,
        place: usize,
        write: impl FnOnce() -> Option<Math>,
    ) -> Option<&Math> {
        self.written[place].get_or_init(write).as_ref()
    }

    /// The least distance of a named mistake of a part from its key, in tolerances; `None` without such a mistake.
    ///
    /// # Errors
    ///
    /// As [`Self::marker`].
    pub fn clearance(&self, place: usize) -> Result<Option<f64>, Absent> {
        match self.key_alone(place) {
            Some(key) => key.as_ref().map(|_| None).map_err(Clone::clone),
            None => Ok(self.marker(place)?.clearance(f64::INFINITY)),
        }
    }

    /// The order in which the options of a part are printed, as places in the file.
    pub fn order(&self, place: usize) -> Vec<usize> {
        let part = &self.template().parts[place];
        let count = part.answer.options().len();
        match self.instance.seed().filter(|_| part.answer.shuffles()) {
            Some(seed) => Streams::of(seed, self.template().id.as_str())
                // A stream for each part: one that is added or left out shuffles no other.
                .named(&format!("part {}", part.id))
                .permutation(count),
            None => (0..count).collect(),
        }
    }

    /// What was computed so far, and what was not.
    pub fn trace(&self) -> Trace {
        let mut trace = self.evaluation.trace();
        if self.template().figure.is_some() {
            let list = if self.is_drawn.get() {
                &mut trace.computed
            } else {
                &mut trace.skipped
            };
            list.push("figure".to_owned());
        }
        trace
    }

    /// Notes for the trace that the figure was drawn.
    pub(crate) fn note_figure(&self) {
        self.is_drawn.set(true);
    }

    fn prepare(&self, place: usize) -> Result<Box<dyn Marker + 't>, Absent> {
        self.template().parts[place]
            .answer
            .prepare(&self.context(place))
    }

    fn context(&self, place: usize) -> Context<'t> {
        let part = &self.template().parts[place];
        let mistakes = part.mistakes.iter().enumerate();
        let mistakes = mistakes
            .filter_map(|(number, mistake)| self.mistake_of(part, number, mistake))
            .collect();
        Context {
            evaluation: Rc::clone(&self.evaluation),
            sampling: Rc::clone(&self.sampling),
            mistakes,
            standing: self.standing.clone(),
            order: self.order(place),
            mark: self.mark,
            doubt: self.doubt,
        }
    }

    /// The named mistake of this number of a part for these data, if it is one for them.
    pub fn mistaken(&self, place: usize, number: usize) -> Option<Mistaken> {
        let part = self.template().parts.get(place)?;
        self.mistake_of(part, number, part.mistakes.get(number)?)
    }

    /// What a mistake gives for these data, if it is one for them.
    fn mistake_of(&self, part: &Part, number: usize, mistake: &Mistake) -> Option<Mistaken> {
        let applies = mistake
            .when
            .is_none_or(|when| self.evaluation.holds(when) == Ok(true));
        // What follows from a mistake may be what another one gives; such a mistake neither counts nor narrows a tolerance.
        let is_superseded = self.is_following && mistake.credit == Credit::NONE;
        if !applies || is_superseded {
            return None;
        }
        let (given, replaced) = match &mistake.answer {
            MistakeAnswer::Formulas(given) => (given.clone(), Vec::new()),
            MistakeAnswer::Replaced(replaced) => (Vec::new(), replaced.clone()),
        };
        let values = match &mistake.answer {
            _ if part.answer.keeps_mistakes() => Ok(Vec::new()),
            MistakeAnswer::Formulas(nodes) => nodes
                .iter()
                .map(|node| self.evaluation.value(*node).cloned())
                .collect::<Result<Vec<_>, _>>(),
            MistakeAnswer::Replaced(replaced) => {
                let with = replaced.iter().map(|(quantity, value)| {
                    Ok((*quantity, self.evaluation.value(*value)?.clone()))
                });
                let other = self
                    .evaluation
                    .replacing(with.collect::<Result<Vec<_>, Absent>>().ok()?);
                part.answer
                    .keys()
                    .into_iter()
                    .map(|key| other.value(key).cloned())
                    .collect()
            }
        };
        Some(Mistaken {
            number,
            given,
            values: values.ok()?,
            replaced,
            unit: mistake.unit,
            credit: mistake.credit,
        })
    }

    /// The entry of an answer id: a quantity with a unit, or a part. Functions of time are given at the times `at`.
    pub fn entry(&self, id: &str, at: &[Precise]) -> Option<Entry> {
        entry::of(self, id, at)
    }
}
