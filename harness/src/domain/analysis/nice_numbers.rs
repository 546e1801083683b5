//! Round numbers: 1, 2, 5, 10, 20, 50, …

/// The numbers of the 1-2-5 series that span these: from the first that is at least the smallest to the
/// first that is at least the largest. Values that are not positive and finite do not count.
pub(super) fn spanning(values: impl IntoIterator<Item = f64>) -> Vec<f64> {
    let range = values
        .into_iter()
        .filter(|v| v.is_finite() && *v > 0.0)
        .map(|v| (v, v))
        .reduce(|(low, high), (v, _)| (low.min(v), high.max(v)));
    let Some((low, high)) = range else {
        return Vec::new();
    };
    let decades = low.log10().floor() as i32..=high.log10().floor() as i32 + 1;
    let round = decades.flat_map(|decade| [1.0, 2.0, 5.0].map(|step| times_ten_to(step, decade)));
    let mut series = Vec::new();
    for number in round.filter(|n| *n >= low) {
        series.push(number);
        if number >= high {
            break;
        }
    }
    series
}

/// Correctly rounded where the power is exact, so that .005 is the number that is written so.
fn times_ten_to(step: f64, decade: i32) -> f64 {
    match decade {
        0.. => step * 10_f64.powi(decade),
        _ => step / 10_f64.powi(-decade),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_numbers_span_what_is_given() {
        assert_eq!(
            spanning([0.9, 30.0, 4.0]),
            [1.0, 2.0, 5.0, 10.0, 20.0, 50.0]
        );
        assert_eq!(spanning([0.0042]), [0.005]);
        assert_eq!(spanning([5e-7, 6e-7]), [5e-7, 1e-6]);
        assert_eq!(spanning([1.0, 1.0]), [1.0]);
        assert_eq!(spanning([90.0, 101.0]), [100.0, 200.0]);
    }

    #[test]
    fn what_has_no_logarithm_does_not_count() {
        assert_eq!(spanning([0.0, -3.0, f64::NAN, f64::INFINITY]), [0.0; 0]);
        assert_eq!(spanning([0.0, 2.0]), [2.0]);
    }
}
