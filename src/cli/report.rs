//! Findings drawn with the lines of their file.

use std::io::IsTerminal;

use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use vibank::diagnostic::{Finding, Severity};
use vibank::source::Span;

use super::shown::shown;

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
        let message = shown(&finding.message);
        let title = level.primary_title(&*message).id(finding.code.name());
        let (text, before) = lines_of(finding);
        if text.len() > MAX_LINES {
            return plain(finding, &message);
        }
        let first_line = finding.source.text[..before].matches('\n').count() + 1;
        let path = shown(&finding.source.path);
        let mut snippet = Snippet::source(text).line_start(first_line).path(&*path);
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
            let range = label.span.range();
            let range = range.start.saturating_sub(before)..range.end.saturating_sub(before);
            let range = clip(range, text);
            let annotation = kind.span(range);
            snippet = snippet.annotation(if label.text.is_empty() {
                annotation
            } else {
                annotation.label(shown(&label.text).into_owned())
            });
        }
        let mut group = title.element(snippet);
        if let Some(help) = &finding.help {
            group = group.element(Level::HELP.message(shown(help).into_owned()));
        }
        self.renderer.render(&[group]).clone()
    }
}

/// Most bytes of the lines that are drawn: of longer ones a reader sees nothing, and the renderer looks at each letter.
const MAX_LINES: usize = 8_000;

/// A finding without the lines that it points at.
fn plain(finding: &Finding, message: &str) -> String {
    let place = finding.place();
    let code = finding.code.name();
    let mut drawn = format!(
        "{}[{code}]: {message}\n --> {}",
        finding.severity,
        shown(&place)
    );
    if let Some(help) = &finding.help {
        drawn.push_str("\n  = help: ");
        drawn.push_str(&shown(help));
    }
    drawn
}

/// The lines that a finding points at, and how many bytes stand before them; all where it points at none.
///
/// The renderer looks through all that it is given, for each finding anew.
fn lines_of(finding: &Finding) -> (&str, usize) {
    let text = &*finding.source.text;
    let spans = finding.labels.iter().map(|label| label.span);
    let Some(span) = spans.filter(|span| !span.is_none()).reduce(Span::join) else {
        return (text, 0);
    };
    let range = clip(span.range(), text);
    let start = text[..range.start].rfind('\n').map_or(0, |end| end + 1);
    let end = text[range.end..].find('\n');
    let end = end.map_or(text.len(), |length| range.end + length + 1);
    (&text[start..end], start)
}

/// A range that lies inside the text and between characters.
fn clip(range: std::ops::Range<usize>, text: &str) -> std::ops::Range<usize> {
    let start = text.floor_char_boundary(range.start.min(text.len()));
    let end = text.ceil_char_boundary(range.end.min(text.len()));
    start..end.max(start)
}
