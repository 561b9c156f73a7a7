//! Rebuilds when a file is added to the bank or to the layouts, which are embedded.

fn main() {
    for folder in ["bank", "templates"] {
        println!("cargo::rerun-if-changed={folder}");
    }
}
