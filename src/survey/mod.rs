//! Surveys: what the draws of an item look like.
//!
//! An author sees from it whether an item is fair: how many instances there are, how often the
//! constraints force another draw, how far the answers range, whether honest three-figure work stays
//! within the tolerances, how far the named mistakes are from the keys, and how well the two routes to
//! each quantity agree.

mod answers;

use serde::Serialize;

pub use answers::AnswerSurvey;

use crate::bank::Template;
use crate::instance::{self, Instance};
use crate::seed::Seed;
use crate::solution::{Solution, proof};
use crate::suitability;

/// What the draws of an item look like, over the seeds from 0 on.
///
/// # Examples
///
/// ```
/// # #[cfg(feature = "render")] {
/// use vibank::bank::{Catalogue, embedded};
/// use vibank::survey::Survey;
///
/// let (catalogue, _) = Catalogue::load(embedded());
/// let item = catalogue.find("ch3/e5-log-decrement").unwrap();
/// let survey = Survey::over(item, 50);
/// assert_eq!(survey.draws, 50);
/// assert!(survey.instances > 10_000.0);
/// assert!(survey.disagreement.unwrap().share < 1e-12);
/// # }
/// ```
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Survey {
    /// The identity of the item, `chapter/name`.
    pub item: String,
    /// How many instances were drawn.
    pub draws: u64,
    /// The number of distinct instances that are fit to hand out: the size of the grid times the
    /// share of its points that pass, as found by drawing.
    pub instances: f64,
    /// The share of draws that a constraint refused.
    pub redrawn: f64,
    /// The share of instances that are not fit to hand out.
    pub unfit: f64,
    /// Where the two routes to a quantity differ most; `None` without a second route.
    pub disagreement: Option<Disagreement>,
    /// The parts that ask for numbers.
    pub answers: Vec<AnswerSurvey>,
}

/// How far the two routes to a quantity differ.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Disagreement {
    /// The name of the quantity.
    pub quantity: String,
    /// The seed of the draw with the greatest difference.
    pub seed: u64,
    /// The greatest difference as a share of the greatest of the numbers.
    pub share: f64,
}

impl Survey {
    /// Draws an item this many times; less often where its draws take [too much work](instance::DRAWS).
    pub fn over(template: &Template, seeds: u64) -> Self {
        let grid = template
            .parameters
            .iter()
            .filter_map(|parameter| parameter.grid)
            .map(|grid| grid.count() as f64)
            .product();
        let mut survey = Self {
            item: template.id.to_string(),
            draws: 0,
            instances: grid,
            redrawn: 0.0,
            unfit: 0.0,
            disagreement: None,
            answers: AnswerSurvey::of_parts(template),
        };
        let (mut redraws, mut unfit) = (0_u64, 0_u64);
        let mut allowance = instance::DRAWS;
        for seed in 0..seeds {
            let Ok(instance) = Instance::draw(template, Seed::new(seed)) else {
                break;
            };
            let own = u64::from(instance.redraws());
            let judged = allowance.take(|| {
                let solution = Solution::of(instance);
                survey.compare(&solution, seed);
                survey.judge(&solution)
            });
            let Some(is_fit) = judged else {
                break;
            };
            survey.draws += 1;
            redraws += own;
            unfit += u64::from(!is_fit);
        }
        survey.redrawn = share(redraws, redraws + survey.draws);
        survey.unfit = share(unfit, survey.draws);
        survey.instances *= (1.0 - survey.redrawn) * (1.0 - survey.unfit);
        survey
    }

    /// Whether an instance is fit to hand out; the answers of those that are count.
    fn judge(&mut self, solution: &Solution<'_>) -> bool {
        let parts: Vec<usize> = (0..solution.template().parts.len()).collect();
        let is_fit = suitability::judge(solution, &parts)
            .and_then(|()| suitability::judge_methods(solution, &parts))
            .is_ok();
        if is_fit {
            for answer in &mut self.answers {
                answer.add(solution);
            }
        }
        is_fit
    }

    /// Notes where two routes differ more than before.
    fn compare(&mut self, solution: &Solution<'_>, seed: u64) {
        for (quantity, share) in proof::disagreements(solution) {
            let greatest = self.disagreement.as_ref().map_or(-1.0, |known| known.share);
            if share > greatest {
                self.disagreement = Some(Disagreement {
                    quantity: quantity.to_string(),
                    seed,
                    share,
                });
            }
        }
    }

    /// The least of a number over the answers.
    pub fn least(&self, number: impl Fn(&AnswerSurvey) -> Option<f64>) -> Option<f64> {
        self.answers.iter().filter_map(number).reduce(f64::min)
    }

    /// The greatest of a number over the answers.
    pub fn greatest(&self, number: impl Fn(&AnswerSurvey) -> Option<f64>) -> Option<f64> {
        self.answers.iter().filter_map(number).reduce(f64::max)
    }
}

/// A share of a whole; of nothing it is nothing.
fn share(part: u64, whole: u64) -> f64 {
    if whole == 0 {
        return 0.0;
    }
    part as f64 / whole as f64
}
