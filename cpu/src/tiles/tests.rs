use super::*;
use glam::Vec3;
use interreflect_scene::Point;

struct Sum;
impl TileKernel for Sum {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        let p = points.vector(PointLayout::POSITION);
        let n = points.vector(PointLayout::NORMAL);
        [p.x + n.x, p.dot(n), p.z / n.y]
    }
}

#[test]
fn every_lane_is_shaded_once_and_masked_ones_are_zero() {
    for (name, set) in InstructionSet::all() {
        if !set.available() {
            println!("not run: this processor has no {name}");
            continue;
        }
        for threads in [1, 2] {
            let cx = CpuCx::new(Some(threads), Some(set)).expect("a pool of threads");
            for (_, arithmetic) in Arithmetic::all() {
                for len in [1, 63, 64, 65, 1500] {
                    shades_each_once(&cx.with_arithmetic(arithmetic), len);
                }
            }
        }
    }
}

fn shades_each_once(cx: &CpuCx, len: usize) {
    let point = |i: usize| {
        (i % 7 != 2).then(|| Point {
            position: Vec3::new(i as f32, 1.0, 2.0),
            normal: Vec3::new(1.0, 2.0, 3.0),
            ..Point::default()
        })
    };
    let points = Points::new(PointLayout::Surface, (0..len).map(point));
    let mut out = Estimate::new(len);
    cx.for_each_tile(&points, &mut out, &Sum);
    for i in 0..len {
        let expected = point(i).map_or(Vec3::ZERO, |p| {
            Vec3::new(i as f32 + 1.0, p.position.dot(p.normal), 1.0)
        });
        assert_eq!(out.get(i), expected, "point {i} of {len}");
    }
}

struct Left;
impl TileKernel for Left {
    /// What rounding leaves of 1/41·41 − 1: nothing in float64.
    #[inline(always)]
    fn shade<L: Lane>(&self, _points: &PointLanes<'_, L>) -> [L; 3] {
        let (one, k) = (L::from(1.0), L::from(41.0));
        [one / k, one / k * k - one, one]
    }
}

#[test]
fn float64_is_rounded_only_when_it_is_stored() {
    let cx = CpuCx::new(Some(1), None).expect("a pool of threads");
    let points = Points::new(PointLayout::Surface, [Some(Point::default())]);
    let of = |arithmetic| {
        let mut out = Estimate::new(1);
        cx.with_arithmetic(arithmetic)
            .for_each_tile(&points, &mut out, &Left);
        out.get(0)
    };
    let part = 1.0 / 41.0;
    assert_eq!(of(Arithmetic::Float64), Vec3::new(part, 0.0, 1.0));
    let rounded = Vec3::new(part, part * 41.0 - 1.0, 1.0);
    assert!(rounded.y != 0.0);
    assert_eq!(of(Arithmetic::Scalar), rounded);
    assert_eq!(of(Arithmetic::Lanes), rounded);
}
