//! From the points of a sheet to its mark: which questions count, rounding, the scale of grades, what passes.
//!
//! All points are exact fractions. Where some are not decided yet, everything is worked out for the least and for the most
//! that the sheet can come to, so that a grade is stated only where it is the same whatever is decided.

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::numerics::Rational;

/// The table `[marks]` of a blueprint or of a file of decisions.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Marks {
    /// How the points of a sheet are rounded, if they are.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rounding: Option<Rounding>,
    /// The points that count as 100 %, in place of all that can be reached.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub full: Option<Exact>,
    /// How many questions count of each section; the nameless one is that of all without a section.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub best: Vec<Best>,
    /// The share of the points of a choice that a wrong one costs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wrong_choice: Option<Exact>,
    /// Whether wrong choices may bring a question below zero.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub below_zero: bool,
    /// What becomes of students on whose sheets nothing was answered.
    #[serde(skip_serializing_if = "Absence::is_usual")]
    pub absent: Absence,
    /// The grades, the best first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub scale: Vec<GradeStep>,
    /// What passes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pass: Option<Bound>,
}

/// What becomes of students on whose sheets nothing was answered.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Absence {
    /// They were absent: they have no mark, and are in no statistics.
    #[default]
    LeftOut,
    /// They have no points, like one who has handed in an empty sheet.
    Zero,
}

impl Absence {
    #[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks so")]
    fn is_usual(&self) -> bool {
        *self == Self::LeftOut
    }
}

/// How many questions of a section count.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Best {
    /// The section; empty for the questions that are in none.
    pub section: String,
    /// How many of its questions count, those with the most points.
    pub count: usize,
}

/// A grade, and from where on it is given.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GradeStep {
    /// As it is printed.
    pub grade: String,
    /// The least that it takes.
    pub from: Bound,
}

/// A least number of points.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Bound {
    /// A number of points.
    Points(Exact),
    /// As a share of the points that count as 100 %.
    Share(Exact),
}

/// How points are rounded.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rounding {
    /// To multiples of this.
    pub step: Exact,
    /// Whether a half, or anything between two steps, is rounded up or down.
    pub direction: Direction,
}

/// The direction of a rounding.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Direction {
    /// To the nearest, halves up.
    #[default]
    Nearest,
    /// In favour of the student.
    Up,
    /// Only what is complete counts.
    Down,
}

/// An exact fraction, as a text in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Exact(pub Rational);

impl Serialize for Exact {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.0.to_string())
    }
}

impl<'de> Deserialize<'de> for Exact {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let (above, below) = text.split_once('/').unwrap_or((&text, "1"));
        Rational::from_decimal(above)
            .zip(Rational::from_decimal(below))
            .and_then(|(above, below)| above.checked_div(below))
            .map(Self)
            .ok_or_else(|| serde::de::Error::custom("no fraction"))
    }
}

/// What a question came to.
#[derive(Clone, Debug, PartialEq)]
pub struct Scored<'a> {
    /// The least that it comes to.
    pub points: Rational,
    /// What more it comes to at most, when all is decided.
    pub open: Rational,
    /// What can be reached.
    pub max: Rational,
    /// Whether its points are beyond those of the sheet.
    pub bonus: bool,
    /// Its section; may be empty.
    pub section: &'a str,
}

/// What a sheet came to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Total {
    /// The least that it comes to.
    pub points: Rational,
    /// What more it comes to at most, when all is decided.
    pub open: Rational,
    /// What can be reached without bonus.
    pub max: Rational,
}

/// What a total is worth.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Worth<'m> {
    /// The grade; two of them, the lower first, where it depends on what is not decided; none without a scale.
    pub grades: Vec<&'m str>,
    /// Whether it passes; none where that is not decided, or nothing says what passes.
    pub passed: Option<bool>,
}

impl Marks {
    /// The points of a sheet: the best questions of each section, and bonus.
    ///
    /// ```
    /// use vibank::numerics::Rational;
    /// use vibank::worksheet::{Best, Marks, Scored};
    ///
    /// let points = Rational::from;
    /// let question = |own, max| Scored {
    ///     points: points(own), open: points(0), max: points(max), bonus: false, section: "",
    /// };
    /// let marks = Marks { best: vec![Best { section: String::new(), count: 2 }], ..Marks::default() };
    /// let total = marks.total(&[question(3, 10), question(8, 10), question(7, 10)]);
    /// assert_eq!((total.points, total.max), (points(15), points(20)));
    /// ```
    pub fn total(&self, questions: &[Scored<'_>]) -> Total {
        let bonus = questions.iter().filter(|question| question.bonus);
        let mut least: Vec<Rational> = bonus.clone().map(|question| question.points).collect();
        let mut most: Vec<Rational> = bonus
            .map(|question| add(question.points, question.open))
            .collect();
        let mut max = Vec::new();
        let mut sections: Vec<&str> = Vec::new();
        for question in questions.iter().filter(|question| !question.bonus) {
            if !sections.contains(&question.section) {
                sections.push(question.section);
            }
        }
        for section in sections {
            let own = questions.iter();
            let own: Vec<&Scored<'_>> = own
                .filter(|own| !own.bonus && own.section == section)
                .collect();
            let counts = self.best.iter().find(|best| best.section == section);
            let count = counts.map_or(own.len(), |best| best.count);
            least.extend(best(own.iter().map(|own| own.points), count));
            most.extend(best(own.iter().map(|own| add(own.points, own.open)), count));
            max.extend(best(own.iter().map(|own| own.max), count));
        }
        let [least, most] = [least, most].map(|points| self.rounded(sum(&points)));
        Total {
            points: least,
            open: most.checked_sub(least).unwrap_or(Rational::ZERO),
            max: sum(&max),
        }
    }

    /// What the wrong choice of an option costs, of a part with this many points.
    pub fn penalty(&self, max: Rational) -> Rational {
        let share = self.wrong_choice.map_or(Rational::ZERO, |share| share.0);
        share.checked_mul(max).unwrap_or(Rational::ZERO)
    }

    /// The points that count as 100 %, where this many can be reached.
    pub fn full(&self, max: Rational) -> Rational {
        self.full.map_or(max, |full| full.0)
    }

    /// The share of what counts as 100 %.
    pub fn share(&self, points: Rational, max: Rational) -> Option<Rational> {
        points.checked_div(self.full(max))
    }

    /// What a total is worth: its grade, and whether it passes.
    pub fn worth(&self, total: &Total) -> Worth<'_> {
        let most = add(total.points, total.open);
        let mut grades: Vec<&str> = [total.points, most]
            .into_iter()
            .filter_map(|points| self.grade(points, total.max))
            .collect();
        grades.dedup();
        let passes = |points| {
            self.pass
                .map(|bound| bound.is_reached(points, self.full(total.max)))
        };
        let passed = passes(total.points);
        Worth {
            grades,
            passed: passed.filter(|_| passed == passes(most)),
        }
    }

    /// The grade of some points.
    pub fn grade(&self, points: Rational, max: Rational) -> Option<&str> {
        let full = self.full(max);
        let mut steps = self.scale.iter();
        let step = steps.find(|step| step.from.is_reached(points, full));
        step.or(self.scale.last()).map(|step| step.grade.as_str())
    }

    fn rounded(&self, points: Rational) -> Rational {
        let Some(Rounding { step, direction }) = self.rounding else {
            return points;
        };
        let rounded = points
            .checked_div(step.0)
            .and_then(|steps| Rational::new(whole(steps, direction), 1)?.checked_mul(step.0));
        rounded.unwrap_or(points)
    }
}

/// How many whole steps so many are, rounded.
fn whole(steps: Rational, direction: Direction) -> i128 {
    let (above, below) = (steps.numerator(), steps.denominator());
    match direction {
        Direction::Down => above.div_euclid(below),
        Direction::Up => -(-above).div_euclid(below),
        Direction::Nearest => (2 * above + below).div_euclid(2 * below),
    }
}

impl Bound {
    /// In points, where this many count as 100 %.
    pub fn points(self, full: Rational) -> Rational {
        match self {
            Self::Points(points) => points.0,
            Self::Share(share) => share.0.checked_mul(full).unwrap_or(full),
        }
    }

    fn is_reached(self, points: Rational, full: Rational) -> bool {
        points >= self.points(full)
    }
}

/// The largest of some numbers, at most this many.
fn best(points: impl Iterator<Item = Rational>, count: usize) -> Vec<Rational> {
    let mut points: Vec<Rational> = points.collect();
    points.sort_by(|a, b| b.cmp(a));
    points.truncate(count);
    points
}

fn sum(points: &[Rational]) -> Rational {
    Rational::sum(points).unwrap_or(Rational::ZERO)
}

fn add(a: Rational, b: Rational) -> Rational {
    a.checked_add(b).unwrap_or(a)
}

#[cfg(feature = "render")]
pub use read::MarksError;
#[cfg(feature = "render")]
pub(crate) use read::{check, read};

#[cfg(feature = "render")]
mod read;

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(above: i128, below: i128) -> Exact {
        Exact(Rational::new(above, below).expect("a fraction"))
    }

    fn question(points: i32, open: i32, max: i32) -> Scored<'static> {
        Scored {
            points: points.into(),
            open: open.into(),
            max: max.into(),
            bonus: false,
            section: "",
        }
    }

    #[test]
    fn what_is_open_stays_open_in_the_best_questions() {
        let marks = Marks {
            best: vec![Best {
                section: String::new(),
                count: 1,
            }],
            ..Marks::default()
        };
        // The second may come to 9, and then it is the one that counts.
        let total = marks.total(&[question(6, 0, 10), question(4, 5, 10)]);
        assert_eq!(
            (total.points, total.open, total.max),
            (6.into(), 3.into(), 10.into())
        );
        // At most 5: it never counts.
        let total = marks.total(&[question(6, 0, 10), question(4, 1, 10)]);
        assert_eq!((total.points, total.open), (6.into(), 0.into()));
    }

    #[test]
    fn bonus_is_beyond_the_points_of_the_sheet() {
        let bonus = Scored {
            bonus: true,
            ..question(3, 0, 5)
        };
        let total = Marks::default().total(&[question(10, 0, 10), bonus]);
        assert_eq!((total.points, total.max), (13.into(), 10.into()));
    }

    #[test]
    fn points_are_rounded_in_the_direction_that_is_stated() {
        let rounded = |points: Rational, direction| {
            let marks = Marks {
                rounding: Some(Rounding {
                    step: exact(1, 2),
                    direction,
                }),
                ..Marks::default()
            };
            marks.rounded(points)
        };
        let quarter = exact(29, 4).0;
        assert_eq!(rounded(quarter, Direction::Nearest), exact(15, 2).0);
        assert_eq!(rounded(quarter, Direction::Up), exact(15, 2).0);
        assert_eq!(rounded(quarter, Direction::Down), 7.into());
        assert_eq!(rounded(exact(-1, 4).0, Direction::Down), exact(-1, 2).0);
        assert_eq!(rounded(exact(-1, 4).0, Direction::Nearest), 0.into());
    }

    #[test]
    fn a_grade_is_stated_where_it_does_not_depend_on_what_is_open() {
        let step = |grade: &str, from| GradeStep {
            grade: grade.to_owned(),
            from: Bound::Share(from),
        };
        let marks = Marks {
            scale: vec![
                step("A", exact(3, 4)),
                step("B", exact(1, 2)),
                step("F", exact(0, 1)),
            ],
            pass: Some(Bound::Share(exact(1, 2))),
            ..Marks::default()
        };
        let worth = |points: i32, open: i32| {
            let total = Total {
                points: points.into(),
                open: open.into(),
                max: 20.into(),
            };
            let worth = marks.worth(&total);
            (worth.grades.join(" to "), worth.passed)
        };
        assert_eq!(worth(10, 4), ("B".to_owned(), Some(true)));
        assert_eq!(worth(10, 5), ("B to A".to_owned(), Some(true)));
        assert_eq!(worth(9, 1), ("F to B".to_owned(), None));
        assert_eq!(worth(0, 0), ("F".to_owned(), Some(false)));
        assert_eq!(worth(-1, 0), ("F".to_owned(), Some(false)));
    }
}
