//! Instances: the data of an item for one seed, under its constraints.
//!
//! A parameter is drawn as an integer on its decimal grid, from a stream of its own that is named
//! after it, so that what is printed is exactly what is solved, and adding a parameter changes no
//! other. A draw that breaks a constraint is drawn again, from the next numbers of the same streams.

use std::sync::Arc;

use crate::bank::{ParameterError, Template};
use crate::expr::Precise;
use crate::quantity::Evaluation;
use crate::seed::{Seed, Stream, Streams};
use crate::unit::Quantity;
use crate::work::{self, Allowance};

/// The data of an item.
#[derive(Clone, Debug)]
pub struct Instance<'t> {
    template: &'t Template,
    seed: Option<Seed>,
    values: Vec<Quantity>,
    redraws: u32,
    /// The constraints that were broken by draws before, and how often.
    broken: Vec<(&'t str, u32)>,
}

/// Why no instance could be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InstanceError {
    /// The constraints were not met in a bounded number of draws.
    #[error("no data of `{item}` meet its constraints in {attempts} draws: {}", .broken.iter().map(|(name, count)| format!("`{name}` was broken {count} times")).collect::<Vec<_>>().join(", "))]
    Constraints {
        /// The identity of the item, `chapter/name`.
        item: String,
        /// How many draws were made.
        attempts: u32,
        /// The constraints that were broken first, and how often.
        broken: Vec<(String, u32)>,
    },
    /// A value for a parameter that the item does not have.
    #[error("`{item}` has no parameter `{found}`{}", .nearest.as_ref().map(|near| format!(", did you mean `{near}`?")).unwrap_or_default())]
    UnknownParameter {
        /// The identity of the item, `chapter/name`.
        item: String,
        /// The name.
        found: String,
        /// The known name that is nearest.
        nearest: Option<String>,
    },
    /// A value that a parameter cannot have.
    #[error("`{name}`: {error}")]
    Value {
        /// The parameter.
        name: String,
        /// What is wrong.
        error: ParameterError,
    },
}

/// What looking over many draws of an item may cost: three of those that use up all that a value may take, or any number
/// of ordinary ones. The items that come with the program take up to 2.8 million units a draw.
pub const DRAWS: Allowance = Allowance::new(40_000_000, 4_000_000);

/// Draws that are made before giving up.
const MAX_DRAWS: u32 = 1000;

/// Units of work that the constraints may take in all these draws.
const MAX_WORK: u64 = 20_000_000;

/// Units of work of a draw by itself.
const WORK_OF_A_DRAW: u64 = 100;

impl<'t> Instance<'t> {
    /// The instance of a seed: a pure function of item and seed.
    ///
    /// # Errors
    ///
    /// [`InstanceError::Constraints`].
    pub fn draw(template: &'t Template, seed: Seed) -> Result<Self, InstanceError> {
        Self::of(template, Some(seed), &[])
    }

    /// The instance with the values of the source.
    pub fn of_source(template: &'t Template) -> Self {
        let values = template
            .parameters
            .iter()
            .map(|parameter| parameter.value)
            .collect();
        Self {
            template,
            seed: None,
            values,
            redraws: 0,
            broken: Vec::new(),
        }
    }

    /// An instance that stands for all: one that is drawn, or that of the source where no draw meets the constraints.
    pub fn typical(template: &'t Template) -> Self {
        // Any seed will do, as long as it is always the same.
        const SEED: Seed = Seed::new(1);
        Self::draw(template, SEED).unwrap_or_else(|_| Self::of_source(template))
    }

    /// The instance with these values; what is not set is drawn if there is a seed, and else has the value of the
    /// source. Ranges and constraints bind what is drawn, never what is set.
    ///
    /// # Errors
    ///
    /// [`InstanceError`].
    pub fn of(
        template: &'t Template,
        seed: Option<Seed>,
        set: &[(&str, &str)],
    ) -> Result<Self, InstanceError> {
        let mut instance = Self {
            seed,
            ..Self::of_source(template)
        };
        let mut is_set = vec![false; template.parameters.len()];
        for (name, text) in set {
            let (place, parameter) = template
                .parameter(name)
                .ok_or_else(|| unknown(template, name))?;
            let set = parameter.set(text);
            instance.values[place] = set.map_err(|error| InstanceError::Value {
                name: (*name).to_owned(),
                error,
            })?;
            is_set[place] = true;
        }
        if let Some(seed) = seed {
            instance.draw_rest(seed, &is_set)?;
        }
        Ok(instance)
    }

    fn draw_rest(&mut self, seed: Seed, is_set: &[bool]) -> Result<(), InstanceError> {
        let streams = Streams::of(seed, self.template.id.as_str());
        let parameters = self.template.parameters.iter().enumerate();
        let drawn = parameters.filter_map(|(place, parameter)| {
            let grid = parameter.grid.filter(|_| !is_set[place])?;
            let stream = streams.named(parameter.name.as_str());
            Some((place, parameter.unit, grid, stream))
        });
        let mut drawn: Vec<(usize, _, _, Stream)> = drawn.collect();
        if drawn.is_empty() {
            return Ok(());
        }
        let mut broken: Vec<(&'t str, u32)> = Vec::new();
        let tried = work::within(MAX_WORK, || {
            for attempt in 0..MAX_DRAWS {
                for (place, unit, grid, stream) in &mut drawn {
                    self.values[*place] = Quantity::new(grid.at(stream.below(grid.count())), *unit);
                }
                let Some(name) = self.first_broken() else {
                    self.redraws = attempt;
                    return None;
                };
                match broken.iter_mut().find(|(known, _)| *known == name) {
                    Some((_, count)) => *count += 1,
                    None => broken.push((name, 1)),
                }
                if work::spend(WORK_OF_A_DRAW).is_err() {
                    return Some(attempt + 1);
                }
            }
            Some(MAX_DRAWS)
        });
        crate::numerics::sort_by(&mut broken, |a, b| b.1.cmp(&a.1).then_with(|| a.0.cmp(b.0)));
        let Some(attempts) = tried.value else {
            self.broken = broken;
            return Ok(());
        };
        let broken = broken
            .into_iter()
            .map(|(name, count)| (name.to_owned(), count))
            .collect();
        Err(InstanceError::Constraints {
            item: self.template.id.to_string(),
            attempts,
            broken,
        })
    }

    /// The first constraint that does not hold; one without a value does not hold.
    fn first_broken(&self) -> Option<&'t str> {
        if self.template.constraints.is_empty() {
            return None;
        }
        let evaluation = self.evaluation();
        let mut constraints = self.template.constraints.iter();
        constraints
            .find(|constraint| evaluation.holds(constraint.node) != Ok(true))
            .map(|constraint| &*constraint.name)
    }

    /// The template that it was drawn from.
    pub fn template(&self) -> &'t Template {
        self.template
    }

    /// The seed it was drawn from.
    pub fn seed(&self) -> Option<Seed> {
        self.seed
    }

    /// The values of its parameters, in their order, as they are printed.
    pub fn values(&self) -> &[Quantity] {
        &self.values
    }

    /// How often it was drawn again.
    pub fn redraws(&self) -> u32 {
        self.redraws
    }

    /// The constraints that draws before this one broke first, the most frequent first, and how often.
    pub fn broken(&self) -> &[(&'t str, u32)] {
        &self.broken
    }

    /// A fresh evaluation of the item's graph for these data.
    pub fn evaluation(&self) -> Evaluation<'t> {
        let data: Arc<[Precise]> = self
            .template
            .parameters
            .iter()
            .zip(&self.values)
            .map(|(parameter, value)| {
                let (high, low) = parameter.si_pair(value);
                // Two words hold a scaled decimal to at least 106 bits.
                Precise::new(
                    high,
                    low,
                    if low == 0.0 {
                        0.0
                    } else {
                        // 2⁻¹⁰⁶, rounded up.
                        high.abs() * 1.3e-32
                    },
                )
            })
            .collect();
        Evaluation::new(&self.template.graph, data)
    }

    /// `item @ revision # seed`: what has to be known to make it again.
    pub fn identity(&self) -> String {
        let item = self.origin();
        match self.seed {
            Some(seed) => format!("{item} # {seed}"),
            None => item,
        }
    }

    /// `item @ revision`: where it comes from, for pages that must not tell the seed.
    pub fn origin(&self) -> String {
        let Template { id, revision, .. } = self.template;
        format!("{id} @ {revision}")
    }
}

fn unknown(template: &Template, name: &str) -> InstanceError {
    let names = template
        .parameters
        .iter()
        .map(|parameter| parameter.name.as_str());
    let nearest = crate::source::nearest(name, names).map(str::to_owned);
    InstanceError::UnknownParameter {
        item: template.id.to_string(),
        found: name.to_owned(),
        nearest,
    }
}
