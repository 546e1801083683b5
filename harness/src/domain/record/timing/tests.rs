use super::*;

fn timing(median: f64, low: f64, high: f64) -> Timing {
    Timing {
        low,
        high,
        mad: 3.0,
        n: 7,
        settled: Some(true),
        ..Timing::of(&[median]).expect("a time")
    }
}

/// Medians add up; distances to the ends of the intervals, and deviations, as 3 and 4 make 5.
#[test]
fn independent_times_add_up() {
    let (first, mut second) = (timing(100.0, 97.0, 106.0), timing(50.0, 46.0, 58.0));
    second.mad = 4.0;
    second.n = 5;
    let both = first.and(second);
    assert_eq!((both.median, both.low, both.high), (150.0, 145.0, 160.0));
    assert_eq!((both.mad, both.n, both.settled), (5.0, 5, Some(true)));
}

/// What speaks against one of them speaks against the sum.
#[test]
fn doubts_are_kept() {
    let good = timing(1.0, 1.0, 1.0);
    let bad = Timing {
        settled: Some(false),
        fallback: Some(Fallback::Still),
        drift: Some(0.2),
        ..good
    };
    for both in [good.and(bad), bad.and(good)] {
        assert_eq!(both.settled, Some(false));
        assert_eq!(both.fallback, Some(Fallback::Still));
        assert_eq!(both.drift, Some(0.2));
    }
    let once = Timing {
        settled: None,
        ..good
    };
    assert_eq!(good.and(once).settled, None);
}

#[test]
fn the_middle_of_an_even_count_is_a_mean() {
    assert_eq!(median([4.0, 1.0, 3.0]), Some(3.0));
    assert_eq!(median([4.0, 1.0, 3.0, 2.0]), Some(2.5));
    assert_eq!(median([]), None);
}
