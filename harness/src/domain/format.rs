//! Numbers as people read them, the same on the terminal and in the report.

use crate::domain::record::{Comparison, Verdict};

/// A number with three significant digits: plain from a thousandth to a million, else with a power
/// of ten.
pub(crate) fn number(value: f64) -> String {
    digits(value, 3)
}

/// A deviation, whose third digit would tell nothing.
pub(crate) fn deviation(value: f64) -> String {
    digits(value, 2)
}

fn digits(value: f64, significant: usize) -> String {
    let magnitude = value.abs();
    if value == 0.0 {
        return "0".into();
    }
    if !(0.000_999_5..999_999.5).contains(&magnitude) {
        return format!("{value:.*e}", significant - 1);
    }
    // 9.996 is 10.0, not 10.00: what counts is the magnitude of the rounded number.
    let rounded: f64 = format!("{magnitude:.*e}", significant - 1)
        .parse()
        .unwrap_or(magnitude);
    let decimals = significant as i32 - 1 - rounded.log10().floor() as i32;
    format!("{value:.*}", decimals.max(0) as usize)
}

/// relMSE, as an upper bound where the reference can't resolve it.
pub(crate) fn relmse(comparison: &Comparison) -> String {
    let conclusive = comparison.verdict == Verdict::Conclusive;
    comparison
        .relmse
        .map_or_else(|| "–".into(), |v| error(v, conclusive))
}

/// An error, as an upper bound where the reference can't resolve it.
pub(crate) fn error(value: f64, conclusive: bool) -> String {
    let bound = if conclusive { "" } else { "≲ " };
    format!("{bound}{}", number(value))
}

/// A number that may not exist.
pub(crate) fn optional(value: Option<f64>) -> String {
    value.map_or_else(|| "–".into(), number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_three_digits() {
        for (value, text) in [
            (0.0, "0"),
            (1.0, "1.00"),
            (-0.123_45, "-0.123"),
            (9.994, "9.99"),
            (9.996, "10.0"),
            (12.345, "12.3"),
            (1234.5, "1234"),
            (0.001_234, "0.00123"),
            (0.000_12, "1.20e-4"),
            (2.5e7, "2.50e7"),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn deviations_keep_two_digits() {
        for (value, text) in [(0.0123, "0.012"), (3.0, "3.0"), (45.6, "46")] {
            assert_eq!(deviation(value), text);
        }
    }
}
