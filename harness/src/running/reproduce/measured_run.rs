//! An estimate, and times as amounts.

use super::verdict::Amount;
use crate::domain::record::{Run, Timing};
use interreflect_scene::Estimate;

/// An estimate with the record of its run.
pub(super) struct MeasuredRun {
    pub(super) estimate: Estimate,
    pub(super) run: Run,
}

impl MeasuredRun {
    /// Milliseconds of a frame: captures, preparation and shading.
    pub(super) fn frame_ms(&self) -> Amount {
        let captured = self.capture_ms().plus(self.prepare_ms());
        captured.plus(self.shade_ms())
    }

    /// Milliseconds of captures.
    pub(super) fn capture_ms(&self) -> Amount {
        self.run
            .phases_ms
            .capture
            .map_or(Amount::exact(0.0), amount)
    }

    /// Milliseconds of preparation.
    pub(super) fn prepare_ms(&self) -> Amount {
        self.run
            .phases_ms
            .prepare
            .map_or(Amount::exact(0.0), amount)
    }

    /// Milliseconds of shading.
    pub(super) fn shade_ms(&self) -> Amount {
        self.run.phases_ms.shade.map_or(Amount::exact(0.0), amount)
    }
}

/// Standard deviations of normal times in their median absolute deviation.
const DEVIATION: f64 = 1.4826;

/// How far a time that was taken once may be off.
const OF_A_SINGLE_TIME: f64 = 0.3;

/// A time with two standard deviations of single times, not of their median: other load comes and goes
/// more slowly than one measurement takes. A single time may be off by 30 %.
pub(super) fn amount(timing: Timing) -> Amount {
    let spread = match timing.n {
        0 | 1 => OF_A_SINGLE_TIME * timing.median,
        _ => 2.0 * DEVIATION * timing.mad,
    };
    Amount {
        value: timing.median,
        spread,
    }
}

/// As [`amount`], of times in milliseconds.
pub(super) fn amount_of(times_ms: &[f64]) -> Amount {
    Timing::of(times_ms).map_or(Amount::exact(f64::NAN), amount)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::record::{Backend, Phases};

    /// The median absolute deviation of normal times is 0.6745 of their standard deviation.
    #[test]
    fn times_may_be_off_by_two_deviations_and_single_ones_by_three_tenths() {
        let many = amount_of(&[9.0, 10.0, 12.0]);
        assert_eq!(many.value, 10.0);
        assert!((many.spread - 2.0 / 0.6745).abs() < 1e-3, "{}", many.spread);
        let single = amount_of(&[10.0]);
        assert!((single.spread - 3.0).abs() < 1e-12);
        assert!(amount_of(&[]).value.is_nan());
    }

    #[test]
    fn a_frame_is_captured_prepared_and_shaded() {
        let timing = |ms| Timing::of(&[ms]);
        let phases_ms = Phases {
            solve: timing(1000.0),
            capture: timing(100.0),
            compile: timing(2000.0),
            prepare: timing(20.0),
            shade: timing(3.0),
            readback: timing(4000.0),
        };
        let measured = MeasuredRun {
            estimate: Estimate::new(0),
            run: Run {
                phases_ms,
                ..Run::new("", "", Backend::Cpu, "")
            },
        };
        let [frame, prepare, shade] = [
            measured.frame_ms(),
            measured.prepare_ms(),
            measured.shade_ms(),
        ];
        assert_eq!(
            (frame.value, prepare.value, shade.value),
            (123.0, 20.0, 3.0)
        );
        let spread = 0.3 * (100.0_f64.powi(2) + 20.0_f64.powi(2) + 3.0_f64.powi(2)).sqrt();
        assert!((frame.spread - spread).abs() < 1e-9);
    }
}
