//! What the path tracer is asked for: the quantity, the light paths that count, when to stop.

use std::time::Duration;

/// What is gathered at each point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PathQuantity {
    /// E = ∫ L cos θ dω in W/m², before albedo.
    Irradiance,
    /// L = ∫ L_i [k_d/π + k_s·norm(n)·(N·H)ⁿ] cos θ dω in W·m⁻²·sr⁻¹ towards the point's viewer,
    /// with the point's material; zero where the points have no material.
    GlossyRadiance,
    /// Cosine-weighted openness in [0, 1], 1 = open: the part of ∫ cos θ dω / π whose rays leave
    /// the scene.
    AmbientOcclusion,
}

/// When to stop: at the end of the round in which the first of the conditions holds. Without any
/// condition one round is run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stop {
    /// Samples a point, rounded up to whole samples in each of the [`super::REPLICATES`].
    pub samples: Option<u32>,
    /// Root mean square of the standard errors over that of the estimates, all points and
    /// channels together.
    pub relative_error: Option<f32>,
    /// Wall-clock time in seconds; a round is not begun if it can't be expected to fit.
    pub seconds: Option<f32>,
}

impl Stop {
    /// Samples per replicate that may be reached, at most `limit`.
    pub(super) fn largest(&self, replicates: u32, limit: u32) -> u32 {
        match self.samples {
            Some(samples) => samples.div_ceil(replicates).clamp(1, limit),
            None => limit,
        }
    }

    /// Samples per replicate of the next round, 0 to stop, after `done` of them in `elapsed`.
    ///
    /// A count alone is run in one round. Otherwise each round doubles what is there, so that
    /// sequences end at powers of two where they can, unless less time is left.
    pub(super) fn next_round(&self, done: u32, largest: u32, error: f32, elapsed: Duration) -> u32 {
        let first = 4.min(largest);
        let left = largest - done;
        match (done, self.relative_error, self.seconds) {
            (0, None, None) if self.samples.is_some() => largest,
            (0, ..) => first,
            (_, None, None) => 0,
            (_, Some(wanted), _) if error <= wanted => 0,
            (_, _, None) => done.min(left),
            (_, _, Some(seconds)) => {
                let elapsed = elapsed.as_secs_f32();
                let affordable = (seconds - elapsed) / elapsed * done as f32;
                done.min(left).min(affordable.max(0.0) as u32)
            }
        }
    }

    /// How far along a run is, in [0, 1], as far as it can be known.
    pub(super) fn progress(&self, done: f32, largest: u32, elapsed: Duration) -> f32 {
        let by_count = done / largest as f32;
        let by_time = self.seconds.map_or(0.0, |s| elapsed.as_secs_f32() / s);
        by_count.max(by_time).min(1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMIT: u32 = 1 << 16;

    fn rounds(stop: Stop, error: impl Fn(u32) -> f32, seconds_per_sample: f32) -> Vec<u32> {
        let largest = stop.largest(32, LIMIT);
        let (mut done, mut rounds) = (0, Vec::new());
        loop {
            let elapsed = Duration::from_secs_f32(seconds_per_sample * done as f32);
            let next = stop.next_round(done, largest, error(done), elapsed);
            if next == 0 {
                return rounds;
            }
            done += next;
            rounds.push(next);
        }
    }

    #[test]
    fn a_count_is_one_round_rounded_up() {
        let stop = |samples| Stop {
            samples: Some(samples),
            ..Stop::default()
        };
        assert_eq!(rounds(stop(1000), |_| 1.0, 1.0), [32]);
        assert_eq!(rounds(stop(0), |_| 1.0, 1.0), [1]);
        assert_eq!(rounds(stop(u32::MAX), |_| 1.0, 1.0), [LIMIT]);
        assert_eq!(rounds(Stop::default(), |_| 1.0, 1.0), [4]);
    }

    #[test]
    fn an_error_doubles_until_it_is_reached_or_the_sequence_ends() {
        let stop = Stop {
            relative_error: Some(0.1),
            ..Stop::default()
        };
        assert_eq!(rounds(stop, |done| 1.0 / done as f32, 1.0), [4, 4, 8]);
        assert_eq!(rounds(stop, |_| f32::NAN, 1.0).iter().sum::<u32>(), LIMIT);
        let both = Stop {
            samples: Some(640),
            ..stop
        };
        assert_eq!(rounds(both, |_| 1.0, 1.0), [4, 4, 8, 4]);
    }

    #[test]
    fn time_is_not_overrun() {
        let stop = Stop {
            seconds: Some(50.0),
            ..Stop::default()
        };
        assert_eq!(rounds(stop, |_| 1.0, 1.0), [4, 4, 8, 16, 18]);
        assert_eq!(rounds(stop, |_| 1.0, 100.0), [4]);
    }
}
