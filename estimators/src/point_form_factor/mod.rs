//! Point-to-point form factors: each texel of a cube map is a virtual point light at its surface's
//! place (A. Keller, *Instant Radiosity*; the usual answer before discs and polygons). It spikes
//! where a point comes near to a texel's middle, by design: a baseline.

mod claims;
mod cpu;
mod gpu;
mod leaves;
pub mod math;
mod params;

use crate::leaves::Leaves;
use crate::texels;
use crate::texels::average::{Averaging, Tables};
use crate::{Claim, Figure, Info, Method, OwnModel, Quantity, Reference, Unsupported};
use interreflect_scene::conventions::texel_solid_angle_sr;
use interreflect_scene::{CubeSpec, Needs, SceneFacts};

pub use params::PointFormFactor;

impl Method for PointFormFactor {
    const INFO: Info = Info {
        id: "point_form_factor",
        title: "Point-to-point form factors",
        summary: "the texels of a cube map with distances as virtual point lights, which are too bright near a surface; for comparison",
        references: &[Reference {
            authors: "A. Keller",
            title: "Instant Radiosity",
            venue: "SIGGRAPH",
            year: 1997,
            doi: Some("10.1145/258734.258769"),
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

impl PointFormFactor {
    /// The capture that is averaged down; nothing has a place without surfaces.
    fn captured(&self, scene: &SceneFacts) -> CubeSpec {
        texels::capture(
            self.resolution,
            self.capture_resolution,
            self.bounces,
            true,
            scene,
        )
    }

    /// A texel's size is its solid angle in sr from the reference point: with the cosine at its
    /// surface that is A/d².
    fn averaging(&self) -> Tables {
        let m = self.resolution;
        let omega_sr = |column, row| texel_solid_angle_sr(m, column, row);
        Tables::new(m, self.capture_resolution, Averaging::MeanPlane, omega_sr)
    }

    /// `clamp`, or the largest number where there is none.
    fn largest_omega_sr(&self) -> f32 {
        match self.clamp > 0.0 {
            true => self.clamp,
            false => f32::MAX,
        }
    }
}
