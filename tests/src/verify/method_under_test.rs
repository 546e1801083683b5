//! An estimator that is checked: one method with its parameters, one quantity, one backend.

use super::{BoxScene, Case, TestBackend, VerifyError};
use interreflect_estimators::{Claim, Configured, OwnModel, Quantity};
use interreflect_scene::{Estimate, Points, Scene, SceneFacts};
use std::f64::consts::PI;

/// What is checked, and how hard.
pub struct MethodUnderTest<'a> {
    /// The backend.
    pub backend: TestBackend<'a>,
    /// The method.
    pub method: &'a dyn Configured,
    /// What it estimates.
    pub quantity: Quantity,
    /// Number of random box scenes for each claim.
    pub cases: u32,
    /// Seed of the random box scenes.
    pub seed: u64,
    /// One box scene instead of random ones.
    pub case: Option<Case>,
}

impl MethodUnderTest<'_> {
    /// What the method claims.
    pub fn claims(&self) -> Vec<Claim> {
        self.method.claims(self.quantity)
    }

    /// What it says that it computes.
    pub fn model(&self) -> OwnModel {
        self.method.model(self.quantity)
    }

    /// Its estimate in a box scene.
    ///
    /// # Errors
    /// [`VerifyError`] as [`TestBackend::estimate`].
    pub fn estimate(&self, box_scene: &BoxScene) -> Result<Estimate, VerifyError> {
        let points = box_scene.placed_points(self.quantity);
        self.backend
            .estimate(&box_scene.scene(), self.method, self.quantity, &points)
    }

    /// Its estimates at several lists of points of a scene.
    ///
    /// # Errors
    /// [`VerifyError`] as [`TestBackend::estimate`].
    pub fn estimates(&self, scene: &Scene, lists: &[Points]) -> Result<Vec<Estimate>, VerifyError> {
        self.backend
            .estimates(scene, self.method, self.quantity, lists)
    }

    /// What rounding to float32 makes of a sum over all captured texels, relative to the largest
    /// value: rounding errors add up like a random walk, four times that for the worst of many; and
    /// the stated error of the power of a lobe.
    pub fn rounding(&self, facts: &SceneFacts) -> f64 {
        let walk = self.texels(facts).sqrt() * 4.0 * f64::from(f32::EPSILON) / 2.0;
        1e-5 + walk
    }

    /// Share of all light that eight captured texels hold: those on the edges of surfaces, which the
    /// rounding of a ray or of a rasteriser gives to either side.
    pub fn edge_texels(&self, facts: &SceneFacts) -> f64 {
        match self.method.needs(self.quantity, facts) {
            Ok(needs) => {
                let coarsest = needs.cubes.iter().map(|c| c.size).min();
                let texel_sr = coarsest.map(|size| 4.0 * PI / (6.0 * f64::from(size).powi(2)));
                texel_sr.map_or(0.0, |sr| 8.0 * sr / PI)
            }
            Err(_) => 0.0,
        }
    }

    fn texels(&self, facts: &SceneFacts) -> f64 {
        let Ok(needs) = self.method.needs(self.quantity, facts) else {
            return 0.0;
        };
        let cubes = needs.cubes.iter().map(|c| 6.0 * f64::from(c.size).powi(2));
        let views = needs.rsms.iter();
        let views = views.map(|v| 6.0 * f64::from(facts.lights) * f64::from(v.size).powi(2));
        cubes.chain(views).sum()
    }
}
