//! Figures and plots of items, and the tables that they are drawn from.

use vibank::document::read_math;
use vibank::instance::Instance;
use vibank::math::{Display, Voice};
use vibank::message::Language;
use vibank::output::{ChapterPiece, chapter_pieces};
use vibank::scene::{Data, Scene};
use vibank::solution::Solution;

use super::items::{block, find};

/// What a directive in the notation of chapters asks for: `plot ch3/t2-pick-the-regime regimes | Words under it.`
pub(super) fn asked(directive: &str) -> String {
    let line = format!("<!-- {directive} -->");
    let pieces = chapter_pieces(&line).unwrap_or_else(|error| panic!("{error}"));
    match pieces[..] {
        [(_, ChapterPiece::Picture { item, plot, words })] => picture(item, plot, words),
        _ => panic!("`{directive}` is no picture"),
    }
}

/// A plot or the figure of an item with the data of its file, and words under it, with `$x$`.
pub(super) fn picture(id: &str, plot: Option<&str>, words: &str) -> String {
    let solution = Solution::of(Instance::of_source(find(id)));
    let scene = Scene::of(&solution, Data::Both);
    let svg = if let Some(plot) = plot {
        let picture = scene.plot(plot);
        let picture = picture.unwrap_or_else(|error| panic!("{id} {plot}: {error}"));
        let name = format!("course-{}-{plot}", id.replace('/', "-"));
        picture.svg(&name, &Language::English)
    } else {
        let picture = scene.picture();
        let picture = picture.unwrap_or_else(|| panic!("`{id}` has no figure"));
        picture.svg.clone()
    };
    shown(&svg, words, id)
}

/// A table of an item's file, as it stands there: `ch3/e5-log-decrement plots.decay`.
pub(super) fn source(argument: &str) -> String {
    let (id, table) = argument.split_once(' ').expect("an item and a table");
    let text = &find(id).source.text;
    let begin = text
        .find(&format!("[{table}]"))
        .unwrap_or_else(|| panic!("`{id}` has no table `{table}`"));
    let text = &text[begin..];
    let end = text[1..].find("\n[").map_or(text.len(), |end| end + 1);
    format!("```toml\n{}\n```", text[..end].trim_end())
}

fn shown(svg: &str, words: &str, id: &str) -> String {
    let (chapter, slug) = id.split_once('/').expect("a chapter and a slug");
    let link = format!("<a href=\"../exercises/{chapter}.md#{slug}\"><code>{id}</code></a>");
    let words = with_math(words);
    block(&format!(
        "<figure>\n{svg}\n<figcaption>{words} ({link})</figcaption>\n</figure>"
    ))
}

fn with_math(words: &str) -> String {
    let pieces = words.split('$').enumerate().map(|(place, piece)| {
        if place % 2 == 0 {
            piece.to_owned()
        } else {
            inline(piece)
        }
    });
    pieces.collect()
}

fn inline(latex: &str) -> String {
    let math = read_math(latex).unwrap_or_else(|error| panic!("`{latex}`: {error:?}"));
    math.mathml(Display::Inline, Voice::ENGLISH)
}

/// A line of a page with its formulas typeset: `$…$` as it is typed, and what an earlier run made of it,
/// which keeps its LaTeX in `data-latex`.
pub(super) fn typeset(line: &str) -> String {
    const KEPT: &str = "<math data-latex=\"";
    let mut typed = String::with_capacity(line.len());
    let mut rest = line;
    while let Some((before, after)) = rest.split_once(KEPT) {
        let (latex, behind) = after.split_once('"').expect("the attribute ends");
        let (_, behind) = behind.split_once("</math>").expect("the formula ends");
        typed.push_str(before);
        typed.push_str(&format!("${}$", plain(latex)));
        rest = behind;
    }
    typed.push_str(rest);
    let pieces = typed.split('$').enumerate().map(|(place, piece)| {
        if place % 2 == 0 {
            return piece.to_owned();
        }
        let math = inline(piece);
        let body = math.strip_prefix("<math").expect("it is MathML");
        // A bar would end the cell of a table.
        format!("{KEPT}{}\"{body}", kept(piece)).replace('|', "&#124;")
    });
    pieces.collect()
}

const SIGNS: [(&str, &str); 4] = [
    ("&", "&amp;"),
    ("<", "&lt;"),
    (">", "&gt;"),
    ("\"", "&quot;"),
];

fn kept(latex: &str) -> String {
    let signs = SIGNS.iter();
    signs.fold(latex.to_owned(), |text, (sign, name)| {
        text.replace(sign, name)
    })
}

fn plain(kept: &str) -> String {
    let signs = SIGNS.iter().rev();
    signs.fold(kept.replace("&#124;", "|"), |text, (sign, name)| {
        text.replace(name, sign)
    })
}
