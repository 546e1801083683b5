//! Captures of one backend given to the other.

use interreflect_estimators::{Captures, Cpu, Gpu};
use interreflect_gpu::{GpuContext, GpuCube, GpuError, GpuRsm};

/// The host's captures on the device. Depth maps are made while they are read, each backend's by
/// itself: there is nothing to give.
///
/// # Errors
/// [`GpuError`] if the device refuses.
pub fn uploaded(context: &GpuContext, from: &Captures<Cpu>) -> Result<Captures<Gpu>, GpuError> {
    let mut captures = Captures {
        environment: from.environment.clone(),
        ..Captures::default()
    };
    for (spec, cube) in &from.cubes {
        let cube = GpuCube::upload(context, cube)?;
        captures.cubes.insert(*spec, cube);
    }
    for (spec, views) in &from.rsms {
        let views = GpuRsm::upload(context, views)?;
        captures.rsms.insert(*spec, views);
    }
    Ok(captures)
}

/// The device's captures on the host, but for depth maps.
///
/// # Errors
/// [`GpuError`] if the device refuses.
pub fn downloaded(context: &GpuContext, from: &Captures<Gpu>) -> Result<Captures<Cpu>, GpuError> {
    let mut captures = Captures {
        environment: from.environment.clone(),
        ..Captures::default()
    };
    for (spec, cube) in &from.cubes {
        captures.cubes.insert(*spec, cube.download(context)?);
    }
    for (spec, views) in &from.rsms {
        captures.rsms.insert(*spec, views.download(context)?);
    }
    Ok(captures)
}
