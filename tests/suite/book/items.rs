//! Items of the bank as they stand in the book, in HTML with MathML.

use std::fmt::Write as _;

use crate::BANK;
use vibank::bank::Template;
use vibank::document::read_math;
use vibank::instance::Instance;
use vibank::math::{Display, Voice};
use vibank::scene::{Data, Scene, Shown};
use vibank::seed::Seed;
use vibank::solution::Solution;
use vibank::worksheet::headings;

/// A displayed formula.
pub(super) fn math(latex: &str) -> String {
    let math = read_math(latex).unwrap_or_else(|error| panic!("`{latex}`: {error:?}"));
    format!("<div>{}</div>", math.mathml(Display::Block, Voice::ENGLISH))
}

pub(super) fn find(id: &str) -> &'static Template {
    BANK.find(id)
        .unwrap_or_else(|| panic!("there is no item `{id}`"))
}

fn texts(shown: &[Shown<'_>]) -> String {
    let pieces = shown
        .iter()
        .map(|piece| piece.document.html(&piece.fillings, Voice::ENGLISH));
    pieces.collect()
}

/// HTML stays one block of Markdown while it has no empty line.
pub(super) fn block(html: &str) -> String {
    let lines = html
        .lines()
        .map(str::trim_end)
        .filter(|line| !line.is_empty());
    lines.collect::<Vec<_>>().join("\n")
}

/// The statement and the questions, with the worked solution folded away.
fn shown(solution: &Solution<'_>) -> String {
    let template = solution.template();
    let scene = Scene::of(solution, Data::Both);
    let mut out = texts(&scene.passage(&template.statement));
    if !template.statement.places_figure()
        && let Some(picture) = scene.picture()
    {
        let _ = writeln!(out, "<figure>\n{}\n</figure>", picture.svg);
    }
    let mut worked = texts(&scene.passage(&template.solution));
    out.push_str("<ol type=\"a\">\n");
    let asked: Vec<usize> = (0..template.parts.len())
        .filter(|place| solution.asks(*place))
        .collect();
    let headings = headings(template, &asked);
    for (number, (heading, place)) in headings.iter().zip(asked.iter().copied()).enumerate() {
        let part = &template.parts[place];
        if let Some((letter, group)) = heading.opened() {
            let _ = writeln!(out, "<li>{}<ol>", texts(&scene.passage(&group.text)));
            if !group.solution.is_empty() {
                let before = texts(&scene.passage(&group.solution));
                let _ = writeln!(worked, "<p><strong>{letter})</strong></p>\n{before}");
            }
        }
        let _ = writeln!(out, "<li>{}", texts(&scene.passage(&part.ask)));
        let options = part.answer.options();
        if !options.is_empty() {
            out.push_str("<ol type=\"a\">\n");
            for option in solution.order(place) {
                let _ = writeln!(
                    out,
                    "<li>{}</li>",
                    options[option].text.html(&Vec::new(), Voice::ENGLISH)
                );
            }
            out.push_str("</ol>\n");
        }
        out.push_str("</li>\n");
        let is_last = headings
            .get(number + 1)
            .is_none_or(|next| next.opens || next.group.is_none());
        if heading.group.is_some() && is_last {
            out.push_str("</ol></li>\n");
        }
        let key = scene
            .key(place)
            .map(|key| {
                key.map(|key| key.mathml(Display::Inline, Voice::ENGLISH))
                    .unwrap_or_default()
            })
            // A line of its own has room for fractions of full size.
            .map(|math| math.replacen("<math", "<math displaystyle=\"true\"", 1));
        let _ = writeln!(
            worked,
            "<p><strong>{})</strong> {}</p>\n{}",
            heading.letter,
            key.unwrap_or_default(),
            texts(&scene.passage(&part.solution))
        );
    }
    let _ = write!(
        out,
        "</ol>\n<details>\n<summary>Worked solution</summary>\n{worked}</details>"
    );
    out
}

/// The identities that the parts of the bank had, and where these parts are now.
pub(super) fn renamed() -> String {
    let mut out = String::from("| item | from → to |\n| --- | --- |\n");
    for template in BANK.items() {
        let parts = template.parts.iter();
        let renamed = parts.flat_map(|part| part.was.iter().map(move |was| (was, &part.id)));
        let renamed: Vec<String> = renamed
            .map(|(was, id)| format!("`{was}` → `{id}`"))
            .collect();
        if !renamed.is_empty() {
            let _ = writeln!(out, "| {} | {} |", template.id, renamed.join(", "));
        }
    }
    out
}

/// An item with the data of a seed, or those of its source: `ch3/e5-log-decrement seed=7`.
pub(super) fn worked(argument: &str) -> String {
    let (id, seed) = argument
        .split_once(" seed=")
        .map_or((argument, None), |(id, seed)| {
            (id, Some(Seed::new(seed.parse().expect("a number"))))
        });
    let template = find(id);
    let instance = Instance::of(template, seed, &[]).unwrap();
    let html = shown(&Solution::of(instance));
    let title = &template.about.title;
    block(&format!(
        "<div class=\"item\">\n<p><strong>{title}</strong> (<code>{id}</code>)</p>\n{html}\n</div>"
    ))
}

/// All items of a chapter with the data of their sources.
pub(super) fn chapter(chapter: &str) -> String {
    let mut out = String::new();
    let inside = format!("{chapter}/");
    let items = BANK
        .items()
        .filter(|item| item.id.as_str().starts_with(&inside));
    for template in items {
        let about = &template.about;
        let topics: Vec<&str> = about
            .topics
            .iter()
            .map(|topic| topic.value.as_str())
            .collect();
        let slug = &template.id.as_str()[inside.len()..];
        let _ = writeln!(
            out,
            "<h2 id=\"{slug}\">{}</h2>\n\n`{}` · level {} · {} min · {}\n\n{}\n",
            about.title,
            template.id,
            about.level,
            template.minutes(),
            topics.join(", "),
            block(&format!(
                "<div class=\"item\">\n{}\n</div>",
                shown(&Solution::of(Instance::of_source(template)))
            ))
        );
    }
    out
}
