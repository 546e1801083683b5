//! What a method claims to compute, evaluated by a deterministic integral.
//!
//! The surroundings of the reference point are captured in small patches, each a planar quad at
//! its surface's place or a bundle of directions at infinity, and merged four by four into a
//! hierarchy (`hierarchy.rs`). Every point gathers from all of them: far nodes by the point kernel, near ones
//! by the exact polygon kernel (`gather.rs`). Places that lights shine on first are patches of the
//! lights' views, all of them summed (`lit.rs`).

mod cell;
mod gather;
mod hierarchy;
mod lit;
mod near;
mod node;
mod split;
#[cfg(test)]
mod tests;

use gather::Gather;
use glam::Vec3;
use hierarchy::Hierarchy;
use interreflect_cpu::path_tracer::{Stop, trace};
use interreflect_cpu::scene::CpuScene;
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::path_reference::path_quantity;
use interreflect_estimators::{OwnModel, Quantity};
use interreflect_scene::{Estimate, LightPaths, Material, Points};
use lit::{Lit, PATCHES};

/// A model's value at each point, with how far it may be off.
pub struct ModelValues {
    /// The values.
    pub values: Estimate,
    /// For each value: the standard error of a path-traced model, or the change from an integral
    /// over patches and nodes of twice the size. The change exceeds the error left in the finer
    /// one on average; single points may agree by chance.
    pub error: Estimate,
    /// One line on how they were computed.
    pub description: String,
}

/// Texels along the edge of the finer of the two patch captures: 3·2ᵏ, to be halved.
pub const PATCH_RESOLUTION: u32 = 192;

/// Squared distance over squared radius from which a node counts as a point. What is left is the
/// bend of the integrand over a node, above all where the horizon cuts it: about 1e-4 of the sum.
const FAR: f32 = 1024.0;

/// Evaluates `model` for `quantity` at every point. `stop` and `seed` are for path-traced models.
pub fn evaluate(
    cx: &CpuCx,
    model: OwnModel,
    quantity: Quantity,
    scene: &CpuScene,
    points: &Points,
    stop: &Stop,
    seed: u64,
) -> ModelValues {
    if let OwnModel::LightTransport(paths) = model {
        let quantity = path_quantity(quantity);
        let traced = cx.install(|| trace(scene, points, quantity, &paths, stop, seed, &|_| {}));
        return ModelValues {
            values: traced.mean,
            error: traced.standard_error,
            description: format!("path tracing, {} samples, seed {seed}", traced.samples),
        };
    }
    if let OwnModel::Other(other) = model {
        let (values, error) = other.0.evaluate(cx, scene, quantity, points);
        return ModelValues {
            values,
            error,
            description: other.0.name().into(),
        };
    }
    if model == OwnModel::OccludedEnvironment {
        let black = black(scene);
        let paths = OwnModel::LightTransport(LightPaths::default());
        return evaluate(cx, paths, quantity, &black, points, stop, seed);
    }
    if let OwnModel::FirstHitsOfLights { directional } = model {
        return lit_values(cx, directional, quantity, scene, points);
    }
    let integral = |size, far| {
        let hierarchy = cx.install(|| Hierarchy::new(model, scene, size));
        let mut values = Estimate::new(points.len());
        cx.for_each_tile(points, &mut values, &Gather::new(&hierarchy, quantity, far));
        values
    };
    let values = integral(PATCH_RESOLUTION, FAR);
    ModelValues {
        error: change(&values, &integral(PATCH_RESOLUTION / 2, FAR / 4.0)),
        values,
        description: format!("integral over 6×{PATCH_RESOLUTION}² patches"),
    }
}

/// A scene whose surfaces send nothing: all light in it comes from the environment, past them.
fn black(scene: &CpuScene) -> CpuScene {
    let mut black = scene.scene().clone();
    black.lights.clear();
    black
        .materials
        .iter_mut()
        .for_each(|m| *m = Material::diffuse(Vec3::ZERO));
    CpuScene::new(&black).expect("a scene that was checked before")
}

fn lit_values(
    cx: &CpuCx,
    directional: bool,
    quantity: Quantity,
    scene: &CpuScene,
    points: &Points,
) -> ModelValues {
    let integral = |patches| {
        let lit = cx.install(|| Lit::new(scene, directional, quantity, patches));
        let mut values = Estimate::new(points.len());
        cx.for_each_tile(points, &mut values, &lit);
        values
    };
    let values = integral(PATCHES);
    ModelValues {
        error: change(&values, &integral(PATCHES / 4)),
        values,
        description: format!("integral over about {PATCHES} patches in the lights' views"),
    }
}

fn change(values: &Estimate, coarse: &Estimate) -> Estimate {
    let mut error = Estimate::new(values.len());
    for i in 0..values.len() {
        error.set(i, (values.get(i) - coarse.get(i)).abs());
    }
    error
}
