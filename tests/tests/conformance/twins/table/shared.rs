use super::*;
use interreflect_cpu::lane::Lane;

pub(super) const TWINS: &[Twin] = &[twin!(
    "",
    "lobe_power",
    "outputs[id.x] = vec4f(lobe_power(a[0], a[1]), 0.0, 0.0, 0.0);",
    over_lanes!(|a| vec![a[0].lobe_power(a[1])]),
    || grid(&[&cosines(), &[0.0, 0.5, 1.0, 5.0, 50.0, 1e3]]),
    LOBE
)];

fn cosines() -> Vec<f32> {
    let near_one = (0..200).map(|i| 1.0 - (i as f32 / 200.0).powi(4));
    near_one.chain([-1.0, 0.0, 1e-7]).collect()
}
