use super::*;

/// A pixel whose normal is turned about y by this angle, seen along −z.
fn turned(angle: f32) -> Option<Point> {
    Some(Point {
        normal: Vec3::new(angle.sin(), 0.0, angle.cos()),
        view: Vec3::Z,
        ..Point::default()
    })
}

#[test]
fn footprints_are_the_larger_turn_to_a_neighbour() {
    // Three columns, two rows; the mirrored direction turns twice as far as the normal.
    let points = [
        turned(0.0),
        turned(1e-3),
        turned(1.5e-3),
        turned(4e-3),
        None,
        turned(0.3),
    ];
    // Right 1e-3, below 4e-3; right ½e-3 alone; left ½e-3, below 0.2985; above 4e-3 alone; no
    // surface; above 0.2985 alone.
    let expected = [8e-3, 1e-3, 0.597, 8e-3, 0.0, 0.597];
    for (i, expected) in expected.into_iter().enumerate() {
        let found = footprint(&points, 3, i);
        // Directions rounded to float32.
        assert!((found - expected).abs() < 1e-6, "pixel {i}: {found}");
    }
    assert_eq!(footprint(&[turned(0.2)], 1, 0), 0.0);
}
