//! Classic environment mapping: what is seen from the reference point is taken to be infinitely
//! far away. Diffuse: a cube map of irradiance by normal, convolved with the cosine. Glossy: a
//! cube map of radiance filtered with a Phong lobe, looked up along the reflected direction.

mod cpu;
mod gpu;
mod leaves;
pub mod math;
mod params;

use crate::convolution::{self, Sizes};
use crate::leaves::Leaves;
use crate::{Claim, Figure, Info, Method, OwnModel, Quantity, Reference, Unsupported};
use interreflect_scene::{CubeSpec, Needs, SceneFacts};

pub use params::ClassicEnvmap;

impl Method for ClassicEnvmap {
    const INFO: Info = Info {
        id: "classic_envmap",
        title: "Classic environment map",
        summary: "an environment map around the reference point, taken to be infinitely far away",
        references: &[
            Reference {
                authors: "G. S. Miller, C. R. Hoffman",
                title: "Illumination and Reflection Maps: Simulated Objects in Simulated and Real Environments",
                venue: "SIGGRAPH course notes",
                year: 1984,
                doi: None,
            },
            Reference {
                authors: "N. Greene",
                title: "Environment Mapping and Other Applications of World Projections",
                venue: "IEEE Computer Graphics and Applications 6(11)",
                year: 1986,
                doi: Some("10.1109/MCG.1986.276658"),
            },
        ],
        figure: Some(Figure {
            scene: "colored-room",
            quantity: Quantity::GlossyRadiance,
            settings: &["scene.receiver.place=wall", "scene.reference.offset=0"],
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
        OwnModel::EnvironmentAtInfinity {
            bounces: self.bounces,
        }
    }

    fn claims(&self, quantity: Quantity) -> Vec<Claim> {
        convolution::claims::claims(&self.sizes(), quantity)
    }
}

impl ClassicEnvmap {
    /// The captured cube: `capture_resolution`, rounded up to a multiple of `resolution`.
    pub fn captured(&self) -> CubeSpec {
        let size = self.capture_resolution.next_multiple_of(self.resolution);
        CubeSpec {
            bounces: self.bounces,
            ..CubeSpec::of_radiance(size)
        }
    }

    fn sizes(&self) -> Sizes {
        Sizes {
            captured: self.captured(),
            resolution: self.resolution,
            cells: self.map_resolution,
        }
    }
}
