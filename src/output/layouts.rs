//! The page layouts: Tera templates, embedded or from a folder.

use std::borrow::Cow;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use include_dir::{Dir, include_dir};
use serde::Serialize;
use tera::{Context, Delimiters, Kwargs, State, Tera, Value};

use super::Writer;

static TEMPLATES: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/templates");

/// Why a page could not be made.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// A layout that cannot be read.
    #[error("the layouts of `{format}` cannot be read: {message}")]
    Layouts {
        /// The format whose layouts these are: `html`, `latex`.
        format: &'static str,
        /// What is wrong and where.
        message: String,
    },
    /// A page that cannot be filled.
    #[error("the layout `{layout}` cannot be filled: {message}")]
    Page {
        /// The name of the layout file.
        layout: String,
        /// What is wrong and where.
        message: String,
    },
}

impl OutputError {
    /// What went wrong in filling a layout.
    pub(crate) fn page(layout: &str, error: impl std::fmt::Display) -> Self {
        Self::Page {
            layout: layout.to_owned(),
            message: error.to_string(),
        }
    }
}

/// The layouts of one format.
pub struct Layouts {
    tera: Tera,
    text: String,
    ending: &'static str,
}

/// The marks of places in layouts of a notation that is full of braces.
const ANGLES: Delimiters = Delimiters {
    block_start: Cow::Borrowed("<%"),
    block_end: Cow::Borrowed("%>"),
    variable_start: Cow::Borrowed("<<"),
    variable_end: Cow::Borrowed(">>"),
    comment_start: Cow::Borrowed("<#"),
    comment_end: Cow::Borrowed("#>"),
};

impl Layouts {
    /// The layouts that come with the program, each replaced by the file of the same name in `own`.
    ///
    /// # Errors
    ///
    /// [`OutputError::Layouts`].
    pub fn of(writer: &dyn Writer, own: &[(String, String)]) -> Result<Self, OutputError> {
        let mut tera = Tera::default();
        tera.register_filter("css", |text: &str, _: Kwargs, _: &State<'_>| {
            Value::safe_string(&css(text))
        });
        match writer.escape() {
            Some(escape) => {
                tera.set_escape_fn(escape);
                tera.autoescape_on(vec![format!(".{}", writer.layout())]);
            }
            None => tera.autoescape_on(Vec::<String>::new()),
        }
        let folder = TEMPLATES.get_dir(writer.name());
        let embedded = folder.into_iter().flat_map(Dir::files).filter_map(|file| {
            Some((
                file.path().file_name()?.to_str()?.to_owned(),
                file.contents_utf8()?.to_owned(),
            ))
        });
        let mut texts: Vec<(String, String)> = embedded
            .filter(|(name, _)| !name.ends_with(".css"))
            .collect();
        for (name, text) in own {
            match texts.iter_mut().find(|(known, _)| known == name) {
                Some((_, known)) => known.clone_from(text),
                None => texts.push((name.clone(), text.clone())),
            }
        }
        let fail = |error: tera::Error| OutputError::Layouts {
            format: writer.name(),
            message: error.to_string(),
        };
        if writer.has_braces() {
            tera.set_delimiters(ANGLES).map_err(fail)?;
        }
        let text = texts.iter().flat_map(|(name, text)| [&**name, &**text]);
        let text = text.collect();
        tera.add_raw_templates(texts).map_err(fail)?;
        Ok(Self {
            tera,
            text,
            ending: writer.layout(),
        })
    }

    /// All layouts, one after the other.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// Whether there is a layout `name`.
    pub(crate) fn has(&self, name: &str) -> bool {
        let layout = format!("{name}.{}", self.ending);
        self.tera.get_template_names().any(|known| known == layout)
    }

    /// Fills the layout `name`.
    pub(crate) fn fill(&self, name: &str, content: &impl Serialize) -> Result<String, OutputError> {
        let layout = format!("{name}.{}", self.ending);
        let context =
            Context::from_serialize(content).map_err(|error| OutputError::page(&layout, error))?;
        self.tera
            .render(&layout, &context)
            .map_err(|error| OutputError::page(&layout, error))
    }
}

/// Whether a format comes with a layout of this name.
pub fn has_layout(writer: &dyn Writer, name: &str) -> bool {
    let path = format!("{}/{name}.{}", writer.name(), writer.layout());
    TEMPLATES.get_file(path).is_some()
}

/// The style of HTML pages.
pub(crate) fn style() -> &'static str {
    text("html/style.css")
}

/// The math font in base 64.
pub(crate) fn font() -> String {
    STANDARD.encode(font_file())
}

/// The file of the math font.
pub(crate) fn font_file() -> &'static [u8] {
    TEMPLATES
        .get_file("fonts/vibank-math.woff2")
        .map_or(&[][..], |file| file.contents())
}

/// The text of a layout's file; empty if there is none.
pub(crate) fn text(path: &str) -> &'static str {
    TEMPLATES
        .get_file(path)
        .and_then(|file| file.contents_utf8())
        .unwrap_or_default()
}

/// Words within the quotes of a string of CSS: whatever could end the string, or the element around it, is written by its
/// code, and so is what an HTML reader would take for markup.
fn css(words: &str) -> String {
    let mut out = String::with_capacity(words.len());
    for sign in words.chars() {
        if sign.is_control() || "\"'\\<>&".contains(sign) {
            out.push_str(&format!("\\{:x} ", u32::from(sign).max(1)));
        } else {
            out.push(sign);
        }
    }
    out
}

/// Base 93: two digits for 13 bits, or for 14 where they allow it, low ones first, as basE91 has it (Henke 2006); what is
/// left at the end takes one digit if that is enough. The digits are the printed ASCII signs without `<`, so that they
/// may stand in a `script` element.
pub(crate) fn base93(bytes: &[u8]) -> String {
    // Two digits reach 93² - 1 = 8,648. The fourteenth bit is worth 8,192, so that only 456 is left for the
    // others.
    const LAST_OF_14: u32 = 93 * 93 - (1 << 13) - 1;
    let digit = |value: u32| char::from(b'!' + value as u8 + u8::from(value >= 27));
    let mut out = String::with_capacity(bytes.len() * 16 / 13 + 2);
    let (mut bits, mut count) = (0_u32, 0);
    for byte in bytes {
        bits |= u32::from(*byte) << count;
        count += 8;
        if count > 13 {
            let length = if bits & 0x1fff > LAST_OF_14 { 13 } else { 14 };
            let pair = bits & ((1 << length) - 1);
            out.extend([digit(pair % 93), digit(pair / 93)]);
            bits >>= length;
            count -= length;
        }
    }
    if count > 0 {
        out.push(digit(bits % 93));
    }
    if count > 7 || bits > 92 {
        out.push(digit(bits / 93));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{base93, css};

    /// Titles and names stay within the string of CSS and the `style` element that they stand in.
    #[test]
    fn words_do_not_leave_a_string_of_css() {
        assert_eq!(css("Midterm – Übung 1: √2"), "Midterm – Übung 1: √2");
        assert_eq!(css("\"; } </style>"), "\\22 ; } \\3c /style\\3e ");
        assert_eq!(css("a\\b\nc"), "a\\5c b\\a c");
    }

    /// Read back as the page reads it.
    #[test]
    fn base93_gives_the_bytes_back_in_digits_that_are_safe_in_html() {
        let worth = |byte: u8| u32::from(byte - b'!') - u32::from(byte > b'<');
        let read = |text: &str| {
            let (mut bits, mut count, mut bytes) = (0_u32, 0, Vec::new());
            for pair in text.as_bytes().chunks(2) {
                let value = worth(pair[0]) + pair.get(1).map_or(0, |high| 93 * worth(*high));
                bits |= value << count;
                count = match pair.len() {
                    1 => 8,
                    _ if value & 0x1fff > 456 => count + 13,
                    _ => count + 14,
                };
                while count >= 8 {
                    bytes.push(bits as u8);
                    bits >>= 8;
                    count -= 8;
                }
            }
            bytes
        };
        for length in 0..200 {
            for step in [0, 1, 37, 91, 255] {
                let bytes: Vec<u8> = (0..length)
                    .map(|at: u8| 255 - at.wrapping_mul(step))
                    .collect();
                let text = base93(&bytes);
                assert_eq!(read(&text), bytes, "{text}");
                assert!(!text.contains('<'));
                let zeros = vec![step; usize::from(length)];
                assert_eq!(read(&base93(&zeros)), zeros);
            }
        }
    }
}
