//! Localized cube maps: Szirmay-Kalos & Lazányi, *Indirect Diffuse and Glossy Illumination on the
//! GPU*. A cube map of radiance and distance, averaged to a few texels; each texel is a small
//! light at its surface's place, and its solid angle is scaled from the reference point to the
//! shaded point.

mod claims;
mod cpu;
mod gpu;
mod leaves;
pub mod math;
mod params;
mod tables;

use crate::leaves::Leaves;
use crate::texels;
use crate::texels::average::{Averaging, Tables};
use crate::{Claim, Figure, Info, Method, OwnModel, Quantity, Reference, Unsupported};
use interreflect_scene::conventions::{cube_vector, texel_centre, texel_solid_angle_sr};
use interreflect_scene::params::Fidelity;
use interreflect_scene::{CubeSpec, Needs, SceneFacts};

pub use params::{LocalizedCubemap, Reflectivity, SolidAngle};

impl Method for LocalizedCubemap {
    const INFO: Info = Info {
        id: "localized_cubemap",
        title: "Localized cube map",
        summary: "a cube map with distances: each texel is a disc at its surface, rescaled to the shaded point",
        references: &[Reference {
            authors: "L. Szirmay-Kalos, I. Lazányi",
            title: "Indirect Diffuse and Glossy Illumination on the GPU",
            venue: "Spring Conference on Computer Graphics",
            year: 2006,
            doi: None,
        }],
        figure: Some(Figure {
            scene: "cornell-box",
            quantity: Quantity::Irradiance,
            settings: &[],
        }),
    };

    const QUANTITIES: &'static [Quantity] = &[Quantity::Irradiance, Quantity::GlossyRadiance];

    const LEAVES: Leaves = leaves::LEAVES;

    fn needs(&self, _quantity: Quantity, scene: &SceneFacts) -> Result<Needs, Unsupported> {
        Ok(Needs {
            cubes: [self.captured(scene)].into(),
            keep_within_m: self.recapture_distance,
            ..Needs::default()
        })
    }

    fn model(&self, _quantity: Quantity) -> OwnModel {
        OwnModel::VisibleFromReference {
            bounces: self.bounces,
        }
    }

    fn claims(&self, quantity: Quantity) -> Vec<Claim> {
        claims::claims(self, quantity)
    }
}

impl LocalizedCubemap {
    /// How the capture is averaged, and what each texel's size is: Δω' in sr in `published`, the
    /// disc's area times its cosine over d² in `corrected`.
    fn averaging(&self) -> Tables {
        let m = self.resolution;
        let (averaging, extent): (_, &dyn Fn(u32, u32) -> f64) = match self.fidelity {
            Fidelity::Published => (Averaging::Plain, &|column, row| self.omega(column, row)),
            Fidelity::Corrected => (Averaging::MeanPlane, &|column, row| {
                math::disc_area(texel_solid_angle_sr(m, column, row))
            }),
        };
        Tables::new(m, self.capture_resolution, averaging, extent)
    }

    /// Published solid angle Δω' in sr of a texel seen from the reference point.
    fn omega(&self, column: u32, row: u32) -> f64 {
        let m = self.resolution;
        let l = cube_vector(0, texel_centre(m, column), texel_centre(m, row)).length();
        match self.solid_angle {
            SolidAngle::Text => math::texel_omega_text(f64::from(m), l),
            SolidAngle::Shader => math::texel_omega_shader(f64::from(m), l),
        }
    }

    /// The capture that is averaged down. Both fidelities place a texel by its distance,
    /// `corrected` by its surface's normal too; nothing has a place without surfaces.
    fn captured(&self, scene: &SceneFacts) -> CubeSpec {
        texels::capture(
            self.resolution,
            self.capture_resolution,
            self.bounces,
            self.fidelity == Fidelity::Corrected,
            scene,
        )
    }
}
