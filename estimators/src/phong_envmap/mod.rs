//! Phong-filtered environment maps: the slow method that Kautz, Daubert & Seidel, *Advanced
//! Environment Mapping in VR Applications*, compare theirs with. Irradiance by the exact cosine
//! convolution; glossy radiance from a cube map filtered with one Phong lobe, looked up along the
//! mirrored direction; Schlick's Fresnel factor between them.

mod cpu;
mod gpu;
mod params;

use crate::convolution::{self, Sizes};
use crate::{Claim, Figure, Info, Method, OwnModel, Quantity, Reference, Unsupported};
use interreflect_scene::{CubeSpec, Needs, SceneFacts};

pub use params::PhongEnvmap;

impl Method for PhongEnvmap {
    const INFO: Info = Info {
        id: "phong_envmap",
        title: "Phong-filtered environment map",
        summary: "an environment map prefiltered with one Phong lobe: the slow method with which Kautz et al. compare theirs",
        references: &[Reference {
            authors: "J. Kautz, K. Daubert, H.-P. Seidel",
            title: "Advanced Environment Mapping in VR Applications",
            venue: "Computers & Graphics 28(1)",
            year: 2004,
            doi: None,
        }],
        figure: Some(Figure {
            scene: "studio",
            quantity: Quantity::GlossyRadiance,
            settings: &[],
        }),
    };

    const QUANTITIES: &'static [Quantity] = &[Quantity::Irradiance, Quantity::GlossyRadiance];

    fn needs(&self, _quantity: Quantity, _scene: &SceneFacts) -> Result<Needs, Unsupported> {
        Ok(Needs {
            cubes: [self.sizes().captured].into(),
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

impl PhongEnvmap {
    /// The captured cube is one of `capture_resolution`, rounded up to a multiple of `resolution`.
    fn sizes(&self) -> Sizes {
        let size = self.capture_resolution.next_multiple_of(self.resolution);
        Sizes {
            captured: CubeSpec {
                bounces: self.bounces,
                ..CubeSpec::of_radiance(size)
            },
            resolution: self.resolution,
            cells: self.map_resolution,
        }
    }

    /// The exponents of the lobes to filter with: one if any point needs it.
    fn exponents(&self, needed: bool) -> Vec<f32> {
        needed.then_some(self.exponent).into_iter().collect()
    }
}
