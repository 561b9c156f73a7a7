//! Links between pages, and the table of contents.

use std::fs;
use std::path::Path;

use super::pages;

/// The targets of the links of a text, `](target)`, outside code.
fn targets(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut is_code = false;
    for line in text.lines() {
        if line.trim_start().starts_with("```") {
            is_code = !is_code;
        }
        if is_code {
            continue;
        }
        let pieces = line.split("](").skip(1);
        found.extend(
            pieces
                .filter_map(|piece| piece.split(')').next())
                .map(str::to_owned),
        );
    }
    found
}

#[test]
fn links_between_pages_lead_somewhere() {
    let mut broken = Vec::new();
    for page in pages() {
        let text = fs::read_to_string(&page).unwrap();
        let folder = page.parent().unwrap();
        for target in targets(&text) {
            let path = target.split('#').next().unwrap();
            let is_ours = !path.is_empty() && !path.contains("://");
            if is_ours && !folder.join(path).exists() {
                broken.push(format!("{}: {target}", page.display()));
            }
        }
    }
    assert!(broken.is_empty(), "{broken:#?}");
}

#[test]
fn every_page_stands_in_the_contents() {
    let summary = fs::read_to_string("book/src/SUMMARY.md").unwrap();
    let listed = targets(&summary);
    let missing: Vec<_> = pages()
        .into_iter()
        .filter(|page| !page.ends_with("SUMMARY.md"))
        .map(|page| {
            let inside = page.strip_prefix(Path::new("book/src")).unwrap();
            inside.to_string_lossy().replace('\\', "/")
        })
        .filter(|page| !listed.contains(page))
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}
