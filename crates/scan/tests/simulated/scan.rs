//! A printed page, and what a scanner makes of it.

use rand::RngExt as _;
use rand_chacha::ChaCha8Rng;

/// Dots per mm of the printed page: 300 per inch.
const FINE: f64 = 300.0 / 25.4;

/// Dots per mm of the scan: 200 per inch.
const COARSE: f64 = 200.0 / 25.4;

/// A4, in mm.
const PAPER: (f64, f64) = (210.0, 297.0);

/// A module, in mm.
const MODULE: f64 = 0.6;

/// A point in mm, or in dots.
type Point = (f64, f64);

/// Dots in shades of grey.
pub(crate) struct Sheet {
    width: usize,
    height: usize,
    dots: Vec<u8>,
}

impl Sheet {
    fn blank() -> Self {
        let (width, height) = ((PAPER.0 * FINE) as usize, (PAPER.1 * FINE) as usize);
        let dots = vec![255; width * height];
        Self {
            width,
            height,
            dots,
        }
    }

    /// A page with lines of strokes as thick and as close as those of letters, and a frame with hatching.
    pub(crate) fn written(random: &mut ChaCha8Rng) -> Self {
        let mut sheet = Self::blank();
        let mut y = 22.0;
        while y < 272.0 {
            let mut x = 20.0;
            while x < random.random_range(120.0..189.0) {
                for _ in 0..2 {
                    let from = (x, y - random.random_range(0.0..2.4));
                    let to = (x + random.random_range(-0.8..0.8), y);
                    sheet.stroke(from, to, 0.3, 0);
                }
                x += random.random_range(1.2..4.0);
            }
            y += random.random_range(4.5..9.0);
        }
        let (left, top) = (
            random.random_range(25.0..100.0),
            random.random_range(60.0..200.0),
        );
        for step in 0..30 {
            let x = left + 2.0 * f64::from(step);
            sheet.stroke((x, top), (x - 2.0, top + 3.0), 0.25, 0);
        }
        sheet
    }

    /// Prints the marks, and writes over one of them on every fifth page.
    pub(crate) fn stamp(&mut self, modules: &[u32; 21], random: &mut ChaCha8Rng) {
        let side = 21.0 * MODULE;
        let corners = [(PAPER.0 - 5.0 - side, 8.0), (5.0, PAPER.1 - 8.0 - side)];
        for (left, top) in corners {
            let dots = |from: f64| (from * FINE) as usize..((from + side) * FINE) as usize + 1;
            for y in dots(top) {
                for x in dots(left) {
                    let quarters = (0..16).filter(|part| {
                        let x = (x as f64 + f64::from(part % 4) / 4.0 + 0.125) / FINE - left;
                        let y = (y as f64 + f64::from(part / 4) / 4.0 + 0.125) / FINE - top;
                        let row = (y >= 0.0).then(|| modules.get((y / MODULE) as usize));
                        let row = row.flatten().copied().unwrap_or(0);
                        (0.0..side).contains(&x) && row >> (x / MODULE) as u32 & 1 == 1
                    });
                    self.dots[y * self.width + x] = 255 - (quarters.count() * 255 / 16) as u8;
                }
            }
        }
        if random.random_bool(0.2) {
            let corner = corners[random.random_range(0..2)];
            let ink = random.random_range(20..110);
            for _ in 0..random.random_range(1..6) {
                let mut end = |start: f64| start + random.random_range(-3.0..side + 3.0);
                let (from, to) = (
                    (end(corner.0), end(corner.1)),
                    (end(corner.0), end(corner.1)),
                );
                let width = random.random_range(0.4..1.0);
                self.stroke(from, to, width, ink);
            }
        }
    }

    fn stroke(&mut self, from: Point, to: Point, width: f64, ink: u8) {
        let reach = width / 2.0 * FINE;
        let steps = ((from.0 - to.0).abs().max((from.1 - to.1).abs()) * FINE * 1.5) as usize + 1;
        for step in 0..=steps {
            let share = step as f64 / steps as f64;
            let x = (from.0 + (to.0 - from.0) * share) * FINE;
            let y = (from.1 + (to.1 - from.1) * share) * FINE;
            for row in (y - reach).max(0.0) as usize..=(y + reach).max(0.0) as usize {
                for column in (x - reach).max(0.0) as usize..=(x + reach).max(0.0) as usize {
                    let (right, low) = (column as f64 - x, row as f64 - y);
                    let is_ink = right * right + low * low <= reach * reach;
                    if is_ink && row < self.height && column < self.width {
                        let dot = &mut self.dots[row * self.width + column];
                        *dot = (*dot).min(ink);
                    }
                }
            }
        }
    }

    /// The shade at a point in dots; beyond the paper, that of the lid.
    fn shade(&self, (x, y): Point, lid: f64) -> f64 {
        let (right, low) = ((self.width - 1) as f64, (self.height - 1) as f64);
        if !(0.0..right).contains(&x) || !(0.0..low).contains(&y) {
            return lid;
        }
        let at = y as usize * self.width + x as usize;
        let (x, y) = (x.fract(), y.fract());
        let dot = |at: usize| f64::from(self.dots[at]);
        (dot(at) * (1.0 - x) + dot(at + 1) * x) * (1.0 - y)
            + (dot(at + self.width) * (1.0 - x) + dot(at + self.width + 1) * x) * y
    }
}

/// The file of a scan, PNG of a page in black and white, else JPEG.
pub(crate) fn scanned(sheet: &Sheet, random: &mut ChaCha8Rng) -> Vec<u8> {
    let angle = random.random_range(-8.0..8.0_f64) + 90.0 * f64::from(random.random_range(0..4));
    let scale = random.random_range(0.97..1.03) * COARSE / FINE;
    let (sin, cos) = sine_and_cosine(angle);
    let (wide, tall) = (sheet.width as f64, sheet.height as f64);
    let corners = [(0.0, 0.0), (wide, 0.0), (wide, tall), (0.0, tall)];
    let bend = 0.012 * wide * scale;
    let mut placed = corners.map(|(x, y)| {
        let (x, y) = ((x - wide / 2.0) * scale, (y - tall / 2.0) * scale);
        let mut off = || random.random_range(-bend..bend);
        (x * cos - y * sin + off(), x * sin + y * cos + off())
    });
    let least = |of: fn(&Point) -> f64| placed.iter().map(of).fold(f64::MAX, f64::min);
    let most = |of: fn(&Point) -> f64| placed.iter().map(of).fold(f64::MIN, f64::max);
    let (left, right) = (least(|point| point.0), most(|point| point.0));
    let (top, low) = (least(|point| point.1), most(|point| point.1));
    // Some of the lid is around the paper, or as little as 3 mm of the paper is cut off.
    let mut around = || random.random_range(-3.0..10.0) * COARSE;
    let [l, t, r, b] = std::array::from_fn(|_| around());
    let (width, height) = (
        (right - left + l + r) as usize,
        (low - top + t + b) as usize,
    );
    for (x, y) in &mut placed {
        *x += l - left;
        *y += t - top;
    }
    let back = projection(placed, corners);
    let lid = if random.random_bool(0.6) {
        random.random_range(0.0..40.0)
    } else {
        random.random_range(200.0..255.0)
    };
    let mut shades = vec![0.0; width * height];
    for (at, shade) in shades.iter_mut().enumerate() {
        let (x, y) = ((at % width) as f64, (at / width) as f64);
        for (over, down) in [(0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75)] {
            let (x, y) = (x + over, y + down);
            let depth = back[6] * x + back[7] * y + 1.0;
            let from = (
                (back[0] * x + back[1] * y + back[2]) / depth - 0.5,
                (back[3] * x + back[4] * y + back[5]) / depth - 0.5,
            );
            *shade += sheet.shade(from, lid) / 4.0;
        }
    }
    blur(&mut shades, width, random.random_range(0.5..1.5));
    let dark = random.random_range(0.0..110.0);
    let light = random.random_range(dark + 90.0..256.0_f64).min(255.0);
    let slope = random.random_range(-25.0..25.0);
    for (at, shade) in shades.iter_mut().enumerate() {
        let down = (at / width) as f64 / height as f64 - 0.5;
        *shade = (dark + *shade / 255.0 * (light - dark) + slope * down).clamp(0.0, 255.0);
    }
    let is_black_and_white = random.random_bool(1.0 / 3.0);
    let limit = dark + (light - dark) * random.random_range(0.35..0.65);
    let speckle = random.random_range(0.0..0.02);
    let mut dots: Vec<u8> = Vec::with_capacity(shades.len());
    for shade in shades {
        let is_speckle = random.random_bool(speckle);
        dots.push(match shade {
            _ if is_speckle => 255 * u8::from(random.random_bool(0.5)),
            shade if is_black_and_white => 255 * u8::from(shade >= limit),
            shade => shade as u8,
        });
    }
    if is_black_and_white {
        as_png(&dots, width, height)
    } else {
        as_jpeg(&dots, width, height, random.random_range(40..=80))
    }
}

#[expect(
    clippy::disallowed_methods,
    reason = "scans need not be the same on all machines"
)]
fn sine_and_cosine(degrees: f64) -> (f64, f64) {
    degrees.to_radians().sin_cos()
}

/// By a bell curve of this many dots.
#[expect(
    clippy::disallowed_methods,
    reason = "scans need not be the same on all machines"
)]
fn blur(shades: &mut [f64], width: usize, sigma: f64) {
    let reach = 4;
    let bell = |step: i32| (-f64::from(step * step) / (2.0 * sigma * sigma)).exp();
    let weights: Vec<f64> = (-reach..=reach).map(bell).collect();
    let sum: f64 = weights.iter().sum();
    let last = shades.len() - 1;
    for stride in [1, width] {
        let before = shades.to_vec();
        for (at, shade) in shades.iter_mut().enumerate() {
            let weighed = weights.iter().enumerate().map(|(step, weight)| {
                let from = (at + step * stride).saturating_sub(reach as usize * stride);
                weight * before[from.min(last)]
            });
            *shade = weighed.sum::<f64>() / sum;
        }
    }
}

fn as_png(dots: &[u8], width: usize, height: usize) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width as u32, height as u32);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::One);
    encoder.set_compression(png::Compression::Fast);
    let mut writer = encoder.write_header().expect("it is written to memory");
    let mut rows = Vec::new();
    for row in dots.chunks_exact(width) {
        let bytes = row.chunks(8).map(|eight| {
            let bits = eight.iter().enumerate();
            bits.fold(0, |byte, (at, dot)| byte | (dot >> 7) << (7 - at))
        });
        rows.extend(bytes);
    }
    writer.write_image_data(&rows).expect("it is whole");
    writer.finish().expect("it is whole");
    file
}

fn as_jpeg(dots: &[u8], width: usize, height: usize, quality: u8) -> Vec<u8> {
    let mut file = Vec::new();
    jpeg_encoder::Encoder::new(&mut file, quality)
        .encode(
            dots,
            width as u16,
            height as u16,
            jpeg_encoder::ColorType::Luma,
        )
        .expect("it is written to memory");
    file
}

/// The projection that takes four points to four others.
fn projection(from: [Point; 4], to: [Point; 4]) -> [f64; 8] {
    let mut rows = [[0.0; 9]; 8];
    for (at, ((x, y), (u, v))) in from.into_iter().zip(to).enumerate() {
        rows[2 * at] = [x, y, 1.0, 0.0, 0.0, 0.0, -u * x, -u * y, u];
        rows[2 * at + 1] = [0.0, 0.0, 0.0, x, y, 1.0, -v * x, -v * y, v];
    }
    for column in 0..8 {
        let size = |row: &usize| rows[*row][column].abs();
        let pivot = (column..8).max_by(|a, b| size(a).total_cmp(&size(b)));
        rows.swap(column, pivot.expect("there is a row"));
        let first = rows[column].map(|entry| entry / rows[column][column]);
        rows[column] = first;
        for row in (0..8).filter(|row| *row != column) {
            let factor = rows[row][column];
            for (entry, first) in rows[row].iter_mut().zip(first) {
                *entry -= factor * first;
            }
        }
    }
    rows.map(|row| row[8])
}
