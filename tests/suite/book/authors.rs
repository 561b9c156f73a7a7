//! The item that the authors' pages build.

use vibank::bank::{Catalogue, embedded};
use vibank::solution::proof;

#[test]
fn the_item_of_the_tutorial_has_no_finding() {
    let tutorial = include_str!("../../fixtures/book/disk-on-a-wire.toml");
    let files = embedded()
        .into_iter()
        .chain([("ch2/disk-on-a-wire.toml", tutorial)]);
    let (catalogue, findings) = Catalogue::load(files);
    assert!(findings.is_empty(), "{findings:?}");
    let item = catalogue.find("ch2/disk-on-a-wire").unwrap();
    assert!(proof::findings(item, 200).is_empty());
}
