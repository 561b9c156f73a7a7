//! Links, anchors and images of the book, of the readme and of the page for contributors; the table of contents.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Component, Path, PathBuf};

use super::pages;

/// The lines that are no code.
fn prose(text: &str) -> impl Iterator<Item = &str> {
    let mut is_code = false;
    text.lines().filter(move |line| {
        let is_fence = line.trim_start().starts_with("```");
        is_code ^= is_fence;
        !is_code && !is_fence
    })
}

/// The targets of links and images, `](target)`, `href="target"` and `src="target"`, outside code.
fn targets(text: &str) -> Vec<String> {
    let ends = [("](", ')'), ("href=\"", '"'), ("src=\"", '"')];
    let mut found = Vec::new();
    for line in prose(text) {
        // Code within the line may show how a link is written.
        let words: String = line.split('`').step_by(2).collect();
        for (begin, end) in ends {
            let pieces = words.split(begin).skip(1);
            found.extend(
                pieces
                    .filter_map(|piece| piece.split(end).next())
                    .map(str::to_owned),
            );
        }
    }
    found
}

/// The places of a page that a link can name: its headings, as mdBook and GitHub name them, and identities.
fn anchors(text: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut times: BTreeMap<String, usize> = BTreeMap::new();
    for line in prose(text) {
        if let Some(heading) = line.strip_prefix('#') {
            let name = anchor(heading.trim_start_matches('#').trim());
            let before = times.entry(name.clone()).or_default();
            found.insert(match *before {
                0 => name,
                count => format!("{name}-{count}"),
            });
            *before += 1;
        }
        let identities = line.split("id=\"").skip(1);
        found.extend(
            identities
                .filter_map(|rest| rest.split('"').next())
                .map(str::to_owned),
        );
    }
    found
}

fn anchor(heading: &str) -> String {
    let letters = heading.chars().filter_map(|letter| match letter {
        '_' | '-' => Some(letter),
        letter if letter.is_alphanumeric() => Some(letter.to_ascii_lowercase()),
        letter if letter.is_whitespace() => Some('-'),
        _ => None,
    });
    letters.collect()
}

/// A path without `.` and `..`.
fn straightened(path: &Path) -> PathBuf {
    let mut out = PathBuf::new();
    for piece in path.components() {
        match piece {
            Component::ParentDir => {
                out.pop();
            }
            Component::CurDir => {}
            piece => out.push(piece),
        }
    }
    out
}

#[test]
fn links_lead_somewhere() {
    let outside = ["README.md", "CONTRIBUTING.md"].map(PathBuf::from);
    let texts: BTreeMap<PathBuf, String> = pages()
        .into_iter()
        .chain(outside)
        .map(|page| (page.clone(), fs::read_to_string(page).unwrap()))
        .collect();
    let mut broken = Vec::new();
    for (page, text) in &texts {
        let folder = page.parent().unwrap();
        for target in targets(text) {
            let (path, anchor) = target.split_once('#').unwrap_or((&target, ""));
            let file = match path {
                "" => page.clone(),
                path => straightened(&folder.join(path)),
            };
            let has_anchor = || {
                let text = texts.get(&file);
                anchor.is_empty() || text.is_some_and(|text| anchors(text).contains(anchor))
            };
            // The book stands by itself: nothing of it is elsewhere.
            if !file.exists() || !has_anchor() {
                broken.push(format!("{}: {target}", page.display()));
            }
        }
        for line in text
            .lines()
            .filter_map(|line| line.strip_prefix("{{#include "))
        {
            let path = folder.join(line.trim_end_matches('}'));
            if !path.exists() {
                broken.push(format!("{}: {line}", page.display()));
            }
        }
    }
    assert!(broken.is_empty(), "{broken:#?}");
}

#[test]
fn every_page_stands_once_in_the_contents() {
    let summary = fs::read_to_string("book/src/SUMMARY.md").unwrap();
    let mut listed = targets(&summary);
    listed.sort();
    let mut found: Vec<String> = pages()
        .into_iter()
        .filter(|page| !page.ends_with("SUMMARY.md"))
        .map(|page| {
            let inside = page.strip_prefix(Path::new("book/src")).unwrap();
            inside.to_string_lossy().replace('\\', "/")
        })
        .collect();
    found.sort();
    assert_eq!(listed, found);
}
