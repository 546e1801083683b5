//! Which points a frame evaluates: all of them, or those that are about to be seen for the first time
//! (P5, §4.1: the list U of what is unseen, and the worklist T).

use super::Filter;
use crate::VisibleTriangles;

/// With so small a share of U left, the rest is evaluated at once: the lists would cost more than they
/// save (P5: "skip it when U is small").
const SMALL: f64 = 0.01;

/// What has been evaluated, kept across frames.
#[derive(Default)]
pub(super) struct Worklist {
    evaluated: Vec<bool>,
    /// U: triangles, or vertices, that were not seen yet; `None` before the first frame that filters.
    unseen: Option<Unseen>,
    /// Points that were evaluated since the start, repetitions counted.
    pub(super) evaluations: u64,
}

/// The list U: whether each triangle or vertex is on it, and how many are.
struct Unseen {
    listed: Vec<bool>,
    count: usize,
}

impl Worklist {
    /// Forgets what was evaluated: surfaces or points have moved.
    pub(super) fn forget(&mut self) {
        self.evaluated.clear();
        self.unseen = None;
    }

    /// Whether it is about so many points.
    pub(super) fn is_of(&self, count: usize) -> bool {
        self.evaluated.len() == count
    }

    /// The points that were evaluated before this frame, in order.
    pub(super) fn done(&self) -> Vec<u32> {
        let points = (0..).zip(&self.evaluated);
        points.filter_map(|(i, done)| done.then_some(i)).collect()
    }

    /// The points out of `count` that this frame has to evaluate, in order: of all that were not yet,
    /// those that the filter lets through.
    pub(super) fn take(
        &mut self,
        count: usize,
        filter: Filter,
        seen: Option<VisibleTriangles<'_>>,
    ) -> Vec<u32> {
        self.evaluated.resize(count, false);
        let filtered = match (filter, seen) {
            (Filter::None, _) | (_, None) => None,
            (Filter::Triangles, Some(seen)) => {
                let new = self.first_seen(seen.triangles.len(), seen.visible);
                let corners = |triangles: Vec<u32>| {
                    let triangles = triangles.into_iter();
                    triangles.flat_map(|t| seen.triangles[t as usize]).collect()
                };
                new.map(corners)
            }
            (Filter::Vertices, Some(seen)) => self.first_seen(count, seen.visible_points),
        };
        let mut wanted = filtered.unwrap_or_else(|| (0..count as u32).collect());
        wanted.sort_unstable();
        wanted.retain(|&i| !std::mem::replace(&mut self.evaluated[i as usize], true));
        self.evaluations += wanted.len() as u64;
        wanted
    }

    /// Strikes off U what is visible, and returns what was still on it; `None` once U is too short to
    /// be worth keeping.
    fn first_seen(&mut self, all: usize, visible: &[u32]) -> Option<Vec<u32>> {
        let unseen = self.unseen.get_or_insert_with(|| Unseen {
            listed: vec![true; all],
            count: all,
        });
        let strike = |&&i: &&u32| std::mem::take(&mut unseen.listed[i as usize]);
        let new: Vec<u32> = visible.iter().filter(strike).copied().collect();
        unseen.count -= new.len();
        let short = (unseen.count as f64) < SMALL * all as f64;
        (!short).then_some(new)
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
                visible_points: &[],
            };
            worklist.take(6, Filter::Triangles, Some(seen))
        };
        assert_eq!(frame(&[0]), [0, 1, 2]);
        assert_eq!(frame(&[0, 1]), [3]);
        assert!(frame(&[0, 1]).is_empty());
        assert_eq!(frame(&[2]), [4, 5]);
        assert_eq!(worklist.evaluations, 6);
        worklist.forget();
        assert_eq!(
            worklist.take(6, Filter::Triangles, None),
            [0, 1, 2, 3, 4, 5]
        );
        assert!(worklist.take(6, Filter::Triangles, None).is_empty());
    }

    /// By vertices a corner that is hidden itself waits, whatever triangle of it is visible; without a
    /// filter nothing does.
    #[test]
    fn hidden_corners_wait_where_vertices_are_filtered() {
        let seen = VisibleTriangles {
            triangles: &[[0, 1, 2], [1, 2, 3], [3, 4, 5]],
            visible: &[0, 1],
            visible_points: &[3, 1],
        };
        let of = |filter| Worklist::default().take(6, filter, Some(seen));
        assert_eq!(of(Filter::Vertices), [1, 3]);
        assert_eq!(of(Filter::Triangles), [0, 1, 2, 3]);
        assert_eq!(of(Filter::None), [0, 1, 2, 3, 4, 5]);
        let mut worklist = Worklist::default();
        worklist.take(6, Filter::Vertices, Some(seen));
        let more = VisibleTriangles {
            visible_points: &[3, 0, 1],
            ..seen
        };
        assert_eq!(worklist.take(6, Filter::Vertices, Some(more)), [0]);
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
                visible_points: &[],
            })
        };
        let mut worklist = Worklist::default();
        for before in [seen(&[0]), seen(&[0, 1, 2]), None] {
            worklist.take(6, Filter::Triangles, before);
            worklist.forget();
            assert!(worklist.done().is_empty());
            assert_eq!(worklist.take(6, Filter::Triangles, seen(&[0])), [0, 1, 2]);
            assert_eq!(worklist.done(), [0, 1, 2]);
            assert_eq!(
                worklist.take(6, Filter::Triangles, seen(&[0, 2])),
                [3, 4, 5]
            );
            worklist.forget();
        }
        // Other points, and fewer of them.
        assert_eq!(worklist.take(3, Filter::Triangles, seen(&[0])), [0, 1, 2]);
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
                visible_points: &[],
            })
        };
        let mut worklist = Worklist::default();
        assert_eq!(
            worklist.take(202, Filter::Triangles, seen(198)).len(),
            200,
            "two are unseen: a hundredth"
        );
        assert_eq!(worklist.take(202, Filter::Triangles, seen(199)), [200, 201]);
        assert_eq!(worklist.evaluations, 202);
    }
}
