use super::drift;

/// Mann and Kendall's score of eight rising times is 28, one pair swapped costs 2; three standard deviations
/// are 3·√(8·7·21/18) = 24.2.
#[test]
fn a_trend_is_more_than_three_deviations_of_chance() {
    let rising: Vec<f64> = (1..=8).map(f64::from).collect();
    // Theil and Sen's slope of 1 over 7 steps, over a median of 4.5.
    let found = drift(&rising).expect("a trend");
    assert!((found - 7.0 / 4.5).abs() < 1e-12, "{found}");
    let falling: Vec<f64> = rising.iter().rev().copied().collect();
    let found = drift(&falling).expect("a trend");
    assert!((found + 7.0 / 4.5).abs() < 1e-12, "{found}");
    let swapped = |pairs: &[usize]| {
        let mut times = rising.clone();
        pairs.iter().for_each(|&i| times.swap(i, i + 1));
        drift(&times).is_some()
    };
    assert!(swapped(&[2]), "26");
    assert!(!swapped(&[2, 5]), "24");
    assert_eq!(drift(&rising[..7]), None, "too few");
    assert_eq!(drift(&[3.0; 20]), None);
}
