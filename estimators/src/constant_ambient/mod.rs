//! Constant ambient light: the mean radiance seen from the reference point arrives from
//! everywhere. The simplest estimator there is, and the template for a new one.

mod claims;
mod cpu;
mod gpu;
pub mod math;
mod params;

use crate::{Claim, Info, Method, OwnModel, Quantity, Unsupported};
use interreflect_scene::{CubeSpec, Needs, SceneFacts};

pub use params::ConstantAmbientParams;

/// The method.
pub struct ConstantAmbient;

impl Method for ConstantAmbient {
    type Params = ConstantAmbientParams;

    const INFO: Info = Info {
        id: "constant_ambient",
        title: "Constant ambient light",
        source: "The ambient term of local illumination models, with its value measured",
    };

    const QUANTITIES: &'static [Quantity] = &[Quantity::Irradiance, Quantity::GlossyRadiance];

    fn needs(
        params: &Self::Params,
        _quantity: Quantity,
        _scene: &SceneFacts,
    ) -> Result<Needs, Unsupported> {
        Ok(Needs {
            cubes: [params.captured()].into(),
            ..Needs::default()
        })
    }

    fn model(params: &Self::Params, _quantity: Quantity) -> OwnModel {
        OwnModel::MeanRadiance {
            bounces: params.bounces,
        }
    }

    fn claims(_params: &Self::Params, quantity: Quantity) -> Vec<Claim> {
        claims::claims(quantity)
    }
}

impl ConstantAmbientParams {
    /// The captured cube.
    fn captured(&self) -> CubeSpec {
        CubeSpec {
            bounces: self.bounces,
            ..CubeSpec::of_radiance(self.capture_resolution)
        }
    }
}
