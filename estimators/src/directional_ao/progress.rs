//! What is known of which points, and what a frame adds to it.

use super::sphere::{self, DIRECTIONS, MAX_LEVEL};
use super::worklist::Worklist;
use super::{DirectionalAo, level};
use crate::{Backend, Changed, Inputs};
use glam::{Quat, Vec3};
use std::ops::Range;

/// Bits of a word, one for each direction.
pub(super) const WORD: usize = u32::BITS as usize;

/// Directions that are looked along for some points.
pub(super) struct Step {
    /// The points, in order.
    pub(super) points: Vec<u32>,
    /// The directions.
    pub(super) directions: Range<usize>,
}

/// A frame that has begun.
pub(super) struct Begun {
    /// s: how often the octahedron of directions is subdivided.
    pub(super) level: u32,
    /// What is looked at, in order.
    pub(super) steps: Vec<Step>,
    /// All that was known is worth nothing.
    pub(super) forget: bool,
    /// How surfaces and points, one rigid body, are turned since what is known was found.
    turn: Quat,
}

impl Begun {
    /// Unit directions of a level in world space: the octahedron's, turned with the surfaces.
    pub(super) fn directions(&self, level: u32) -> Vec<Vec3> {
        let directions = sphere::directions(level).into_iter();
        directions.map(|towards| self.turn * towards).collect()
    }
}

/// What is known, kept across frames.
#[derive(Default)]
pub(super) struct Progress {
    worklist: Worklist,
    /// Level of the last frame.
    level: Option<u32>,
    /// Directions that were looked along for all evaluated points.
    known: usize,
    /// Rotation of surfaces and points when nothing was known, where they are one rigid body.
    rotation: Option<Quat>,
    /// Their rotation since then.
    turn: Quat,
}

impl Progress {
    /// Points that were evaluated since the start, repetitions counted.
    pub(super) fn evaluations(&self) -> u64 {
        self.worklist.evaluations
    }

    /// Begins a frame: its level, what it has to look at, and whether all that was known is worth
    /// nothing.
    pub(super) fn begin<B: Backend>(
        &mut self,
        method: &DirectionalAo,
        inputs: &Inputs<'_, B>,
    ) -> Begun {
        let count = inputs.host_points.len();
        let turned = self.turned(inputs.rigid_rotation.filter(|_| self.worklist.is_of(count)));
        let moved = inputs.changed.any(Changed::GEOMETRY | Changed::POINTS);
        let forget = inputs.changed.any(Changed::PARAMS) || (moved && turned.is_none());
        if forget {
            self.worklist.forget();
            self.known = 0;
            self.rotation = inputs.rigid_rotation;
            self.turn = Quat::IDENTITY;
        } else {
            self.turn = turned.unwrap_or(self.turn);
        }
        let moved = forget && inputs.changed.any(Changed::GEOMETRY);
        let level = level::next(method, self.level, inputs.last_frame_ms, moved);
        self.level = Some(level);
        let known = self.known;
        self.known = known.max(DIRECTIONS[level as usize] as usize);
        let refined = Step {
            points: self.worklist.done(),
            directions: known..self.known,
        };
        let new = Step {
            points: self.worklist.take(count, method.filter, inputs.visible),
            directions: 0..self.known,
        };
        let steps = [refined, new].into_iter();
        let steps = steps.filter(|s| !s.points.is_empty() && !s.directions.is_empty());
        Begun {
            level,
            steps: steps.collect(),
            forget,
            turn: self.turn,
        }
    }

    /// How surfaces and points are turned since nothing was known, where they are a rigid body then and
    /// now.
    fn turned(&self, now: Option<Quat>) -> Option<Quat> {
        let (then, now) = (self.rotation?, now?);
        // Exactly none, where rounding would leave some.
        Some(if then == now {
            Quat::IDENTITY
        } else {
            now * then.conjugate()
        })
    }
}

/// Words that hold the bits of all directions of a level.
pub(super) fn words(level: u32) -> usize {
    (DIRECTIONS[level.min(MAX_LEVEL) as usize] as usize).div_ceil(WORD)
}

/// A range of directions, cut where a new word begins.
pub(super) fn by_words(directions: Range<usize>) -> impl Iterator<Item = Range<usize>> {
    let words = directions.start / WORD..directions.end.div_ceil(WORD);
    words.map(move |w| directions.start.max(w * WORD)..directions.end.min((w + 1) * WORD))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_cut_at_words() {
        let cut = |range| by_words(range).collect::<Vec<_>>();
        assert_eq!(cut(0..33), [0..32, 32..33]);
        assert_eq!(cut(6..66), [6..32, 32..64, 64..66]);
        assert!(cut(64..64).is_empty());
        assert_eq!(
            (0..=MAX_LEVEL).map(words).collect::<Vec<_>>(),
            [1, 1, 3, 9, 33]
        );
    }
}
