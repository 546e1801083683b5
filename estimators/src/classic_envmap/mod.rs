//! Classic environment mapping: what is seen from the reference point is taken to be infinitely
//! far away. Diffuse: a cube map of irradiance by normal, convolved with the cosine. Glossy: a
//! cube map of radiance filtered with a Phong lobe, looked up along the reflected direction.

mod cpu;
mod gpu;
pub mod math;
mod params;

use crate::convolution::Sizes;
use crate::{
    Backend, Changed, EstimatorError, Info, Inputs, Method, OwnModel, Quantity, Unsupported,
};
use interreflect_scene::{CubeSpec, Needs, SceneFacts};

pub use params::ClassicEnvmapParams;

/// The method.
pub struct ClassicEnvmap;

impl Method for ClassicEnvmap {
    type Params = ClassicEnvmapParams;

    const INFO: Info = Info {
        id: "classic_envmap",
        title: "Classic environment map",
        source: "G. Miller, R. Hoffman: Illumination and Reflection Maps; N. Greene: Environment \
                 Mapping and Other Applications of World Projections",
    };

    const QUANTITIES: &'static [Quantity] = &[Quantity::Irradiance, Quantity::GlossyRadiance];

    fn needs(
        params: &Self::Params,
        _quantity: Quantity,
        _scene: &SceneFacts,
    ) -> Result<Needs, Unsupported> {
        Ok(Needs {
            cubes: [params.captured()].into(),
            light_transport: false,
        })
    }

    fn model(_params: &Self::Params, _quantity: Quantity) -> OwnModel {
        OwnModel::EnvironmentAtInfinity
    }
}

impl ClassicEnvmapParams {
    /// The captured cube: `capture_resolution`, rounded up to a multiple of `resolution`.
    pub fn captured(&self) -> CubeSpec {
        CubeSpec::of_radiance(self.capture_resolution.next_multiple_of(self.resolution))
    }

    fn sizes(&self) -> Sizes {
        Sizes {
            captured: self.captured(),
            resolution: self.resolution,
            cells: self.map_resolution,
        }
    }
}

/// Lobes that one filtered map is kept for.
pub const MAX_LOBES: usize = 8;

/// The Phong exponents that the points' glossy materials call for, each once, ascending; none for
/// other quantities. `kept` are those of the session's last `prepare`: they hold until the points
/// change.
fn lobe_exponents<B: Backend>(
    quantity: Quantity,
    inputs: &Inputs<'_, B>,
    kept: Vec<f32>,
) -> Result<Vec<f32>, EstimatorError> {
    if quantity != Quantity::GlossyRadiance {
        return Ok(Vec::new());
    }
    if !(kept.is_empty() || inputs.changed.any(Changed::POINTS)) {
        return Ok(kept);
    }
    let mut exponents: Vec<f32> = Vec::new();
    for point in inputs.host_points.iter().flatten() {
        let exponent = math::phong_exponent(point.material.shininess);
        if let Err(place) = exponents.binary_search_by(|e| e.total_cmp(&exponent)) {
            exponents.insert(place, exponent);
        }
        if exponents.len() > MAX_LOBES {
            return Err(Unsupported(format!(
                "classic_envmap filters one map per shininess, at most {MAX_LOBES}; the points \
                 have more: use fewer materials"
            ))
            .into());
        }
    }
    if exponents.is_empty() {
        exponents.push(0.0);
    }
    Ok(exponents)
}
