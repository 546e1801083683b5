//! Frames of a scene that moves, shaded at vertices.

use super::super::desk::Desk;
use crate::error::HarnessError;
use crate::frames::Shaded;
use crate::record::Backend;
use crate::stages::Sequence;
use crate::view::{Look, ShadedAt, View};
use interreflect_estimators::execution::LoadedScene;
use interreflect_estimators::{Configured, Quantity};
use interreflect_scene::motion::Moves;
use interreflect_scene::{PointLayout, Points, Scene};

/// A moment of a scene, where it can be shaded.
pub(super) struct Moment {
    pub(super) room: LoadedScene,
    pub(super) view: View,
    pub(super) points: Points,
}

impl Moment {
    /// A scene at a time in seconds, seen by its camera and shaded at all vertices.
    pub(super) fn of(desk: &Desk<'_>, rest: &Scene, time_s: f32) -> Result<Self, HarnessError> {
        let room = desk.set_up(&rest.at(time_s))?;
        let look = Look {
            at: ShadedAt::Vertices,
            ..Look::default()
        };
        let view = desk.whole_view(&room, desk.pick(180, 512), look)?;
        let points = view.points(PointLayout::Surface);
        Ok(Self { room, view, points })
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
        desk: &Desk<'_>,
        on: (&mut Sequence, Backend),
        method: &dyn Configured,
        moves: Moves,
    ) -> Result<Shaded, HarnessError> {
        self.shade_as(desk, on, (method, Quantity::AmbientOcclusion), moves)
    }

    /// As [`Self::shade`], of any quantity.
    pub(super) fn shade_as(
        &self,
        desk: &Desk<'_>,
        on: (&mut Sequence, Backend),
        (method, quantity): (&dyn Configured, Quantity),
        moves: Moves,
    ) -> Result<Shaded, HarnessError> {
        let what = (&self.points, self.view.visible(), moves);
        desk.frame(&self.room, on, method, quantity, what)
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
