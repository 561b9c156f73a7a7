//! The figures of the bank, and the elements of the book's gallery.

use std::fmt::Write as _;

use crate::BANK;
use vibank::bank::{Catalogue, Template};
use vibank::figure::{Bounds, Drawing, Fill, Head, LETTER_SIZE, Picture, draw_free};
use vibank::instance::Instance;
use vibank::message::Language;
use vibank::scene::{Data, Scene};
use vibank::seed::Seed;
use vibank::solution::Solution;

use crate::generated;

/// Draws of each item.
const DRAWS: u64 = 25;

/// A figure, and what is wrong with it.
fn faults(template: &Template, instance: Instance<'_>) -> Vec<String> {
    let Some(figure) = &template.figure else {
        let id = &template.id;
        return vec![format!("{id}: it has no figure, as each item of this bank")];
    };
    let identity = instance.identity();
    let solution = Solution::of(instance);
    let scene = Scene::of(&solution, Data::Both);
    let drawing = match figure.draw(&scene) {
        Ok(drawing) => drawing,
        Err(error) => return vec![format!("{identity}: {error}")],
    };
    let picture = scene.picture().expect("what is drawn has a picture");
    let mut faults = faults_of(&drawing, &picture);
    // A figure that takes nothing from the data is drawn for the first of them alone.
    let head = Head {
        id: "",
        title: "",
        description: "",
    };
    let own = drawing.svg(&head);
    let [own, kept] = [&own, &picture.svg].map(|svg| svg.split_once('\n'));
    if own.map(|(_, marks)| marks) != kept.map(|(_, marks)| marks) {
        faults.push("the picture is that of other data".to_owned());
    }
    if figure.has_free() {
        let free = draw_free(figure, &scene);
        let picture = scene.free_picture().expect("it has one");
        match free.and_then(|drawing| Ok((drawing, picture?))) {
            Ok((drawing, picture)) => faults.extend(faults_of(&drawing, &picture)),
            Err(error) => faults.push(error.to_string()),
        }
    }
    faults
        .iter()
        .map(|fault| format!("{identity}: {fault}"))
        .collect()
}

/// What is wrong with a drawing and its picture.
fn faults_of(drawing: &Drawing, picture: &Picture) -> Vec<String> {
    let mut faults = overlaps(drawing);
    faults.extend(astray(drawing));
    faults.extend(outside(drawing));
    if picture.svg.len() > 40_000 {
        faults.push(format!("{} bytes", picture.svg.len()));
    }
    if picture.width > 180.0 || picture.height > 120.0 {
        faults.push(format!("{} mm by {} mm", picture.width, picture.height));
    }
    for word in ["NaN", "inf", "class=", "foreignObject"] {
        if picture.svg.contains(word) {
            faults.push(format!("`{word}` in the picture"));
        }
    }
    if !picture.alt.ends_with('.') || picture.alt.len() < 12 {
        faults.push(format!("described as `{}`", picture.alt));
    }
    faults
}

/// Labels on each other or on a line.
fn overlaps(drawing: &Drawing) -> Vec<String> {
    let mut faults = Vec::new();
    let labels = drawing.labels();
    for (place, lettering) in labels.iter().enumerate() {
        let name = lettering.label.plain();
        for other in labels[..place]
            .iter()
            .filter(|other| other.bounds.meets(lettering.bounds))
        {
            faults.push(format!("`{name}` lies on `{}`", other.label.plain()));
        }
        for mark in drawing.marks() {
            let reach = mark.pen.map_or(0.0, |pen| pen.width() / 2.0);
            let mut is_hit = false;
            mark.path.for_each_segment(|a, b| {
                is_hit |= lettering.bounds.grown(reach).chord(a, b).is_some();
            });
            if is_hit {
                faults.push(format!("`{name}` lies on a line of element {}", mark.owner));
            }
        }
    }
    faults
}

/// The room between a label and what it names, in figure units; beyond it a reader looks for another element.
const REACH: f64 = 0.45;

/// Labels that lie apart from the element that they name; words alone have none.
fn astray(drawing: &Drawing) -> Vec<String> {
    let mut faults = Vec::new();
    for lettering in drawing.labels() {
        let mut own = drawing
            .marks()
            .iter()
            .filter(|mark| mark.owner == lettering.owner)
            .peekable();
        let near = lettering.bounds.grown(REACH);
        let is_alone = own.peek().is_none();
        let is_near = own.any(|mark| {
            let mut is_met = mark.fill != Fill::None && mark.path.bounds().meets(near);
            mark.path
                .for_each_segment(|a, b| is_met |= near.chord(a, b).is_some());
            is_met
        });
        if !is_alone && !is_near {
            let name = lettering.label.plain();
            faults.push(format!(
                "`{name}` lies apart from element {}",
                lettering.owner
            ));
        }
    }
    faults
}

/// Marks and labels that leave the frame.
fn outside(drawing: &Drawing) -> Vec<String> {
    let frame = drawing.frame();
    let holds = |bounds: Bounds| frame.joined(bounds) == frame;
    let marks = drawing.marks().iter().map(|mark| mark.path.bounds());
    let labels = drawing.labels().iter().map(|lettering| lettering.bounds);
    let count = marks.chain(labels).filter(|bounds| !holds(*bounds)).count();
    (count > 0)
        .then(|| format!("{count} marks leave the frame"))
        .into_iter()
        .collect()
}

#[test]
fn every_item_is_drawn_legibly_for_many_data() {
    let catalogue = &*BANK;
    let mut all = Vec::new();
    for template in catalogue.items() {
        all.extend(faults(template, Instance::of_source(template)));
        if template.figure.is_none() {
            continue;
        }
        for seed in 0..DRAWS {
            if let Ok(instance) = Instance::draw(template, Seed::new(seed)) {
                all.extend(faults(template, instance));
            }
        }
    }
    assert!(all.is_empty(), "{}", all.join("\n"));
}

#[test]
fn letters_are_readable_in_print() {
    // A letter's size in millimetres; 2.5 mm, seven points, is the least of a script.
    let least = LETTER_SIZE * 10.0 * 0.68;
    assert!(least >= 2.5, "{least}");
}

#[test]
fn the_same_data_give_the_same_bytes_and_others_other_identities() {
    let catalogue = &*BANK;
    let template = catalogue
        .find("ch2/p5-stepped-disk-two-springs")
        .expect("it is there");
    let picture = |seed| {
        let solution = Solution::of(Instance::draw(template, Seed::new(seed)).expect("it draws"));
        Scene::of(&solution, Data::Both)
            .picture()
            .expect("it has a figure")
            .svg
    };
    assert_eq!(picture(3), picture(3));
    let id = |svg: &str| {
        svg.split("id=\"")
            .nth(1)
            .map(|rest| rest.split('"').next().map(str::to_owned))
    };
    assert_ne!(id(&picture(3)), id(&picture(4)));
}

#[test]
fn a_description_tells_what_is_joined_to_what() {
    let item = item(
        "points = { W = [0, 1], B = [4, 1] }\nelements = [\n\
        { ground = [\"[0, 2]\", \"[0, 0]\"] },\n{ spring = [\"W\", \"B\"], label = \"k\" },\n\
        { damper = [\"W\", \"B\"], label = \"'c'\" },\n{ block = \"B\", label = \"m\" } ]\n",
    );
    let (svg, alt) = drawn(&item);
    assert_eq!(
        alt,
        "A block m. A spring k and a damper c join the block m to the wall on the left."
    );
    assert!(svg.contains("<title") && svg.contains("<desc"));
}

/// Pages of elements: their words and their pictures.
#[test]
fn the_gallery_of_the_book_is_fresh() {
    let mut page = String::from(
        "# Elements of figures\n\n\
         A figure is declared in the table `[figure]` of an item and drawn from its data.\n\
         One unit is 10 mm in print, y points up.\n\
         An element is an inline table whose first key is its kind and holds its place; all take `label` \
         (a formula, or words between single quotes), `at` (`above`, `below`, `left`, `right`) and `style` \
         (`solid`, `dashed`, `dotted`, `faint`).\n\
         This page is generated from the elements themselves.\n",
    );
    for kind in vibank::figure::element::KINDS {
        let name = kind.name();
        let file = name.replace('-', "_");
        let source = std::fs::read_to_string(format!("src/figure/element/{file}.rs"))
            .expect("one file a kind");
        let lines = source.lines().map_while(|line| line.strip_prefix("//!"));
        let text: Vec<&str> = lines
            .map(|line| line.strip_prefix(' ').unwrap_or(line))
            .collect();
        let text = text.join("\n");
        let (_, rest) = text
            .split_once("```toml\n")
            .unwrap_or_else(|| panic!("`{name}` has an example"));
        let (example, _) = rest.split_once("```").expect("it ends");
        let (svg, alt) = drawn(&item(example));
        assert!(alt.len() > 3, "{name}: {alt}");
        write!(
            page,
            "\n## `{name}`\n\n{text}\n\n![{alt}](figures/{name}.svg)\n"
        )
        .expect("a string takes all");
        generated::compare(
            format!("book/src/reference/figures/{name}.svg"),
            &format!("{svg}\n"),
        );
    }
    generated::compare("book/src/reference/figure-elements.md", &page);
}

/// An item with a figure.
fn item(figure: &str) -> String {
    format!(
        "[item]\ntitle = 'T'\nsource = 'S'\n[parameters]\n\
         m = '1 kg'\nM = '1 kg'\nk = '1 N/m'\nc = '1 N s/m'\nl = '1 m'\nL = '1 m'\nr = '1 m'\nI = '1 kg m^2'\n\
         R = '1 ohm'\nC = '1 F'\nA = '1 m^2'\nv = '1 m/s'\nkappa = '1 N m'\ntheta = '0.1'\nx = '1 m'\nu = '1 m'\n\
         [statement]\ntext = 'X'\n[figure]\n{figure}\n\
         [[part]]\nid = 'a'\nkey = '2*m'\nunit = 'kg'\nask = 'Y'\n"
    )
}

/// The picture of the only item of a bank, and its description.
fn drawn(item: &str) -> (String, String) {
    let (catalogue, findings) = Catalogue::load([
        ("bank.toml", include_str!("../fixtures/bank/bank.toml")),
        (
            "free/_chapter.toml",
            include_str!("../fixtures/bank/free/_chapter.toml"),
        ),
        ("free/figure.toml", item),
    ]);
    assert!(findings.is_empty(), "{item}\n{findings:?}");
    let template = catalogue.find("free/figure").expect("it is read");
    let figure = template.figure.as_ref().expect("it has a figure");
    let solution = Solution::of(Instance::of_source(template));
    let scene = Scene::of(&solution, Data::Both);
    let faults = figure
        .draw(&scene)
        .map(|drawing| overlaps(&drawing))
        .expect("it can be drawn");
    assert!(faults.is_empty(), "{item}\n{faults:?}");
    let picture = figure
        .picture(&scene, "example", &Language::English)
        .expect("it can be drawn");
    (picture.svg, picture.alt)
}

/// Every file of an element is one of the list.
#[test]
fn every_element_is_listed() {
    let listed: Vec<String> = vibank::figure::element::KINDS
        .iter()
        .map(|kind| format!("{}.rs", kind.name().replace('-', "_")))
        .collect();
    for entry in std::fs::read_dir("src/figure/element").expect("the folder is there") {
        let name = entry
            .expect("it can be listed")
            .file_name()
            .to_string_lossy()
            .into_owned();
        assert!(
            ["mod.rs", "family.rs"].contains(&name.as_str()) || listed.contains(&name),
            "no element of `KINDS` has the name of the file {name}"
        );
    }
}

/// A filled area is not needed to know what is a body: outlines are there in black and white.
#[test]
fn areas_have_outlines() {
    let catalogue = &*BANK;
    for template in catalogue.items() {
        // Those without one are said by another test.
        let Some(figure) = &template.figure else {
            continue;
        };
        let solution = Solution::of(Instance::of_source(template));
        let drawing = figure
            .draw(&Scene::of(&solution, Data::Both))
            .expect("it draws");
        let is_bare = drawing
            .marks()
            .iter()
            .any(|mark| mark.fill == Fill::Tint && mark.pen.is_none());
        assert!(!is_bare, "{}", template.id.as_str());
    }
}
