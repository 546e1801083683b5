//! Frames of a scene that moves, shaded at vertices.

use super::super::experiment_context::ExperimentContext;
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::frames::Shaded;
use crate::running::on_backend::Sequence;
use crate::running::view::{Look, ShadedAt, View};
use interreflect_estimators::execution::LoadedScene;
use interreflect_estimators::{Configured, Quantity};
use interreflect_scene::motion::Moves;
use interreflect_scene::{PointLayout, Points, Scene};

/// A moment of a scene, where it can be shaded.
pub(super) struct Moment {
    pub(super) loaded: LoadedScene,
    pub(super) view: View,
    pub(super) points: Points,
}

impl Moment {
    /// A scene at a time in seconds, seen by its camera and shaded at all vertices.
    pub(super) fn of(
        context: &ExperimentContext<'_>,
        rest: &Scene,
        time_s: f32,
    ) -> Result<Self, RunError> {
        let loaded = context.set_up(&rest.at(time_s))?;
        let look = Look {
            at: ShadedAt::Vertices,
            ..Look::default()
        };
        let view = context.whole_view(&loaded, context.pick(180, 512), look)?;
        let points = view.points(PointLayout::Surface);
        Ok(Self {
            loaded,
            view,
            points,
        })
    }

    /// Indices of the vertices that some pixel shows.
    pub(super) fn seen(&self) -> Vec<usize> {
        let Some(seen) = self.view.visible() else {
            return Vec::new();
        };
        let corners = seen
            .visible
            .iter()
            .flat_map(|&t| seen.triangles[t as usize]);
        let mut vertices: Vec<usize> = corners.map(|v| v as usize).collect();
        vertices.sort_unstable();
        vertices.dedup();
        vertices
    }

    /// The next frame of a session shows it.
    pub(super) fn shade(
        &self,
        context: &ExperimentContext<'_>,
        on: (&mut Sequence, Backend),
        method: &dyn Configured,
        moves: Moves,
    ) -> Result<Shaded, RunError> {
        self.shade_as(context, on, (method, Quantity::AmbientOcclusion), moves)
    }

    /// As [`Self::shade`], of any quantity.
    pub(super) fn shade_as(
        &self,
        context: &ExperimentContext<'_>,
        on: (&mut Sequence, Backend),
        (method, quantity): (&dyn Configured, Quantity),
        moves: Moves,
    ) -> Result<Shaded, RunError> {
        let what = (&self.points, self.view.visible(), moves);
        context.frame(&self.loaded, on, method, quantity, what)
    }
}

/// Meshes move.
pub(super) const DEFORMING: Moves = Moves {
    geometry: true,
    camera: false,
    lights: false,
    environment: false,
};

/// Nothing moves.
pub(super) const RESTING: Moves = Moves {
    geometry: false,
    ..DEFORMING
};
