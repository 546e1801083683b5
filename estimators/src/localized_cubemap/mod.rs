//! Localized cube maps: Szirmay-Kalos & Lazányi, *Indirect Diffuse and Glossy Illumination on the
//! GPU*. A cube map of radiance and distance, averaged to a few texels; each texel is a small
//! light at its surface's place, and its solid angle is scaled from the reference point to the
//! shaded point.

mod cpu;
mod gpu;
pub mod math;
mod params;
mod texels;

use crate::{Info, Method, OwnModel, Quantity, Unsupported};
use interreflect_scene::params::Fidelity;
use interreflect_scene::{CubeChannels, CubeSpec, Needs, SceneFacts};

pub use params::{LocalizedCubemapParams, SolidAngle};

/// The method.
pub struct LocalizedCubemap;

impl Method for LocalizedCubemap {
    type Params = LocalizedCubemapParams;

    const INFO: Info = Info {
        id: "localized_cubemap",
        title: "Localized cube map",
        source: "L. Szirmay-Kalos, I. Lazányi: Indirect Diffuse and Glossy Illumination on the GPU",
    };

    const QUANTITIES: &'static [Quantity] = &[Quantity::Irradiance, Quantity::GlossyRadiance];

    fn needs(
        params: &Self::Params,
        _quantity: Quantity,
        scene: &SceneFacts,
    ) -> Result<Needs, Unsupported> {
        Ok(Needs {
            cubes: [params.captured(scene)].into(),
            keep_within_m: params.recapture_distance,
            ..Needs::default()
        })
    }

    fn model(params: &Self::Params, _quantity: Quantity) -> OwnModel {
        OwnModel::VisibleFromReference {
            bounces: params.bounces,
        }
    }
}

impl LocalizedCubemapParams {
    /// Texels along the captured cube's edge: `capture_resolution`, rounded up to a multiple of
    /// `resolution` so that each texel averages the same whole number of captured ones.
    pub fn capture_size(&self) -> u32 {
        self.capture_resolution.next_multiple_of(self.resolution)
    }

    /// The capture that is averaged down. Both fidelities place a texel by its distance,
    /// `corrected` by its surface's normal too; nothing has a place without surfaces.
    fn captured(&self, scene: &SceneFacts) -> CubeSpec {
        CubeSpec {
            size: self.capture_size(),
            channels: CubeChannels {
                radiance: true,
                distance: scene.surfaces,
                normal: scene.surfaces && self.fidelity == Fidelity::Corrected,
            },
            bounces: self.bounces,
        }
    }
}
