//! Which level a frame is evaluated at (P5, §4.2).

use super::DirectionalAo;

/// Cost of a level over that of the one below: four times the directions.
const COST_RATIO: f64 = 4.0;

/// The level of a frame, after one of level `last` that took `last_ms` milliseconds (neither at the
/// start). While surfaces move it is at most `moving_level`; at rest it rises by one a frame. Held to a
/// frame rate it falls by one where the last frame took too long, and rises only where the next level
/// can be expected to fit.
pub(super) fn next(
    method: &DirectionalAo,
    last: Option<u32>,
    last_ms: Option<f64>,
    moved: bool,
) -> u32 {
    let Some(last) = last else {
        return method.level;
    };
    let highest = match moved {
        true => method.level.min(method.moving_level),
        false => method.level,
    };
    let budget_ms = match method.target_fps {
        fps if fps > 0.0 => 1e3 / f64::from(fps),
        _ => f64::INFINITY,
    };
    let wanted = match last_ms {
        Some(ms) if ms > budget_ms => last.saturating_sub(1),
        Some(ms) if ms * COST_RATIO > budget_ms => last,
        // Moving scenes start over each frame, so that there is nothing to refine.
        _ if moved && budget_ms.is_infinite() => highest,
        _ => last + 1,
    };
    wanted.min(highest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_fall_in_motion_and_rise_at_rest() {
        let params = DirectionalAo {
            level: 3,
            moving_level: 1,
            ..DirectionalAo::default()
        };
        assert_eq!(next(&params, None, None, true), 3);
        assert_eq!(next(&params, Some(3), Some(5.0), true), 1);
        assert_eq!(next(&params, Some(1), Some(5.0), true), 1);
        assert_eq!(next(&params, Some(1), Some(5.0), false), 2);
        assert_eq!(next(&params, Some(2), None, false), 3);
        assert_eq!(next(&params, Some(3), None, false), 3);
    }

    #[test]
    fn a_frame_rate_is_held() {
        let params = DirectionalAo {
            level: 4,
            target_fps: 50.0,
            ..DirectionalAo::default()
        };
        assert_eq!(next(&params, Some(3), Some(21.0), true), 2);
        assert_eq!(
            next(&params, Some(2), Some(6.0), true),
            2,
            "24 ms would not fit"
        );
        assert_eq!(next(&params, Some(2), Some(4.9), true), 3);
        assert_eq!(next(&params, Some(0), Some(1e3), false), 0);
        // A model of a machine on which a level takes 0.3·4ˢ ms: the level settles and stays.
        let mut level = 4;
        let mut seen = Vec::new();
        for _ in 0..12 {
            let ms = 0.3 * COST_RATIO.powi(level as i32);
            level = next(&params, Some(level), Some(ms), true);
            seen.push(level);
        }
        assert_eq!(seen[4..], [3; 8], "{seen:?}");
    }
}
