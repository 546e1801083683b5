//! Polygon-to-point form factors: Umenhoffer & Szirmay-Kalos, *Robust Diffuse Final Gathering on the
//! GPU*. Each texel of a cube map with distances is a quadrilateral through its four corners, and
//! every point gathers from all of them by the form factor of a polygon.

mod claims;
mod corners;
mod cpu;
mod gpu;
mod leaves;
pub mod math;
mod params;

use crate::leaves::Leaves;
use crate::texels;
use crate::texels::average::{Averaging, Tables};
use crate::{Claim, Figure, Info, Method, OwnModel, Quantity, Reference, Unsupported};
use interreflect_scene::params::Fidelity;
use interreflect_scene::{CubeSpec, Needs, SceneFacts};

pub use params::{Corners, Facing, PolygonFormFactor, Radiance};

impl Method for PolygonFormFactor {
    const INFO: Info = Info {
        id: "polygon_form_factor",
        title: "Polygon-to-point form factors",
        summary: "the texels of a cube map with distances as quadrilaterals, gathered by polygon-to-point form factors",
        references: &[Reference {
            authors: "T. Umenhoffer, L. Szirmay-Kalos",
            title: "Robust Diffuse Final Gathering on the GPU",
            venue: "WSCG",
            year: 2007,
            doi: None,
        }],
        figure: Some(Figure {
            scene: "divided-room",
            quantity: Quantity::Irradiance,
            settings: &[
                "polygon_form_factor.resolution=8",
                "polygon_form_factor.bounces=8",
                "scene.reference=passage",
            ],
        }),
    };

    const QUANTITIES: &'static [Quantity] = &[Quantity::Irradiance];

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

    fn claims(&self, _quantity: Quantity) -> Vec<Claim> {
        claims::claims(self)
    }
}

impl PolygonFormFactor {
    /// The capture that is averaged down. A distance along another ray than the captured ones
    /// follows the surface's plane, so it needs normals; nothing has a place without surfaces.
    fn captured(&self, scene: &SceneFacts) -> CubeSpec {
        let along_rays = self.fidelity == Fidelity::Corrected || self.corners() == Corners::Exact;
        texels::capture(
            self.resolution,
            self.capture_resolution,
            self.bounces,
            along_rays,
            scene,
        )
    }

    /// How the capture is averaged; quadrilaterals have their extent by their corners.
    fn averaging(&self) -> Tables {
        let averaging = match self.fidelity {
            Fidelity::Published => Averaging::Plain,
            Fidelity::Corrected => Averaging::Middle,
        };
        Tables::new(
            self.resolution,
            self.capture_resolution,
            averaging,
            |_, _| 0.0,
        )
    }
}
