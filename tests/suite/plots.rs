//! Every plot of the bank, over many draws.

use std::fmt::Write as _;

use vibank::bank::{Catalogue, Template, embedded};
use vibank::figure::plot::Picture;
use vibank::figure::{Bounds, Head};
use vibank::instance::Instance;
use vibank::scene::{Data, Scene};
use vibank::seed::Seed;
use vibank::solution::Solution;

/// Draws of each plot.
const SEEDS: u64 = 12;

/// All items with plots.
fn items(catalogue: &Catalogue) -> impl Iterator<Item = &Template> {
    catalogue
        .items()
        .iter()
        .filter(|item| !item.plots.is_empty())
}

/// Calls `visit` with each plot of the bank for the data of its source and for several draws.
fn for_each_plot(mut visit: impl FnMut(&str, Result<Picture, String>)) {
    let (catalogue, _) = Catalogue::load(embedded());
    for item in items(&catalogue) {
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
    let svg = drawing.svg(&Head {
        id: "p",
        title: &picture.title,
        description: &picture.description,
    });
    if svg.contains("NaN") || svg.contains("inf") {
        return Err("a number is not finite".to_owned());
    }
    let (width, height) = drawing.size();
    if width > 170.0 || height > 120.0 {
        return Err(format!("{width} mm by {height} mm is too large"));
    }
    if svg.len() > 20_000 {
        return Err(format!("{} bytes are too many", svg.len()));
    }
    Ok(())
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
                let head = Head {
                    id: &format!("p{count}"),
                    title: &picture.title,
                    description: &picture.description,
                };
                let svg = picture.drawing.svg(&head);
                let _ = write!(
                    page,
                    "<div><b>{name}</b> {} bytes<br>{svg}<small>{}</small></div>",
                    svg.len(),
                    picture.description
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
