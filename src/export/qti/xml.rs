//! XML of the standard: elements under the names of each version, and HTML as the standard takes it.

use super::Version;
use crate::math::escape;

/// The namespace of formulas.
const MATH: &str = "http://www.w3.org/1998/Math/MathML";

/// Elements of HTML and MathML that have no end.
const VOID: [&str; 6] = ["br", "hr", "img", "mspace", "mprescripts", "none"];

/// Elements in which a picture may stand; elsewhere it gets a paragraph of its own.
const HOLDERS: [&str; 12] = [
    "p", "td", "th", "li", "span", "em", "h1", "h2", "h3", "h4", "h5", "h6",
];

/// A file while it is written. Names are given as in version 2; version 3 has them with hyphens.
pub(crate) struct Xml {
    pub(crate) out: String,
    version: Version,
    open: Vec<String>,
}

impl Xml {
    pub(crate) fn new(version: Version) -> Self {
        Self {
            out: String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"),
            version,
            open: Vec::new(),
        }
    }

    /// Begins an element.
    pub(crate) fn open(&mut self, name: &str, attributes: &[(&str, &str)]) {
        let name = self.begin(name, attributes);
        self.out.push('>');
        self.open.push(name);
    }

    /// Ends the element that was begun last.
    pub(crate) fn close(&mut self) {
        if let Some(name) = self.open.pop() {
            self.out.push_str(&format!("</{name}>\n"));
        }
    }

    /// An element without content.
    pub(crate) fn empty(&mut self, name: &str, attributes: &[(&str, &str)]) {
        self.begin(name, attributes);
        self.out.push_str("/>\n");
    }

    /// An element with words.
    pub(crate) fn words(&mut self, name: &str, attributes: &[(&str, &str)], words: &str) {
        self.open(name, attributes);
        escape(&mut self.out, words);
        self.close();
    }

    /// HTML, as the standard takes it.
    pub(crate) fn html(&mut self, html: &str) {
        markup(&mut self.out, html);
    }

    /// HTML in an element that version 3 puts around it.
    pub(crate) fn content(&mut self, html: &str) {
        if self.version == Version::V30 {
            self.open("contentBody", &[]);
            self.html(html);
            self.close();
        } else {
            self.html(html);
        }
    }

    fn begin(&mut self, name: &str, attributes: &[(&str, &str)]) -> String {
        let name = match self.version {
            Version::V30 => format!("qti-{}", hyphenated(name)),
            _ => name.to_owned(),
        };
        self.out.push('<');
        self.out.push_str(&name);
        for (attribute, value) in attributes {
            let is_own = self.version == Version::V30 && !attribute.contains(':');
            let attribute = if is_own {
                hyphenated(attribute)
            } else {
                (*attribute).to_owned()
            };
            self.out.push_str(&format!(" {attribute}=\""));
            escape(&mut self.out, value);
            self.out.push('"');
        }
        name
    }
}

/// `responseIdentifier` as `response-identifier`.
fn hyphenated(name: &str) -> String {
    let mut out = String::with_capacity(name.len() + 4);
    for letter in name.chars() {
        if letter.is_ascii_uppercase() {
            out.push('-');
        }
        out.push(letter.to_ascii_lowercase());
    }
    out
}

/// HTML as our writers give it, as XML: elements without an end are closed, formulas have their namespace, pictures stand
/// in a line, and attributes that the standard does not have are dropped.
fn markup(out: &mut String, html: &str) {
    let mut open: Vec<&str> = Vec::new();
    let mut rest = html;
    while let Some(start) = rest.find('<') {
        out.push_str(&rest[..start]);
        let Some(length) = rest[start..].find('>') else {
            break;
        };
        let tag = &rest[start + 1..start + length];
        rest = &rest[start + length + 1..];
        if let Some(name) = tag.strip_prefix('/') {
            // It was closed where it began.
            if VOID.contains(&name) {
                continue;
            }
            open.pop();
            out.push_str(&format!("</{name}>"));
            continue;
        }
        let is_closed = tag.ends_with('/');
        let tag = tag.trim_end_matches('/').trim_end();
        let (name, attributes) = tag.split_once(' ').unwrap_or((tag, ""));
        let is_void = is_closed || VOID.contains(&name);
        let is_loose = name == "img" && !open.iter().any(|own| HOLDERS.contains(own));
        if is_loose {
            out.push_str("<p>");
        }
        out.push('<');
        out.push_str(name);
        if name == "math" {
            out.push_str(&format!(" xmlns=\"{MATH}\""));
        }
        write_attributes(out, attributes);
        out.push_str(if is_void { "/>" } else { ">" });
        if is_loose {
            out.push_str("</p>");
        }
        if !is_void {
            open.push(name);
        }
    }
    out.push_str(rest);
}

/// Attributes but those for looks.
fn write_attributes(out: &mut String, attributes: &str) {
    let mut rest = attributes.trim();
    while let Some((name, behind)) = rest.split_once("=\"") {
        let Some((value, behind)) = behind.split_once('"') else {
            return;
        };
        if !matches!(name.trim(), "style" | "start") {
            out.push_str(&format!(" {}=\"{value}\"", name.trim()));
        }
        rest = behind.trim_start();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn xml(html: &str) -> String {
        let mut out = String::new();
        markup(&mut out, html);
        out
    }

    #[test]
    fn html_becomes_xml() {
        assert_eq!(xml("<p>a<br>b &lt; c</p>"), "<p>a<br/>b &lt; c</p>");
        assert_eq!(xml("<img alt=\"w\">"), "<p><img alt=\"w\"/></p>");
        assert_eq!(xml("<p><img alt=\"w\"></p>"), "<p><img alt=\"w\"/></p>");
        assert_eq!(xml("<td style=\"text-align:left\">1</td>"), "<td>1</td>");
        assert_eq!(
            xml("<math display=\"block\"><mspace width=\"1em\"></mspace></math>"),
            format!("<math xmlns=\"{MATH}\" display=\"block\"><mspace width=\"1em\"/></math>")
        );
    }

    #[test]
    fn names_of_version_3_have_hyphens() {
        let mut file = Xml::new(Version::V30);
        file.empty("textEntryInteraction", &[("responseIdentifier", "a")]);
        let written = "<qti-text-entry-interaction response-identifier=\"a\"/>\n";
        assert!(file.out.ends_with(written), "{}", file.out);
    }
}
