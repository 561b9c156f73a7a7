//! Finds marks by their finder patterns, and reads their modules.

use rqrr::BitGrid;

use super::{BYTES, Grey};

/// Modules on a side.
const WIDTH: usize = 21;

/// A module in shares of the longer side of a page: 0.6 mm of 297 mm.
const MODULE: f32 = 0.6 / 297.0;

/// Most finder patterns of a page that are looked at; a page of text has some by chance.
const MAX_FINDERS: usize = 300;

/// Most places of a page at which a mark is tried to be read.
const MAX_TRIES: usize = 400;

/// How far the fourth corner may lie off the parallelogram of the others, in modules.
const BENDS: [(f32, f32); 5] = [
    (0.0, 0.0),
    (0.4, 0.4),
    (-0.4, -0.4),
    (0.4, -0.4),
    (-0.4, 0.4),
];

/// Windows in modules over which a shade counts as dark where it is darker than the mean, and by how much.
const WINDOWS: [(f32, u64); 3] = [(8.0, 4), (16.0, 6), (5.0, 4)];

/// A point, or a step.
type Point = (f32, f32);

/// The middle of a finder pattern.
#[derive(Clone, Copy, Debug)]
struct Finder {
    at: Point,
    module: f32,
    /// Rows in which it was met.
    rows: u16,
}

/// The bytes of a mark in a page.
pub(crate) fn mark(page: &Grey) -> Option<[u8; BYTES]> {
    let module = MODULE * page.width().max(page.height()) as f32;
    WINDOWS.iter().find_map(|(window, bias)| {
        let dark = Dark::of(page, ((window * module) as usize).max(9), *bias);
        let finders = dark.finders(0.56 * module..=1.9 * module);
        let mut tries = MAX_TRIES;
        of_three(page, &finders, &mut tries).or_else(|| of_two(page, &finders, &mut tries))
    })
}

/// The mark of three finder patterns.
fn of_three(page: &Grey, finders: &[Finder], tries: &mut usize) -> Option<[u8; BYTES]> {
    for corner in finders {
        for right in finders {
            let across = length(step(corner.at, right.at));
            let module = f32::midpoint(corner.module, right.module);
            if !(9.0 * module..=20.0 * module).contains(&across) {
                continue;
            }
            for below in finders {
                let along = length(step(corner.at, below.at));
                if !(0.8 * across..=1.25 * across).contains(&along) {
                    continue;
                }
                let (x, y) = (step(corner.at, right.at), step(corner.at, below.at));
                // At right angles, and not as in a mirror.
                if x.0 * y.1 - x.1 * y.0 < 0.9 * across * along {
                    continue;
                }
                *tries = tries.checked_sub(1)?;
                let read = |bend| read(page, corner.at, right.at, below.at, bend);
                if let Some(bytes) = BENDS.into_iter().find_map(read) {
                    return Some(bytes);
                }
            }
        }
    }
    None
}

/// The mark of two finder patterns, where something is written over the third.
fn of_two(page: &Grey, finders: &[Finder], tries: &mut usize) -> Option<[u8; BYTES]> {
    for one in finders {
        for other in finders {
            let (x, y) = step(one.at, other.at);
            let module = f32::midpoint(one.module, other.module);
            if !(11.0 * module..=17.5 * module).contains(&length((x, y))) {
                continue;
            }
            *tries = tries.checked_sub(1)?;
            // The other one is right of it, or below.
            let below = (one.at.0 - y, one.at.1 + x);
            let right = (one.at.0 + y, one.at.1 - x);
            let found = read(page, one.at, other.at, below, BENDS[0])
                .or_else(|| read(page, one.at, right, other.at, BENDS[0]));
            if found.is_some() {
                return found;
            }
        }
    }
    None
}

fn step(from: Point, to: Point) -> Point {
    (to.0 - from.0, to.1 - from.1)
}

fn length(step: Point) -> f32 {
    step.0.hypot(step.1)
}

/// The bytes of a mark whose finder patterns have their middles at these points.
fn read(
    page: &Grey,
    corner: Point,
    right: Point,
    below: Point,
    bend: Point,
) -> Option<[u8; BYTES]> {
    /// Least difference between paper and ink.
    const CONTRAST: f32 = 20.0;
    /// Between finder patterns, in modules.
    const APART: f32 = 14.0;
    let (x, y) = (step(corner, right), step(corner, below));
    let shade = |column: f32, row: f32| {
        let bent = (column * row / (APART * APART)).max(0.0);
        let (column, row) = (
            (column + bend.0 * bent) / APART,
            (row + bend.1 * bent) / APART,
        );
        page.at(
            corner.0 + x.0 * column + y.0 * row,
            corner.1 + x.1 * column + y.1 * row,
        )
    };
    let shades: [f32; WIDTH * WIDTH] = std::array::from_fn(|at| {
        let (column, row) = ((at % WIDTH) as f32 - 3.0, (at / WIDTH) as f32 - 3.0);
        let near = [
            (0.0, 0.0),
            (0.25, 0.0),
            (-0.25, 0.0),
            (0.0, 0.25),
            (0.0, -0.25),
        ];
        let sum: f32 = near.iter().map(|(x, y)| shade(column + x, row + y)).sum();
        sum / near.len() as f32
    });
    // What is known to be dark and to be light: the rings of the finder patterns.
    let (mut dark, mut light) = ((0.0, 0.0), (0.0, 0.0));
    for (left, top) in [(0, 0), (WIDTH - 7, 0), (0, WIDTH - 7)] {
        for row in 0..7_usize {
            for column in 0..7_usize {
                let is_light = column.abs_diff(3).max(row.abs_diff(3)) == 2;
                let kind = if is_light { &mut light } else { &mut dark };
                kind.0 += shades[(top + row) * WIDTH + left + column];
                kind.1 += 1.0;
            }
        }
    }
    let (dark, light) = (dark.0 / dark.1, light.0 / light.1);
    if light - dark < CONTRAST {
        return None;
    }
    [0.5, 0.38, 0.62].iter().find_map(|share| {
        let limit = dark + (light - dark) * share;
        let modules = Modules(std::array::from_fn(|at| shades[at] < limit));
        let mut bytes = Vec::new();
        rqrr::Grid::new(modules).decode_to(&mut bytes).ok()?;
        <[u8; BYTES]>::try_from(bytes).ok()
    })
}

/// Which modules are dark, row by row.
struct Modules([bool; WIDTH * WIDTH]);

impl BitGrid for Modules {
    fn size(&self) -> usize {
        WIDTH
    }

    fn bit(&self, row: usize, column: usize) -> bool {
        self.0[row * WIDTH + column]
    }
}

/// Which pixels of a page are dark, row by row.
struct Dark {
    width: usize,
    height: usize,
    pixels: Vec<bool>,
}

impl Dark {
    /// Those that are darker by `bias` than the mean over a window around them.
    fn of(page: &Grey, window: usize, bias: u64) -> Self {
        let (width, height) = (page.width(), page.height());
        // Sums over all above and left of a pixel.
        let mut sums = vec![0_u64; (width + 1) * (height + 1)];
        for (y, row) in page.pixels().chunks_exact(width).enumerate() {
            let mut sum = 0;
            for (x, shade) in row.iter().enumerate() {
                sum += u64::from(*shade);
                sums[(y + 1) * (width + 1) + x + 1] = sums[y * (width + 1) + x + 1] + sum;
            }
        }
        let reach = window / 2;
        let mut pixels = Vec::with_capacity(width * height);
        for (y, row) in page.pixels().chunks_exact(width).enumerate() {
            let (top, low) = (y.saturating_sub(reach), (y + reach + 1).min(height));
            for (x, shade) in row.iter().enumerate() {
                let (left, right) = (x.saturating_sub(reach), (x + reach + 1).min(width));
                let at = |x: usize, y: usize| sums[y * (width + 1) + x];
                let sum = at(right, low) + at(left, top) - at(left, low) - at(right, top);
                let count = ((low - top) * (right - left)) as u64;
                pixels.push((u64::from(*shade) + bias) * count < sum);
            }
        }
        Self {
            width,
            height,
            pixels,
        }
    }

    /// Whether the pixel at a point is dark; nothing beyond the page.
    fn at(&self, point: Point) -> Option<bool> {
        let is_within = (0.0..self.width as f32).contains(&point.0)
            && (0.0..self.height as f32).contains(&point.1);
        is_within.then(|| self.pixels[point.1 as usize * self.width + point.0 as usize])
    }

    /// Finder patterns with modules of these sizes, in the order of the rows.
    fn finders(&self, sizes: std::ops::RangeInclusive<f32>) -> Vec<Finder> {
        let mut found: Vec<Finder> = Vec::new();
        let mut starts = Vec::new();
        for (y, row) in self.pixels.chunks_exact(self.width).enumerate() {
            starts.clear();
            starts.push(0);
            starts.extend((1..self.width).filter(|x| row[*x] != row[x - 1]));
            starts.push(self.width);
            for run in starts.windows(6).filter(|run| row[run[0]]) {
                let runs = std::array::from_fn(|at| (run[at + 1] - run[at]) as f32);
                if !proportion(runs).is_some_and(|module| sizes.contains(&module)) {
                    continue;
                }
                let at = ((run[2] + run[3]) as f32 / 2.0, y as f32 + 0.5);
                let Some(new) = self.settled(at, *sizes.end()) else {
                    continue;
                };
                let is_near = |old: &&mut Finder| {
                    let (x, y) = step(old.at, new.at);
                    x.abs().max(y.abs()) < 2.0 * new.module
                };
                match found.iter_mut().find(is_near) {
                    Some(old) => old.join(&new),
                    None => found.push(new),
                }
                if found.len() >= MAX_FINDERS {
                    return found;
                }
            }
        }
        found
    }

    /// The finder pattern around a point, if it is one in both directions.
    fn settled(&self, mut at: Point, largest: f32) -> Option<Finder> {
        let reach = 6.0 * largest;
        at.1 += self.across(at, (0.0, 1.0), reach)?.0;
        let (off, wide) = self.across(at, (1.0, 0.0), reach)?;
        at.0 += off;
        let (off, tall) = self.across(at, (0.0, 1.0), reach)?;
        at.1 += off;
        let is_square = (wide - tall).abs() <= 0.5 * wide.max(tall);
        is_square.then_some(Finder {
            at,
            module: f32::midpoint(wide, tall),
            rows: 1,
        })
    }

    /// How far the middle of a finder pattern lies from a point in this direction, and its module.
    fn across(&self, from: Point, direction: Point, reach: f32) -> Option<(f32, f32)> {
        /// Of a pixel.
        const STEP: f32 = 0.5;
        let at = |distance: f32| {
            self.at((
                from.0 + direction.0 * distance,
                from.1 + direction.1 * distance,
            ))
        };
        if at(0.0) != Some(true) {
            return None;
        }
        let ends = |sign: f32| {
            let mut ends = [0.0; 3];
            let mut known = 0;
            for count in 1..(reach / STEP) as u16 {
                let distance = f32::from(count) * STEP;
                if at(sign * distance).unwrap_or(false) != (known % 2 == 0) {
                    ends[known] = distance - STEP / 2.0;
                    known += 1;
                    if known == ends.len() {
                        return Some(ends);
                    }
                }
            }
            None
        };
        let (after, before) = (ends(1.0)?, ends(-1.0)?);
        let module = proportion([
            before[2] - before[1],
            before[1] - before[0],
            before[0] + after[0],
            after[1] - after[0],
            after[2] - after[1],
        ])?;
        Some(((after[0] - before[0]) / 2.0, module))
    }
}

impl Finder {
    /// Takes the mean with what was met in another row.
    fn join(&mut self, new: &Self) {
        let share = 1.0 / (f32::from(self.rows) + 1.0);
        self.at.0 += (new.at.0 - self.at.0) * share;
        self.at.1 += (new.at.1 - self.at.1) * share;
        self.module += (new.module - self.module) * share;
        self.rows = self.rows.saturating_add(1);
    }
}

/// The module of five runs that are as 1 : 1 : 3 : 1 : 1.
fn proportion(runs: [f32; 5]) -> Option<f32> {
    /// Pixels in a module below which nothing can be read.
    const LEAST: f32 = 1.2;
    let module = runs.iter().sum::<f32>() / 7.0;
    let slack = 0.65 * module + 0.4;
    let [first, second, middle, fourth, last] = runs;
    let is_one = |run: f32| (run - module).abs() < slack;
    let is_finder = module >= LEAST
        && [first, second, fourth, last].into_iter().all(is_one)
        && (middle - 3.0 * module).abs() < 1.6 * slack;
    is_finder.then_some(module)
}
