//! The table of layers in the book's architecture page, held against the code.
//!
//! The compiler holds crates apart; what it cannot see, modules within a crate, is read from the sources, tests included.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// A row of the table.
struct Row {
    layer: u32,
    package: String,
    imports: BTreeSet<String>,
}

/// Crates that are one module, with the name that the module has in the table and in `vibank`.
const SINGLE: [(&str, &str); 3] = [
    ("vibank-notation", "math"),
    ("vibank-response", "response"),
    ("vibank-source", "source"),
];

/// What each module may import, as the architecture page states it.
fn stated() -> BTreeMap<String, Row> {
    let page =
        fs::read_to_string("book/src/contributors/architecture.md").expect("the page exists");
    let table = page
        .lines()
        .skip_while(|line| !line.starts_with("| layer |"))
        .skip(2);
    let quoted = |cell: &str| -> Vec<String> {
        cell.split('`')
            .skip(1)
            .step_by(2)
            .map(str::to_owned)
            .collect()
    };
    table
        .take_while(|line| line.starts_with('|'))
        .map(|line| {
            let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
            let [layer, package, module, _, imports] = cells[..] else {
                panic!("five columns: {line}");
            };
            let row = Row {
                layer: layer.parse().expect("a number"),
                package: package.to_owned(),
                imports: quoted(imports).into_iter().collect(),
            };
            let module = quoted(module).swap_remove(0);
            (module, row)
        })
        .collect()
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

/// The folder of the sources of a package.
fn folder(package: &str) -> PathBuf {
    match package.strip_prefix("vibank-") {
        Some(name) => Path::new("crates").join(name).join("src"),
        None => PathBuf::from("src"),
    }
}

/// The names that a source file takes from crates of ours, each after the package that `crate` or its own name means.
fn named(text: &str, package: &str) -> BTreeSet<(String, String)> {
    let code: String = text
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"))
        .flat_map(|line| [line, "\n"])
        .collect();
    let mut names = BTreeSet::new();
    for (at, _) in code.match_indices("::") {
        let before = &code[..at];
        let start = before
            .rfind(|letter: char| !letter.is_alphanumeric() && letter != '_')
            .map_or(0, |end| end + 1);
        let package = match &before[start..] {
            "crate" => package.to_owned(),
            word if word.starts_with("vibank") => word.replace('_', "-"),
            _ => continue,
        };
        for name in first_names(&code[at + 2..]) {
            names.insert((package.clone(), name));
        }
    }
    names
}

/// The first names of a path, or of each path of a group: of `{a, b::{c, d}}` the names `a` and `b`.
fn first_names(path: &str) -> Vec<String> {
    let name = |item: &str| -> String {
        item.trim_start()
            .chars()
            .take_while(|letter| letter.is_alphanumeric() || *letter == '_')
            .collect()
    };
    let Some(group) = path.strip_prefix('{') else {
        return vec![name(path)];
    };
    let (mut depth, mut start, mut names) = (0, 0, Vec::new());
    for (at, sign) in group.char_indices() {
        match sign {
            '{' => depth += 1,
            '}' if depth > 0 => depth -= 1,
            ',' | '}' if depth == 0 => {
                names.push(name(&group[start..at]));
                start = at + 1;
                if sign == '}' {
                    break;
                }
            }
            _ => {}
        }
    }
    names
}

/// The module of the table that a name of a package belongs to.
fn module_of(stated: &BTreeMap<String, Row>, package: &str, name: &str) -> Option<String> {
    let is_own = |row: &Row| row.package == package || package == "vibank";
    if stated.get(name).is_some_and(is_own) {
        return Some(name.to_owned());
    }
    let single = SINGLE.iter().find(|(single, _)| *single == package);
    single.map(|(_, module)| (*module).to_owned())
}

/// What each module imports, with one of the files that do.
fn imports(stated: &BTreeMap<String, Row>) -> BTreeMap<String, BTreeMap<String, PathBuf>> {
    let packages: BTreeSet<&str> = stated.values().map(|row| row.package.as_str()).collect();
    let mut imports: BTreeMap<String, BTreeMap<String, PathBuf>> = BTreeMap::new();
    for package in packages {
        let root = folder(package);
        let mut files = Vec::new();
        sources(&root, &mut files);
        for file in files {
            let inside = file.strip_prefix(&root).expect("below the root");
            let first = inside.components().next().expect("a name").as_os_str();
            let first = first.to_string_lossy().replace(".rs", "");
            let is_part = matches!(first.as_str(), "lib" | "main" | "cli");
            let Some(module) = module_of(stated, package, &first) else {
                assert!(is_part, "{}: `{first}` has no row", file.display());
                continue;
            };
            let text = fs::read_to_string(&file).expect("UTF-8");
            let used = imports.entry(module.clone()).or_default();
            for (package, name) in named(&text, package) {
                let target = module_of(stated, &package, &name);
                if let Some(target) = target.filter(|target| *target != module) {
                    used.insert(target, file.clone());
                }
            }
        }
    }
    imports
}

#[test]
fn every_module_imports_what_its_row_allows_and_nothing_else() {
    let stated = stated();
    let imports = imports(&stated);
    let mut faults = Vec::new();
    for (module, row) in &stated {
        let used = imports.get(module).cloned().unwrap_or_default();
        for (name, file) in &used {
            if !row.imports.contains(name) {
                faults.push(format!(
                    "{}: `{module}` imports `{name}`, which its row does not allow",
                    file.display()
                ));
            }
        }
        for name in row.imports.iter().filter(|name| !used.contains_key(*name)) {
            faults.push(format!("`{module}` may import `{name}`, and does not"));
        }
        for name in &row.imports {
            let below = stated.get(name).map(|row| row.layer);
            if below.is_none_or(|below| below >= row.layer) {
                faults.push(format!(
                    "`{module}` imports `{name}`, which is not a layer below"
                ));
            }
        }
    }
    assert!(
        faults.is_empty(),
        "against the table of layers:\n{}",
        faults.join("\n")
    );
    assert!(
        imports["expr"].contains_key("numerics") && imports.len() > 20,
        "the walk found the modules: {imports:?}"
    );
}

#[test]
fn a_package_depends_on_the_packages_of_its_rows() {
    let stated = stated();
    for (package, _) in SINGLE
        .into_iter()
        .chain([("vibank-dynamics", ""), ("vibank-formula", "")])
    {
        let file = Path::new("crates").join(&package["vibank-".len()..]);
        let manifest = fs::read_to_string(file.join("Cargo.toml")).expect("a manifest");
        let rows = stated.values().filter(|row| row.package == package);
        let needed: BTreeSet<&str> = rows
            .flat_map(|row| &row.imports)
            .map(|name| stated[name].package.as_str())
            .filter(|needed| *needed != package)
            .collect();
        let depended: BTreeSet<&str> = manifest
            .lines()
            .filter_map(|line| line.strip_suffix(".workspace = true"))
            .filter(|name| name.starts_with("vibank-"))
            .collect();
        assert_eq!(depended, needed, "{package}");
    }
}

#[test]
fn whole_files_are_read() {
    let text = "use crate::{a, b::{c, d}};\n// crate::e\n#[cfg(test)]\nmod tests {\n    use vibank_source::Span;\n}\n";
    let own = |name: &str| ("vibank".to_owned(), name.to_owned());
    let span = ("vibank-source".to_owned(), "Span".to_owned());
    assert_eq!(named(text, "vibank"), [own("a"), own("b"), span].into());
}

#[test]
fn the_command_line_uses_public_names_only() {
    let mut files = vec![PathBuf::from("src/main.rs")];
    sources(Path::new("src/cli"), &mut files);
    let stated = stated();
    for file in files {
        let text = fs::read_to_string(&file).expect("UTF-8");
        let library: Vec<_> = named(&text, "")
            .into_iter()
            .filter(|(package, name)| package.is_empty() && stated.contains_key(name))
            .collect();
        assert!(
            library.is_empty(),
            "{} reaches into the library: {library:?}",
            file.display()
        );
    }
}
