//! Localized cube maps: Szirmay-Kalos & Lazányi, *Indirect Diffuse and Glossy Illumination on the
//! GPU*. A cube map of radiance and distance, averaged to a few texels; each texel is a small
//! light at its surface's place, and its solid angle is scaled from the reference point to the
//! shaded point.

mod cpu;
mod gpu;
pub mod math;
mod params;
mod texels;

use crate::{Backend, EstimatorError, Info, Inputs, Method, OwnModel, Quantity, Unsupported};
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
        let mut needs = Needs::default();
        needs.cubes.insert(params.captured(scene));
        needs.cubes.extend(params.texel_surfaces(scene));
        Ok(needs)
    }

    fn model(_params: &Self::Params, _quantity: Quantity) -> OwnModel {
        OwnModel::VisibleFromReference
    }
}

impl LocalizedCubemapParams {
    /// Texels along the captured cube's edge: `capture_resolution`, rounded up to a multiple of
    /// `resolution` so that each texel averages the same whole number of captured ones.
    pub fn capture_size(&self) -> u32 {
        self.capture_resolution.next_multiple_of(self.resolution)
    }

    /// The captures as the backend holds them: the cube that is averaged down, and the surfaces
    /// at the texels' centres where they were declared.
    fn read<'a, B: Backend>(
        &self,
        inputs: &Inputs<'a, B>,
    ) -> Result<(&'a B::Cube, Option<&'a B::Cube>), EstimatorError> {
        let surfaces = self.texel_surfaces(&inputs.scene);
        Ok((
            inputs.cube(&self.captured(&inputs.scene))?,
            surfaces.map(|s| inputs.cube(&s)).transpose()?,
        ))
    }

    /// The capture that is averaged down. `published` averages distances too.
    fn captured(&self, scene: &SceneFacts) -> CubeSpec {
        CubeSpec {
            size: self.capture_size(),
            channels: CubeChannels {
                radiance: true,
                distance: self.fidelity == Fidelity::Published && scene.surfaces,
                normal: false,
            },
        }
    }

    /// `corrected` takes distance and normal on the ray through each texel's centre instead of an
    /// average: a second capture at the final resolution.
    fn texel_surfaces(&self, scene: &SceneFacts) -> Option<CubeSpec> {
        (self.fidelity == Fidelity::Corrected && scene.surfaces).then_some(CubeSpec {
            size: self.resolution,
            channels: CubeChannels {
                radiance: false,
                distance: true,
                normal: true,
            },
        })
    }
}
