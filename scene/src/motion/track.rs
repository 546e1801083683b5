//! Values at times, and between them.

/// Values at strictly increasing times in seconds: held before the first and after the last time,
/// in between as the value's own interpolation says. Empty for what does not move.
#[derive(Clone, Debug, PartialEq)]
pub struct Track<V> {
    /// Time in seconds and value there.
    pub keys: Vec<(f32, V)>,
}

impl<V> Default for Track<V> {
    fn default() -> Self {
        Self { keys: Vec::new() }
    }
}

impl<V: Copy + PartialEq> Track<V> {
    /// The value at a time; `between(a, b, t)` with t in [0, 1] is the value between two. `None`
    /// without any.
    pub fn at(&self, time_s: f32, between: impl Fn(V, V, f32) -> V) -> Option<V> {
        let next = self.keys.partition_point(|(time, _)| *time <= time_s);
        let before = next.checked_sub(1).and_then(|i| self.keys.get(i));
        match (before, self.keys.get(next)) {
            (Some((_, a)), None) => Some(*a),
            (None, b) => b.map(|(_, b)| *b),
            (Some((_, a)), Some((_, b))) if a == b => Some(*a),
            (Some((start, a)), Some((end, b))) => {
                let [time, start, end] = [time_s, *start, *end].map(f64::from);
                match (time - start) / (end - start) {
                    0.0 => Some(*a),
                    t => Some(between(*a, *b, t as f32)),
                }
            }
        }
    }

    /// Whether the value differs between any two times.
    pub fn varies(&self) -> bool {
        self.keys.windows(2).any(|pair| pair[0].1 != pair[1].1)
    }

    /// Whether times are finite and strictly increasing.
    pub fn is_ordered(&self) -> bool {
        self.keys.iter().all(|(time, _)| time.is_finite())
            && self.keys.windows(2).all(|pair| pair[0].0 < pair[1].0)
    }
}
