//! Signed errors in colour: too dark is blue, too bright is red, right is nearly white.

use crate::domain::image::HdrImage;
use crate::domain::statistics::nearest_rank;
use image::{Rgba, RgbaImage};

/// Signed errors of an image, one number per pixel: the mean over the channels of estimate −
/// reference, as the metrics weigh them. `None` where a pixel shows no surface.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorMap {
    width: usize,
    errors: Vec<Option<f32>>,
}

/// The colour map: five stops in sRGB at equal distances, from −range to +range.
pub const STOPS: [[u8; 3]; 5] = [
    [24, 54, 128],
    [104, 160, 218],
    [245, 244, 240],
    [233, 140, 104],
    [136, 22, 30],
];

/// Colour of a pixel without a surface, or of an error that is not finite.
pub const NOTHING: Rgba<u8> = Rgba([128, 128, 128, 255]);

/// The colour map's stops as CSS colours, at equal distances from −range to +range.
pub fn colour_stops() -> impl Iterator<Item = String> {
    STOPS.iter().map(|[r, g, b]| format!("rgb({r},{g},{b})"))
}

/// The range that shows all but the largest hundredth of several maps' errors, rounded up to 1, 2
/// or 5 times a power of ten, so that maps side by side share one scale. 1 if all errors are 0.
pub fn error_range<'a>(maps: impl IntoIterator<Item = &'a ErrorMap>) -> f32 {
    let all = maps.into_iter().flat_map(|m| m.errors.iter().flatten());
    let mut errors: Vec<f64> = all
        .map(|e| f64::from(e.abs()))
        .filter(|e| e.is_finite())
        .collect();
    errors.sort_by(f64::total_cmp);
    round_up(nearest_rank(&errors, 0.99)) as f32
}

/// The next of …, 1, 2, 5, 10, … that is not below a value; 1 for 0.
fn round_up(value: f64) -> f64 {
    if value <= 0.0 {
        return 1.0;
    }
    let decade = 10_f64.powf(value.log10().floor());
    // Written decimals are rarely exact in binary: 0.5 must not become 1.
    let slack = 1.0 - 1e-6;
    let step = [1.0, 2.0, 5.0]
        .into_iter()
        .find(|s| value * slack <= s * decade);
    step.unwrap_or(10.0) * decade
}

impl ErrorMap {
    /// Errors of an image against a reference of the same size; `None` if the sizes differ.
    /// `surface` says which pixels show a surface.
    pub fn new(
        image: &HdrImage,
        reference: &HdrImage,
        surface: impl Fn(usize) -> bool,
    ) -> Option<Self> {
        let same = (image.width, image.height) == (reference.width, reference.height);
        let error = |i: usize| (image.pixels[i] - reference.pixels[i]).element_sum() / 3.0;
        same.then(|| Self {
            width: image.width,
            errors: (0..image.pixels.len())
                .map(|i| surface(i).then(|| error(i)))
                .collect(),
        })
    }

    /// The map in colour; errors beyond ±`range` take the outermost colours.
    pub fn coloured(&self, range: f32) -> RgbaImage {
        let height = self.errors.len().checked_div(self.width).unwrap_or(0);
        RgbaImage::from_fn(self.width as u32, height as u32, |x, y| {
            let error = self.errors[y as usize * self.width + x as usize];
            error
                .filter(|e| e.is_finite())
                .map_or(NOTHING, |e| colour(e / range))
        })
    }

    /// The map in colour above a colour bar labelled −range, 0 and +range.
    pub fn with_colour_bar(&self, range: f32) -> RgbaImage {
        let map = self.coloured(range);
        let labels = [format!("-{range}"), "0".into(), format!("+{range}")];
        let room: u32 = labels.iter().map(|l| text_width(l) + 2 * MARGIN).sum();
        let width = map.width().max(room);
        let bar_top = map.height() + MARGIN;
        let text_top = bar_top + BAR_HEIGHT + MARGIN;
        let height = text_top + TEXT_HEIGHT + MARGIN;
        let mut canvas = RgbaImage::from_pixel(width, height, Rgba([255, 255, 255, 255]));
        image::imageops::replace(&mut canvas, &map, 0, 0);
        for (x, y) in (0..width).flat_map(|x| (bar_top..bar_top + BAR_HEIGHT).map(move |y| (x, y)))
        {
            let t = 2.0 * (x as f32 + 0.5) / width as f32 - 1.0;
            canvas.put_pixel(x, y, colour(t));
        }
        let [low, zero, high] = &labels;
        write(&mut canvas, low, MARGIN, text_top);
        write(&mut canvas, zero, (width - text_width(zero)) / 2, text_top);
        write(
            &mut canvas,
            high,
            width - MARGIN - text_width(high),
            text_top,
        );
        canvas
    }
}

/// Colour of an error as a fraction of the range, linear between the stops.
fn colour(fraction: f32) -> Rgba<u8> {
    let position = (fraction.clamp(-1.0, 1.0) + 1.0) * 0.5 * (STOPS.len() - 1) as f32;
    let lower = (position as usize).min(STOPS.len() - 2);
    let t = position - lower as f32;
    let mix = |c: usize| {
        let (a, b) = (f32::from(STOPS[lower][c]), f32::from(STOPS[lower + 1][c]));
        (a + t * (b - a)).round() as u8
    };
    Rgba([mix(0), mix(1), mix(2), 255])
}

const MARGIN: u32 = 4;
const BAR_HEIGHT: u32 = 10;
/// A glyph of 3 × 5 cells, each two pixels wide and high.
const CELL: u32 = 2;
const GLYPH: (u32, u32) = (3, 5);
const TEXT_HEIGHT: u32 = GLYPH.1 * CELL;

fn text_width(text: &str) -> u32 {
    text.len() as u32 * (GLYPH.0 + 1) * CELL
}

/// Writes digits, signs and points in black.
fn write(canvas: &mut RgbaImage, text: &str, left: u32, top: u32) {
    for (i, character) in text.chars().enumerate() {
        let rows = glyph(character);
        let left = left + i as u32 * (GLYPH.0 + 1) * CELL;
        for (x, y) in (0..GLYPH.0 * CELL).flat_map(|x| (0..TEXT_HEIGHT).map(move |y| (x, y))) {
            let bit = GLYPH.0 - 1 - x / CELL;
            if rows[(y / CELL) as usize] >> bit & 1 == 1 {
                canvas.put_pixel(left + x, top + y, Rgba([0, 0, 0, 255]));
            }
        }
    }
}

/// Rows of a glyph from the top, three bits each.
fn glyph(character: char) -> [u8; 5] {
    match character {
        '0' => [0b111, 0b101, 0b101, 0b101, 0b111],
        '1' => [0b010, 0b110, 0b010, 0b010, 0b111],
        '2' => [0b111, 0b001, 0b111, 0b100, 0b111],
        '3' => [0b111, 0b001, 0b111, 0b001, 0b111],
        '4' => [0b101, 0b101, 0b111, 0b001, 0b001],
        '5' => [0b111, 0b100, 0b111, 0b001, 0b111],
        '6' => [0b111, 0b100, 0b111, 0b101, 0b111],
        '7' => [0b111, 0b001, 0b010, 0b010, 0b010],
        '8' => [0b111, 0b101, 0b111, 0b101, 0b111],
        '9' => [0b111, 0b101, 0b111, 0b001, 0b111],
        '-' => [0b000, 0b000, 0b111, 0b000, 0b000],
        '+' => [0b000, 0b010, 0b111, 0b010, 0b000],
        '.' => [0b000, 0b000, 0b000, 0b000, 0b010],
        'e' => [0b000, 0b111, 0b111, 0b100, 0b111],
        _ => [0; 5],
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]
    use super::*;
    use glam::Vec3;

    fn map(errors: &[f32]) -> ErrorMap {
        let mut image = HdrImage::new(errors.len(), 1);
        for (x, e) in errors.iter().enumerate() {
            image.set(x, 0, Vec3::new(3.0 * e, 0.0, 0.0));
        }
        ErrorMap::new(&image, &HdrImage::new(errors.len(), 1), |_| true).unwrap()
    }

    #[test]
    fn too_dark_is_blue_and_too_bright_is_red() {
        let picture = map(&[-2.0, 0.0, 1.0, 9.0, f32::NAN]).coloured(2.0);
        let rgb = |x: u32| picture.get_pixel(x, 0).0;
        let solid = |[r, g, b]: [u8; 3]| [r, g, b, 255];
        assert_eq!(rgb(0), solid(STOPS[0]));
        assert_eq!(rgb(1), solid(STOPS[2]));
        assert_eq!(rgb(2), solid(STOPS[3]));
        assert_eq!(rgb(3), solid(STOPS[4]), "beyond the range");
        assert_eq!(rgb(4), NOTHING.0, "not a number");
    }

    #[test]
    fn pixels_without_a_surface_are_grey_and_set_no_range() {
        let (image, reference) = (
            HdrImage {
                width: 2,
                height: 1,
                pixels: vec![Vec3::ONE, Vec3::splat(900.0)],
            },
            HdrImage::new(2, 1),
        );
        let map = ErrorMap::new(&image, &reference, |i| i == 0).unwrap();
        assert_eq!(map.coloured(1.0).get_pixel(1, 0), &NOTHING);
        assert_eq!(error_range([&map]), 1.0);
        assert!(ErrorMap::new(&image, &HdrImage::new(1, 2), |_| true).is_none());
    }

    #[test]
    fn ranges_are_shared_and_round() {
        assert_eq!(error_range([&map(&[0.03, -0.01]), &map(&[-0.11])]), 0.2);
        assert_eq!(error_range([&map(&[0.0])]), 1.0);
        assert_eq!(error_range([]), 1.0);
        for (value, rounded) in [
            (0.5, 0.5),
            (0.51, 1.0),
            (1e-3, 1e-3),
            (7.0, 10.0),
            (2.1, 5.0),
        ] {
            assert!((round_up(value) / rounded - 1.0).abs() < 1e-9, "{value}");
        }
    }

    #[test]
    fn the_colour_bar_states_the_range() {
        let picture = map(&[0.5; 8]).with_colour_bar(0.5);
        assert!(
            picture.width() > 8,
            "a narrow map makes room for the labels"
        );
        let black = picture.pixels().filter(|p| p.0 == [0, 0, 0, 255]).count() as u32;
        let cells = |text: &str| -> u32 {
            text.chars()
                .flat_map(glyph)
                .map(u8::count_ones)
                .sum::<u32>()
                * CELL
                * CELL
        };
        assert_eq!(black, cells("-0.50+0.5"));
    }
}
