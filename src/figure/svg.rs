//! Drawings as SVG: plain SVG 1.1, lines in the colour of the text around, stable bytes.
//!
//! One unit of the picture is a tenth of a millimetre, with one decimal; marks in a row that look alike
//! share one element. Letters name the fonts that the pages and the PDF have, and stay text.

use super::drawing::{Drawing, DrawnPath, Lettering};
use super::label::{Above, LetterRun, Look};
use super::path::{Path, PathStep};
use super::{Bounds, Fill, LETTER_SIZE, Pen, Point};

/// Picture units in a figure unit.
const SCALE: f64 = 100.0;

/// Text fonts: that of the PDF first, then what a browser may have.
const FONTS: &str =
    "Libertinus Serif, STIX Two Text, Cambria, Noto Serif, Liberation Serif, Georgia, serif";

/// What stands before the drawing in its SVG.
#[derive(Clone, Copy, Debug)]
pub struct Head<'a> {
    /// Begins all identities in the picture; unique on the page, letters, digits and hyphens.
    pub id: &'a str,
    /// What it shows, in a few words.
    pub title: &'a str,
    /// What it shows, for those who cannot see it; may be empty.
    pub description: &'a str,
}

/// Width and height in print of what is in a frame, in millimetres.
pub(crate) fn size(frame: Bounds) -> (f64, f64) {
    let View { width, height, .. } = View::of(frame);
    (width as f64 / 10.0, height as f64 / 10.0)
}

/// What is in a frame as an SVG element.
pub(crate) fn element(frame: Bounds, head: &Head<'_>, content: &str) -> String {
    let mut writer = SvgWriter {
        out: String::with_capacity(content.len() + 1024),
    };
    writer.head(head, View::of(frame));
    writer.out.push_str(content);
    writer.out.push_str("</svg>");
    writer.out
}

/// The marks and labels of a drawing; labels that were not settled are left out.
pub(crate) fn content(drawing: &Drawing) -> String {
    let mut writer = SvgWriter {
        out: String::with_capacity(4096),
    };
    writer.marks(&drawing.marks);
    writer.labels(&drawing.labels);
    writer.out
}

/// The visible part of the plane, in picture units.
struct View {
    left: i64,
    top: i64,
    width: i64,
    height: i64,
}

impl View {
    fn of(frame: Bounds) -> Self {
        // What is drawn is bounded; the clamp keeps integers in range whatever it was given.
        let whole = |number: f64| number.clamp(-1e9, 1e9) as i64;
        let (left, top) = (
            whole((frame.low.x * SCALE).floor()),
            whole((-frame.high.y * SCALE).floor()),
        );
        let (right, bottom) = (
            whole((frame.high.x * SCALE).ceil()),
            whole((-frame.low.y * SCALE).ceil()),
        );
        Self {
            left,
            top,
            width: (right - left).max(1),
            height: (bottom - top).max(1),
        }
    }
}

struct SvgWriter {
    out: String,
}

impl SvgWriter {
    fn head(&mut self, head: &Head<'_>, view: View) {
        self.text("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"");
        self.tenths(view.width);
        self.text("mm\" height=\"");
        self.tenths(view.height);
        self.text("mm\" viewBox=\"");
        for (place, number) in [view.left, view.top, view.width, view.height]
            .iter()
            .enumerate()
        {
            if place > 0 {
                self.out.push(' ');
            }
            self.out.push_str(&number.to_string());
        }
        // Fonts wider than the one that was measured run over the edge, where nothing cuts them.
        self.text("\" overflow=\"visible\" role=\"img\" aria-labelledby=\"");
        self.name(head.id, "t");
        if !head.description.is_empty() {
            self.out.push(' ');
            self.name(head.id, "d");
        }
        self.text("\"><title id=\"");
        self.name(head.id, "t");
        self.text("\">");
        self.escaped(head.title);
        self.text("</title>");
        if !head.description.is_empty() {
            self.text("<desc id=\"");
            self.name(head.id, "d");
            self.text("\">");
            self.escaped(head.description);
            self.text("</desc>");
        }
        self.out.push('\n');
    }

    /// An identity of this picture.
    fn name(&mut self, id: &str, part: &str) {
        self.escaped(id);
        self.out.push('-');
        self.out.push_str(part);
    }

    fn marks(&mut self, marks: &[DrawnPath]) {
        self.text("<g fill=\"none\" stroke=\"currentColor\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n");
        let mut rest = marks;
        while let Some(first) = rest.first() {
            let count = rest
                .iter()
                .take_while(|mark| joins(first, mark))
                .count()
                .max(1);
            let (alike, after) = rest.split_at(count);
            self.text("<path");
            self.look(first.pen, first.fill);
            self.text(" d=\"");
            for mark in alike {
                self.path(&mark.path);
            }
            self.text("\"/>\n");
            rest = after;
        }
        self.text("</g>\n");
    }

    fn look(&mut self, pen: Option<Pen>, fill: Fill) {
        match fill {
            Fill::None => {}
            Fill::Tint => self.text(" fill=\"currentColor\" fill-opacity=\".09\""),
            Fill::Shade => self.text(" fill=\"currentColor\" fill-opacity=\".28\""),
            Fill::Ink => self.text(" fill=\"currentColor\""),
            Fill::Paper => self.text(" fill=\"#fff\""),
        }
        let Some(pen) = pen else {
            self.text(" stroke=\"none\"");
            return;
        };
        self.text(" stroke-width=\"");
        self.number(pen.width() * SCALE);
        self.out.push('"');
        if let Some(pattern) = pen.dash.pattern() {
            self.text(" stroke-dasharray=\"");
            self.out.push_str(pattern);
            self.out.push('"');
        }
        if pen.is_faint {
            self.text(" stroke-opacity=\".45\"");
        }
    }

    fn path(&mut self, path: &Path) {
        for step in path.steps() {
            match *step {
                PathStep::Move(to) => {
                    self.out.push('M');
                    self.point(to);
                }
                PathStep::Line(to) => {
                    self.out.push('L');
                    self.point(to);
                }
                PathStep::Curve(first, second, to) => {
                    self.out.push('C');
                    self.point(first);
                    self.out.push(' ');
                    self.point(second);
                    self.out.push(' ');
                    self.point(to);
                }
                PathStep::Arc {
                    centre,
                    radius,
                    from,
                    to,
                } => {
                    self.out.push('A');
                    self.number(radius * SCALE);
                    self.out.push(' ');
                    self.number(radius * SCALE);
                    let is_large = (to - from).abs() > std::f64::consts::PI;
                    self.text(if is_large { " 0 1 " } else { " 0 0 " });
                    // The picture's y points down: counterclockwise is a negative sweep there.
                    self.text(if to > from { "0 " } else { "1 " });
                    self.point(centre + Point::at_angle(to) * radius);
                }
                PathStep::Close => self.out.push('Z'),
            }
        }
    }

    fn labels(&mut self, labels: &[Lettering]) {
        if labels.is_empty() {
            return;
        }
        self.text("<g fill=\"currentColor\" font-family=\"");
        self.text(FONTS);
        self.text("\" font-size=\"");
        self.number(LETTER_SIZE * SCALE);
        self.text("\">\n");
        for lettering in labels {
            self.label(lettering);
        }
        self.text("</g>\n");
    }

    fn label(&mut self, lettering: &Lettering) {
        let Lettering {
            label,
            anchor,
            bounds,
            ..
        } = lettering;
        let baseline = bounds.low.y + label.depth();
        let is_marked = !label.marks.is_empty();
        // The marks are placed from the left end, so letters below them start there whatever their width.
        let (x, side) = match anchor.x {
            _ if is_marked => (bounds.low.x, None),
            x if x < 0.0 => (bounds.low.x, None),
            x if x > 0.0 => (bounds.high.x, Some("end")),
            _ => (bounds.centre().x, Some("middle")),
        };
        self.text("<text x=\"");
        self.number(x * SCALE);
        self.text("\" y=\"");
        self.number(-baseline * SCALE);
        self.out.push('"');
        if let Some(side) = side {
            self.text(" text-anchor=\"");
            self.text(side);
            self.out.push('"');
        }
        // What is drawn above letters stays above them, whatever the width of the letters in the font of the reader.
        if is_marked {
            self.text(" lengthAdjust=\"spacingAndGlyphs\"");
            self.attribute(" textLength=\"", label.width() * SCALE);
        }
        self.out.push('>');
        let mut rise = 0.0;
        for run in &label.runs {
            self.run(run, rise, is_marked);
            rise = run.look.rise;
        }
        self.text("</text>\n");
        for mark in &label.marks {
            self.above(*mark, Point::new(bounds.low.x + mark.x, baseline + mark.y));
        }
    }

    fn above(&mut self, mark: Above, centre: Point) {
        let count = mark.dots();
        for number in 0..count {
            let shift = (f64::from(number) - f64::from(count - 1) / 2.0) * 0.1;
            self.text("<circle cx=\"");
            self.number((centre.x + shift) * SCALE);
            self.text("\" cy=\"");
            self.number(-centre.y * SCALE);
            self.text("\" r=\"2.4\"/>\n");
        }
        let Some((first, rest)) = mark.line().split_first() else {
            return;
        };
        self.text("<path fill=\"none\" stroke=\"currentColor\" stroke-width=\"2\" d=\"M");
        self.point(centre + Point::new(first.0, first.1));
        for corner in rest {
            self.out.push('L');
            self.point(centre + Point::new(corner.0, corner.1));
        }
        self.text("\"/>\n");
    }

    /// In a marked label every run has an element of its own: the press stretches bare text to the length of the label.
    fn run(&mut self, run: &LetterRun, rise: f64, is_marked: bool) {
        let Look {
            is_italic,
            is_bold,
            size,
            ..
        } = run.look;
        let is_plain = !is_italic && !is_bold && size == LETTER_SIZE;
        let shift = (run.look.rise - rise) * SCALE;
        if is_plain && shift == 0.0 && run.gap == 0.0 && !is_marked {
            self.escaped(&run.text);
            return;
        }
        self.text("<tspan");
        if is_italic {
            self.text(" font-style=\"italic\"");
        }
        if is_bold {
            self.text(" font-weight=\"bold\"");
        }
        if size != LETTER_SIZE {
            self.attribute(" font-size=\"", size * SCALE);
        }
        if run.gap != 0.0 {
            self.attribute(" dx=\"", run.gap * SCALE);
        }
        if shift != 0.0 {
            self.attribute(" dy=\"", -shift);
        }
        self.out.push('>');
        self.escaped(&run.text);
        self.text("</tspan>");
    }

    fn attribute(&mut self, name: &str, number: f64) {
        self.text(name);
        self.number(number);
        self.out.push('"');
    }

    fn point(&mut self, point: Point) {
        self.number(point.x * SCALE);
        self.out.push(' ');
        self.number(-point.y * SCALE);
    }

    /// A number with at most one decimal; zero has no sign.
    fn number(&mut self, number: f64) {
        self.tenths((number * 10.0).round() as i64);
    }

    fn tenths(&mut self, tenths: i64) {
        // From the last sign on: the largest has nineteen digits, a point and a minus.
        let mut signs = [0_u8; 21];
        let mut first = signs.len();
        let mut put = |sign: u8| {
            first -= 1;
            signs[first] = sign;
        };
        let (mut rest, tenth) = (tenths.unsigned_abs() / 10, tenths.unsigned_abs() % 10);
        if tenth > 0 {
            put(b'0' + tenth as u8);
            put(b'.');
        }
        loop {
            put(b'0' + (rest % 10) as u8);
            rest /= 10;
            if rest == 0 {
                break;
            }
        }
        if tenths < 0 {
            put(b'-');
        }
        self.text(std::str::from_utf8(&signs[first..]).unwrap_or_default());
    }

    fn text(&mut self, text: &str) {
        self.out.push_str(text);
    }

    fn escaped(&mut self, text: &str) {
        crate::math::escape(&mut self.out, text);
    }
}

/// Whether two marks can share one element: grey areas cannot, they would darken each other differently.
fn joins(a: &DrawnPath, b: &DrawnPath) -> bool {
    let is_even = matches!(a.fill, Fill::None | Fill::Ink);
    is_even && a.pen == b.pen && a.fill == b.fill
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{Dash, Weight};

    fn number(number: f64) -> String {
        let mut writer = SvgWriter { out: String::new() };
        writer.number(number);
        writer.out
    }

    #[test]
    fn numbers_are_short_and_zero_has_no_sign() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (-0.04, "0"),
            (-0.06, "-0.1"),
            (12.0, "12"),
            (-12.34, "-12.3"),
            (1999.96, "2000"),
        ] {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn lines_that_look_alike_share_an_element() {
        let mut drawing = Drawing::new();
        let line = |x: f64| Path::line(Point::new(x, 0.0), Point::new(x, 1.0));
        let thin = Pen::new(Weight::Thin);
        drawing.stroke(line(0.0), thin);
        drawing.stroke(line(1.0), thin);
        drawing.stroke(line(2.0), thin.dashed(Dash::Dashed));
        let svg = drawing.svg(&Head {
            id: "a",
            title: "<>",
            description: "",
        });
        assert_eq!(svg.matches("<path").count(), 2);
        assert!(svg.contains("<title id=\"a-t\">&lt;&gt;</title>"), "{svg}");
    }
}
