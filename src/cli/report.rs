//! Findings drawn with the lines of their file.

use std::io::IsTerminal;

use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use vibank::diagnostic::{Finding, Severity};

/// Draws findings as the compiler of Rust does.
pub(crate) struct Reporter {
    renderer: Renderer,
}

impl Reporter {
    /// For standard error: with colours on a terminal, plain text elsewhere.
    pub(crate) fn for_stderr() -> Self {
        let styled = std::io::stderr().is_terminal();
        Self {
            renderer: if styled {
                Renderer::styled().decor_style(DecorStyle::Unicode)
            } else {
                Renderer::plain()
            },
        }
    }

    /// In plain text.
    pub(crate) fn plain() -> Self {
        Self {
            renderer: Renderer::plain(),
        }
    }

    /// One finding.
    pub(crate) fn draw(&self, finding: &Finding) -> String {
        let level = match finding.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
            Severity::Advice => Level::INFO.with_name("advice"),
        };
        let title = level
            .primary_title(&finding.message)
            .id(finding.code.name());
        let text = &*finding.source.text;
        let mut snippet = Snippet::source(text).path(&*finding.source.path);
        for (position, label) in finding
            .labels
            .iter()
            .filter(|label| !label.span.is_none())
            .enumerate()
        {
            let kind = if position == 0 {
                AnnotationKind::Primary
            } else {
                AnnotationKind::Context
            };
            let range = clip(label.span.range(), text);
            let annotation = kind.span(range);
            snippet = snippet.annotation(if label.text.is_empty() {
                annotation
            } else {
                annotation.label(&label.text)
            });
        }
        let mut group = title.element(snippet);
        if let Some(help) = &finding.help {
            group = group.element(Level::HELP.message(help));
        }
        self.renderer.render(&[group]).clone()
    }
}

/// A range that lies inside the text and between characters.
fn clip(range: std::ops::Range<usize>, text: &str) -> std::ops::Range<usize> {
    let start = text.floor_char_boundary(range.start.min(text.len()));
    let end = text.ceil_char_boundary(range.end.min(text.len()));
    start..end.max(start)
}
