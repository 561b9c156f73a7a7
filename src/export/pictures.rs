//! Figures as files of their own, beside the text that shows them.

use crate::document::{Filling, Formulas};
use crate::math::{Voice, escape};
use crate::scene::Shown;

/// The figures of one question.
#[derive(Default)]
pub(crate) struct Pictures {
    /// Name and SVG of each.
    pub(crate) files: Vec<(String, String)>,
    /// What their names begin with, where those of all questions lie in one folder.
    prefix: String,
}

impl Pictures {
    /// Figures whose names begin alike.
    pub(crate) fn named(prefix: String) -> Self {
        Self {
            prefix,
            ..Self::default()
        }
    }

    /// An element that shows a figure, which becomes a file; `folder` is where the platform has it.
    pub(crate) fn image(&mut self, folder: &str, svg: &str) -> String {
        let known = self.files.iter().position(|(_, known)| known == svg);
        let place = known.unwrap_or_else(|| {
            let name = format!("{}figure-{}.svg", self.prefix, self.files.len() + 1);
            self.files.push((name, svg.to_owned()));
            self.files.len() - 1
        });
        let mut alternative = String::new();
        for tag in ["title", "desc"] {
            if let Some(words) = content(svg, tag) {
                let mark = if alternative.is_empty() || alternative.ends_with('.') {
                    ""
                } else {
                    "."
                };
                let space = if alternative.is_empty() { "" } else { " " };
                alternative = format!("{alternative}{mark}{space}{words}");
            }
        }
        // The words come from the SVG and are escaped there as they have to be here.
        let alternative = alternative.replace('"', "&quot;");
        let mut out = String::from("<img src=\"");
        escape(&mut out, folder);
        format!("{out}{}\" alt=\"{alternative}\">", self.files[place].0)
    }

    /// Texts as HTML, one after the other, their figures shown as files.
    pub(crate) fn html(
        &mut self,
        folder: &str,
        formulas: Formulas,
        voice: &'static Voice,
        shown: &[Shown<'_>],
    ) -> String {
        let mut out = String::new();
        for piece in shown {
            let fillings: Vec<Filling> = piece
                .fillings
                .iter()
                .map(|filling| match filling {
                    Filling::Figure(svg) if svg.is_empty() => Filling::Figure(String::new()),
                    Filling::Figure(svg) => Filling::Figure(self.image(folder, svg)),
                    other => other.clone(),
                })
                .collect();
            piece
                .document
                .write_html_with(&mut out, &fillings, formulas, voice);
        }
        out
    }
}

/// The content of the first element of this name, which holds words alone.
fn content<'s>(svg: &'s str, tag: &str) -> Option<&'s str> {
    let (_, behind) = svg.split_once(&format!("<{tag}"))?;
    let (_, behind) = behind.split_once('>')?;
    let (words, _) = behind.split_once(&format!("</{tag}>"))?;
    Some(words.trim())
}
