//! Choosing the variants of a run: the first seeds whose items are all suitable, alike and not repeated.
//!
//! Looking at a seed is pure and costs most, so [`Chooser::propose`] can be called from many threads;
//! [`Chooser::take`] then decides in the order of the run. What is taken does not depend on how many
//! were proposed at once.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

use super::candidate::{AskedQuestion, Candidate, Fixed, mark, question_mark};
use super::draw::SheetError;
use super::fairness::{Alike, Fairness, QuestionFairness};
use super::manifest::QuestionEntry;
use super::plan::Plan;
use super::seat::Seat;
use super::sheet::{Sheet, SheetQuestion, Student};
use super::usual::{Unusual, Usual, size};
use crate::seed::Variant;
use crate::suitability::{self, Unfit};

/// Chooses the variants of a run.
pub struct Chooser<'p, 'c> {
    plan: &'p Plan<'c>,
    /// By place in the plan.
    questions: Vec<TakenData>,
    codes: BTreeSet<Variant>,
    /// By place in the run.
    taken: BTreeMap<u64, Variant>,
    has_pseudonyms: bool,
    /// The identities of the students, by place in the run.
    students: Vec<String>,
    /// What they have already, by place in the run.
    fixed: BTreeMap<u64, Fixed>,
    /// What they had on an earlier sheet, of which they get nothing again, by place in the run.
    barred: BTreeMap<u64, Vec<QuestionEntry>>,
    /// The places of those who gave way.
    gave_way: BTreeSet<u64>,
    /// The seats of the students, by place in the run.
    seats: Vec<Option<(usize, Seat)>>,
    /// Who has a seat.
    room: BTreeMap<(usize, Seat), Vec<usize>>,
    /// What neighbours must not share, of those that were taken, by place in the run.
    marks: BTreeMap<u64, Vec<BTreeSet<u64>>>,
    /// Seeds that were tried and not taken.
    rejected: u64,
    /// By item, how often its data were not suitable.
    unsuitable: BTreeMap<String, u64>,
    /// Sheets that were taken though a wrong method may come within a tolerance.
    lenient: u64,
    fairness: Fairness,
}

/// What was taken for one question of the plan.
struct TakenData {
    /// How many different data there are, constraints aside.
    instances: u64,
    /// Digests of those that were taken.
    data: BTreeSet<u64>,
    /// What is usual for each candidate.
    usual: Vec<OnceLock<Usual>>,
}

/// Why a seed is not taken.
#[derive(Debug, thiserror::Error)]
enum Objection {
    #[error("its data repeat an earlier variant")]
    Repeats,
    #[error("it shares data or an answer with a neighbour")]
    Neighbour,
    #[error(transparent)]
    Unusual(#[from] Unusual),
    #[error(transparent)]
    Unfit(#[from] Unfit),
}

/// Seeds tried for one variant before one is taken that repeats another or is not like most.
const TRIES_FOR_FAIRNESS: u64 = 60;
/// Seeds tried for one variant before one is taken on which a wrong method comes within a tolerance.
// A sheet of forty questions takes some twenty; only one of about a hundred takes more than these.
const TRIES_FOR_METHODS: u64 = 340;
/// Seeds tried for one variant before giving up.
const MAX_TRIES: u64 = 400;
/// The same where nothing of an earlier sheet may come again: drawing data alone costs little.
const MAX_TRIES_APART: u64 = 20_000;

impl<'p, 'c> Chooser<'p, 'c> {
    /// The seeds that are tried for one variant at most, or for one that has nothing of an earlier sheet.
    pub fn max_tries(is_apart: bool) -> u64 {
        if is_apart { MAX_TRIES_APART } else { MAX_TRIES }
    }

    /// A chooser at the first variant of a plan; `students` are those of the class list, if there is one, of whom some
    /// have a sheet already.
    pub fn new(
        plan: &'p Plan<'c>,
        students: &[Student],
        mut fixed: BTreeMap<String, Fixed>,
    ) -> Self {
        let questions = plan.questions.iter();
        // Seats of two rooms are no neighbours, whatever their numbers are.
        let mut rooms = BTreeMap::new();
        let mut seat = |student: &Student| {
            let count = rooms.len();
            let room = *rooms.entry(student.room.clone()).or_insert(count);
            Some((room, Seat::read(&student.seat)?))
        };
        let seats: Vec<Option<(usize, Seat)>> = students.iter().map(&mut seat).collect();
        let mut room: BTreeMap<(usize, Seat), Vec<usize>> = BTreeMap::new();
        for (place, seat) in seats.iter().enumerate() {
            if let Some(seat) = seat {
                room.entry(*seat).or_default().push(place);
            }
        }
        Self {
            plan,
            questions: questions
                .clone()
                .map(|planned| TakenData {
                    instances: planned.instances(),
                    data: BTreeSet::new(),
                    usual: planned.candidates.iter().map(|_| OnceLock::new()).collect(),
                })
                .collect(),
            codes: BTreeSet::new(),
            taken: BTreeMap::new(),
            has_pseudonyms: false,
            fixed: (0..)
                .zip(students)
                .filter_map(|(place, student)| Some((place, fixed.remove(&student.id)?)))
                .collect(),
            students: students.iter().map(|student| student.id.clone()).collect(),
            barred: BTreeMap::new(),
            gave_way: BTreeSet::new(),
            seats,
            room,
            marks: BTreeMap::new(),
            rejected: 0,
            unsuitable: BTreeMap::new(),
            lenient: 0,
            fairness: Fairness {
                questions: questions.map(|_| QuestionFairness::default()).collect(),
                ..Fairness::default()
            },
        }
    }

    /// The places of a run of `count` sheets in the order in which they are to be taken: first those that are fixed, then
    /// the students by a keyed order of their identities, then what stands beside the list.
    ///
    /// So it does not matter in which rows students stand, and one who is added moves only those who rank behind and
    /// would have the same.
    pub fn order(&self, count: usize) -> Vec<u64> {
        let mut order: Vec<u64> = (0..count as u64).collect();
        order.sort_by_cached_key(|place| match self.students.get(*place as usize) {
            Some(id) => {
                let fixed = self.fixed.get(place);
                let is_free = fixed.is_none_or(|fixed| fixed.has_moved);
                (0, is_free, self.plan.rank(id))
            }
            None => (1, true, *place),
        });
        order
    }

    /// The variant at a place of the run, and an attempt at it.
    fn variant(&self, index: u64, attempt: u64) -> Variant {
        match self.students.get(index as usize) {
            Some(id) => self.plan.variant_of_student(id, attempt),
            None => self
                .plan
                .variant(index - self.students.len() as u64, attempt),
        }
    }

    /// The same, but what it reports of students names the codes of their sheets.
    #[must_use]
    pub fn with_pseudonyms(self) -> Self {
        Self {
            has_pseudonyms: true,
            ..self
        }
    }

    /// The same, but students get no datum that they had: the questions of an earlier sheet, by identity.
    #[must_use]
    pub fn without(self, mut earlier: BTreeMap<String, Vec<QuestionEntry>>) -> Self {
        let places = (0..).zip(&self.students);
        let barred = places
            .filter_map(|(place, id)| Some((place, earlier.remove(id)?)))
            .collect();
        Self { barred, ..self }
    }

    /// A datum that is drawn and was on an earlier sheet of the same student.
    fn barred(&self, index: u64, sheet: &Sheet<'c>) -> Option<String> {
        let earlier = self.barred.get(&index)?;
        for question in &sheet.questions {
            let template = question.solution.template();
            let set = &self.plan.questions[question.place].set;
            let values = question.solution.instance().values();
            let drawn = template.parameters.iter().zip(values).filter(|(own, _)| {
                let is_drawn = own.grid.is_some_and(|grid| grid.count() > 1);
                is_drawn && set.iter().all(|(name, _)| name != own.name.as_str())
            });
            let before = || earlier.iter().filter(|entry| entry.item == template.id);
            for (parameter, value) in drawn {
                let (name, value) = (parameter.name.as_str(), value.to_string());
                if before().any(|entry| entry.values.get(name) == Some(&value)) {
                    return Some(format!("`{name} = {value}` of {}", template.id));
                }
            }
        }
        None
    }

    /// What a page calls the sheet at a place of the run, which has been taken.
    fn name(&self, place: u64) -> String {
        let id = self.students.get(place as usize);
        match id.filter(|_| !self.has_pseudonyms) {
            Some(id) => id.clone(),
            None => self
                .taken
                .get(&place)
                .map(Variant::to_string)
                .unwrap_or_default(),
        }
    }

    /// How many seeds were tried and not taken so far.
    pub fn rejected(&self) -> u64 {
        self.rejected
    }

    /// The items whose data were not suitable in seeds that were tried, with how often; the costliest first.
    pub fn unsuitable(&self) -> Vec<(&str, u64)> {
        let counts = self.unsuitable.iter();
        let mut counts: Vec<(&str, u64)> = counts.map(|(item, n)| (item.as_str(), *n)).collect();
        counts.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
        counts
    }

    /// How many sheets were taken though a wrong method may come within a tolerance: no seed suited all of their questions.
    pub fn lenient(&self) -> u64 {
        self.lenient
    }

    /// The variants that were taken so far, by place in the run.
    pub fn taken(&self) -> impl Iterator<Item = Variant> + '_ {
        self.taken.values().copied()
    }

    /// The places of those who gave way to another student so far.
    pub fn gave_way(&self) -> &BTreeSet<u64> {
        &self.gave_way
    }

    /// How alike the variants are that were taken so far.
    pub fn fairness(&self) -> &Fairness {
        &self.fairness
    }

    /// The first attempt at the variant `index`, not before `from`, that is suitable, like most others, and
    /// repeats nothing that was taken so far.
    ///
    /// # Errors
    ///
    /// [`SheetError`].
    pub fn propose(&self, index: u64, from: u64) -> Result<Candidate, SheetError> {
        if from == 0
            && let Some(candidate) = self.fixed(index)
            && self.accepts(&candidate).is_ok()
        {
            return Ok(candidate);
        }
        let is_apart = self.barred.contains_key(&index);
        let most = Self::max_tries(is_apart);
        let mut shared: BTreeMap<String, u64> = BTreeMap::new();
        // What has a datum of the first sheet says nothing of fairness.
        let mut tries = if is_apart { 0 } else { from };
        let mut last = None;
        let mut unsuitable = Vec::new();
        // Whoever proposes again does so because another has what was proposed before.
        let mut gave_way = from > 0;
        for attempt in from..from.max(most) {
            let variant = self.variant(index, attempt);
            let sheet = Sheet::draw(self.plan, variant, None)?;
            if let Some(datum) = self.barred(index, &sheet) {
                *shared.entry(datum).or_default() += 1;
                continue;
            }
            if tries >= MAX_TRIES {
                break;
            }
            let judged = self.judge(index, [attempt, tries], &sheet);
            tries += 1;
            match judged {
                Ok(candidate) => {
                    return Ok(Candidate {
                        gave_way,
                        unsuitable,
                        ..candidate
                    });
                }
                Err((objection, item)) => {
                    unsuitable.extend(item.clone());
                    gave_way |= matches!(objection, Objection::Repeats | Objection::Neighbour);
                    last = Some(item.map_or_else(
                        || objection.to_string(),
                        |item| format!("{item}, {objection}"),
                    ));
                }
            }
        }
        let most_shared = shared.into_iter().max_by_key(|(_, count)| *count);
        if let Some((datum, _)) = most_shared.filter(|_| last.is_none()) {
            return Err(SheetError::Shared {
                attempts: most,
                datum,
            });
        }
        Err(SheetError::NoVariant {
            attempts: MAX_TRIES,
            reason: last.unwrap_or_default(),
        })
    }

    /// What a place has already, if that can still be drawn and what is new in it is suitable.
    fn fixed(&self, index: u64) -> Option<Candidate> {
        let fixed = self.fixed.get(&index)?;
        let sheet = Sheet::draw(self.plan, fixed.variant, None).ok()?;
        let mut candidate = Candidate::of(index, 0, &sheet);
        candidate.is_fixed = !fixed.has_moved;
        candidate.gave_way = fixed.gave_way;
        for question in &sheet.questions {
            if !fixed.questions.contains(&question_mark(question)) {
                suitability::judge(&question.solution, &question.parts).ok()?;
            }
            let data = candidate.questions[question.place].data;
            candidate.questions[question.place] = self.asked(question, data);
        }
        Some(candidate)
    }

    /// Takes a candidate, unless it repeats what was taken since it was proposed; then another has to be proposed,
    /// from its [next attempt](Candidate::next_attempt).
    ///
    /// Candidates are taken in the order of the run.
    pub fn take(&mut self, candidate: &Candidate) -> bool {
        if self.accepts(candidate).is_err() {
            return false;
        }
        self.codes.insert(candidate.variant);
        self.taken.insert(candidate.index, candidate.variant);
        self.rejected += candidate.tries;
        self.lenient += u64::from(!candidate.is_fixed && candidate.tries >= TRIES_FOR_METHODS);
        for item in &candidate.unsuitable {
            *self.unsuitable.entry(item.clone()).or_default() += 1;
        }
        self.fairness.variants += 1;
        let neighbours = self.neighbours(candidate.index);
        let count = neighbours.clone().count();
        let alike: Vec<(u64, Vec<usize>)> = neighbours
            .map(|(place, marks)| (place, candidate.shared(marks)))
            .filter(|(_, questions)| !questions.is_empty())
            .collect();
        self.fairness.neighbours += count as u64;
        self.fairness.alike_neighbours += alike.len() as u64;
        let room = Fairness::MAX_LISTED.saturating_sub(self.fairness.alike.len());
        let own = self.name(candidate.index);
        for (place, questions) in alike.into_iter().take(room) {
            let students = [self.name(place), own.clone()];
            self.fairness.alike.push(Alike {
                students,
                questions,
            });
        }
        if candidate.gave_way && (candidate.index as usize) < self.students.len() {
            self.fairness.gave_way.push(own);
            self.gave_way.insert(candidate.index);
        }
        for (place, asked) in candidate.questions.iter().enumerate() {
            let item = self.plan.questions[place].candidates[asked.item];
            let taken = &mut self.questions[place];
            let is_new = taken.data.insert(asked.data) || taken.is_the_same_for_all();
            self.fairness.questions[place].add(item, asked, is_new);
        }
        if !self.seats.is_empty() {
            let marks = candidate.questions.iter();
            let marks = marks.map(|asked| asked.marks.iter().copied().collect());
            self.marks.insert(candidate.index, marks.collect());
        }
        true
    }

    /// Whether a sheet can be taken; the cheapest questions come first. With an objection, the item that it is about.
    fn judge(
        &self,
        index: u64,
        [attempt, tries]: [u64; 2],
        sheet: &Sheet<'c>,
    ) -> Result<Candidate, (Objection, Option<String>)> {
        let mut candidate = Candidate {
            tries,
            ..Candidate::of(index, attempt, sheet)
        };
        self.accepts(&candidate)
            .map_err(|objection| (objection, None))?;
        let refuse = |question: &SheetQuestion<'_>, objection| {
            let item = question.solution.template().id.to_string();
            (objection, Some(item))
        };
        for question in &sheet.questions {
            let data = candidate.questions[question.place].data;
            let asked = self.judge_question(tries, question, data);
            candidate.questions[question.place] =
                asked.map_err(|objection| refuse(question, objection))?;
        }
        if tries < TRIES_FOR_METHODS {
            for judge_methods in [
                suitability::judge_methods_of_numbers,
                suitability::judge_methods_of_functions,
            ] {
                for question in &sheet.questions {
                    judge_methods(&question.solution, &question.parts)
                        .map_err(|unfit| refuse(question, unfit.into()))?;
                }
            }
        }
        self.accepts(&candidate)
            .map_err(|objection| (objection, None))?;
        Ok(candidate)
    }

    fn judge_question(
        &self,
        tries: u64,
        question: &SheetQuestion<'_>,
        data: u64,
    ) -> Result<AskedQuestion, Objection> {
        suitability::judge(&question.solution, &question.parts)?;
        let asked = self.asked(question, data);
        if tries < TRIES_FOR_FAIRNESS && asked.is_unusual {
            self.usual(question).judge(question)?;
        }
        Ok(asked)
    }

    /// Whether a candidate repeats nothing, or has to be taken anyway.
    fn accepts(&self, candidate: &Candidate) -> Result<(), Objection> {
        if self.codes.contains(&candidate.variant) {
            return Err(Objection::Repeats);
        }
        if candidate.is_fixed || candidate.tries >= TRIES_FOR_FAIRNESS {
            return Ok(());
        }
        let mut pairs = self.questions.iter().zip(&candidate.questions);
        if pairs.any(|(question, asked)| question.repeats(asked.data)) {
            return Err(Objection::Repeats);
        }
        if self
            .neighbours(candidate.index)
            .any(|(_, marks)| !candidate.shared(marks).is_empty())
        {
            return Err(Objection::Neighbour);
        }
        Ok(())
    }

    /// What the neighbours of a place have, of those that were taken.
    fn neighbours(&self, index: u64) -> impl Iterator<Item = (u64, &Vec<BTreeSet<u64>>)> + Clone {
        let seat = self.seats.get(index as usize).copied().flatten();
        let around = seat.into_iter();
        let around = around.flat_map(|(room, seat)| seat.around().map(move |near| (room, near)));
        let near = around.filter_map(|seat| self.room.get(&seat)).flatten();
        near.filter(move |place| **place as u64 != index)
            .filter_map(|place| Some((*place as u64, self.marks.get(&(*place as u64))?)))
    }

    fn asked(&self, question: &SheetQuestion<'_>, data: u64) -> AskedQuestion {
        let usual = self.usual(question);
        let solution = &question.solution;
        let sizes = question
            .parts
            .iter()
            .map(|part| (*part, size(solution, *part)));
        let answers = question.parts.iter().filter_map(|part| {
            let key = solution.key(*part).ok().filter(|_| usual.differs(*part))?;
            Some(mark(
                &[question.place as u64, *part as u64],
                &key.math.plain(),
            ))
        });
        AskedQuestion {
            item: self.item(question),
            data,
            parts: sizes.collect(),
            is_unusual: usual.judge(question).is_err(),
            marks: if self.seats.is_empty() || self.questions[question.place].is_the_same_for_all()
            {
                Vec::new()
            } else {
                std::iter::once(data).chain(answers).collect()
            },
        }
    }

    fn item(&self, question: &SheetQuestion<'_>) -> usize {
        let id = &question.solution.template().id;
        let mut candidates = self.plan.questions[question.place].candidates.iter();
        candidates
            .position(|item| item.id == *id)
            .unwrap_or_default()
    }

    /// What is usual for a question; looked for when it is first needed.
    fn usual(&self, question: &SheetQuestion<'_>) -> &Usual {
        let planned = &self.plan.questions[question.place];
        let usual = &self.questions[question.place].usual[self.item(question)];
        usual.get_or_init(|| Usual::of(question.solution.template(), planned))
    }
}

impl TakenData {
    /// Whether data were taken before, while there are others.
    fn repeats(&self, data: u64) -> bool {
        self.data.contains(&data) && (self.data.len() as u64) < self.instances
    }

    /// Whether nothing is drawn, so that it is meant to be the same for all.
    fn is_the_same_for_all(&self) -> bool {
        self.instances <= 1
    }
}
