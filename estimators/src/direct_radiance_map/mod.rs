//! Direct radiance maps (Frisvad, Frisvad, Christensen, Falster: *Direct Radiance Mapping*): a
//! picture taken from the light shows what is lit, and nothing else; a few of its texels are small
//! lights that shine on every point.

mod claims;
mod cpu;
mod gpu;
mod leaves;
pub mod math;
mod params;
mod samples;

use crate::leaves::Leaves;
use crate::{Claim, Figure, Info, Method, OwnModel, Quantity, Reference, Unsupported};
use interreflect_scene::params::Fidelity;
use interreflect_scene::{Needs, RsmChannels, RsmSpec, RsmViews, SceneFacts};

pub use params::{DirectRadianceMap, Pictures, SolidAngle, Surface, TexelOf};

impl Method for DirectRadianceMap {
    const INFO: Info = Info {
        id: "direct_radiance_map",
        title: "Direct radiance mapping",
        summary: "a few texels of reflective shadow maps (RSMs) light every point",
        references: &[Reference {
            authors: "J. R. Frisvad, R. R. Frisvad, N. J. Christensen, P. Falster",
            title: "Scene Independent Real-Time Indirect Illumination (Direct Radiance Mapping)",
            venue: "Computer Graphics International",
            year: 2005,
            doi: Some("10.1109/CGI.2005.1500412"),
        }],
        figure: Some(Figure {
            scene: "cornell-box",
            quantity: Quantity::Irradiance,
            settings: &["direct_radiance_map.samples_per_side=5"],
        }),
    };

    const QUANTITIES: &'static [Quantity] = &[Quantity::Irradiance, Quantity::GlossyRadiance];

    const LEAVES: Leaves = leaves::LEAVES;

    fn needs(&self, _quantity: Quantity, scene: &SceneFacts) -> Result<Needs, Unsupported> {
        let (n, w) = (self.samples_per_side, self.map_resolution);
        if n > w {
            return Err(Unsupported(format!(
                "samples_per_side is {n} and the pictures have {w}×{w} texels: raise \
                 map_resolution to {n} or take fewer samples"
            )));
        }
        if scene.lights == 0 {
            return Err(Unsupported(
                "pictures are taken from lights: the scene needs a point, spot, directional or \
                 area light"
                    .into(),
            ));
        }
        if !scene.any_surface {
            return Err(Unsupported(
                "there is no surface that the lights could shine on: add a mesh".into(),
            ));
        }
        Ok(Needs {
            rsms: [self.captured()].into(),
            ..Needs::default()
        })
    }

    fn model(&self, _quantity: Quantity) -> OwnModel {
        OwnModel::FirstHitsOfLights {
            directional: self.shining(),
        }
    }

    fn claims(&self, quantity: Quantity) -> Vec<Claim> {
        claims::claims(self, quantity)
    }
}

/// What a photon counts from a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Formula {
    /// The same solid angle in sr from everywhere: equations 11 and 15.
    Constant,
    /// Equation 14.
    Published,
    /// The disc formula.
    Corrected,
}

impl DirectRadianceMap {
    /// The views that are sampled. Equations 11 and 15 know no normals.
    fn captured(&self) -> RsmSpec {
        let shining = self.shining();
        RsmSpec {
            size: self.map_resolution,
            views: match self.pictures {
                Pictures::One => RsmViews::Picture,
                Pictures::Surround => RsmViews::Surround,
            },
            channels: RsmChannels {
                radiance: !shining,
                normal: shining || self.formula() != Formula::Constant,
                true_colors: shining,
            },
        }
    }

    /// Whether lit surfaces reflect by their whole material.
    fn shining(&self) -> bool {
        self.surface == Surface::BlinnPhong
    }

    fn formula(&self) -> Formula {
        match (self.fidelity, self.solid_angle) {
            (Fidelity::Corrected, _) => Formula::Corrected,
            (Fidelity::Published, SolidAngle::Eq14) => Formula::Published,
            (Fidelity::Published, _) => Formula::Constant,
        }
    }

    /// Whether a photon is the mean of all that its cell shows, and not of radiance alone.
    fn averages_cells(&self) -> bool {
        self.mip && self.fidelity == Fidelity::Corrected
    }

    /// Whether a scene that is turned or mirrored about the axes has samples that are: its views do, and
    /// each sample lies in the middle of its cell.
    fn samples_symmetrically(&self) -> bool {
        let texels = self.map_resolution / self.samples_per_side;
        let middles = self.map_resolution.is_multiple_of(self.samples_per_side) && texels % 2 == 1;
        middles && self.pictures == Pictures::Surround
    }

    /// Whether a photon's solid angle is the same whatever its area.
    fn shares_hemisphere(&self) -> bool {
        (self.fidelity, self.solid_angle) == (Fidelity::Published, SolidAngle::Eq11)
    }
}

#[cfg(test)]
mod tests;
