//! What the device, or this crate, must refuse with a typed error.

use crate::oracle::{empty, everything};
use crate::{Case, ensure};
use glam::Vec3;
use interreflect_gpu::{
    Binding, GpuContext, GpuCube, GpuCx, GpuError, GpuPoints, GpuScene, MAX_LIGHTS, Shader,
    adapters, capture_cube,
};
use interreflect_scene::{CubeImage, Light, PointLayout, Points};
use libtest_mimic::Failed;
use std::sync::Arc;

pub(crate) const CASES: &[Case] = &[
    ("errors::unknown_adapter", unknown_adapter),
    (
        "errors::adapters_are_chosen_by_name",
        adapters_are_chosen_by_name,
    ),
    ("errors::invalid_shader", invalid_shader),
    ("errors::unknown_entry_point", unknown_entry_point),
    ("errors::unbound_slot", unbound_slot),
    ("errors::wrong_kind_of_binding", wrong_kind_of_binding),
    (
        "errors::recorded_faults_are_typed",
        recorded_faults_are_typed,
    ),
    ("errors::own_errors_pass_through", own_errors_pass_through),
    ("errors::too_many_points", too_many_points),
    ("errors::too_many_lights", too_many_lights),
    ("errors::impossible_captures", impossible_captures),
    ("errors::lost_device", lost_device),
];

const SHADER: Shader = Shader {
    label: "fill",
    parts: &[
        "@group(0) @binding(0) var<storage, read_write> values: array<f32>;",
        "@compute @workgroup_size(1) fn fill() { values[0] = 1.0; }",
    ],
};

fn unknown_adapter(_: &Arc<GpuContext>) -> Result<(), Failed> {
    for choice in ["no such adapter", "99"] {
        match GpuContext::new(Some(choice)).err() {
            Some(GpuError::UnknownAdapter { asked, known }) => {
                ensure!(asked == choice && known.contains("0: "), "{asked}: {known}");
            }
            other => return Err(format!("{other:?}").into()),
        }
    }
    Ok(())
}

fn adapters_are_chosen_by_name(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let known = adapters();
    ensure!(known.contains(context.info()), "{known:?}");
    let name = context.info().name.to_uppercase();
    let chosen = GpuContext::new(Some(&name))?;
    ensure!(
        chosen.info().name == context.info().name,
        "{:?}",
        chosen.info()
    );
    Ok(())
}

fn invalid_shader(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let shader = Shader {
        label: "broken",
        parts: &["@compute @workgroup_size(1) fn main() { let x: f32 = 1u; }"],
    };
    match context.kernel(&shader, "main", &[]).err() {
        Some(GpuError::Shader {
            label: "broken",
            reason,
        }) => {
            ensure!(reason.contains("broken:1"), "no place: {reason}");
            Ok(())
        }
        other => Err(format!("{other:?}").into()),
    }
}

fn unknown_entry_point(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let error = context.kernel(&SHADER, "main", &[]).err();
    let expected = GpuError::UnknownEntryPoint {
        label: "fill",
        asked: "main".into(),
        known: "fill".into(),
    };
    ensure!(error.as_ref() == Some(&expected), "{error:?}");
    Ok(())
}

fn unbound_slot(context: &Arc<GpuContext>) -> Result<(), Failed> {
    for bindings in [&[][..], &[Binding::None]] {
        let error = context.kernel(&SHADER, "fill", bindings).err();
        let expected = GpuError::Unbound {
            label: "fill",
            slot: 0,
            name: "values".into(),
        };
        ensure!(error.as_ref() == Some(&expected), "{error:?}");
    }
    Ok(())
}

fn wrong_kind_of_binding(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let uniform = context.uniform("uniform", &[0.0_f32; 4])?;
    let error = context.kernel(&SHADER, "fill", &[(&uniform).into()]).err();
    ensure!(
        matches!(error, Some(GpuError::Validation { .. })),
        "{error:?}"
    );
    Ok(())
}

fn recorded_faults_are_typed(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let buffer = context.storage_zeroed("values", 16)?;
    let kernel = context.kernel(&SHADER, "fill", &[(&buffer).into()])?;
    let recorded = context.record("too many workgroups", |cx| {
        kernel.record(cx, [1 << 20, 1, 1]);
        Ok::<_, GpuError>(())
    });
    match recorded.err() {
        Some(GpuError::Validation { what, .. }) => {
            ensure!(what == "too many workgroups", "{what}");
        }
        other => return Err(format!("{other:?}").into()),
    }
    // The context still works.
    context.record("fill", |cx| {
        kernel.record(cx, [1, 1, 1]);
        Ok::<_, GpuError>(())
    })?;
    ensure!(
        context.read_buffer::<f32>(&buffer)?[0] == 1.0,
        "nothing was written"
    );
    Ok(())
}

fn own_errors_pass_through(context: &Arc<GpuContext>) -> Result<(), Failed> {
    #[derive(Debug, PartialEq)]
    enum Own {
        Refused,
        Gpu(GpuError),
    }
    impl From<GpuError> for Own {
        fn from(error: GpuError) -> Self {
            Self::Gpu(error)
        }
    }
    let result = context.record("refused", |_: &mut GpuCx| Err::<(), _>(Own::Refused));
    ensure!(result == Err(Own::Refused), "{result:?}");
    Ok(())
}

fn too_many_points(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let layout = PointLayout::Material;
    let max = context.max_points(layout);
    if max > 4_000_000 {
        // As many points as the device refuses would not fit into a test's memory.
        return Ok(());
    }
    let points = Points::new(layout, std::iter::repeat_n(None, max + 1));
    let error = GpuPoints::upload(context, &points).err();
    let expected = GpuError::TooManyPoints {
        points: max + 1,
        max,
    };
    ensure!(error.as_ref() == Some(&expected), "{error:?}");
    Ok(())
}

fn too_many_lights(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let mut scene = empty(Vec3::ZERO);
    let light = Light::Point {
        position: Vec3::X,
        intensity: Vec3::ONE,
        picture: None,
    };
    scene.lights = vec![light; MAX_LIGHTS + 1];
    let error = GpuScene::new(context, &scene).err();
    let expected = GpuError::TooManyLights {
        lights: MAX_LIGHTS + 1,
        max: MAX_LIGHTS,
    };
    ensure!(error.as_ref() == Some(&expected), "{error:?}");
    Ok(())
}

fn impossible_captures(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let scene = GpuScene::new(context, &empty(Vec3::ZERO))?;
    for size in [0, 1 << 20] {
        let error = context
            .record("capture", |cx| {
                capture_cube(cx, &scene, Vec3::ZERO, everything(size), None)
            })
            .err();
        ensure!(
            matches!(error, Some(GpuError::TextureTooLarge { .. })),
            "{size}: {error:?}"
        );
    }
    let mut image = CubeImage::new(everything(4));
    image.distance.pop();
    let error = GpuCube::upload(context, &image).err();
    let expected = GpuError::CubeImage {
        found: 95,
        expected: 96,
    };
    ensure!(error.as_ref() == Some(&expected), "{error:?}");
    Ok(())
}

fn lost_device(_: &Arc<GpuContext>) -> Result<(), Failed> {
    let context = GpuContext::new(None)?;
    context.device().destroy();
    let recorded = context.record("after the loss", |_| Ok::<_, GpuError>(()));
    ensure!(
        matches!(recorded, Err(GpuError::DeviceLost { .. })),
        "{recorded:?}"
    );
    Ok(())
}
