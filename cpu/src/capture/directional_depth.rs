//! Depth maps along directions, by an orthographic rasteriser.

use crate::scene::CpuScene;
use glam::Vec3;
use glam::{DVec2, DVec3};
use interreflect_scene::{BoundingSphere, DepthMap, DirectionalDepthSpec, DirectionalFrame};
use std::sync::Arc;

/// Where depth maps of a scene come from, direction by direction.
#[derive(Clone, Debug)]
pub struct DirectionalDepths {
    scene: Arc<CpuScene>,
    sphere: BoundingSphere,
    spec: DirectionalDepthSpec,
}

impl DirectionalDepths {
    /// Depth maps of everything in a scene.
    pub fn new(scene: Arc<CpuScene>, spec: DirectionalDepthSpec) -> Self {
        Self {
            sphere: BoundingSphere::of_objects(scene.scene()),
            scene,
            spec,
        }
    }

    /// The map seen from a unit direction: at each texel's centre the depth of the nearest
    /// triangle's plane there. Its texels' depths do not depend on the order of triangles.
    pub fn map(&self, towards: Vec3) -> DepthMap {
        let frame = DirectionalFrame::new(self.sphere, towards);
        let mut map = DepthMap::new(frame, self.spec.size);
        for object in &self.scene.scene().objects {
            let mesh = &object.mesh;
            let projected: Vec<DVec3> = mesh.positions.iter().map(|&p| frame.project(p)).collect();
            for triangle in &mesh.triangles {
                let corners = triangle.map(|v| projected[v as usize]);
                draw(&mut map, corners, self.spec.slope_scaled);
            }
        }
        map
    }
}

/// Keeps the smaller depth wherever the triangle covers a texel's centre; edges count as inside, so
/// that neighbours leave no crack.
fn draw(map: &mut DepthMap, corners: [DVec3; 3], slope_scaled: bool) {
    let size = f64::from(map.size);
    // In texels, the centre of texel (0, 0) at 0.
    let at = |p: DVec3| (p.truncate() * 0.5 + 0.5) * size - 0.5;
    let [a, b, c] = corners.map(at);
    let (ab, ac) = (b - a, c - a);
    let area = ab.perp_dot(ac);
    if area == 0.0 {
        return;
    }
    let low = a.min(b).min(c).ceil().max(DVec2::ZERO);
    let high = a.max(b).max(c).floor().min(DVec2::splat(size - 1.0));
    if low.cmpgt(high).any() {
        return;
    }
    let rise = [corners[1].z - corners[0].z, corners[2].z - corners[0].z];
    let per_column = (rise[0] * ac.y - rise[1] * ab.y) / area;
    let per_row = (rise[1] * ab.x - rise[0] * ac.x) / area;
    let offset = match slope_scaled {
        true => polygon_offset(corners.map(|c| c.z), per_column.abs().max(per_row.abs())),
        false => 0.0,
    };
    for row in low.y as usize..=high.y as usize {
        for column in low.x as usize..=high.x as usize {
            let p = DVec2::new(column as f64, row as f64) - a;
            let (u, v) = (p.perp_dot(ac) / area, ab.perp_dot(p) / area);
            if u >= 0.0 && v >= 0.0 && u + v <= 1.0 {
                let depth = corners[0].z + u * rise[0] + v * rise[1] + offset;
                let texel = &mut map.depth[row * map.size as usize + column];
                *texel = texel.min(depth as f32);
            }
        }
    }
}

/// Vulkan's depth bias with a constant factor of 1 and a slope factor of 1, for depths of 32-bit
/// floats: the slope per texel and one unit in the last place of the largest depth.
fn polygon_offset(depths: [f64; 3], slope: f64) -> f64 {
    let largest = depths.into_iter().fold(f64::MIN_POSITIVE, f64::max);
    slope + (largest.log2().floor() - 23.0).exp2()
}
