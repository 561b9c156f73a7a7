//! The self-check page: one HTML file with the items, the math font and the grader.
//!
//! Nothing is fetched: the page works from a disk. Its program may run only as it was written here (a content
//! security policy names its digest), and all texts are written by the grader, which escapes them.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use sha2::{Digest, Sha256};
use tera::{Context, Tera};

use super::layouts::{self, OutputError, base93};
use crate::bank::Compiled;
use crate::document::Filling;
use crate::message::Language;
use crate::worksheet::Practice;

/// The grader, built from these sources and deflated by `src/wasm/build.sh`.
pub(crate) const GRADER: &[u8] = include_bytes!("../wasm/grader.deflate");

/// How hard the items are deflated: the most that miniz does.
pub(crate) const LEVEL: u8 = 10;

/// The page of a practice with its items.
///
/// # Errors
///
/// [`OutputError`] if the layout cannot be filled.
pub fn practice(practice: &Practice, items: &[Compiled]) -> Result<String, OutputError> {
    page(practice, items, None)
}

/// The page as a course has it: with the adapter to the platform, and what it has to know, as JSON.
pub(crate) fn in_course(
    practice: &Practice,
    items: &[Compiled],
    course: &str,
) -> Result<String, OutputError> {
    page(practice, items, Some(course))
}

fn page(
    practice: &Practice,
    items: &[Compiled],
    course: Option<&str>,
) -> Result<String, OutputError> {
    let adapter = course.map_or("", |_| layouts::text("page/scorm.js"));
    let script = &unspaced(
        &[
            layouts::text("page/common.js"),
            adapter,
            layouts::text("page/page.js"),
        ]
        .concat(),
        "/**",
    );
    let texts = texts(&practice.language);
    let words: serde_json::Value =
        serde_json::from_str(texts).map_err(|error| OutputError::page("page.html", error))?;
    let instructions = practice.instructions.html(
        &Vec::<Filling>::new(),
        Language::of(&practice.language).unwrap_or_default().voice(),
    );
    let style = [
        crate::math::MATHML_STYLE,
        "\n",
        &unspaced(layouts::text("page/page.css"), "/*"),
    ]
    .concat();

    let mut tera = Tera::default();
    tera.autoescape_on(vec![".html"]);
    tera.add_raw_template("page.html", layouts::text("page/page.html"))
        .map_err(|error| OutputError::page("page.html", error))?;
    let mut context = Context::new();
    context.insert("language", &practice.language);
    context.insert("title", &practice.title);
    context.insert("program", &practice.program);
    context.insert("instructions", &instructions);
    context.insert("texts", &words);
    context.insert("texts_json", &in_script(texts));
    context.insert("style", &style);
    context.insert("font", &base93(layouts::font_file()));
    context.insert("course", &course.map(in_script));
    context.insert("script", script);
    context.insert(
        "script_digest",
        &STANDARD.encode(Sha256::digest(script.as_bytes())),
    );
    let items = practice.lines(items);
    let items = miniz_oxide::deflate::compress_to_vec(items.as_bytes(), LEVEL);
    context.insert("items", &base93(&items));
    context.insert("grader", &base93(GRADER));
    tera.render("page.html", &context)
        .map_err(|error| OutputError::page("page.html", error))
}

/// A program or a style without indents, empty lines, and lines that are a comment; it travels in every page.
pub(crate) fn unspaced(text: &str, comment: &str) -> String {
    let is_comment =
        |line: &str| line.starts_with("//") || line.starts_with(comment) && line.ends_with("*/");
    let lines = text.lines().map(str::trim);
    let kept: Vec<&str> = lines
        .filter(|line| !line.is_empty() && !is_comment(line))
        .collect();
    kept.join("\n")
}

/// The words of the page in a language, else in English.
pub(crate) fn texts(language: &str) -> &'static str {
    let spoken = Language::of(language).unwrap_or_default();
    layouts::text(&format!("page/texts.{}.json", spoken.code()))
}

/// JSON as it may stand in a `script` element.
pub(crate) fn in_script(json: &str) -> String {
    json.replace('<', "\\u003c")
}
