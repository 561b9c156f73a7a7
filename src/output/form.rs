//! The page on which a sheet is answered: one HTML file that works without a network, and knows no key.
//!
//! It carries the texts of one sheet as they were made, and items [without anything that could compute a
//! key](crate::bank::Template::stripped), by which it says how an answer is read.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;
use sha2::{Digest, Sha256};
use tera::{Context, Tera};

use super::layouts::{self, OutputError, base93};
use super::page::{GRADER, LEVEL, in_script, texts, unspaced};
use crate::bank::Compiled;
use crate::worksheet::Practice;

/// A sheet that is answered on a page.
#[derive(Clone, Debug, Serialize)]
pub struct FormSheet {
    /// The code of the variant, which is printed on the sheet as well.
    pub code: String,
    /// Whose it is; may be empty.
    pub name: String,
    /// The run that it belongs to, by which a browser keeps its answers apart.
    pub sheet: String,
    /// Title of the sheet.
    pub title: String,
    /// In the order of the sheet.
    pub questions: Vec<FormQuestion>,
}

/// A question of such a sheet.
#[derive(Clone, Debug, Serialize)]
pub struct FormQuestion {
    /// Its place on the sheet, from 1.
    pub number: usize,
    /// The heading of the item.
    pub title: String,
    /// What it is worth, in words.
    pub points: String,
    /// What it says, as HTML.
    #[serde(skip)]
    pub statement: String,
    /// Its parts, as the grader of a page shows them; `reads` is what reads their answers, if anything does.
    pub parts: Vec<serde_json::Value>,
}

/// What a layout shows of a question.
#[derive(Serialize)]
struct FormQuestionView<'a> {
    number: usize,
    title: &'a str,
    points: &'a str,
    statement: &'a str,
}

/// The page of a sheet; the questions of `practice` are those of the sheet, each with the item that reads its answers.
///
/// # Errors
///
/// [`OutputError`] if the layout cannot be filled.
pub fn form(
    sheet: &FormSheet,
    practice: &Practice,
    readers: &[Compiled],
) -> Result<String, OutputError> {
    let script = &unspaced(
        &[
            layouts::text("page/common.js"),
            layouts::text("form/form.js"),
        ]
        .concat(),
        "/**",
    );
    let style = [
        crate::math::MATHML_STYLE,
        "\n",
        &unspaced(layouts::text("page/page.css"), "/*"),
        "\n",
        &unspaced(layouts::text("form/form.css"), "/*"),
    ]
    .concat();
    let said = texts(&practice.language);
    let words: serde_json::Value =
        serde_json::from_str(said).map_err(|error| OutputError::page("form.html", error))?;
    let json =
        serde_json::to_string(sheet).map_err(|error| OutputError::page("form.html", error))?;
    let questions: Vec<FormQuestionView<'_>> = sheet.questions.iter().map(view).collect();
    let lines = practice.lines(readers);
    let items = miniz_oxide::deflate::compress_to_vec(lines.as_bytes(), LEVEL);

    let mut tera = Tera::default();
    tera.autoescape_on(vec![".html"]);
    tera.add_raw_template("form.html", layouts::text("form/form.html"))
        .map_err(|error| OutputError::page("form.html", error))?;
    let mut context = Context::new();
    context.insert("language", &practice.language);
    context.insert("title", &sheet.title);
    context.insert("code", &sheet.code);
    context.insert("name", &sheet.name);
    context.insert("program", &practice.program);
    context.insert("instructions", "");
    context.insert("questions", &questions);
    context.insert("texts", &words);
    context.insert("texts_json", &in_script(said));
    context.insert("form", &in_script(&json));
    context.insert("style", &style);
    context.insert("font", &base93(layouts::font_file()));
    context.insert("items", &base93(&items));
    context.insert("grader", &base93(GRADER));
    context.insert("script", script);
    context.insert(
        "script_digest",
        &STANDARD.encode(Sha256::digest(script.as_bytes())),
    );
    tera.render("form.html", &context)
        .map_err(|error| OutputError::page("form.html", error))
}

fn view(question: &FormQuestion) -> FormQuestionView<'_> {
    FormQuestionView {
        number: question.number,
        title: &question.title,
        points: &question.points,
        statement: &question.statement,
    }
}
