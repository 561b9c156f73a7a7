//! A plan: a blueprint whose items were found in the bank.

mod error;

use std::collections::{BTreeMap, BTreeSet};

use self::error::PlanError;
use super::blueprint::{Blueprint, Choice, Filter, Question};
use super::fairness::Fairness;
use crate::answer::AnswerKind;
use crate::bank::{Catalogue, Chapter, ItemId, Part, Space, Template, shortened};
use crate::diagnostic::{Finding, Severity};
use crate::message::Language;
use crate::numerics::Rational;
use crate::seed::{Secret, Seed, Streams, Variant};
use crate::source::{Span, Text, nearest};

/// A blueprint whose items were found.
#[derive(Debug)]
pub struct Plan<'c> {
    /// The blueprint that the plan follows.
    pub blueprint: &'c Blueprint,
    /// Its questions, each pick as many times as it counts.
    pub questions: Vec<Planned<'c>>,
    /// The chapters whose formulas are printed.
    pub formulas: Vec<&'c Chapter>,
    /// What keys the seeds.
    pub secret: Option<Secret>,
    /// What the teacher should know though all can be made.
    pub warnings: Vec<Finding>,
    /// A further sitting of the same exam, of which students get other variants; empty for the first.
    pub sitting: String,
}

/// A question whose item, or whose candidates, are known.
#[derive(Clone, Debug)]
pub struct Planned<'c> {
    /// The item, or those of which one is drawn for each variant.
    pub candidates: Vec<&'c Template>,
    /// The parts and groups that are asked, by name; all if empty.
    pub parts: Vec<String>,
    /// Points of the whole question.
    pub points: Option<Rational>,
    /// Points of single parts and groups.
    pub part_points: Vec<(String, Rational)>,
    /// Room for work at parts that have none of their own.
    pub usual_space: Option<Space>,
    /// Room for work at each part, in place of what the item says.
    pub space: Option<Space>,
    /// Room for work at single parts and groups.
    pub part_space: Vec<(String, Space)>,
    /// Data that are fixed.
    pub set: Vec<(String, String)>,
    /// Whether its points are beyond those of the sheet.
    pub bonus: bool,
    /// Its section; empty if it is in none.
    pub section: String,
}

impl<'c> Plan<'c> {
    /// Looks up the items of a blueprint.
    ///
    /// # Errors
    ///
    /// All findings at once.
    pub fn of(
        blueprint: &'c Blueprint,
        catalogue: &'c Catalogue,
        secret: Option<Secret>,
    ) -> Result<Self, Vec<Finding>> {
        let mut planner = Planner {
            blueprint,
            catalogue,
            findings: Vec::new(),
            questions: Vec::new(),
        };
        planner.language();
        for (place, question) in blueprint.questions.iter().enumerate() {
            planner.question(place, question);
        }
        let formulas = planner.formulas();
        Finding::sort(&mut planner.findings);
        let is_error = |finding: &Finding| finding.severity == Severity::Error;
        if planner.findings.iter().any(is_error) {
            return Err(shortened(planner.findings, &blueprint.source));
        }
        Ok(Self {
            blueprint,
            questions: planner.questions,
            formulas,
            secret,
            warnings: planner.findings,
            sitting: String::new(),
        })
    }

    /// The variant at a place of a run without a class list, and an attempt at it.
    pub fn variant(&self, index: u64, attempt: u64) -> Variant {
        let seed = Seed::new(self.blueprint.seed);
        Variant::of(seed, index, attempt, self.secret.as_ref())
    }

    /// The variant of a student, and an attempt at it.
    pub fn variant_of_student(&self, id: &str, attempt: u64) -> Variant {
        let seed = Seed::new(self.blueprint.seed);
        if self.sitting.is_empty() {
            return Variant::of_student(seed, id, attempt, self.secret.as_ref());
        }
        // No identity of a class list has a line break.
        let own = format!("{id}\n{}", self.sitting);
        Variant::of_student(seed, &own, attempt, self.secret.as_ref())
    }

    /// The files of the items that variants have, by identity: what marking needs when the bank has moved on.
    pub fn used(&self, fairness: &Fairness) -> BTreeMap<String, String> {
        let used = fairness
            .questions
            .iter()
            .flat_map(|question| question.items.keys());
        let used: BTreeSet<&ItemId> = used.collect();
        self.questions
            .iter()
            .flat_map(|planned| &planned.candidates)
            .filter(|item| used.contains(&item.id))
            .map(|item| (item.id.to_string(), item.source.text.to_string()))
            .collect()
    }

    /// Who goes first among students: the lower number.
    pub(crate) fn rank(&self, id: &str) -> u64 {
        Variant::rank(Seed::new(self.blueprint.seed), id, self.secret.as_ref())
    }
}

impl Planned<'_> {
    /// Whether it asks a part of its item.
    pub fn asks(&self, part: &Part) -> bool {
        self.parts.is_empty() || self.parts.iter().any(|name| part.is_named(name))
    }

    /// The room for work at a part: what the blueprint says of the part, then of the question, then what the item says,
    /// then what the blueprint says of all.
    pub fn space(&self, part: &Part) -> Space {
        let own = self.part_space.iter().find(|(name, _)| part.is_named(name));
        let stated = own.map(|(_, space)| *space).or(self.space);
        let stated = stated.or(part.space).or(self.usual_space);
        stated.unwrap_or(if part.answer.kind().is_by_hand() {
            Space::OF_WORK
        } else {
            Space::None
        })
    }

    /// How many different data its items can have, constraints aside; saturates.
    pub fn instances(&self) -> u64 {
        let is_free = |name: &str| self.set.iter().all(|(set, _)| set != name);
        let of_item = |item: &&Template| {
            let free = item.parameters.iter();
            let free = free.filter(|parameter| is_free(parameter.name.as_str()));
            let counts = free.filter_map(|parameter| parameter.grid.map(|grid| grid.count()));
            counts.fold(1, u64::saturating_mul)
        };
        let counts = self.candidates.iter().map(of_item);
        counts.fold(0, u64::saturating_add)
    }
}

/// Points as they were written.
fn exact(points: f64) -> Option<Rational> {
    Rational::from_decimal(&points.to_string())
}

struct Planner<'c> {
    blueprint: &'c Blueprint,
    catalogue: &'c Catalogue,
    findings: Vec<Finding>,
    questions: Vec<Planned<'c>>,
}

impl<'c> Planner<'c> {
    /// The texts of items are printed as the bank has them: what can be asked for is the language of the rest.
    fn language(&mut self) {
        let asked = &self.blueprint.language;
        let bank = &self.catalogue.bank.language;
        // `en-GB` is `en`, as far as texts are concerned.
        let primary = |tag: &str| tag.split('-').next().map(str::to_lowercase);
        if asked.span != Span::NONE && primary(&asked.value) != primary(bank) {
            let (found, bank, span) = (asked.value.clone(), bank.clone(), asked.span);
            let mut questions = self.blueprint.questions.iter();
            self.find(&match Language::of(&found) {
                // Their texts are in the language of the blueprint.
                Some(_) if questions.all(|own| matches!(own.choice, Choice::Own(_))) => return,
                Some(_) => PlanError::OtherLanguage { found, bank, span },
                None => PlanError::Language { found, bank, span },
            });
        }
    }

    fn question(&mut self, place: usize, question: &'c Question) {
        let points = question.points.and_then(exact);
        let part_points = question.part_points.iter();
        let part_points =
            part_points.filter_map(|(part, points)| Some((part.value.clone(), exact(*points)?)));
        let part_points: Vec<_> = part_points.collect();
        let planned = |candidates| Planned {
            candidates,
            parts: question
                .parts
                .iter()
                .map(|part| part.value.clone())
                .collect(),
            points,
            part_points: part_points.clone(),
            usual_space: self.blueprint.space,
            space: question.space,
            part_space: question
                .part_space
                .iter()
                .map(|(part, space)| (part.value.clone(), *space))
                .collect(),
            set: question
                .set
                .iter()
                .map(|(name, value)| (name.value.clone(), value.value.clone()))
                .collect(),
            bonus: question.bonus,
            section: question
                .section
                .as_ref()
                .map_or_else(String::new, |section| section.value.clone()),
        };
        match &question.choice {
            Choice::Item(text) => match self.catalogue.find(&text.value) {
                Some(item) => {
                    self.fits(item, question);
                    self.adds_up(item, question, points, &part_points);
                    self.questions.push(planned(vec![item]));
                }
                None => self.unknown_item(text),
            },
            Choice::Own(own) => {
                if self.catalogue.has(own.item.id.as_str()) {
                    let (found, span) = (own.item.id.to_string(), question.span);
                    return self.find(&PlanError::Known { found, span });
                }
                self.fits(&own.item, question);
                self.adds_up(&own.item, question, points, &part_points);
                self.questions.push(planned(vec![&own.item]));
            }
            Choice::Pick {
                filter,
                count,
                same,
            } => {
                if !part_points.is_empty() {
                    let span = question.span;
                    return self.find(&PlanError::PartPoints { span });
                }
                if let Some((part, _)) = question.part_space.first() {
                    let span = part.span;
                    return self.find(&PlanError::PartSpace { span });
                }
                if !self.knows(filter) {
                    return;
                }
                let found = self.pass(filter);
                if found.len() < *count {
                    let (found, wanted, span) = (found.len(), *count, question.span);
                    return self.find(&PlanError::TooFew {
                        found,
                        wanted,
                        span,
                    });
                }
                if *same {
                    let order = Streams::of(Seed::new(self.blueprint.seed), "blueprint")
                        .named(&format!("pick {place}"))
                        .permutation(found.len());
                    self.questions.extend(
                        order
                            .into_iter()
                            .take(*count)
                            .map(|at| planned(vec![found[at]])),
                    );
                } else {
                    self.questions
                        .extend((0..*count).map(|_| planned(found.clone())));
                }
            }
        }
    }

    /// The chapters whose formulas are printed: those of all items that can be asked, the same in every variant.
    fn formulas(&mut self) -> Vec<&'c Chapter> {
        let Some(place) = self.blueprint.formula_sheet else {
            return Vec::new();
        };
        let items = || {
            self.questions
                .iter()
                .flat_map(|question| &question.candidates)
        };
        let found: Vec<&Chapter> = self
            .catalogue
            .chapters
            .iter()
            .filter(|chapter| {
                let is_asked = items().any(|item| item.id.chapter() == chapter.folder);
                is_asked && !chapter.formulas.is_empty()
            })
            .collect();
        if found.is_empty() && !self.questions.is_empty() {
            self.find(&PlanError::NoFormulas { span: place });
        }
        found
    }

    /// Whether the words of a filter are those of the bank; a finding for each that is not.
    fn knows(&mut self, filter: &Filter) -> bool {
        let bank = self.catalogue;
        let chapters = bank.ids().map(ItemId::chapter).collect();
        let topics = bank.items().flat_map(|item| &item.about.topics);
        let topics = topics.map(|topic| topic.value.as_str()).collect();
        let kinds = AnswerKind::ALL.iter().map(|kind| kind.name()).collect();
        let words: [(_, _, BTreeSet<&str>); 3] = [
            ("chapter", &filter.chapter, chapters),
            ("topic", &filter.topic, topics),
            ("kind", &filter.kind, kinds),
        ];
        let mut knows_all = true;
        for (what, wanted, known) in words {
            let Some(wanted) = wanted.as_ref().filter(|own| !known.contains(&*own.value)) else {
                continue;
            };
            knows_all = false;
            let near = nearest(&wanted.value, known).map(str::to_owned);
            let (found, span) = (wanted.value.clone(), wanted.span);
            self.find(&PlanError::Word {
                what,
                found,
                nearest: near,
                span,
            });
        }
        knows_all
    }

    fn pass(&mut self, filter: &Filter) -> Vec<&'c Template> {
        for text in &filter.items {
            if self.catalogue.find(&text.value).is_none() {
                self.unknown_item(text);
            }
        }
        let fitting = self.catalogue.items().filter(|item| {
            (filter.items.is_empty() || filter.items.iter().any(|id| id.value == item.id.as_str()))
                && filter
                    .chapter
                    .as_ref()
                    .is_none_or(|chapter| chapter.value == item.id.chapter())
                && filter.topic.as_ref().is_none_or(|topic| {
                    item.about.topics.iter().any(|own| own.value == topic.value)
                })
                && (filter.levels.is_empty()
                    || filter.levels.contains(&i64::from(item.about.level)))
                && filter.kind.as_ref().is_none_or(|kind| {
                    item.parts
                        .iter()
                        .any(|part| part.answer.kind().name() == kind.value)
                })
        });
        fitting.collect()
    }

    /// Parts and data of a question have to be those of its item.
    fn fits(&mut self, item: &Template, question: &Question) {
        let pointed = question.part_points.iter().map(|(part, _)| part);
        let spaced = question.part_space.iter().map(|(part, _)| part);
        for part in question.parts.iter().chain(pointed).chain(spaced) {
            if item.parts.iter().all(|own| !own.is_named(&part.value)) {
                let near = nearest(&part.value, item.part_names()).map(str::to_owned);
                let (found, span) = (part.value.clone(), part.span);
                self.find(&PlanError::Part {
                    item: item.id.to_string(),
                    found,
                    nearest: near,
                    span,
                });
            }
        }
        for (name, value) in &question.set {
            match item.parameter(&name.value) {
                None => {
                    let names = item
                        .parameters
                        .iter()
                        .map(|parameter| parameter.name.as_str());
                    let near = nearest(&name.value, names).map(str::to_owned);
                    let (found, span) = (name.value.clone(), name.span);
                    self.find(&PlanError::Parameter {
                        item: item.id.to_string(),
                        found,
                        nearest: near,
                        span,
                    });
                }
                Some((_, parameter)) => {
                    if let Err(error) = parameter.set(&value.value) {
                        let (name, message) = (name.value.clone(), error.to_string());
                        self.find(&PlanError::Value {
                            name,
                            message,
                            span: value.span,
                        });
                    }
                }
            }
        }
    }

    /// Points of parts are those of parts that are asked, and leave what others need.
    fn adds_up(
        &mut self,
        item: &Template,
        question: &Question,
        whole: Option<Rational>,
        part_points: &[(String, Rational)],
    ) {
        let is_asked = |part: &&Part| {
            let mut named = question.parts.iter();
            question.parts.is_empty() || named.any(|name| part.is_named(&name.value))
        };
        let mut pointed = BTreeSet::new();
        for (name, _) in &question.part_points {
            let mut named = item.parts.iter().filter(|part| part.is_named(&name.value));
            let is_twice = named.clone().any(|part| !pointed.insert(part.id.as_str()));
            let (found, span) = (name.value.clone(), name.span);
            if named.clone().next().is_some() && !named.any(|part| is_asked(&part)) {
                self.find(&PlanError::NotAsked { found, span });
            } else if is_twice {
                self.find(&PlanError::Twice { found, span });
            }
        }
        let given: Vec<Rational> = part_points.iter().map(|(_, points)| *points).collect();
        let (Some(whole), Some(sum), false) =
            (whole, Rational::sum(&given), part_points.is_empty())
        else {
            return;
        };
        let mut asked = item.parts.iter().filter(is_asked);
        let is_whole = asked.all(|part| pointed.contains(part.id.as_str()));
        let is_sound = if is_whole { sum == whole } else { sum < whole };
        if !is_sound {
            let (parts, whole) = (sum.to_f64(), whole.to_f64());
            let rest = if is_whole {
                ""
            } else {
                " and leave nothing to the others"
            };
            let stated = format!(
                "the question has {whole} points, the points of its parts sum up to {parts}{rest}"
            );
            let span = question.span;
            self.find(&PlanError::Sum { stated, span });
        }
    }

    fn unknown_item(&mut self, text: &Text) {
        let (found, span) = (text.value.clone(), text.span);
        if self.catalogue.has(&found) {
            return self.find(&PlanError::Broken { found, span });
        }
        let nearest = self.catalogue.nearest(&found).map(str::to_owned);
        self.find(&PlanError::Item {
            found,
            nearest,
            span,
        });
    }

    fn find(&mut self, error: &PlanError) {
        self.findings
            .push(Finding::of(error, &self.blueprint.source));
    }
}
