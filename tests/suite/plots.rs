//! Every plot of the bank, over many draws.

use std::fmt::Write as _;

use crate::BANK;
use vibank::bank::{Catalogue, Template};
use vibank::figure::Bounds;
use vibank::figure::plot::Picture;
use vibank::figure::story::Speaker as _;
use vibank::instance::Instance;
use vibank::message::Language;
use vibank::scene::{Data, Scene};
use vibank::seed::Seed;
use vibank::solution::Solution;

use crate::generated;

/// Draws of each plot.
const SEEDS: u64 = 12;

/// All items with plots.
fn items(catalogue: &Catalogue) -> impl Iterator<Item = &Template> {
    catalogue.items().filter(|item| !item.plots.is_empty())
}

/// Calls `visit` with each plot of the bank for the data of its source and for several draws.
fn for_each_plot(mut visit: impl FnMut(&str, Result<Picture, String>)) {
    let catalogue = &*BANK;
    for item in items(catalogue) {
        for seed in 0..SEEDS {
            let instance = match seed {
                0 => Ok(Instance::of_source(item)),
                _ => Instance::draw(item, Seed::new(seed)),
            };
            let solution = Solution::of(instance.expect("the constraints can be met"));
            let scene = Scene::of(&solution, Data::Both);
            for plot in &item.plots {
                let name = format!("{} plots.{} # {seed}", item.id, plot.name);
                visit(
                    &name,
                    scene
                        .plot(&plot.name)
                        .map_err(|undrawn| undrawn.to_string()),
                );
            }
        }
    }
}

#[test]
fn every_plot_is_drawn_with_all_it_has_in_its_frame() {
    let mut faults = String::new();
    for_each_plot(|name, picture| {
        let Err(fault) = picture.and_then(|picture| sound(&picture)) else {
            return;
        };
        let _ = writeln!(faults, "{name}: {fault}");
    });
    assert!(faults.is_empty(), "\n{faults}");
}

#[test]
fn a_plot_is_computed_where_it_is_shown_and_nowhere_else() {
    let catalogue = &*BANK;
    let template = catalogue
        .find("ch3/e4-underdamped-response")
        .expect("the item is there");
    let solution = Solution::of(Instance::of_source(template));
    let scene = Scene::of(&solution, Data::Both);
    let plots = || {
        let computed = solution.trace().computed.into_iter();
        computed.filter(|label| label.starts_with("plots.")).count()
    };
    scene.passage(&template.statement);
    for part in &template.parts {
        scene.passage(&part.ask);
    }
    assert_eq!(plots(), 0);
    scene.passage(&template.solution);
    for part in &template.parts {
        scene.passage(&part.solution);
    }
    assert!(plots() > 0);
}

/// What is wrong with a picture.
fn sound(picture: &Picture) -> Result<(), String> {
    let drawing = &picture.drawing;
    let frame = drawing.frame();
    let boxes: Vec<Bounds> = drawing.labels().iter().map(|label| label.bounds).collect();
    for (place, label) in drawing.labels().iter().enumerate() {
        if !(frame.has(label.bounds.low) && frame.has(label.bounds.high)) {
            return Err(format!("`{}` lies outside", label.label.plain()));
        }
        let later = boxes[place + 1..]
            .iter()
            .position(|other| other.meets(label.bounds));
        if let Some(other) = later {
            let other = &drawing.labels()[place + 1 + other].label;
            return Err(format!(
                "`{}` overlaps `{}`",
                label.label.plain(),
                other.plain()
            ));
        }
        for mark in drawing.marks() {
            let mut is_crossed = false;
            mark.path
                .for_each_segment(|a, b| is_crossed |= label.bounds.chord(a, b).is_some());
            if is_crossed && mark.fill != vibank::figure::Fill::Tint {
                return Err(format!("a line crosses `{}`", label.label.plain()));
            }
        }
    }
    let svg = picture.svg("p", &Language::English);
    if svg.contains("NaN") || svg.contains("inf") {
        return Err("a number is not finite".to_owned());
    }
    let (width, height) = drawing.size();
    if width > 170.0 || height > 120.0 {
        return Err(format!("{width} mm by {height} mm is too large"));
    }
    if svg.len() > 40_000 {
        return Err(format!("{} bytes are too many", svg.len()));
    }
    Ok(())
}

/// The plots of the book's gallery: item, plot, and what it is an example of.
const GALLERY: [(&str, &str, &str); 13] = [
    (
        "ch3/e4-underdamped-response",
        "decay",
        "Displacement with its envelope",
    ),
    (
        "ch3/t2-pick-the-regime",
        "regimes",
        "The three regimes, one formula with three values of a parameter",
    ),
    (
        "ch3/p3-two-springs-coulomb",
        "decay",
        "Coulomb decay with its straight envelope and the stick band",
    ),
    (
        "ch4/e2-amplitude-resonance",
        "resonance",
        "Resonance curves for several dampings",
    ),
    ("ch4/e3-bandwidth-cutoff", "resonance", "Peak and cut-offs"),
    ("ch4/e5-phase-behaviour", "phase", "Phase"),
    (
        "ch4/e1-forced-steady-state",
        "phasors",
        "Phasors of the forces",
    ),
    (
        "ch4/t4-vibration-absorber",
        "response",
        "An axis with a range of its own",
    ),
    ("ch4/t5-beats-near-resonance", "beats", "Beats"),
    (
        "ch5/p4-table-block-pulley-hanging-block",
        "motion",
        "The motion of two masses",
    ),
    ("ch5/p5-three-mass-two-wall-springs", "modes", "Mode shapes"),
    ("ch2/t6-energy-of-free-motion", "plane", "A phase plane"),
    (
        "ch1/e9-pendulum-equilibrium-stability",
        "energy",
        "A potential with its equilibria",
    ),
];

/// The gallery of the book: pictures beside the tables that they come from.
#[test]
fn the_gallery_is_fresh() {
    let book = std::path::Path::new("book/src");
    let mut files: Vec<(std::path::PathBuf, String)> = Vec::new();
    let mut page = include_str!("../fixtures/plots.md").to_owned();
    let catalogue = &*BANK;
    for (item, plot, about) in GALLERY {
        let template = catalogue.find(item).expect("the item is there");
        let solution = Solution::of(Instance::of_source(template));
        let picture = Scene::of(&solution, Data::Both)
            .plot(plot)
            .expect("it can be drawn");
        let name = format!("{}-{plot}", item.replace('/', "-"));
        files.push((
            book.join(format!("figures/{name}.svg")),
            picture.svg(&name, &Language::English) + "\n",
        ));
        let begin = template
            .source
            .text
            .find(&format!("[plots.{plot}]"))
            .expect("it is declared");
        let table = &template.source.text[begin..];
        let end = table[1..].find("\n[").map_or(table.len(), |end| end + 1);
        let _ = write!(
            page,
            "\n## {about}\n\n![{}](../figures/{name}.svg)\n\nFrom `{item}`:\n\n```toml\n{}\n```\n",
            Language::English.caption(&picture.story).title,
            table[..end].trim_end()
        );
    }
    files.push((book.join("reference/plots.md"), page));
    for (path, content) in files {
        generated::compare(path, &content);
    }
}

/// Writes a page with all plots into the folder that `VIBANK_PICTURES` names, to be looked at.
#[test]
fn pictures() {
    let Ok(folder) = std::env::var("VIBANK_PICTURES") else {
        return;
    };
    let mut pages: Vec<String> = Vec::new();
    let mut count = 0;
    for_each_plot(|name, picture| {
        if count % 12 == 0 {
            pages.push("<!DOCTYPE html><meta charset=utf-8><style>body{font:12px sans-serif;display:grid;grid-template-columns:1fr 1fr 1fr;gap:8px}svg{width:100%;height:auto;border:1px solid #ddd}div{overflow:hidden}small{color:#888}</style>".to_owned());
        }
        let keep = std::env::var("VIBANK_SEED").unwrap_or_else(|_| "0".to_owned());
        if !name.ends_with(&format!("# {keep}")) {
            return;
        }
        let page = pages.last_mut().expect("a page was begun");
        match picture {
            Ok(picture) => {
                let svg = picture.svg(&format!("p{count}"), &Language::English);
                let words = Language::English.caption(&picture.story).description;
                let _ = write!(
                    page,
                    "<div><b>{name}</b> {} bytes<br>{svg}<small>{words}</small></div>",
                    svg.len()
                );
            }
            Err(fault) => {
                let _ = write!(page, "<div><b>{name}</b><br>{fault}</div>");
            }
        }
        count += 1;
    });
    for (number, page) in pages
        .iter()
        .filter(|page| page.contains("<div>"))
        .enumerate()
    {
        std::fs::write(format!("{folder}/plots-{number}.html"), page).expect("the folder is there");
    }
}
