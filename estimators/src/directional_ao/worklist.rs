//! Which points a frame evaluates: all of them, or those of triangles that are about to be seen for
//! the first time (P5: the lists U of unseen triangles and T, the worklist).

use crate::VisibleTriangles;

/// With so few unseen triangles left, the rest is evaluated at once: the lists would cost more than
/// they save (P5: "skip it when U is small").
const SMALL: f64 = 0.01;

/// What has been evaluated, kept across frames.
#[derive(Default)]
pub(super) struct Worklist {
    evaluated: Vec<bool>,
    /// U: triangles that were not seen yet; `None` before the first frame that filters.
    unseen: Option<Unseen>,
    /// Points that were evaluated since the start, repetitions counted.
    pub(super) evaluations: u64,
}

/// The list U: whether each triangle is on it, and how many are.
struct Unseen {
    triangles: Vec<bool>,
    count: usize,
}

impl Worklist {
    /// Forgets what was evaluated: surfaces or points have moved.
    pub(super) fn forget(&mut self) {
        self.evaluated.clear();
        self.unseen = None;
    }

    /// The points that were evaluated before this frame, in order.
    pub(super) fn done(&self) -> Vec<u32> {
        let points = (0..).zip(&self.evaluated);
        points.filter_map(|(i, done)| done.then_some(i)).collect()
    }

    /// The points out of `count` that this frame has to evaluate, in order: all that were not yet,
    /// or with `seen` those of them at corners of triangles that are seen for the first time.
    pub(super) fn take(&mut self, count: usize, seen: Option<VisibleTriangles<'_>>) -> Vec<u32> {
        self.evaluated.resize(count, false);
        let mut wanted = match seen {
            Some(seen) => self.about_to_be_seen(seen),
            None => (0..count as u32).collect(),
        };
        wanted.retain(|&i| !std::mem::replace(&mut self.evaluated[i as usize], true));
        self.evaluations += wanted.len() as u64;
        wanted
    }

    fn about_to_be_seen(&mut self, seen: VisibleTriangles<'_>) -> Vec<u32> {
        let all = seen.triangles.len();
        let unseen = self.unseen.get_or_insert_with(|| Unseen {
            triangles: vec![true; all],
            count: all,
        });
        let mut todo = Vec::new();
        for &triangle in seen.visible {
            if std::mem::take(&mut unseen.triangles[triangle as usize]) {
                unseen.count -= 1;
                todo.extend(seen.triangles[triangle as usize]);
            }
        }
        if (unseen.count as f64) < SMALL * all as f64 {
            unseen.triangles.fill(false);
            unseen.count = 0;
            todo = (0..self.evaluated.len() as u32).collect();
        }
        todo.sort_unstable();
        todo.dedup();
        todo
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_vertices_of_triangles_seen_for_the_first_time() {
        let triangles = [[0, 1, 2], [1, 2, 3], [3, 4, 5]];
        let mut worklist = Worklist::default();
        let mut frame = |visible: &[u32]| {
            let seen = VisibleTriangles {
                triangles: &triangles,
                visible,
            };
            worklist.take(6, Some(seen))
        };
        assert_eq!(frame(&[0]), [0, 1, 2]);
        assert_eq!(frame(&[0, 1]), [3]);
        assert!(frame(&[0, 1]).is_empty());
        assert_eq!(frame(&[2]), [4, 5]);
        assert_eq!(worklist.evaluations, 6);
        worklist.forget();
        assert_eq!(worklist.take(6, None), [0, 1, 2, 3, 4, 5]);
        assert!(worklist.take(6, None).is_empty());
    }

    /// After surfaces or points have moved everything that is seen is to do once more, as often as it
    /// happens; also where all was evaluated before, and where the lists were given up for being short.
    #[test]
    fn what_is_seen_after_a_move_is_to_do_again() {
        let triangles = [[0, 1, 2], [1, 2, 3], [3, 4, 5]];
        let seen = |visible: &'static [u32]| {
            Some(VisibleTriangles {
                triangles: &triangles,
                visible,
            })
        };
        let mut worklist = Worklist::default();
        for before in [seen(&[0]), seen(&[0, 1, 2]), None] {
            worklist.take(6, before);
            worklist.forget();
            assert!(worklist.done().is_empty());
            assert_eq!(worklist.take(6, seen(&[0])), [0, 1, 2]);
            assert_eq!(worklist.done(), [0, 1, 2]);
            assert_eq!(worklist.take(6, seen(&[0, 2])), [3, 4, 5]);
            worklist.forget();
        }
        // Other points, and fewer of them.
        assert_eq!(worklist.take(3, seen(&[0])), [0, 1, 2]);
    }

    /// Once less than a hundredth of the triangles is unseen, the rest of the points is done at once.
    #[test]
    fn few_unseen_triangles_are_done_at_once() {
        let triangles: Vec<[u32; 3]> = (0..200).map(|t| [t, t + 1, t + 2]).collect();
        let visible: Vec<u32> = (0..199).collect();
        let seen = |count: usize| {
            Some(VisibleTriangles {
                triangles: &triangles,
                visible: &visible[..count],
            })
        };
        let mut worklist = Worklist::default();
        assert_eq!(
            worklist.take(202, seen(198)).len(),
            200,
            "two are unseen: a hundredth"
        );
        assert_eq!(worklist.take(202, seen(199)), [200, 201]);
        assert_eq!(worklist.evaluations, 202);
    }
}
