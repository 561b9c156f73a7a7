//! The table of layers in the book's architecture page, held against the code.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// What each module may import, as the architecture page states it.
fn stated() -> BTreeMap<String, BTreeSet<String>> {
    let page =
        fs::read_to_string("book/src/contributors/architecture.md").expect("the page exists");
    let table = page
        .lines()
        .skip_while(|line| !line.starts_with("| layer |"))
        .skip(2);
    let rows: Vec<Vec<String>> = table
        .take_while(|line| line.starts_with('|'))
        .map(|line| {
            line.trim_matches('|')
                .split('|')
                .map(|cell| cell.trim().to_owned())
                .collect()
        })
        .collect();
    let names = |cell: &str| {
        cell.split('`')
            .skip(1)
            .step_by(2)
            .map(str::to_owned)
            .collect::<BTreeSet<_>>()
    };
    let mut above = BTreeSet::new();
    let mut map = BTreeMap::new();
    for row in rows {
        let [_, module, _, imports] = row.try_into().expect("four columns");
        let module = names(&module)
            .into_iter()
            .next()
            .expect("a module in back-ticks");
        let imports = if imports == "all above" {
            above.clone()
        } else {
            names(&imports)
        };
        above.insert(module.clone());
        map.insert(module, imports);
    }
    map
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
    {
        if entry.is_dir() {
            sources(&entry, found);
        } else if entry.extension().is_some_and(|end| end == "rs") {
            found.push(entry);
        }
    }
}

/// The modules that a source file names after `crate::`, tests and comments aside.
fn imported(text: &str) -> BTreeSet<String> {
    let code = text.split("#[cfg(test)]").next().unwrap_or(text);
    let lines = code
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"));
    let mut names = BTreeSet::new();
    for line in lines {
        for rest in line.split("crate::").skip(1) {
            // `crate::{a, b::c}` names several.
            let group = rest
                .strip_prefix('{')
                .map_or(vec![rest], |group| group.split(',').collect());
            for item in group {
                let name: String = item
                    .trim()
                    .chars()
                    .take_while(|letter| letter.is_ascii_lowercase() || *letter == '_')
                    .collect();
                names.insert(name);
            }
        }
    }
    names.remove("");
    names
}

#[test]
fn every_module_imports_only_what_its_row_allows() {
    let stated = stated();
    let mut files = Vec::new();
    sources(Path::new("src"), &mut files);
    let mut faults = Vec::new();
    let mut seen = BTreeSet::new();
    for file in files {
        let inside = file.strip_prefix("src").expect("below src");
        let module = inside
            .components()
            .next()
            .expect("a name")
            .as_os_str()
            .to_string_lossy()
            .replace(".rs", "");
        if matches!(module.as_str(), "lib" | "main" | "cli") {
            continue;
        }
        seen.insert(module.clone());
        let Some(allowed) = stated.get(&module) else {
            faults.push(format!("{}: `{module}` has no row", file.display()));
            continue;
        };
        let text = fs::read_to_string(&file).expect("UTF-8");
        for name in imported(&text)
            .difference(allowed)
            .filter(|name| **name != module)
        {
            faults.push(format!("{}: imports `{name}`", file.display()));
        }
    }
    assert!(
        faults.is_empty(),
        "against the table of layers:\n{}",
        faults.join("\n")
    );
    assert!(
        seen.contains("numerics") && seen.len() > 5,
        "the walk found the modules: {seen:?}"
    );
}

#[test]
fn the_command_line_uses_public_names_only() {
    let mut files = vec![PathBuf::from("src/main.rs")];
    sources(Path::new("src/cli"), &mut files);
    let stated = stated();
    for file in files {
        let text = fs::read_to_string(&file).expect("UTF-8");
        let used = imported(&text);
        let library: Vec<_> = used
            .iter()
            .filter(|name| stated.contains_key(*name))
            .collect();
        assert!(
            library.is_empty(),
            "{} reaches into the library: {library:?}",
            file.display()
        );
    }
}
