//! Computes the digest of what shapes the bytes of a file: the sources of the press, and the packages that it is made of,
//! by version and checksum, as the lock file has them.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::{env, fs};

use sha2::{Digest, Sha256};

/// A package of the lock file: its version and checksum, and the names of what it depends on.
#[derive(Default)]
struct Package {
    identity: String,
    dependencies: Vec<String>,
}

fn main() {
    let folder = PathBuf::from(env::var("CARGO_MANIFEST_DIR").expect("set by cargo"));
    let mut digest = Sha256::new();
    for source in ["src/lib.rs", "src/world.rs"] {
        println!("cargo::rerun-if-changed={source}");
        digest.update(fs::read(folder.join(source)).expect("part of the package"));
    }
    let lock = folder
        .ancestors()
        .map(|place| place.join("Cargo.lock"))
        .find(|lock| lock.is_file());
    if let Some(lock) = lock {
        println!("cargo::rerun-if-changed={}", lock.display());
        for identity in below("typst", &packages(&lock)) {
            digest.update(identity);
        }
    }
    let hexadecimal: String = digest
        .finalize()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect();
    println!("cargo::rustc-env=VIBANK_PRESS_DIGEST={hexadecimal}");
}

/// The packages of a lock file, by name and, where a name occurs twice, by name and version.
fn packages(lock: &Path) -> BTreeMap<String, Package> {
    let text = fs::read_to_string(lock).expect("it is readable");
    let mut packages = BTreeMap::new();
    for block in text.split("[[package]]").skip(1) {
        let field = |key: &str| {
            let line = block.lines().find_map(|line| line.strip_prefix(key));
            line.unwrap_or_default().trim_matches([' ', '=', '"'])
        };
        let dependencies = block
            .lines()
            .filter_map(|line| line.strip_prefix(" \"")?.strip_suffix("\","))
            .map(str::to_owned);
        let package = Package {
            identity: format!(
                "{} {} {}\n",
                field("name"),
                field("version"),
                field("checksum")
            ),
            dependencies: dependencies.collect(),
        };
        let dependencies = package.dependencies.clone();
        let identity = package.identity.clone();
        packages.insert(format!("{} {}", field("name"), field("version")), package);
        packages.insert(
            field("name").to_owned(),
            Package {
                identity,
                dependencies,
            },
        );
    }
    packages
}

/// The identities of a package and of all below it, in order.
fn below(name: &str, packages: &BTreeMap<String, Package>) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut waiting = vec![name.to_owned()];
    for more in ["typst-layout", "typst-pdf", "typst-assets"] {
        waiting.push(more.to_owned());
    }
    while let Some(name) = waiting.pop() {
        let Some(package) = packages.get(&name) else {
            continue;
        };
        if found.insert(package.identity.clone()) {
            waiting.extend(package.dependencies.iter().cloned());
        }
    }
    found
}
