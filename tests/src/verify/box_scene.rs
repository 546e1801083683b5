//! Box scenes with known answers: six walls around a reference point, and shading points.

use crate::oracles::polygon::polygon_irradiance;
use crate::oracles::solid_angle::polygon_solid_angle_sr;
use glam::{DVec3, Mat3, Vec3};
use interreflect_estimators::{OwnModel, Quantity};
use interreflect_scene::conventions::{CUBE_FACES, cube_frame};
use interreflect_scene::{
    Camera, Environment, LatLongImage, Light, Material, Mesh, Object, Point, Points, Role, Scene,
    SceneMotion,
};
use std::f32::consts::PI;

/// What lights a box scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lighting {
    /// They emit.
    Walls,
    /// They reflect the light of a lamp.
    Lamp,
    /// They stand before a sky, each of a size of its own.
    Sky,
}

impl Lighting {
    /// What a method can be tried under: what its model takes light from.
    pub fn of(model: OwnModel, quantity: Quantity) -> Self {
        match (model, quantity) {
            (_, Quantity::AmbientOcclusion) | (OwnModel::OccludedEnvironment, _) => Self::Sky,
            (OwnModel::FirstHitsOfLights { .. }, _) => Self::Lamp,
            _ => Self::Walls,
        }
    }
}

/// Transform of a box scene: x ↦ `linear`·x + `shift`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// A cube's symmetry times a size.
    pub linear: Mat3,
    /// In metres.
    pub shift: Vec3,
}

impl Placement {
    /// As it is.
    pub const NONE: Self = Self {
        linear: Mat3::IDENTITY,
        shift: Vec3::ZERO,
    };

    fn at(&self, x: Vec3) -> Vec3 {
        self.linear * x + self.shift
    }

    fn size(&self) -> f32 {
        self.linear.x_axis.length()
    }

    fn direction(&self, d: Vec3) -> Vec3 {
        (self.linear * d) / self.size()
    }
}

/// A box of six walls with what lights it, a reference point, and points.
#[derive(Clone, Debug)]
pub struct BoxScene {
    /// What the walls are.
    pub lighting: Lighting,
    /// Half the box's edges, in metres.
    pub half: Vec3,
    /// Of each wall, in the order of cube faces: radiance, albedo, or (first channel) size in [0, 1].
    pub walls: [Vec3; CUBE_FACES],
    /// Whether specks in the box's corners keep its bounds, whatever walls there are.
    pub specks: bool,
    /// Factor on the distance of each wall's corners from the reference point, along their rays.
    pub reach: [f32; CUBE_FACES],
    /// The sky's radiance is 1 + `sky`·d.
    pub sky: Vec3,
    /// Reference point.
    pub reference: Vec3,
    /// Position of a point light of 1 W/sr.
    pub lamp: Vec3,
    /// The points.
    pub points: Vec<Point>,
    /// Where all of it is put.
    pub placement: Placement,
}

impl BoxScene {
    /// The scene.
    pub fn scene(&self) -> Scene {
        let mut mesh = Mesh::default();
        let materials = self.walls.map(|wall| match self.lighting {
            Lighting::Walls => Material::emitter(wall),
            Lighting::Lamp => Material::diffuse(wall),
            Lighting::Sky => Material::diffuse(Vec3::ZERO),
        });
        for face in 0..CUBE_FACES {
            if let Some(corners) = self.wall(face) {
                let first = mesh.positions.len() as u32;
                mesh.positions.extend(corners);
                let [a, b, c, d] = [0, 1, 2, 3].map(|i| first + i);
                mesh.triangles.extend([[a, b, c], [a, c, d]]);
                mesh.materials.extend([face as u32; 2]);
            }
        }
        if self.specks {
            for k in 0..8 {
                let sign = |bit: u32| if k & bit == 0 { -1.0 } else { 1.0 };
                let corner = Vec3::new(sign(1), sign(2), sign(4));
                let first = mesh.positions.len() as u32;
                let speck = [
                    corner,
                    corner * (1.0 - 1e-3 * Vec3::X),
                    corner * (1.0 - 1e-3 * Vec3::Y),
                ];
                mesh.positions
                    .extend(speck.map(|c| self.placement.at(c * self.half)));
                mesh.triangles.push([first, first + 1, first + 2]);
                mesh.materials.push(0);
            }
        }
        if self.placement.linear.determinant() < 0.0 {
            mesh.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        }
        let objects = (!mesh.triangles.is_empty()).then(|| Object {
            name: "walls".into(),
            role: Role::Environment,
            mesh,
            motion: None,
        });
        Scene {
            name: "box scene".into(),
            objects: objects.into_iter().collect(),
            materials: materials.into(),
            lights: self.lights(),
            environment: (self.lighting == Lighting::Sky).then(|| self.environment()),
            camera: Camera {
                eye: self.placement.at(Vec3::new(0.0, 0.0, 0.9 * self.half.z)),
                target: self.placement.at(Vec3::ZERO),
                up: self.placement.direction(Vec3::Y),
                vfov_deg: 60.0,
                resolution: [16, 16],
            },
            reference_point: self.placement.at(self.reference),
            captured_at: None,
            motion: SceneMotion::default(),
        }
    }

    /// A wall's corners, facing inwards; `None` if it has no size.
    fn wall(&self, face: usize) -> Option<[Vec3; 4]> {
        let size = match self.lighting {
            Lighting::Sky => self.walls[face].x,
            _ => 1.0,
        };
        let (axis, s, t) = cube_frame(face);
        let corners = [-s - t, s - t, s + t, t - s];
        let corners = corners.map(|c| (axis + c * f64::from(size)).as_vec3() * self.half);
        let along = |c: Vec3| c + (c - self.reference) * (self.reach[face] - 1.0);
        (size > 0.0).then(|| corners.map(|c| self.placement.at(along(c))))
    }

    fn lights(&self) -> Vec<Light> {
        let lamp = Light::Point {
            position: self.placement.at(self.lamp),
            intensity: Vec3::splat(self.placement.size().powi(2)),
            picture: None,
        };
        let lit = self.lighting == Lighting::Lamp;
        lit.then_some(lamp).into_iter().collect()
    }

    fn environment(&self) -> Environment {
        let gradient = self.placement.direction(self.sky);
        sky(32, |d| 1.0 + gradient.dot(d))
    }

    /// The points, where they are put, in a quantity's layout.
    pub fn placed_points(&self, quantity: Quantity) -> Points {
        let placed = self.points.iter().map(|p| Point {
            position: self.placement.at(p.position),
            normal: self.placement.direction(p.normal),
            view: self.placement.direction(p.view),
            ..*p
        });
        Points::new(quantity.layout(), placed.map(Some))
    }

    /// What surroundings of the greatest radiance that is sent anywhere would give: πL for
    /// irradiance, L times the greater albedo for reflected radiance, 1 for openness.
    pub fn greatest(&self, quantity: Quantity) -> f64 {
        let radiance = match self.lighting {
            Lighting::Walls => self.brightest(|face| self.walls[face].max_element()),
            Lighting::Sky => 1.0 + self.sky.length(),
            Lighting::Lamp => self.brightest(|face| {
                let (axis, ..) = cube_frame(face);
                let axis = axis.as_vec3();
                let distance = (axis * self.half - self.lamp).dot(axis);
                self.walls[face].max_element() / (PI * distance * distance)
            }),
        };
        let albedo = self.points.iter().map(|p| {
            let material = p.material;
            (material.diffuse + material.specular).max_element()
        });
        f64::from(match quantity {
            Quantity::Irradiance => PI * radiance,
            Quantity::GlossyRadiance => radiance * albedo.fold(0.0, f32::max),
            Quantity::AmbientOcclusion => 1.0,
        })
    }

    fn brightest(&self, radiance: impl Fn(usize) -> f32) -> f32 {
        (0..CUBE_FACES).map(radiance).fold(0.0, f32::max)
    }

    /// Irradiance in W/m² at a point as a model has it, from walls that emit, by the exact kernel of
    /// polygons; `None` for a model that it does not serve. The box stands at rest.
    pub fn irradiance(&self, model: OwnModel, point: &Point) -> Option<f64> {
        let from = match model {
            OwnModel::VisibleFromReference { .. } | OwnModel::LightTransport(_) => point.position,
            OwnModel::EnvironmentAtInfinity { .. } | OwnModel::MeanRadiance { .. } => {
                self.reference
            }
            _ => return None,
        };
        let normal = point.normal.as_dvec3();
        let wall = |face: usize| {
            let corners = self.corners(face).map(|c| c - from.as_dvec3());
            let factor = match model {
                OwnModel::MeanRadiance { .. } => polygon_solid_angle_sr(&corners) / 4.0,
                _ => polygon_irradiance(normal, &corners).abs(),
            };
            f64::from(self.walls[face].x) * factor
        };
        (self.lighting == Lighting::Walls).then(|| (0..CUBE_FACES).map(wall).sum())
    }

    /// A wall's corners where the box stands at rest, counter-clockwise from inside.
    pub fn corners(&self, face: usize) -> [DVec3; 4] {
        let (axis, s, t) = cube_frame(face);
        let half = self.half.as_dvec3();
        [-s - t, s - t, s + t, t - s].map(|c| (axis + c) * half)
    }
}

/// A sky of `rows` rows whose radiance is the same in each channel.
pub fn sky(rows: u32, radiance: impl Fn(Vec3) -> f32) -> Environment {
    let mut image = LatLongImage {
        width: 2 * rows,
        height: rows,
        texels: Vec::new(),
    };
    for row in 0..image.height {
        for column in 0..image.width {
            let towards = image.direction(column as f32 + 0.5, row as f32 + 0.5);
            image.texels.push(Vec3::splat(radiance(towards)));
        }
    }
    Environment {
        image,
        scale: 1.0,
        rotate_deg: 0.0,
    }
}
