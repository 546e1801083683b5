//! How far two computations of one value may part, and why.

/// A bound on |a − b| with its cause: `absolute` + `relative`·max(|a|, |b|).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Absolute part, in the unit of what is compared.
    pub absolute: f64,
    /// Relative part.
    pub relative: f64,
    /// Where the difference comes from.
    pub cause: &'static str,
}

impl Tolerance {
    /// Largest difference that is allowed between these two values.
    pub fn bound(&self, a: f64, b: f64) -> f64 {
        self.absolute + self.relative * a.abs().max(b.abs())
    }

    /// The difference between two values over the largest one that is allowed: at most 1 where it
    /// holds. Not a number where a value is none; without a bound, 0 or infinite.
    pub fn of_bound(&self, a: f64, b: f64) -> f64 {
        match (a - b).abs() {
            0.0 => 0.0,
            difference => difference / self.bound(a, b),
        }
    }

    /// Checks two values.
    ///
    /// # Errors
    /// A line with both values, their difference, the bound and its cause.
    pub fn check(&self, a: f64, b: f64) -> Result<(), String> {
        let (difference, bound) = ((a - b).abs(), self.bound(a, b));
        match difference <= bound {
            true => Ok(()),
            false => Err(format!(
                "{a} and {b} differ by {difference:.3e}, more than {bound:.3e} ({})",
                self.cause
            )),
        }
    }

    /// Checks two lists value by value; the first failure names its place.
    ///
    /// # Errors
    /// As [`Tolerance::check`], or if the lengths differ.
    pub fn check_all(
        &self,
        a: impl ExactSizeIterator<Item = f64>,
        b: impl ExactSizeIterator<Item = f64>,
    ) -> Result<(), String> {
        if a.len() != b.len() {
            return Err(format!("{} values against {}", a.len(), b.len()));
        }
        for (i, (a, b)) in a.zip(b).enumerate() {
            self.check(a, b).map_err(|e| format!("value {i}: {e}"))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const T: Tolerance = Tolerance {
        absolute: 0.1,
        relative: 0.01,
        cause: "a test",
    };

    #[test]
    fn bounds_add_up_and_not_a_number_never_passes() {
        assert!(T.check(10.0, 10.19).is_ok());
        assert!(T.check(10.0, 10.21).is_err());
        assert!(T.check(f64::NAN, 1.0).is_err());
        assert!(T.check(f64::INFINITY, f64::INFINITY).is_err());
        assert!(
            T.check_all([1.0, 2.0].into_iter(), [1.0, 3.0].into_iter())
                .is_err()
        );
        assert!(
            T.check_all([1.0].into_iter(), [1.0, 3.0].into_iter())
                .is_err()
        );
    }
}
