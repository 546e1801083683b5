//! Captures, by what they are asked for with.

use crate::backend::Backend;
use interreflect_scene::{CubeSpec, DirectionalDepthSpec, Environment, RsmSpec};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The captures that were made for one or several methods, by the specs that asked for them.
pub struct Captures<B: Backend> {
    /// Cube maps around the reference point.
    pub cubes: BTreeMap<CubeSpec, B::Cube>,
    /// Depth maps along directions.
    pub depths: BTreeMap<DirectionalDepthSpec, B::Depths>,
    /// What arrives from infinitely far away, if the scene has any.
    pub environment: Option<Environment>,
    /// Reflective shadow maps of the lights.
    pub rsms: BTreeMap<RsmSpec, B::Rsm>,
    /// Ray queries in the whole scene.
    pub transport: Option<Arc<B::Transport>>,
}

impl<B: Backend> Default for Captures<B> {
    fn default() -> Self {
        Self {
            cubes: BTreeMap::new(),
            depths: BTreeMap::new(),
            environment: None,
            rsms: BTreeMap::new(),
            transport: None,
        }
    }
}
