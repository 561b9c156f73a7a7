//! What keys the reader of items knows, found out by asking for one that it does not.

use std::collections::BTreeSet;

use vibank::bank::{Catalogue, embedded};

/// An item with a place, `@NAME@`, in each table that has keys of its own.
const SPECIMEN: &str = r#"
@top@
[item]
title = "T"
source = "S"
@item@
[parameters]
m = { value = "1 kg" @parameter@ }
k = { value = "1 N/m" }
[symbols]
om = { unit = "rad/s" @symbol@ }
[model]
coordinates = { x = { unit = "m" @coordinate@ }, y = { unit = "m" } }
kinetic = "1/2*m*x'^2 + 1/2*m*y'^2"
potential = "1/2*k*x^2 + 1/2*k*y^2"
friction = { x = { kinetic = "1[N]" @friction@ } }
@model@
[models.b]
like = "model"
@models@
[quantities]
w = { formula = "sqrt(k/m)", unit = "rad/s" @quantity@ }
[statement]
text = "X"
@statement@
[solution]
text = "X"
@solution@
[figure]
elements = []
@figure@
[plots.p]
x = { variable = "t", range = ["0[s]", "1[s]"], unit = "s" @abscissa@ }
y = { unit = "1" @ordinate@ }
curves = [{ y = "t/1[s]" @curve@ }]
marks = [{ at = ["0[s]", "1"] @mark@ }]
@curves@
[plots.q]
kind = "mode-shapes"
@shapes@
[plots.r]
kind = "phasors"
phasors = [{ of = "w" @phasor@ }]
angles = [{ from = "1", to = "i" @angle@ }]
@phasors@
[[part]]
key = "w"
ask = "Y"
mistakes = [{ answer = "k/m", feedback = "F" @mistake@ }]
@numeric@
[[part]]
id = "b"
key = "2"
ask = "Y"
kind = "integer"
@integer@
[[part]]
id = "c"
key = "sqrt(k/m)"
ask = "Y"
kind = "formula"
@formula@
[[part]]
id = "d"
key = "model.equation.x"
ask = "Y"
kind = "equation"
@equation@
[[part]]
id = "f"
key = "model.K"
ask = "Y"
kind = "matrix"
@matrix@
[[part]]
id = "h"
key = "[1, 1]"
ask = "Y"
kind = "mode-shape"
mode = 1
@mode-shape@
[[part]]
id = "l"
key = "cos(w*t)"
ask = "Y"
kind = "function"
@function@
[[part]]
id = "n"
key = "[0, 1]"
variable = "om"
ask = "Y"
kind = "interval"
@interval@
[[part]]
id = "p"
text = "T"
@group@
[[part.blank]]
key = "w"
ask = "Y"
@blank@
[[part.blank]]
id = "q"
key = "2*w"
unit = "rad/s"
ask = "Y"
[[part]]
id = "o"
ask = "Y"
kind = "choice"
options = [{ id = "a", text = "A", right = true @option@ }, { id = "b", text = "B" }]
@choice@
[[part]]
id = "z"
ask = "Y"
kind = "work"
rubric = [{ points = 1, text = "T" @rubric@ }]
@work@
[[check]]
source = "S"
expect = { w = "1 rad/s" }
@check@
"#;

/// Where the schema has the keys of a table of the specimen; parts are looked at apart.
pub(super) const PLACES: [(&str, &str); 28] = [
    ("top", ""),
    ("item", "/properties/item"),
    (
        "parameter",
        "/properties/parameters/additionalProperties/anyOf/1",
    ),
    ("symbol", "/properties/symbols/additionalProperties/anyOf/1"),
    (
        "coordinate",
        "/properties/model/properties/coordinates/additionalProperties",
    ),
    (
        "friction",
        "/properties/model/properties/friction/additionalProperties/anyOf/1",
    ),
    ("model", "/properties/model"),
    ("models", "/properties/models/additionalProperties"),
    (
        "quantity",
        "/properties/quantities/additionalProperties/anyOf/1",
    ),
    ("statement", "/properties/statement"),
    ("solution", "/properties/solution"),
    ("figure", "/properties/figure"),
    (
        "abscissa",
        "/properties/plots/additionalProperties/properties/x",
    ),
    (
        "ordinate",
        "/properties/plots/additionalProperties/properties/y",
    ),
    (
        "curve",
        "/properties/plots/additionalProperties/properties/curves/items",
    ),
    (
        "mark",
        "/properties/plots/additionalProperties/properties/marks/items",
    ),
    (
        "phasor",
        "/properties/plots/additionalProperties/properties/phasors/items",
    ),
    (
        "angle",
        "/properties/plots/additionalProperties/properties/angles/items",
    ),
    ("curves", "/properties/plots/additionalProperties"),
    ("shapes", "/properties/plots/additionalProperties"),
    ("phasors", "/properties/plots/additionalProperties"),
    (
        "mistake",
        "/properties/part/items/properties/mistakes/items",
    ),
    ("option", "/properties/part/items/properties/options/items"),
    ("rubric", "/properties/part/items/properties/rubric/items"),
    ("check", "/properties/check/items"),
    ("numeric", "/properties/part/items"),
    ("group", "/properties/part/items"),
    ("blank", "/properties/part/items"),
];

/// The keys that the reader knows at a place of the specimen, as its finding lists them.
pub(super) fn read_at(place: &str) -> BTreeSet<String> {
    let pieces: Vec<&str> = SPECIMEN.split('@').collect();
    assert!(
        pieces.iter().skip(1).step_by(2).any(|name| *name == place),
        "{place}"
    );
    let marked = pieces.iter().enumerate().map(|(number, piece)| {
        let is_within = pieces
            .get(number + 1)
            .is_some_and(|next| next.starts_with(" }"));
        match (number % 2, *piece == place) {
            (0, _) => piece,
            (_, false) => "",
            (_, true) if is_within => ", qqqqqqqq = 1",
            (_, true) => "qqqqqqqq = 1",
        }
    });
    let text: String = marked.collect();
    let files = embedded()
        .into_iter()
        .filter(|(path, _)| ["bank.toml", "ch2/_chapter.toml"].contains(path));
    let (_, findings) = Catalogue::load(files.chain([("ch2/specimen.toml", text.as_str())]));
    let help = findings
        .iter()
        .filter_map(|finding| finding.help.as_deref())
        .find_map(|help| help.strip_prefix("the keys are "))
        .unwrap_or_else(|| panic!("{place}: {findings:?}"));
    help.split(", ").map(str::to_owned).collect()
}
