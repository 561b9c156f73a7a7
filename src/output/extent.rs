//! About how much paper a question takes, from what is printed of it.

/// Millimetres of a line of text.
const LINE: usize = 5;

/// Millimetres of a line of text, across.
const WIDTH: usize = 176;

/// Characters of a line of text.
const CHARACTERS: usize = 105;

/// Millimetres between two paragraphs.
const GAP: usize = 2;

/// Millimetres of a formula that stands alone, with what is free around it.
const FORMULA: usize = 13;

/// About how many millimetres a text of HTML takes on a page of A4, plots included. Lines are counted by characters, which
/// is right to a line or two for a statement.
pub(crate) fn text(html: &str) -> usize {
    within(html, WIDTH)
}

/// About how many millimetres a text takes with a figure, which stands beside it where half of the page is left.
pub(crate) fn with_figure(html: &str, figure: &str) -> usize {
    let (width, height) = picture(figure);
    if (1..=WIDTH / 2 - 2 * GAP).contains(&width) {
        within(html, WIDTH - width - 2 * GAP).max(height)
    } else {
        within(html, WIDTH) + height
    }
}

/// About how many millimetres a text takes that is so many millimetres wide.
fn within(html: &str, width: usize) -> usize {
    let line = (CHARACTERS * width / WIDTH).max(1);
    let (mut millimetres, mut characters) = (0, 0_usize);
    let mut rest = html;
    while let Some(at) = first(rest, b'<') {
        characters += rest[..at].trim_matches('\n').chars().count();
        rest = &rest[at..];
        let behind = |end: &str| rest.find(end).map(|at| at + end.len());
        let length = match rest.as_bytes() {
            [b'<', b's', b'v', b'g', ..] => {
                millimetres += picture(rest).1 + 2 * GAP;
                behind("</svg>")
            }
            [b'<', b'm', b'a', b't', b'h', ..] if opening(rest).contains("display=\"block\"") => {
                millimetres += FORMULA;
                behind("</math>")
            }
            tag => {
                if let [b'<', b'/', b'p', b'>', ..] | [b'<', b'/', b'l', b'i', b'>', ..] = tag {
                    millimetres += characters.div_ceil(line) * LINE + GAP;
                    characters = 0;
                }
                first(rest, b'>').map(|at| at + 1)
            }
        };
        rest = length.map_or("", |length| &rest[length..]);
    }
    millimetres + (characters + rest.trim().chars().count()).div_ceil(line) * LINE
}

/// Where an ASCII sign first stands; tags and the words between them are so short that looking at each byte is quickest.
fn first(html: &str, sign: u8) -> Option<usize> {
    html.bytes().position(|byte| byte == sign)
}

/// Width and height of a picture in millimetres; nothing where there is none.
fn picture(svg: &str) -> (usize, usize) {
    let side = |name| {
        let length = attribute(opening(svg), name)?.strip_suffix("mm")?;
        length.parse::<f64>().ok()
    };
    let [width, height] = ["width", "height"].map(|name| side(name).unwrap_or(0.0) as usize);
    (width, height)
}

/// The tag that a text begins with.
fn opening(html: &str) -> &str {
    html.split('>').next().unwrap_or("")
}

/// The value of an attribute of a tag.
fn attribute<'t>(tag: &'t str, name: &str) -> Option<&'t str> {
    tag.split_once(&format!(" {name}=\""))?.1.split('"').next()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_as_high_as_its_lines_formulas_and_plots() {
        let line = format!("<p>{}</p>", "m".repeat(CHARACTERS));
        assert_eq!(text(""), 0);
        assert_eq!(text(&line), LINE + GAP);
        assert_eq!(text(&format!("{line}\n{line}")), 2 * (LINE + GAP));
        let two = format!("<p>{} <em>and</em> {}</p>", "m".repeat(60), "m".repeat(60));
        assert_eq!(text(&two), 2 * LINE + GAP);
        let formula = "<math display=\"block\" alttext=\"x\"><mi>x</mi></math>";
        assert_eq!(text(&format!("{line}{formula}")), LINE + GAP + FORMULA);
        let plot =
            "<svg xmlns=\"s\" width=\"120.5mm\" height=\"60.7mm\"><text>long words</text></svg>";
        assert_eq!(text(&format!("{line}{plot}")), LINE + GAP + 60 + 2 * GAP);
    }

    #[test]
    fn a_narrow_figure_stands_beside_its_text() {
        let words = format!("<p>{}</p>", "m".repeat(5 * CHARACTERS));
        let figure = |width: u32| format!("<svg width=\"{width}.0mm\" height=\"40.0mm\"></svg>");
        assert_eq!(with_figure(&words, ""), 5 * LINE + GAP);
        assert_eq!(with_figure("<p>m</p>", &figure(60)), 40);
        // A third of the width is taken.
        assert_eq!(with_figure(&words, &figure(60)), 8 * LINE + GAP);
        assert_eq!(with_figure(&words, &figure(90)), 5 * LINE + GAP + 40);
    }

    /// What ends within a tag, or has none.
    #[test]
    fn any_text_has_a_height() {
        for html in [
            "<",
            "<svg",
            "<math display=\"block\"",
            "a < b",
            "<svg height=\"mm\">",
        ] {
            assert!(text(html) <= FORMULA + LINE, "{html}");
        }
    }
}
