//! What a schematic shows, in words, for those who cannot see it: bodies, what joins them to what, what is marked.

use super::element::Role;
use super::part::Part;
use super::schematic::Item;
use super::{Path, Point};
use crate::source::capital;

/// A title of a few words, and a description.
pub(crate) struct Story {
    pub(crate) title: String,
    pub(crate) text: String,
}

/// The words for the elements of a schematic.
pub(crate) fn story(items: &[Item], parts: &[Part<'_>]) -> Story {
    let elements: Vec<(&Item, &Part<'_>)> = items.iter().zip(parts).collect();
    let mut sentences = Vec::new();
    let bodies: Vec<String> = elements
        .iter()
        .filter_map(|(item, part)| match item.kind.role() {
            Role::Body(noun) | Role::Thing(noun) if noun != "force" && noun != "moment" => {
                Some(format!("{} {noun}{}", article(noun), named(part)))
            }
            _ => None,
        })
        .collect();
    if !bodies.is_empty() {
        sentences.push(listed(&bodies));
    }
    sentences.extend(joins(&elements));
    for (item, part) in &elements {
        if let Role::Thing(noun @ ("force" | "moment")) = item.kind.role() {
            let on = part
                .ends
                .first()
                .and_then(|end| met(&elements, end.point, noun));
            let on = on.map_or_else(String::new, |on| format!(" acts on {on}"));
            sentences.push(format!("{} {noun}{}{on}", article(noun), named(part)));
        }
    }
    let marked: Vec<String> = elements
        .iter()
        .filter(|(item, part)| item.kind.role() == Role::Measure && !part.words.is_empty())
        .map(|(_, part)| part.words.to_owned())
        .fold(Vec::new(), |mut all, word| {
            if !all.contains(&word) {
                all.push(word);
            }
            all
        });
    if !marked.is_empty() {
        let verb = if marked.len() == 1 { "is" } else { "are" };
        sentences.push(format!("marked {verb} {}", listed(&marked)));
    }
    let text: String = sentences
        .iter()
        .map(|sentence| format!("{}. ", capital(sentence)))
        .collect();
    let title = title(&elements);
    let text = match text.trim_end() {
        "" => format!("{title}."),
        text => text.to_owned(),
    };
    Story { title, text }
}

fn title(elements: &[(&Item, &Part<'_>)]) -> String {
    let mut nouns: Vec<String> = Vec::new();
    for (item, _) in elements {
        if let Role::Body(noun) | Role::Link(noun) | Role::Thing(noun) = item.kind.role()
            && !nouns.iter().any(|known| known == noun)
        {
            nouns.push(noun.to_owned());
        }
    }
    if nouns.is_empty() {
        return "Sketch".to_owned();
    }
    format!("Sketch: {}", listed(&nouns))
}

/// Links, those between the same two things together.
fn joins(elements: &[(&Item, &Part<'_>)]) -> Vec<String> {
    let mut groups: Vec<([Option<String>; 2], Vec<String>)> = Vec::new();
    for (item, part) in elements {
        let Role::Link(noun) = item.kind.role() else {
            continue;
        };
        let (Some(first), Some(last)) = (part.ends.first(), part.ends.last()) else {
            continue;
        };
        let mut ends = [first, last].map(|end| met(elements, end.point, noun));
        crate::numerics::sort_by(&mut ends, Ord::cmp);
        let link = format!("{} {noun}{}", article(noun), named(part));
        match groups.iter_mut().find(|(known, _)| *known == ends) {
            Some((_, links)) => links.push(link),
            None => groups.push((ends, vec![link])),
        }
    }
    let sentence = |(ends, links): &([Option<String>; 2], Vec<String>)| {
        let (links, verb) = (
            listed(links),
            if links.len() > 1 { "join" } else { "joins" },
        );
        match ends {
            [Some(a), Some(b)] if a != b => format!("{links} {verb} {a} to {b}"),
            [Some(one), _] | [None, Some(one)] => format!("{links} at {one}"),
            [None, None] => links,
        }
    };
    groups.iter().map(sentence).collect()
}

/// What lies at a point: a body, a bar or a ground.
fn met(elements: &[(&Item, &Part<'_>)], point: Point, except: &str) -> Option<String> {
    // 1.2 mm in print: ends that look joined may lie a line's width apart.
    const NEAR: f64 = 0.12;
    let is_near_line = |part: &Part<'_>| {
        let (a, b) = (part.ends[0].point, part.ends[part.ends.len() - 1].point);
        let mut is_near = false;
        Path::line(a, b).for_each_segment(|a, b| is_near = distance(point, a, b) < NEAR);
        is_near
    };
    let body = elements.iter().find_map(|(item, part)| {
        let Role::Body(noun) = item.kind.role() else {
            return None;
        };
        let outline = item.kind.outline(part)?;
        (noun != except && outline.bounds().grown(NEAR).has(point))
            .then(|| format!("the {noun}{}", named(part)))
    });
    let bar = || {
        elements.iter().find_map(|(item, part)| {
            let Role::Link(noun @ ("bar" | "rod")) = item.kind.role() else {
                return None;
            };
            (noun != except && is_near_line(part)).then(|| format!("the {noun}{}", named(part)))
        })
    };
    let ground = || {
        elements.iter().find_map(|(item, part)| {
            (item.kind.role() == Role::Ground && is_near_line(part))
                .then(|| ground_name(part).to_owned())
        })
    };
    body.or_else(bar).or_else(ground)
}

/// A ground is called by where it lies.
fn ground_name(part: &Part<'_>) -> &'static str {
    let out = -(part.ends[1].point - part.ends[0].point).unit().left();
    if out.y.abs() >= out.x.abs() {
        if out.y < 0.0 {
            "the floor"
        } else {
            "the ceiling"
        }
    } else if out.x < 0.0 {
        "the wall on the left"
    } else {
        "the wall on the right"
    }
}

fn distance(point: Point, a: Point, b: Point) -> f64 {
    let way = b - a;
    let share = (point - a).dot(way) / way.dot(way).max(1e-12);
    point.distance(a + way * share.clamp(0.0, 1.0))
}

fn named(part: &Part<'_>) -> String {
    if part.words.is_empty() {
        String::new()
    } else {
        format!(" {}", part.words)
    }
}

fn article(noun: &str) -> &'static str {
    if noun.starts_with(['a', 'e', 'i', 'o', 'u']) {
        "an"
    } else {
        "a"
    }
}

fn listed(words: &[String]) -> String {
    match words {
        [] => String::new(),
        [one] => one.clone(),
        [rest @ .., last] => format!("{} and {last}", rest.join(", ")),
    }
}
