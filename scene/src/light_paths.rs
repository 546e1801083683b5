//! Which light paths count.

/// Which light paths count. The default is full light transport.
///
/// Light straight from point, spot, directional and area lights never counts at the points
/// themselves, only what surfaces reflect of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct LightPaths {
    /// Largest number of reflections between a source and the arrival at the point; 0 = unlimited.
    /// What emission and the environment send straight to the point has 0 reflections. Reflections
    /// at mirrors count.
    pub bounces: u32,
    /// Least number of reflections between a source and the arrival at the point, counted in the
    /// same way: paths with fewer do not count. Above a `bounces` that limits, nothing does.
    pub least_bounces: u32,
    /// `false`: nothing occludes the gather leg, the first one seen from the point. All surfaces
    /// along it contribute (reflection of either side, emission of the front), and the
    /// environment too. Openness is then 1.
    pub indirect_visibility: bool,
    /// `false`: receivers are absent, as occluders and as reflectors.
    pub self_shadowing: bool,
    /// `true`: the gather leg starts at the scene's reference point instead of the point, and
    /// passes through receivers (the reference point usually lies inside one). This is what an
    /// environment map at infinity assumes.
    pub environment_at_infinity: bool,
}

impl LightPaths {
    /// Full light transport.
    pub const ALL: Self = Self {
        bounces: 0,
        least_bounces: 0,
        indirect_visibility: true,
        self_shadowing: true,
        environment_at_infinity: false,
    };
}

impl Default for LightPaths {
    fn default() -> Self {
        Self::ALL
    }
}
