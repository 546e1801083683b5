//! From a measurement to its record.

use super::on_backend::Timed;
use crate::domain::record::{Run, TimeSource};

/// A run with what was measured of it.
pub(crate) fn measured(run: Run, timed: &Timed) -> Run {
    let phases = timed.measured.phases;
    Run {
        phases_ms: phases,
        time_source: phases.shade.map_or(TimeSource::WallClock, |t| t.source),
        bytes: Some(timed.measured.bytes),
        software: timed.software,
        ..run
    }
}
