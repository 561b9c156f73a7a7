//! Pictures: time against error, and error against the small number of a sweep.

use std::fmt::Write;

use vibank::numerics::{log10, powi};

use crate::record::Record;

const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 430.0;
const LEFT: f64 = 74.0;
const RIGHT: f64 = 250.0;
const TOP: f64 = 44.0;
const BOTTOM: f64 = 56.0;

/// Ours first; the others are told apart by colour and by mark.
const COLOURS: [&str; 7] = [
    "#c1121f", "#1d4e89", "#2a9d8f", "#b8860b", "#6a4c93", "#555555", "#bc6c25",
];

/// Errors below this are drawn on the edge of the picture.
const MIN_ERROR: f64 = 1e-17;

/// A logarithmic axis on a stretch of pixels.
struct Axis {
    /// The powers of ten at its ends.
    low: i32,
    high: i32,
    start: f64,
    end: f64,
}

impl Axis {
    /// An axis that holds all values.
    fn over(values: impl Iterator<Item = f64>, start: f64, end: f64) -> Self {
        let (low, high) = values
            .map(log10)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                (low.min(value), high.max(value))
            });
        let low = low.floor();
        Self {
            low: low as i32,
            high: high.ceil().max(low + 1.0) as i32,
            start,
            end,
        }
    }

    fn of_errors(start: f64, end: f64) -> Self {
        Self {
            low: -17,
            high: 0,
            start,
            end,
        }
    }

    fn place(&self, value: f64) -> f64 {
        let (low, high) = (f64::from(self.low), f64::from(self.high));
        let share = (log10(value).clamp(low, high) - low) / (high - low);
        self.start + share * (self.end - self.start)
    }

    /// The powers of ten on the axis, and whether there is room for their numbers.
    fn decades(&self) -> impl Iterator<Item = (i32, bool)> {
        let step = 1 + (self.high - self.low) / 11;
        let high = self.high;
        (self.low..=self.high).map(move |power| (power, (high - power) % step == 0))
    }
}

/// A picture that is being drawn.
struct Picture {
    svg: String,
    across: Axis,
    up: Axis,
}

/// The title of a task's picture.
fn title(task: &str) -> String {
    let words = task.replace('-', " ");
    let mut letters = words.chars();
    letters.next().map_or(String::new(), |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

/// Error to the right, time upwards, a mark for each measurement of a task.
pub(crate) fn work(task: &str, records: &[&Record]) -> String {
    let times = records.iter().map(|record| record.timing.fast);
    let mut picture = Picture::new(
        &format!("{}: time against error", title(task)),
        Axis::of_errors(LEFT, WIDTH - RIGHT),
        Axis::over(times, HEIGHT - BOTTOM, TOP),
    );
    picture.frame("largest error, of the scale", "time per item in ns");
    let point = |record: &Record| (record.error.scaled.max(MIN_ERROR), record.timing.fast);
    picture.methods(records, point, |before, after| {
        before.case == after.case && before.tolerance.is_some()
    });
    picture.finish()
}

/// The small number of a sweep to the right, the error upwards, a line for each method.
pub(crate) fn sweep(task: &str, records: &[&Record]) -> String {
    let parameters = records.iter().filter_map(|record| record.parameter);
    let mut picture = Picture::new(
        &format!("{}: error against the small number", title(task)),
        Axis::over(parameters, LEFT, WIDTH - RIGHT),
        Axis::of_errors(HEIGHT - BOTTOM, TOP),
    );
    picture.frame("small number of the sweep", "largest error, of the scale");
    let mut sorted = records.to_vec();
    let parameter = |record: &Record| record.parameter.unwrap_or(f64::NAN);
    sorted.sort_by(|a, b| parameter(a).total_cmp(&parameter(b)));
    let point = |record: &Record| (parameter(record), record.error.scaled.max(MIN_ERROR));
    picture.methods(&sorted, point, |_, _| true);
    picture.finish()
}

impl Picture {
    fn new(title: &str, across: Axis, up: Axis) -> Self {
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" font-size=\"12\">\n\
             <title>{title}</title>\n<rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"white\"/>\n\
             <text x=\"{LEFT}\" y=\"26\" font-size=\"15\">{title}</text>\n"
        );
        Self { svg, across, up }
    }

    fn line(&mut self, text: std::fmt::Arguments<'_>) {
        writeln!(self.svg, "{text}").expect("a string takes any text");
    }

    /// Grid, numbers and names of the axes.
    fn frame(&mut self, across: &str, up: &str) {
        let (left, right) = (self.across.start, self.across.end);
        let (bottom, top) = (self.up.start, self.up.end);
        for (power, is_numbered) in self.across.decades().collect::<Vec<_>>() {
            let x = self.across.place(powi(10.0, power));
            self.line(format_args!(
                "<path d=\"M{x:.1} {bottom:.1}V{top:.1}\" stroke=\"#e3e3e3\"/>"
            ));
            if is_numbered {
                let y = bottom + 17.0;
                self.line(format_args!(
                    "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"middle\">{}</text>",
                    power_of_ten(power)
                ));
            }
        }
        for (power, is_numbered) in self.up.decades().collect::<Vec<_>>() {
            let y = self.up.place(powi(10.0, power));
            self.line(format_args!(
                "<path d=\"M{left:.1} {y:.1}H{right:.1}\" stroke=\"#e3e3e3\"/>"
            ));
            if is_numbered {
                let (x, y) = (left - 7.0, y + 4.0);
                self.line(format_args!(
                    "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"end\">{}</text>",
                    power_of_ten(power)
                ));
            }
        }
        self.line(format_args!(
            "<path d=\"M{left:.1} {top:.1}V{bottom:.1}H{right:.1}\" fill=\"none\" stroke=\"#333\"/>"
        ));
        let (x, y) = (f64::midpoint(left, right), HEIGHT - 14.0);
        self.line(format_args!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"middle\">{across}</text>"
        ));
        let y = f64::midpoint(top, bottom);
        self.line(format_args!(
            "<text x=\"18\" y=\"{y:.1}\" text-anchor=\"middle\" transform=\"rotate(-90 18 {y:.1})\">{up}</text>"
        ));
    }

    /// Marks and lines of all methods, ours on top, and what they mean.
    fn methods(
        &mut self,
        records: &[&Record],
        point: impl Fn(&Record) -> (f64, f64),
        are_joined: impl Fn(&Record, &Record) -> bool,
    ) {
        let mut methods: Vec<&str> = Vec::new();
        for record in records {
            if !methods.contains(&record.method) {
                methods.push(record.method);
            }
        }
        for (index, method) in methods.iter().enumerate().rev() {
            let mut before: Option<(&Record, f64, f64)> = None;
            for record in records.iter().filter(|record| record.method == *method) {
                let (x, y) = point(record);
                let (x, y) = (self.across.place(x), self.up.place(y));
                if let Some((earlier, from_x, from_y)) = before
                    && are_joined(earlier, record)
                {
                    let colour = COLOURS[index % COLOURS.len()];
                    self.line(format_args!(
                        "<path d=\"M{from_x:.1} {from_y:.1}L{x:.1} {y:.1}\" stroke=\"{colour}\" stroke-opacity=\"0.5\"/>"
                    ));
                }
                let said = format!(
                    "{}: {:.1e}, {:.3} ns",
                    record.case, record.error.scaled, record.timing.fast
                );
                self.mark(index, x, y, &said);
                before = Some((record, x, y));
            }
        }
        for (index, method) in methods.iter().enumerate() {
            let (x, y) = (WIDTH - RIGHT + 22.0, TOP + 8.0 + 20.0 * index as f64);
            self.mark(index, x, y, method);
            let (x, y) = (x + 12.0, y + 4.0);
            self.line(format_args!(
                "<text x=\"{x:.1}\" y=\"{y:.1}\">{method}</text>"
            ));
        }
    }

    /// Circle, square, triangle and diamond in turn.
    fn mark(&mut self, index: usize, x: f64, y: f64, said: &str) {
        let colour = COLOURS[index % COLOURS.len()];
        let path = match index % 4 {
            0 => format!("M{:.1} {y:.1}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0z", x - 5.0),
            1 => format!("M{:.1} {:.1}h7v7h-7z", x - 3.5, y - 3.5),
            2 => format!("M{x:.1} {:.1}l4.5 8h-9z", y - 5.0),
            _ => format!("M{x:.1} {:.1}l4.5 5l-4.5 5l-4.5 -5z", y - 5.0),
        };
        self.line(format_args!(
            "<path d=\"{path}\" fill=\"{colour}\" fill-opacity=\"0.85\"><title>{said}</title></path>"
        ));
    }

    fn finish(self) -> String {
        self.svg + "</svg>\n"
    }
}

fn power_of_ten(power: i32) -> String {
    format!(
        "10<tspan dy=\"-5\" font-size=\"9\">{}</tspan>",
        power.to_string().replace('-', "−")
    )
}
