//! The marks of a run on the page for teachers: the distribution of points with pass mark and grades, and groups.

use serde::Serialize;

use super::pages::Run;
use super::words::filled;
use crate::grade::rounded;
use crate::numerics::Rational;
use crate::report::{GroupSummary, MarksSummary};
use crate::worksheet::{Best, Direction, Marks};

/// The marks of a run with what they are measured by.
#[derive(Clone, Debug)]
pub struct MarkedRun {
    /// What came out.
    pub summary: MarksSummary,
    /// The points that can be reached without bonus.
    pub max: f64,
    /// The points with which a sheet passes.
    pub pass: Option<f64>,
    /// The grades, the best first, each with the points from which on it is given.
    pub scale: Vec<(String, f64)>,
    /// How points become marks.
    pub rules: Marks,
}

/// The same as a layout shows it.
#[derive(Serialize)]
pub(crate) struct MarksView {
    histogram: Option<Histogram>,
    rules: Vec<String>,
    grades: Vec<[String; 2]>,
    has_pass: bool,
    groups: Vec<GroupView>,
}

#[derive(Serialize)]
struct GroupView {
    group: String,
    sheets: u64,
    open: u64,
    mean: String,
    median: String,
    deviation: String,
    range: String,
    passed: String,
}

/// How many sheets have how many points, in the units of a picture.
#[derive(Serialize)]
struct Histogram {
    /// What it shows, in words.
    words: String,
    bars: Vec<PointsBar>,
    ticks: Vec<Tick>,
    pass: Option<Tick>,
    bands: Vec<Band>,
}

#[derive(Serialize)]
struct PointsBar {
    x: f64,
    y: f64,
    width: f64,
    height: f64,
    middle: f64,
    count: usize,
    passes: bool,
}

#[derive(Serialize)]
struct Tick {
    x: f64,
    label: String,
    /// How its label is set.
    anchor: &'static str,
}

/// The points with one grade.
#[derive(Serialize)]
struct Band {
    x: f64,
    width: f64,
    middle: f64,
    label: String,
}

/// Width of the picture between its first and last points.
const WIDTH: f64 = 400.0;
/// Height of the highest bar.
const HEIGHT: f64 = 90.0;
/// Most bars: more are thinner than their counts.
const MAX_BARS: f64 = 24.0;
/// Most numbers along the axis.
const MAX_TICKS: f64 = 9.0;
/// Width that a letter takes under the axis.
const LETTER: f64 = 4.5;

impl MarkedRun {
    pub(crate) fn view(&self, run: &Run) -> MarksView {
        let summary = &self.summary;
        let all = std::iter::once(&summary.all);
        let groups = all.chain(&summary.groups).enumerate();
        let groups = groups.map(|(place, group)| view(group, place == 0, run));
        MarksView {
            histogram: self.histogram(run),
            rules: rules(&self.rules, run),
            grades: summary
                .grades
                .iter()
                .map(|own| [own.grade.clone(), own.count.to_string()])
                .collect(),
            has_pass: self.pass.is_some(),
            groups: groups.collect(),
        }
    }

    fn histogram(&self, run: &Run) -> Option<Histogram> {
        let points = &self.summary.points;
        let phrases = &run.words.report;
        let (first, last) = (points.first()?, points.last()?);
        let low = first.min(0.0);
        let high = last.max(self.max);
        let step = nice((high - low) / MAX_BARS);
        let low = (low / step).floor() * step;
        // The highest points stand in the last bar, not beyond it.
        let count = ((high - low) / step - 1e-9).ceil().max(1.0) as usize;
        let high = low + step * count as f64;
        let scale = WIDTH / (high - low);
        let x = |points: f64| round((points - low) * scale);
        let mut counts = vec![0; count];
        for own in points {
            // What lies on an edge counts above it, whatever rounding has left of it.
            counts[(((own - low) / step + 1e-9) as usize).min(count - 1)] += 1;
        }
        let most = counts.iter().copied().max().unwrap_or(1).max(1) as f64;
        let edge = |place: usize| low + step * place as f64;
        let bar = |(place, count): (usize, &usize)| {
            let (from, to) = (x(edge(place)), x(edge(place + 1)));
            let height = round(HEIGHT * *count as f64 / most);
            PointsBar {
                x: round(from + 0.75),
                y: round(HEIGHT - height),
                width: round(to - from - 1.5),
                height,
                middle: round(f64::midpoint(from, to)),
                count: *count,
                passes: self.pass.is_none_or(|pass| edge(place) + 1e-9 >= pass),
            }
        };
        let tick_step = nice((high - low) / MAX_TICKS).max(step);
        let ticks = (0..=count)
            .map(edge)
            .filter(|points| ((points / tick_step).round() * tick_step - points).abs() < 1e-9)
            .map(|points| Tick {
                x: x(points),
                label: number(points, run),
                anchor: "middle",
            });
        let pass = self.pass.map(|pass| Tick {
            x: x(pass),
            label: filled(&phrases.pass_mark, &[("points", &number(pass, run))]),
            anchor: if x(pass) > WIDTH * 0.8 {
                "end"
            } else {
                "start"
            },
        });
        let mut words: Vec<String> = (0..count)
            .filter(|place| counts[*place] > 0)
            .map(|place| {
                let [from, to] = [edge(place), edge(place + 1)].map(|own| number(own, run));
                let count = counts[place].to_string();
                let values = [("from", &*from), ("to", &to), ("count", &count)];
                filled(&phrases.histogram_bar, &values)
            })
            .collect();
        if let Some(pass) = self.pass {
            words.push(filled(
                &phrases.histogram_pass,
                &[("points", &number(pass, run))],
            ));
        }
        Some(Histogram {
            words: format!("{} {}.", phrases.histogram, words.join(". ")),
            bars: counts.iter().enumerate().map(bar).collect(),
            ticks: ticks.collect(),
            pass,
            bands: self.bands(&x, high),
        })
    }

    /// The grades along the axis, the best first.
    fn bands(&self, x: &dyn Fn(f64) -> f64, high: f64) -> Vec<Band> {
        let mut end = x(high);
        let mut bands = Vec::new();
        for (grade, from) in &self.scale {
            let begin = x(*from).clamp(0.0, end);
            let width = round(end - begin);
            let fits = width > LETTER * grade.chars().count() as f64;
            bands.push(Band {
                x: begin,
                width,
                middle: round(f64::midpoint(begin, end)),
                label: if fits { grade.clone() } else { String::new() },
            });
            end = begin;
        }
        bands
    }
}

fn view(group: &GroupSummary, is_all: bool, run: &Run) -> GroupView {
    let shown = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |own| number(own, run));
    let words = &run.words.report;
    let range = group.lowest.zip(group.highest);
    let settled = group.passed + group.failed;
    GroupView {
        group: match (is_all, group.group.as_str()) {
            (true, _) => words.all.clone(),
            (false, "") => words.without_group.clone(),
            (false, name) => name.to_owned(),
        },
        sheets: group.sheets,
        open: group.undecided,
        mean: shown(group.mean),
        median: shown(group.median),
        deviation: shown(group.deviation),
        range: range.map_or_else(
            || "–".to_owned(),
            |(low, high)| {
                let values = [("from", &*number(low, run)), ("to", &number(high, run))];
                filled(&words.to, &values)
            },
        ),
        passed: group.pass_rate.map_or_else(
            || "–".to_owned(),
            |_| {
                let [count, all] = [group.passed, settled].map(|own| own.to_string());
                filled(&words.passed_of, &[("count", &count), ("all", &all)])
            },
        ),
    }
}

/// How points become marks, a sentence each.
fn rules(marks: &Marks, run: &Run) -> Vec<String> {
    let words = &run.words.report;
    let say = |phrase: &str, name: &str, points: Rational| {
        filled(phrase, &[(name, &run.marked(&rounded(points)))])
    };
    let best = marks.best.iter().map(|Best { section, count }| {
        let phrase = match section.as_str() {
            "" => &words.best,
            _ => &words.best_of_section,
        };
        let values = [("count", &*count.to_string()), ("section", section)];
        filled(phrase, &values)
    });
    let mut rules: Vec<String> = best.collect();
    if let Some(share) = marks.wrong_choice {
        let phrase = if marks.below_zero {
            &words.wrong_choice
        } else {
            &words.wrong_choice_floor
        };
        let percent = share.0.checked_mul(Rational::from(100)).unwrap_or(share.0);
        rules.push(say(phrase, "percent", percent));
    }
    if let Some(rounding) = marks.rounding {
        let phrase = match rounding.direction {
            Direction::Nearest => &words.rounded,
            Direction::Up => &words.rounded_up,
            Direction::Down => &words.rounded_down,
        };
        rules.push(say(phrase, "step", rounding.step.0));
    }
    if let Some(full) = marks.full {
        rules.push(say(&words.full, "points", full.0));
    }
    rules
}

/// The next of 1, 2, 2.5 and 5 times a power of ten that is not smaller.
fn nice(step: f64) -> f64 {
    let mut power = 0.01;
    loop {
        for factor in [1.0, 2.0, 2.5, 5.0] {
            if factor * power >= step * (1.0 - 1e-9) {
                return factor * power;
            }
        }
        // Points are far below this; the bound also ends the search for a step that is not a number.
        if power > 1e9 {
            return power;
        }
        power *= 10.0;
    }
}

/// Points in at most two decimals.
fn number(points: f64, run: &Run) -> String {
    let text = format!("{points:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    run.marked(if text == "-0" { "0" } else { text })
}

fn round(length: f64) -> f64 {
    (length * 10.0).round() / 10.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_round_numbers() {
        let steps = [0.3, 1.0, 1.1, 2.2, 3.0, 6.0].map(nice);
        assert_eq!(steps, [0.5, 1.0, 2.0, 2.5, 5.0, 10.0]);
    }
}
