//! Scenes, points and capture images: what is lit, and what is asked of a backend.
//!
//! Everything in this crate is data and pure functions; it knows no backend. Units: metres,
//! linear RGB, radiance in W·m⁻²·sr⁻¹; frames are right-handed.

mod bounds;
pub mod camera;
pub mod coarse_irradiance;
pub mod conventions;
pub mod cube_image;
mod digest;
pub mod directional_depth;
pub mod environment;
mod error;
pub mod library;
pub mod light;
pub mod light_frame;
mod light_paths;
pub mod load;
pub mod material;
pub mod mesh;
pub mod motion;
pub mod needs;
pub mod normals;
pub mod params;
pub mod points;
pub mod rsm;
mod scene;
pub mod shapes;
mod validate;

pub use bounds::Bounds;
pub use camera::Camera;
pub use coarse_irradiance::CoarseIrradiance;
pub use cube_image::CubeImage;
pub use digest::{digest, digest_of_bytes};
pub use directional_depth::{BoundingSphere, DepthMap, DirectionalDepthSpec, DirectionalFrame};
pub use environment::{Environment, LatLongImage};
pub use error::{Place, SceneError};
pub use light::{Incident, Light, LightPicture, SpotShape};
pub use light_frame::{LightFrame, Projection, Surroundings, light_frames};
pub use light_paths::LightPaths;
pub use load::{SceneRequest, open, open_points};
pub use material::{DirectLight, Material, ReflectionLaw};
pub use mesh::Mesh;
pub use motion::{Motion, Moves, SceneMotion};
pub use needs::{CubeChannels, CubeSpec, Needs, RsmChannels, RsmSpec, RsmViews, SceneFacts};
pub use points::{Estimate, LANES, Point, PointError, PointLayout, Points, SurfaceMaterial};
pub use rsm::{RsmImage, TrueColors};
pub use scene::{Object, Role, Scene};
