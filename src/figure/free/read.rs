//! From the tables `[figure.free.<body>]` to free-body diagrams.

use super::company::with_company;
use super::error::FreeFault;
use super::letter::Product;
use super::{
    Acting, BodyMotion, Contact, CutBody, Force, ForceOrigin, Free, FreeError, Heading, Letter,
    Strand, TurnSense, WrittenArrow,
};
use crate::diagnostic::Finding;
use crate::expr::{Expr, Name};
use crate::figure::FigureLabel;
use crate::figure::element::{self, Role};
use crate::figure::formula::Amount;
use crate::figure::part::LineStyle;
use crate::figure::read::FigureReader;
use crate::figure::schematic::{ElementPlace, Item};
use crate::math::Math;
use crate::source::{Data, Entry, Span, Table, Text, Value, nearest};

/// No body has more arrows.
const MAX_COUNT: usize = 40;

/// A force as the bodies of a diagram have it: a component for each motion.
struct Components {
    name: Name,
    all: Vec<Option<Product>>,
}

/// What a diagram says about the forces of its body.
struct Stated {
    /// The links of a force, by its name.
    links: Vec<(String, Vec<Text>)>,
    arms: Vec<(String, Expr)>,
    arrows: Vec<(Option<Text>, Option<Expr>, WrittenArrow)>,
}

/// Reads free-body diagrams in the names of a figure, whose elements are read already.
pub(crate) struct FreeReader<'r, 'a, 's> {
    figure: &'r mut FigureReader<'a, 's>,
    items: &'r [Item],
}

impl<'r, 'a, 's> FreeReader<'r, 'a, 's> {
    pub(crate) fn new(figure: &'r mut FigureReader<'a, 's>, items: &'r [Item]) -> Self {
        Self { figure, items }
    }

    /// The free-body diagrams; `rows` are the elements as they are written.
    pub(crate) fn diagrams(mut self, rows: &[Value]) -> Free {
        self.hold_identities(rows);
        let Some(outer) = self.figure.table.table("free") else {
            return Free { bodies: Vec::new() };
        };
        let acting = self.figure.item.bodies();
        let mut found = Vec::new();
        let mut bodies = Vec::new();
        for entry in outer.entries() {
            let inner = Table::of(
                outer.source(),
                outer.problems(),
                "figure.free",
                &entry.value,
            );
            let Some(inner) = inner else { continue };
            bodies.extend(self.body(&acting, &inner, entry, &mut found));
            inner.finish();
        }
        let missing = acting.iter().filter(|own| !found.contains(&own.body));
        for own in missing {
            let name = own.body.to_string();
            self.fault(FreeFault::Missing { name }, outer.span());
        }
        Free { bodies }
    }

    fn fault(&mut self, fault: FreeFault, span: Span) {
        let error = FreeError { fault, span };
        self.figure
            .findings
            .push(Finding::of(&error, self.figure.table.source()));
    }

    fn body(
        &mut self,
        acting: &[Acting],
        table: &Table<'s>,
        entry: &'s Entry,
        found: &mut Vec<Name>,
    ) -> Option<CutBody> {
        let span = entry.span;
        let words = |key: &'static str| {
            let words: Vec<String> = table
                .texts(key)
                .into_iter()
                .map(|text| text.value)
                .collect();
            if words.is_empty() {
                vec![entry.key.clone()]
            } else {
                words
            }
        };
        let mut laws: Vec<&Acting> = Vec::new();
        for name in words("bodies") {
            match acting.iter().find(|own| own.body.as_str() == name) {
                Some(own) => {
                    found.push(own.body.clone());
                    laws.push(own);
                }
                None => {
                    let known = acting.iter().map(|own| own.body.to_string()).collect();
                    self.fault(FreeFault::Unknown { name, known }, span);
                }
            }
        }
        let mut kept: Vec<usize> = Vec::new();
        for id in words("keep") {
            kept.extend(self.identified(&id, span));
        }
        let slots = with_company(self.items, &mut kept);
        let motions = self.motions(&laws, table, &kept, &slots, span);
        let stated = self.stated(table);
        let shift = table
            .value("shift")
            .and_then(|value| self.figure.pair(table, "shift", value));
        if laws.is_empty() || kept.is_empty() {
            return None;
        }
        let mut body = CutBody {
            name: entry.key.clone(),
            kept,
            shift,
            motions: motions?,
            forces: Vec::new(),
            idle: Vec::new(),
            span,
        };
        self.forces(&laws, stated, &mut body);
        Some(body)
    }

    /// The element with an identity.
    fn identified(&mut self, id: &str, span: Span) -> Option<usize> {
        let found = self
            .items
            .iter()
            .position(|item| item.id.as_deref() == Some(id));
        if found.is_none() {
            let known = self.items.iter().filter_map(|item| item.id.as_deref());
            let fault = FreeFault::Identity {
                id: id.to_owned(),
                nearest: nearest(id, known).map(str::to_owned),
            };
            self.fault(fault, span);
        }
        found
    }

    /// The ways in which the bodies of a diagram move.
    fn motions(
        &mut self,
        laws: &[&Acting],
        table: &Table<'s>,
        kept: &[usize],
        slots: &[u32],
        span: Span,
    ) -> Option<Vec<BodyMotion>> {
        let along = table
            .value("along")
            .and_then(|value| self.figure.pair(table, "along", value));
        let turn = self.figure.word(table, "turn", &["ccw", "cw"]);
        let about = table
            .value("about")
            .and_then(|value| self.figure.place(table, "about", value));
        let has_turn = laws
            .iter()
            .flat_map(|law| &law.moves)
            .any(|one| one.is_turn);
        let mut motions = Vec::new();
        for (rank, law) in laws.iter().enumerate() {
            // A law of moments that is divided by a radius moves by a length; `turn` says that it is one.
            let is_divided = turn.is_some() && !has_turn && rank + 1 == laws.len();
            for own in &law.moves {
                let shows = |kinds: &[&str]| {
                    self.items.iter().position(|item| {
                        let name = item.label.as_ref().and_then(|label| label.name.as_ref());
                        kinds.contains(&item.kind.name()) && name == Some(&own.name)
                    })
                };
                let motion = if own.is_turn || is_divided {
                    let shown = shows(&["turn"]);
                    let sense = turn
                        .map(|word| TurnSense::Written(word == "ccw"))
                        .or(shown.map(TurnSense::Shown));
                    let centre = about
                        .clone()
                        .or_else(|| shown.and_then(|item| self.items[item].ends.first().cloned()))
                        .or_else(|| slots.first().map(|slot| ElementPlace::Named(*slot)))
                        .or_else(|| {
                            kept.first()
                                .and_then(|item| self.items[*item].ends.first().cloned())
                        });
                    sense
                        .zip(centre)
                        .map(|(sense, centre)| BodyMotion::Turn(centre, sense))
                } else {
                    along
                        .clone()
                        .map(Heading::Written)
                        .or(shows(&["coordinate", "arrow"]).map(Heading::Shown))
                        .map(BodyMotion::Along)
                };
                if motion.is_none() {
                    let fault = FreeFault::Direction {
                        name: own.name.to_string(),
                        is_turn: own.is_turn,
                    };
                    self.fault(fault, span);
                }
                motions.push(motion);
            }
        }
        motions.into_iter().collect()
    }

    /// Links, arms and arrows.
    fn stated(&mut self, table: &Table<'s>) -> Stated {
        let mut stated = Stated {
            links: Vec::new(),
            arms: Vec::new(),
            arrows: Vec::new(),
        };
        if let Some(links) = table.table("links") {
            for entry in links.entries().iter().take(MAX_COUNT) {
                let ids = match &entry.value.data {
                    Data::List(items) => items.as_slice(),
                    _ => std::slice::from_ref(&entry.value),
                };
                let ids = ids.iter().filter_map(|id| links.as_text(&entry.key, id));
                stated.links.push((entry.key.clone(), ids.collect()));
            }
        }
        if let Some(arms) = table.table("arms") {
            for entry in arms.entries().iter().take(MAX_COUNT) {
                let arm = arms
                    .as_formula(&entry.key, &entry.value)
                    .and_then(|text| self.formula(&text));
                stated.arms.extend(arm.map(|arm| (entry.key.clone(), arm)));
            }
        }
        if let Some(arrows) = table.value("arrows") {
            let rows = table.items("arrows", arrows);
            for row in rows.iter().take(MAX_COUNT) {
                let arrow = self.arrow(table, row);
                stated.arrows.extend(arrow);
            }
        }
        stated
    }

    fn formula(&mut self, text: &Text) -> Option<Expr> {
        let expr = Expr::read(&text.value);
        expr.map_err(|error| self.figure.find_in(&error, text)).ok()
    }

    /// An arrow that is written: the force that it names, the formula of its letter, and the arrow.
    fn arrow(
        &mut self,
        outer: &Table<'s>,
        row: &'s Value,
    ) -> Option<(Option<Text>, Option<Expr>, WrittenArrow)> {
        let table = Table::of(outer.source(), outer.problems(), "figure.free.arrows", row)?;
        let first = table.entries().first();
        let known = first.and_then(|entry| {
            let found = Contact::ALL.iter().find(|(name, _)| *name == entry.key);
            found.copied()
        });
        let Some((key, kind)) = known else {
            self.figure.find(&crate::figure::FigureError::Word {
                key: "arrow",
                found: first.map(|entry| entry.key.clone()).unwrap_or_default(),
                known: Contact::ALL.iter().map(|(name, _)| *name).collect(),
                span: row.span,
            });
            return None;
        };
        let value = table.value(key)?;
        let place = self.figure.place(&table, key, value);
        let direction = table
            .value("direction")
            .and_then(|value| self.figure.pair(&table, "direction", value));
        let at = self
            .figure
            .word(&table, "at", &crate::figure::Side::WORDS)
            .and_then(crate::figure::Side::of_word);
        let force = table.text("force");
        let label = table.text("label");
        let written = label
            .as_ref()
            .and_then(|text| self.figure.written(text, false));
        let formula = label
            .as_ref()
            .filter(|text| !text.value.starts_with('\''))
            .and_then(|text| Expr::read(&text.value).ok());
        table.finish();
        let usual = match kind {
            Contact::Normal => "N",
            Contact::Friction => "F",
            Contact::Reaction => "R",
            Contact::Weight => "W",
        };
        let label = written.map_or_else(
            || (FigureLabel::words(usual), Math::text(usual)),
            |written| (written.label, written.math),
        );
        let item = Item {
            kind: element::kind("force")?,
            id: None,
            ends: vec![place?],
            settings: Vec::new(),
            label: None,
            at,
            style: LineStyle::default(),
        };
        let written = WrittenArrow {
            kind,
            item,
            label,
            direction,
            share: None,
        };
        Some((force, formula, written))
    }

    /// Joins each force of the model with its arrow.
    fn forces(&mut self, laws: &[&Acting], stated: Stated, body: &mut CutBody) {
        let forces = components(laws);
        let Stated {
            links,
            arms,
            mut arrows,
        } = stated;
        let strange = |named: &str| forces.iter().all(|force| force.name.as_str() != named);
        let named = links.iter().map(|(name, _)| name);
        let named = named.chain(arms.iter().map(|(name, _)| name)).cloned();
        let by_arrows = arrows.iter().filter_map(|(force, ..)| force.as_ref());
        let named: Vec<String> = named
            .chain(by_arrows.map(|text| text.value.clone()))
            .collect();
        for force in named.into_iter().filter(|name| strange(name)) {
            let fault = FreeFault::NoForce {
                body: body.name.clone(),
                force,
            };
            self.fault(fault, body.span);
        }
        for force in forces {
            let name = force.name.to_string();
            let arm = arms
                .iter()
                .find(|(own, _)| *own == name)
                .map(|(_, arm)| arm);
            let Some(product) = self.letter(&force, arm, body) else {
                continue;
            };
            let mine = arrows.iter().position(|(own, _, written)| match own {
                Some(own) => own.value == name,
                None => Contact::ALL.contains(&(name.as_str(), written.kind)),
            });
            let source = match mine.map(|place| arrows.remove(place)) {
                Some((_, formula, written)) => {
                    self.written_force(&product, formula.as_ref(), written, body, &name)
                }
                None => self.cut(&links, &name, &product, body.span),
            };
            let Some(source) = source else {
                let fault = FreeFault::NoArrow {
                    body: body.name.clone(),
                    force: name,
                };
                self.fault(fault, body.span);
                continue;
            };
            let velocity = product
                .velocity()
                .map(|velocity| self.figure.item.typeset(velocity));
            body.forces.push(Force {
                name: force.name,
                signs: force
                    .all
                    .iter()
                    .map(|own| own.as_ref().map(Product::is_negative))
                    .collect(),
                source,
                velocity,
            });
        }
        body.idle
            .extend(arrows.into_iter().map(|(_, _, written)| written));
    }

    /// The letter of a force: its first component, per length of its arm where it is a moment.
    fn letter(
        &mut self,
        force: &Components,
        arm: Option<&Expr>,
        body: &CutBody,
    ) -> Option<Product> {
        let first = force.all.iter().position(Option::is_some)?;
        let component = force.all[first].as_ref()?.clone();
        let is_turn = matches!(body.motions[first], BodyMotion::Turn(..));
        let letter = match arm.filter(|_| is_turn) {
            None => Some(component),
            Some(arm) => Product::of(arm).and_then(|arm| component.over(&arm)),
        };
        // In the other components the same force acts, with an arm.
        let is_one = letter.as_ref().is_some_and(|letter| {
            let others = force.all.iter().skip(first + 1).flatten();
            let mut shares = others.map(|own| own.clone().over(letter));
            shares.all(|rest| rest.is_some())
        });
        if !is_one {
            let fault = FreeFault::Arm {
                body: body.name.clone(),
                force: force.name.to_string(),
                arm: arm.map_or_else(|| "its arm".to_owned(), Expr::to_string),
            };
            self.fault(fault, body.span);
            return None;
        }
        letter
    }

    /// A force whose arrow is written; it has the letter of the model where it has none of its own.
    fn written_force(
        &mut self,
        product: &Product,
        formula: Option<&Expr>,
        mut written: WrittenArrow,
        body: &CutBody,
        force: &str,
    ) -> Option<ForceOrigin> {
        match formula.and_then(Product::of) {
            None => written.label = self.set(product),
            Some(own) => match product.clone().over(&own) {
                Some(rest) => written.share = self.share(&rest.letter(), body.span),
                None => {
                    let fault = FreeFault::Arm {
                        body: body.name.clone(),
                        force: force.to_owned(),
                        arm: own.letter().to_string(),
                    };
                    self.fault(fault, body.span);
                    return None;
                }
            },
        }
        Some(ForceOrigin::Written(written))
    }

    fn share(&mut self, formula: &Expr, span: Span) -> Option<Amount> {
        let text = Text {
            value: formula.to_string(),
            span,
        };
        self.figure.amount(&text)
    }

    /// A force whose arrow is left by a link, or shown by the figure.
    fn cut(
        &mut self,
        links: &[(String, Vec<Text>)],
        name: &str,
        product: &Product,
        span: Span,
    ) -> Option<ForceOrigin> {
        let linked = links.iter().find(|(own, _)| own == name);
        let Some((_, ids)) = linked else {
            let item = self
                .items
                .iter()
                .position(|item| item.id.as_deref() == Some(name))?;
            return match self.items[item].kind.role() {
                Role::Thing(_) => Some(ForceOrigin::Shown(item)),
                Role::Link(_) => Some(self.links(vec![(item, Strand::All)], product)),
                _ => None,
            };
        };
        let mut cut = Vec::new();
        for text in ids {
            let (id, strand) = match text.value.split_once('.') {
                Some((id, "first")) => (id, Strand::First),
                Some((id, "last")) => (id, Strand::Last),
                _ => (text.value.as_str(), Strand::All),
            };
            let item = self.identified(id, span)?;
            if !matches!(self.items[item].kind.role(), Role::Link(_)) {
                return None;
            }
            cut.push((item, strand));
        }
        (!cut.is_empty()).then(|| self.links(cut, product))
    }

    fn links(&self, links: Vec<(usize, Strand)>, product: &Product) -> ForceOrigin {
        let letter = Letter {
            one: self.set(product),
            each: self.set(&product.clone().shared(2)),
        };
        ForceOrigin::Links { links, letter }
    }

    fn set(&self, product: &Product) -> (FigureLabel, Math) {
        let math = self.figure.item.typeset(&product.letter());
        (FigureLabel::of(&math), math)
    }

    /// Elements do not share an identity.
    fn hold_identities(&mut self, rows: &[Value]) {
        for (place, item) in self.items.iter().enumerate() {
            let Some(id) = &item.id else { continue };
            if self.items[..place]
                .iter()
                .any(|other| other.id.as_ref() == Some(id))
            {
                let span = rows.iter().filter(|row| has_id(row, id)).nth(1);
                let span = span.map_or(Span::NONE, |row| row.span);
                self.fault(FreeFault::Twice { id: id.clone() }, span);
            }
        }
    }
}

fn has_id(row: &Value, id: &str) -> bool {
    let Data::Table(entries) = &row.data else {
        return false;
    };
    entries.iter().any(|entry| {
        entry.key == "id" && matches!(&entry.value.data, Data::Text(text) if **text == *id)
    })
}

/// The forces of several laws, each with a component for each of their motions.
fn components(laws: &[&Acting]) -> Vec<Components> {
    let motions: usize = laws.iter().map(|law| law.moves.len()).sum();
    let mut forces: Vec<Components> = Vec::new();
    let mut from = 0;
    for law in laws {
        for (name, all) in &law.forces {
            let place = match forces.iter().position(|own| own.name == *name) {
                Some(place) => place,
                None => {
                    let all = (0..motions).map(|_| None).collect();
                    let name = name.clone();
                    forces.push(Components { name, all });
                    forces.len() - 1
                }
            };
            for (at, component) in all.iter().enumerate() {
                forces[place].all[from + at] = Product::of(component);
            }
        }
        from += law.moves.len();
    }
    forces
}
