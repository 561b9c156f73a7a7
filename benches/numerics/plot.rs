//! Work against precision, one picture a task.

use std::fmt::Write;

use crate::record::Record;

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 480.0;
const LEFT: f64 = 70.0;
const RIGHT: f64 = 230.0;
const TOP: f64 = 40.0;
const BOTTOM: f64 = 55.0;

const COLOURS: [&str; 8] = [
    "#c1121f", "#1d4e89", "#2a9d8f", "#e09f3e", "#6a4c93", "#555555", "#8ab17d", "#bc6c25",
];

/// A logarithmic axis from 10^low to 10^high on a stretch of pixels.
struct Axis {
    low: f64,
    high: f64,
    start: f64,
    end: f64,
}

impl Axis {
    fn place(&self, value: f64) -> f64 {
        let share = (vibank::numerics::log10(value).clamp(self.low, self.high) - self.low)
            / (self.high - self.low);
        self.start + share * (self.end - self.start)
    }

    fn decades(&self) -> impl Iterator<Item = i32> {
        (self.low as i32)..=(self.high as i32)
    }
}

/// Error to the right, time upwards, a mark for each measurement of a task.
pub(crate) fn svg(task: &str, records: &[&Record]) -> String {
    let times = || {
        records
            .iter()
            .map(|record| vibank::numerics::log10(record.timing.fast))
    };
    let errors = Axis {
        low: -17.0,
        high: 0.0,
        start: LEFT,
        end: WIDTH - RIGHT,
    };
    let work = Axis {
        low: times().fold(f64::INFINITY, f64::min).floor(),
        high: times().fold(f64::NEG_INFINITY, f64::max).floor() + 1.0,
        start: HEIGHT - BOTTOM,
        end: TOP,
    };
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" font-size=\"12\">\n\
         <title>{task}: time against error</title>\n<rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"white\"/>\n\
         <text x=\"{LEFT}\" y=\"24\" font-size=\"15\">{task}</text>\n"
    );
    grid(&mut svg, &errors, &work);
    for (index, method) in methods(records).into_iter().enumerate() {
        series(&mut svg, index, method, records, &errors, &work);
    }
    svg + "</svg>\n"
}

/// The methods in order of appearance.
fn methods<'a>(records: &[&'a Record]) -> Vec<&'a str> {
    let mut methods = Vec::new();
    for record in records {
        if !methods.contains(&record.method) {
            methods.push(record.method);
        }
    }
    methods
}

fn grid(svg: &mut String, errors: &Axis, work: &Axis) {
    let mut line =
        |text: std::fmt::Arguments<'_>| svg.write_fmt(text).expect("a string takes any text");
    for decade in errors.decades() {
        let x = errors.place(exp10(decade));
        line(format_args!(
            "<line x1=\"{x:.1}\" y1=\"{TOP}\" x2=\"{x:.1}\" y2=\"{:.1}\" stroke=\"#ddd\"/>\n",
            work.start
        ));
        if decade % 2 == 0 {
            let y = work.start + 16.0;
            line(format_args!(
                "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"middle\">1e{decade}</text>\n"
            ));
        }
    }
    for decade in work.decades() {
        let y = work.place(exp10(decade));
        line(format_args!(
            "<line x1=\"{LEFT}\" y1=\"{y:.1}\" x2=\"{:.1}\" y2=\"{y:.1}\" stroke=\"#ddd\"/>\n",
            errors.end
        ));
        line(format_args!(
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">1e{decade}</text>\n",
            LEFT - 6.0,
            y + 4.0
        ));
    }
    let (x, y) = (f64::midpoint(errors.start, errors.end), HEIGHT - 14.0);
    line(format_args!(
        "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"middle\">largest error, of the scale</text>\n"
    ));
    let y = f64::midpoint(work.start, work.end);
    line(format_args!(
        "<text x=\"16\" y=\"{y:.1}\" text-anchor=\"middle\" transform=\"rotate(-90 16 {y:.1})\">ns per item</text>\n"
    ));
}

/// A line through the tolerances of an integrator, single marks otherwise.
fn series(
    svg: &mut String,
    index: usize,
    method: &str,
    records: &[&Record],
    errors: &Axis,
    work: &Axis,
) {
    let colour = COLOURS[index % COLOURS.len()];
    let radius = if index == 0 { 5.0 } else { 3.5 };
    let mut last: Option<(&str, f64, f64)> = None;
    for record in records.iter().filter(|record| record.method == method) {
        let (x, y) = (
            errors.place(record.scaled_error.max(1e-17)),
            work.place(record.timing.fast),
        );
        if let Some((case, from_x, from_y)) = last
            && case == record.case
        {
            writeln!(svg, "<line x1=\"{from_x:.1}\" y1=\"{from_y:.1}\" x2=\"{x:.1}\" y2=\"{y:.1}\" stroke=\"{colour}\"/>")
                .expect("a string takes any text");
        }
        writeln!(
            svg,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"{colour}\"><title>{}: {:.1e}, {:.0} ns</title></circle>",
            record.case, record.scaled_error, record.timing.fast
        )
        .expect("a string takes any text");
        last = Some((&record.case, x, y));
    }
    let y = TOP + 18.0 * index as f64 + 6.0;
    let x = WIDTH - RIGHT + 18.0;
    writeln!(
        svg,
        "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"{colour}\"/><text x=\"{:.1}\" y=\"{:.1}\">{method}</text>",
        x + 12.0,
        y + 4.0
    )
    .expect("a string takes any text");
}

fn exp10(power: i32) -> f64 {
    vibank::numerics::powi(10.0, power)
}
