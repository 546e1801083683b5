//! Constant ambient light: the mean radiance seen from the reference point arrives from
//! everywhere. The simplest estimator there is, and the template for a new one.

mod claims;
mod cpu;
mod gpu;
mod leaves;
pub mod math;
mod params;

use crate::leaves::Leaves;
use crate::{Claim, Figure, Info, Method, OwnModel, Quantity, Unsupported};
use interreflect_scene::{CubeSpec, Needs, SceneFacts};

pub use params::ConstantAmbient;

impl Method for ConstantAmbient {
    const INFO: Info = Info {
        id: "constant_ambient",
        title: "Constant ambient light",
        summary: "the mean radiance seen from the reference point arrives from everywhere; the template for a new method",
        references: &[],
        figure: Some(Figure {
            scene: "cornell-box",
            quantity: Quantity::Irradiance,
            settings: &[],
        }),
    };

    const QUANTITIES: &'static [Quantity] = &[Quantity::Irradiance, Quantity::GlossyRadiance];

    const LEAVES: Leaves = leaves::LEAVES;

    fn needs(&self, _quantity: Quantity, _scene: &SceneFacts) -> Result<Needs, Unsupported> {
        Ok(Needs {
            cubes: [self.captured()].into(),
            ..Needs::default()
        })
    }

    fn model(&self, _quantity: Quantity) -> OwnModel {
        OwnModel::MeanRadiance {
            bounces: self.bounces,
        }
    }

    fn claims(&self, quantity: Quantity) -> Vec<Claim> {
        claims::claims(quantity)
    }
}

impl ConstantAmbient {
    /// The captured cube.
    fn captured(&self) -> CubeSpec {
        CubeSpec {
            bounces: self.bounces,
            ..CubeSpec::of_radiance(self.capture_resolution)
        }
    }
}
