//! Whether a difference is more than the noise of what it is compared with: the one definition.
//!
//! There are two statements, the second of which is the stronger:
//!
//! - A difference is *above the noise* ([`Difference::is_above_noise`]) if its square is more than
//!   [`NOISE_FACTOR`] times what noise alone would give: a standard error is itself uncertain. That is said of a
//!   step of an error breakdown, whose noise is that of both of its ends and may be none.
//! - A comparison is *conclusive* ([`verdict`]) if its relMSE is above the noise and also exceeds the floor by
//!   more than [`NOISE_DEVIATIONS`] standard deviations of what noise alone would give, which guards against few
//!   points. The RMSE has to exceed its own floor too: at dark points whose samples all happened to agree the
//!   standard error is too small, and relMSE gives such points most weight. An exact reference is always
//!   conclusive: even a difference of zero is then a result.

use super::record::Verdict;

/// How many times the noise floor a difference above the noise is at least.
pub const NOISE_FACTOR: f64 = 2.0;

/// By how many standard deviations of pure noise a conclusive relMSE exceeds the floor.
pub const NOISE_DEVIATIONS: f64 = 3.0;

/// A mean squared difference, relative or in units of the quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// As it was measured.
    pub squared: f64,
    /// What noise alone would give; 0 if there is none.
    pub floor: f64,
}

impl Difference {
    /// Whether noise alone is no explanation.
    pub fn is_above_noise(self) -> bool {
        self.squared > NOISE_FACTOR * self.floor
    }
}

/// Whether a comparison is conclusive: from its MSE, and from its relMSE with the standard deviation of what
/// noise alone would give, `None` for a reference that is zero everywhere.
pub fn verdict(mse: Difference, relmse: Option<(Difference, f64)>) -> Verdict {
    let conclusive = match relmse {
        Some(_) if mse.floor > 0.0 && mse.squared <= mse.floor => false,
        Some((relmse, deviation)) => {
            let beyond_chance = relmse.floor + NOISE_DEVIATIONS * deviation;
            relmse.floor == 0.0 || (relmse.is_above_noise() && relmse.squared > beyond_chance)
        }
        None => mse.floor == 0.0 || mse.is_above_noise(),
    };
    match conclusive {
        true => Verdict::Conclusive,
        false => Verdict::Inconclusive,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LARGE: Difference = Difference {
        squared: 10.0,
        floor: 1.0,
    };

    #[test]
    fn a_conclusive_comparison_is_above_the_noise_and_beyond_chance() {
        let verdict_of = |squared, deviation| {
            let relmse = Difference {
                squared,
                floor: 1.0,
            };
            (
                relmse.is_above_noise(),
                verdict(LARGE, Some((relmse, deviation))),
            )
        };
        assert_eq!(verdict_of(1.9, 0.0), (false, Verdict::Inconclusive));
        assert_eq!(verdict_of(2.1, 0.3), (true, Verdict::Conclusive));
        assert_eq!(verdict_of(2.1, 0.4), (true, Verdict::Inconclusive));
    }

    #[test]
    fn an_exact_reference_tells_of_a_difference_of_zero_which_is_not_above_the_noise() {
        let none = Difference {
            squared: 0.0,
            floor: 0.0,
        };
        assert!(!none.is_above_noise());
        assert_eq!(verdict(none, Some((none, 0.0))), Verdict::Conclusive);
        assert_eq!(verdict(none, None), Verdict::Conclusive);
    }

    #[test]
    fn an_mse_within_its_own_noise_is_inconclusive() {
        let within = Difference {
            squared: 1.0,
            floor: 1.0,
        };
        assert_eq!(verdict(within, Some((LARGE, 0.0))), Verdict::Inconclusive);
        assert_eq!(verdict(within, None), Verdict::Inconclusive);
        assert_eq!(verdict(LARGE, None), Verdict::Conclusive);
    }
}
