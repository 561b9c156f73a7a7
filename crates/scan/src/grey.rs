//! Pages in shades of grey.

use std::fmt;
use std::io::Cursor;

use zune_core::colorspace::ColorSpace;
use zune_core::options::DecoderOptions;
use zune_jpeg::JpegDecoder;

/// Most pixels of a page: A3 at 600 dots per inch has 70 million.
const MAX_PIXELS: usize = 100_000_000;

/// Most pixels on a side.
const MAX_SIDE: usize = 30_000;

/// The longer side in pixels at which pages are read, within a factor of two: 200 dots per inch.
const READING_SIDE: usize = 2_200;

/// A page, from black at 0 to white at 255.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Grey {
    width: usize,
    height: usize,
    pixels: Vec<u8>,
}

/// Why a file is no page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ReadError {
    /// It is neither PNG nor JPEG.
    Unknown,
    /// It has too many bytes or pixels.
    Large,
    /// It cannot be read or decoded.
    Broken(String),
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown => f.write_str("it is neither PNG nor JPEG"),
            Self::Large => f.write_str("it is too large"),
            Self::Broken(why) => f.write_str(why),
        }
    }
}

impl std::error::Error for ReadError {}

impl Grey {
    /// A page of these pixels, row by row, unless there are none, too many, or not as many as the sides say.
    pub fn new(width: usize, height: usize, pixels: Vec<u8>) -> Option<Self> {
        let is_sound = (1..=MAX_SIDE).contains(&width)
            && (1..=MAX_SIDE).contains(&height)
            && width * height <= MAX_PIXELS
            && pixels.len() == width * height;
        is_sound.then_some(Self {
            width,
            height,
            pixels,
        })
    }

    /// The page in a file of PNG or JPEG.
    ///
    /// # Errors
    ///
    /// Where it is another file, too large or broken.
    pub fn read(bytes: &[u8]) -> Result<Self, ReadError> {
        if bytes.starts_with(b"\x89PNG") {
            Self::read_png(bytes)
        } else if bytes.starts_with(b"\xff\xd8") {
            Self::read_jpeg(bytes)
        } else {
            Err(ReadError::Unknown)
        }
    }

    fn read_png(bytes: &[u8]) -> Result<Self, ReadError> {
        let broken = |error: png::DecodingError| ReadError::Broken(error.to_string());
        let limits = png::Limits {
            bytes: 8 * MAX_PIXELS,
        };
        let mut decoder = png::Decoder::new_with_limits(Cursor::new(bytes), limits);
        decoder.set_transformations(png::Transformations::normalize_to_color8());
        let (width, height) = decoder.read_header_info().map_err(broken)?.size();
        let pixels = bounded(width as usize, height as usize)?;
        let mut reader = decoder.read_info().map_err(broken)?;
        let length = reader.output_buffer_size().ok_or(ReadError::Large)?;
        if length > 4 * pixels {
            return Err(ReadError::Large);
        }
        let mut buffer = vec![0; length];
        let frame = reader.next_frame(&mut buffer).map_err(broken)?;
        buffer.truncate(frame.buffer_size());
        Self::of_samples(
            width as usize,
            height as usize,
            &buffer,
            frame.color_type.samples(),
        )
    }

    fn read_jpeg(bytes: &[u8]) -> Result<Self, ReadError> {
        let broken = |error: zune_jpeg::errors::DecodeErrors| ReadError::Broken(error.to_string());
        let options = DecoderOptions::default()
            .set_max_width(MAX_SIDE)
            .set_max_height(MAX_SIDE)
            .jpeg_set_max_scans(64);
        let mut decoder = JpegDecoder::new_with_options(Cursor::new(bytes), options);
        decoder.decode_headers().map_err(broken)?;
        let info = decoder
            .info()
            .ok_or_else(|| ReadError::Broken("it has no header".to_owned()))?;
        let (width, height) = (usize::from(info.width), usize::from(info.height));
        bounded(width, height)?;
        let space = match decoder.input_colorspace() {
            Some(ColorSpace::YCbCr | ColorSpace::Luma) => ColorSpace::Luma,
            _ => ColorSpace::RGB,
        };
        decoder.set_options(options.jpeg_set_out_colorspace(space));
        let buffer = decoder.decode().map_err(broken)?;
        Self::of_samples(width, height, &buffer, space.num_components())
    }

    /// A page of samples of grey, grey with alpha, colours, or colours with alpha.
    fn of_samples(
        width: usize,
        height: usize,
        samples: &[u8],
        each: usize,
    ) -> Result<Self, ReadError> {
        let grey = |sample: &[u8]| match *sample {
            [red, green, blue, ..] => {
                let sum = 77 * u32::from(red) + 150 * u32::from(green) + 29 * u32::from(blue);
                (sum >> 8) as u8
            }
            [grey, ..] => grey,
            [] => 255,
        };
        let pixels = samples.chunks_exact(each.max(1)).map(grey).collect();
        Self::new(width, height, pixels)
            .ok_or_else(|| ReadError::Broken("it is not as large as it says".to_owned()))
    }

    /// Pixels in a row.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// The pixels, row by row.
    pub fn pixels(&self) -> &[u8] {
        &self.pixels
    }

    /// The page in about 200 dots per inch, where it has more than twice as many, or fewer than 150; nothing of one that
    /// is too small to have a mark.
    pub(crate) fn at_reading_size(&self) -> Option<Self> {
        let side = self.width.max(self.height);
        if self.width.min(self.height) < 64 {
            return None;
        }
        let by = side / READING_SIDE;
        Some(if by > 1 {
            self.shrunk(by)
        } else if side < 3 * READING_SIDE / 4 {
            self.doubled()
        } else {
            self.clone()
        })
    }

    /// Each square of `by` pixels as one.
    fn shrunk(&self, by: usize) -> Self {
        let (width, height) = (self.width / by, self.height / by);
        let mut pixels = Vec::with_capacity(width * height);
        for y in 0..height {
            for x in 0..width {
                let rows = (y * by..(y + 1) * by).map(|row| row * self.width + x * by);
                let squares = rows.flat_map(|at| &self.pixels[at..at + by]);
                let sum: usize = squares.map(|pixel| usize::from(*pixel)).sum();
                pixels.push((sum / (by * by)) as u8);
            }
        }
        Self {
            width,
            height,
            pixels,
        }
    }

    fn doubled(&self) -> Self {
        let (width, height) = (2 * self.width, 2 * self.height);
        let mut pixels = Vec::with_capacity(width * height);
        for y in 0..height {
            for x in 0..width {
                let at = self.at(x as f32 / 2.0 + 0.25, y as f32 / 2.0 + 0.25);
                pixels.push(at.round() as u8);
            }
        }
        Self {
            width,
            height,
            pixels,
        }
    }

    /// The shade at a point, where a pixel has its middle at ½.
    pub(crate) fn at(&self, x: f32, y: f32) -> f32 {
        let x = (x - 0.5).clamp(0.0, (self.width - 1) as f32);
        let y = (y - 0.5).clamp(0.0, (self.height - 1) as f32);
        let (left, top) = (x as usize, y as usize);
        let (right, low) = (
            (left + 1).min(self.width - 1),
            (top + 1).min(self.height - 1),
        );
        let (x, y) = (x - left as f32, y - top as f32);
        let pixel = |x: usize, y: usize| f32::from(self.pixels[y * self.width + x]);
        (pixel(left, top) * (1.0 - x) + pixel(right, top) * x) * (1.0 - y)
            + (pixel(left, low) * (1.0 - x) + pixel(right, low) * x) * y
    }

    /// Each pixel as the median of the nine around it; the border stays.
    pub(crate) fn median(&self) -> Self {
        let mut out = self.clone();
        for y in 1..self.height.saturating_sub(1) {
            for x in 1..self.width.saturating_sub(1) {
                let mut around = [0; 9];
                for (row, three) in around.chunks_exact_mut(3).enumerate() {
                    let start = (y + row - 1) * self.width + x - 1;
                    three.copy_from_slice(&self.pixels[start..start + 3]);
                }
                around.sort_unstable();
                out.pixels[y * self.width + x] = around[4];
            }
        }
        out
    }

    /// Blurred by a bell curve of this many pixels.
    pub(crate) fn blurred(&self, sigma: f32) -> Self {
        let reach = (3.0 * sigma).ceil() as usize;
        let bell = |step: usize| {
            let step = step as f32 - reach as f32;
            (-step * step / (2.0 * sigma * sigma)).exp()
        };
        let weights: Vec<f32> = (0..=2 * reach).map(bell).collect();
        let sum: f32 = weights.iter().sum();
        let weights: Vec<f32> = weights.iter().map(|weight| weight / sum).collect();
        // Beyond the border the page goes on as at the border.
        let place = |at: usize, step: usize, length: usize| {
            (at + step).saturating_sub(reach).min(length - 1)
        };
        let mut rows = vec![0.0; self.pixels.len()];
        for (row, out) in self
            .pixels
            .chunks_exact(self.width)
            .zip(rows.chunks_exact_mut(self.width))
        {
            for (x, out) in out.iter_mut().enumerate() {
                let weighed = weights.iter().enumerate();
                *out = weighed
                    .map(|(step, weight)| weight * f32::from(row[place(x, step, self.width)]))
                    .sum();
            }
        }
        let mut out = self.clone();
        let mut sums = vec![0.0; self.width];
        for (y, out) in out.pixels.chunks_exact_mut(self.width).enumerate() {
            sums.fill(0.0);
            for (step, weight) in weights.iter().enumerate() {
                let start = place(y, step, self.height) * self.width;
                for (sum, shade) in sums.iter_mut().zip(&rows[start..start + self.width]) {
                    *sum += weight * shade;
                }
            }
            for (out, sum) in out.iter_mut().zip(&sums) {
                *out = sum.round() as u8;
            }
        }
        out
    }
}

/// The number of pixels, unless there are too many.
fn bounded(width: usize, height: usize) -> Result<usize, ReadError> {
    let is_sound = width <= MAX_SIDE && height <= MAX_SIDE && width * height <= MAX_PIXELS;
    is_sound.then_some(width * height).ok_or(ReadError::Large)
}
