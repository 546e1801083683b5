//! What all plots share: axes and the page's colours.

use crate::presenting::error::PresentError;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, ValueFormatter};
use plotters::prelude::*;
use std::ops::Range;

/// A plot over two [`Axis`].
pub(super) type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<Axis, Axis>>;

/// Why a plot could not be drawn.
pub(super) type Failure = DrawingAreaErrorKind<std::io::Error>;

/// Hues that tell estimators apart, `--hue-0` to `--hue-9` in the page's style.
pub(super) const HUES: usize = 10;

/// What a line is drawn with. Plots are drawn in stand-ins, which become the page's own colours, so
/// that they are dark on light and light on dark.
#[derive(Clone, Copy)]
pub(super) enum Ink {
    /// Axes and words.
    Text,
    /// The grid.
    Grid,
    /// An estimator's hue.
    Hue(usize),
}

impl Ink {
    fn all() -> impl Iterator<Item = Self> {
        [Self::Text, Self::Grid]
            .into_iter()
            .chain((0..HUES).map(Self::Hue))
    }

    /// The stand-in.
    pub(super) fn colour(self) -> RGBColor {
        match self {
            Self::Text => RGBColor(1, 0, 1),
            Self::Grid => RGBColor(2, 0, 2),
            Self::Hue(hue) => RGBColor(3, hue as u8, 3),
        }
    }

    /// The colour in the page.
    fn css(self) -> String {
        match self {
            Self::Text => "currentColor".into(),
            Self::Grid => "var(--line)".into(),
            Self::Hue(hue) => format!("var(--hue-{hue})"),
        }
    }
}

/// An axis: where values lie on it, and where it is labelled. Ends and labels are kept as their places:
/// of logarithms, if it is logarithmic.
#[derive(Clone)]
pub(super) struct Axis {
    log: bool,
    range: [f64; 2],
    ticks: Vec<f64>,
}

impl Axis {
    /// A logarithmic axis that holds positive values, labelled at powers of ten, and between them
    /// where there are few.
    pub(super) fn log(values: impl Iterator<Item = f64>) -> Self {
        let [low, high] = bounds(values.map(f64::log10)).unwrap_or([0.0, 1.0]);
        let margin = (0.08 * (high - low)).max(0.1);
        let (low, high) = (low - margin, high + margin);
        let steps: &[f64] = if high - low < 2.0 {
            &[1.0, 2.0, 5.0]
        } else {
            &[1.0]
        };
        let every = (((high - low) / 8.0).ceil() as usize).max(1);
        let decades = (low.floor() as i32..=high.ceil() as i32).step_by(every);
        let ticks = decades.flat_map(|d| steps.iter().map(move |s| f64::from(d) + s.log10()));
        Self {
            log: true,
            range: [low, high],
            ticks: ticks.filter(|t| (low..=high).contains(t)).collect(),
        }
    }

    /// An axis of a parameter, labelled at its values: logarithmic where these are positive and span
    /// more than a factor of four.
    pub(super) fn at_values(values: &[f64]) -> Self {
        let [low, high] = bounds(values.iter().copied()).unwrap_or([0.0, 1.0]);
        let log = low > 0.0 && high > 4.0 * low;
        let place = |v: f64| if log { v.log10() } else { v };
        let margin = (0.06 * (place(high) - place(low))).max(1e-6);
        let mut ticks: Vec<f64> = Vec::new();
        for at in values.iter().map(|v| place(*v)) {
            // Labels need room.
            let near = |t: &f64| (t - at).abs() < margin;
            if !ticks.iter().any(near) {
                ticks.push(at);
            }
        }
        Self {
            log,
            range: [place(low) - margin, place(high) + margin],
            ticks,
        }
    }

    fn place(&self, value: f64) -> f64 {
        if self.log { value.log10() } else { value }
    }

    fn value(&self, place: f64) -> f64 {
        if self.log { 10_f64.powf(place) } else { place }
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    /// Values beyond the ends lie at the ends.
    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        let [low, high] = self.range;
        let fraction = (self.place(*value).clamp(low, high) - low) / (high - low);
        (f64::from(from) + fraction * f64::from(to - from)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.iter().map(|t| self.value(*t)).collect()
    }

    fn range(&self) -> Range<f64> {
        self.value(self.range[0])..self.value(self.range[1])
    }
}

impl ValueFormatter<f64> for Axis {
    fn format(value: &f64) -> String {
        let magnitude = value.abs();
        if magnitude != 0.0 && !(0.999e-3..0.999e5).contains(&magnitude) {
            return format!("{value:.0e}");
        }
        // Three decimals at most, and no zeros behind.
        let text = format!("{value:.3}");
        text.trim_end_matches('0').trim_end_matches('.').into()
    }
}

/// Least and greatest of finite values; `None` without any.
fn bounds(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    let grow = |b: Option<[f64; 2]>, v: f64| {
        let [low, high] = b.unwrap_or([v, v]);
        Some([low.min(v), high.max(v)])
    };
    values.filter(|v| v.is_finite()).fold(None, grow)
}

/// Draws axes and what `content` adds; gives the elements within the SVG, and what `content` gives.
pub(super) fn draw<T>(
    size: (u32, u32),
    axes: [&Axis; 2],
    titles: [&str; 2],
    content: impl FnOnce(&mut Chart<'_, '_>) -> Result<T, Failure>,
) -> Result<(String, T), PresentError> {
    let mut svg = String::new();
    let drawn = draw_on(&mut svg, size, axes, titles, content);
    let drawn = drawn.map_err(|e| PresentError::Plot(e.to_string()))?;
    let inner = svg.split_once('>').map_or("", |(_, rest)| rest);
    let mut inner = inner.trim().trim_end_matches("</svg>").to_owned();
    for ink in Ink::all() {
        let RGBColor(r, g, b) = ink.colour();
        inner = inner.replace(&format!("#{r:02X}{g:02X}{b:02X}"), &ink.css());
    }
    Ok((inner, drawn))
}

fn draw_on<T>(
    svg: &mut String,
    size: (u32, u32),
    [x, y]: [&Axis; 2],
    [x_title, y_title]: [&str; 2],
    content: impl FnOnce(&mut Chart<'_, '_>) -> Result<T, Failure>,
) -> Result<T, Failure> {
    let root = SVGBackend::with_string(svg, size).into_drawing_area();
    let mut chart = ChartBuilder::on(&root)
        .margin(6)
        .margin_right(16)
        .x_label_area_size(46)
        .y_label_area_size(68)
        .build_cartesian_2d(x.clone(), y.clone())?;
    let words = ("sans-serif", 15).into_font().color(&Ink::Text.colour());
    chart
        .configure_mesh()
        .bold_line_style(Ink::Grid.colour())
        .light_line_style(TRANSPARENT)
        .axis_style(Ink::Text.colour())
        .label_style(words.clone())
        .axis_desc_style(words)
        .x_desc(x_title)
        .y_desc(y_title)
        .draw()?;
    let drawn = content(&mut chart)?;
    drop(chart);
    root.present()?;
    Ok(drawn)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_labelled_where_people_look() {
        let labels = |axis: &Axis| -> Vec<String> {
            axis.ticks
                .iter()
                .map(|t| Axis::format(&axis.value(*t)))
                .collect()
        };
        let wide = Axis::log([0.02, 300.0].into_iter());
        assert_eq!(labels(&wide), ["0.01", "0.1", "1", "10", "100"]);
        let narrow = Axis::log([1.5, 4.0].into_iter());
        assert_eq!(labels(&narrow), ["2", "5"]);
        assert!(Axis::log([1e-30, 1e30].into_iter()).ticks.len() <= 9);
        assert_eq!(
            labels(&Axis::at_values(&[4.0, 8.0, 32.0])),
            ["4", "8", "32"]
        );
        assert_eq!(
            labels(&Axis::at_values(&[0.0, 0.5, 1.0])),
            ["0", "0.5", "1"]
        );
    }

    #[test]
    fn values_lie_in_order_within_the_axis() {
        let axis = Axis::log([1.0, 1000.0].into_iter());
        let places = [0.0, 1.0, 10.0, 1000.0, 1e9].map(|v| axis.map(&v, (100, 0)));
        assert_eq!([places[0], places[4]], [100, 0], "{places:?}");
        assert!(places.is_sorted_by(|a, b| a > b), "{places:?}");
        assert_eq!(Axis::log(std::iter::empty()).map(&1e9, (0, 7)), 7);
    }
}
