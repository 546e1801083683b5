//! Spherical harmonics and a mip pyramid: Kautz, Daubert & Seidel, *Advanced Environment Mapping in
//! VR Applications*. What is seen from the reference point is taken to be infinitely far away.
//! Diffuse: nine spherical harmonics of a small cube, convolved with the cosine. Glossy: a
//! box-filtered mip pyramid, looked up along the mirrored direction at a blurred level.

mod claims;
mod cpu;
mod gpu;
mod leaves;
pub mod math;
mod params;
mod tables;

use crate::leaves::Leaves;
use crate::{
    Backend, Claim, EstimatorError, Figure, Info, Inputs, Method, OwnModel, Quantity, Reference,
    Unsupported,
};
use glam::Vec3;
use interreflect_scene::{CubeSpec, Needs, SceneFacts};

pub use params::{LodMode, ShMipEnvmap, Window};

impl Method for ShMipEnvmap {
    const INFO: Info = Info {
        id: "sh_mip_envmap",
        title: "Spherical harmonics and mip pyramid",
        summary: "an environment map as nine spherical harmonics and a mip pyramid",
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
            settings: &["sh_mip_envmap.lod=5", "sh_mip_envmap.f_lambda=1"],
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
        claims::claims(self, quantity)
    }
}

impl ShMipEnvmap {
    /// The captured cube: `capture_resolution`, rounded up to a multiple of both averaged cubes'.
    pub fn captured(&self) -> CubeSpec {
        let multiple = self.sh_size().max(self.base_size());
        CubeSpec {
            bounces: self.bounces,
            ..CubeSpec::of_radiance(self.capture_resolution.next_multiple_of(multiple))
        }
    }

    /// Texels along a face's edge of the cube that is projected: a power of two.
    fn sh_size(&self) -> u32 {
        self.sh_resolution.next_power_of_two()
    }

    /// Texels along a face's edge of the pyramid's base: a power of two.
    fn base_size(&self) -> u32 {
        self.resolution.next_power_of_two()
    }

    /// The pyramid's coarsest level, of one texel a face.
    fn top_level(&self) -> u32 {
        self.base_size().ilog2()
    }

    /// Checks that a level can be found for the points that need one.
    fn check_levels<B: Backend>(&self, inputs: &Inputs<'_, B>) -> Result<(), EstimatorError> {
        let mut glossy = inputs.host_points.iter().flatten();
        let mut known = || glossy.any(|p| p.material.specular != Vec3::ZERO && p.footprint > 0.0);
        if self.lod_mode == LodMode::Absolute || known() {
            return Ok(());
        }
        Err(Unsupported(
            "sh_mip_envmap with lod_mode=bias takes the level from neighbouring pixels, and these \
         points have none: render an image, or set lod_mode=absolute"
                .into(),
        )
        .into())
    }
}
