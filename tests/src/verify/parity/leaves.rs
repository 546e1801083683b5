//! Leaf functions: on the device, in float32, alone and in lanes, and in float64 the same for one table
//! of inputs.

use super::{Finding, Found, MethodUnderTest};
use interreflect_cpu::lane::{Lane, WIDTH, Wide};
use interreflect_estimators::leaves::{ARGUMENTS, Call, Input, Leaf, Leaves, RESULTS};
use interreflect_estimators::{ANGLE, EstimatorError, LOBE_POWER, texels};
use interreflect_gpu::{GpuContext, GpuError, Shader, wgsl};
use std::sync::Arc;

/// All leaf functions of a method, on the host and on the device.
pub(super) fn parity(under_test: &MethodUnderTest<'_>, context: &Arc<GpuContext>) -> Found {
    let leaves = under_test.method.leaves();
    let mut finding = Finding::default();
    for leaf in leaves.functions {
        finding.cases += (leaf.inputs)().len();
        let on_device = || match on_device(context, leaves, leaf) {
            Ok(compared) => compared,
            Err(why) => Err(why.to_string()),
        };
        if let Err(why) = on_host(leaf).and_then(|()| on_device()) {
            finding.value += 1.0;
            finding.note = why;
        }
    }
    Ok(finding)
}

/// A leaf function on the host, in float32 against float64, and in lanes bit for bit as alone.
///
/// # Errors
/// A line that names the inputs and the difference.
pub fn on_host(leaf: &Leaf) -> Result<(), String> {
    let Some(f32) = leaf.calls.f32 else {
        return Ok(());
    };
    let inputs = (leaf.inputs)();
    for input in &inputs {
        compare(leaf, input, &f32(input))?;
    }
    match leaf.calls.lanes {
        Some(lanes) => inputs
            .chunks(WIDTH)
            .try_for_each(|inputs| same_in_lanes(leaf.name, inputs, f32, lanes)),
        None => Ok(()),
    }
}

/// Up to sixteen inputs side by side give the bits that each gives by itself.
fn same_in_lanes(
    name: &str,
    inputs: &[Input],
    f32: Call<f32>,
    lanes: Call<Wide>,
) -> Result<(), String> {
    let input = |lane: usize| &inputs[lane.min(inputs.len() - 1)];
    let side_by_side = std::array::from_fn(|k| Wide::by_lane(|lane| input(lane)[k]));
    let found = lanes(&side_by_side);
    for lane in 0..WIDTH {
        let found: Vec<f32> = found.iter().map(|all| all.lanes()[lane]).collect();
        let alone = f32(input(lane));
        let bits = |values: &[f32]| -> Vec<u32> { values.iter().map(|v| v.to_bits()).collect() };
        if bits(&found) != bits(&alone) {
            return Err(format!(
                "{name} of {:?} is {alone:?}, in lane {lane} {found:?}",
                input(lane)
            ));
        }
    }
    Ok(())
}

fn compare(leaf: &Leaf, input: &Input, found: &[f32]) -> Result<(), String> {
    let exact = (leaf.calls.f64)(&input.map(f64::from));
    for (i, (exact, found)) in exact.iter().zip(found).enumerate() {
        let checked = leaf.tolerance.check(*exact, f64::from(*found));
        checked.map_err(|e| format!("{} of {input:?}, result {i}: {e}", leaf.name))?;
    }
    Ok(())
}

/// A leaf function in WGSL against float64: `Err` within if they differ.
///
/// # Errors
/// [`EstimatorError`] if the device refuses the shader or fails.
pub fn on_device(
    context: &Arc<GpuContext>,
    leaves: &Leaves,
    leaf: &Leaf,
) -> Result<Result<(), String>, EstimatorError> {
    let inputs = (leaf.inputs)();
    let shader = shader(leaves, leaf);
    let input = context.storage("inputs", inputs.as_flattened())?;
    let output = context.storage_zeroed("outputs", (inputs.len() * 4 * RESULTS) as u64)?;
    let kernel = context.kernel(&shader, "leaf", &[(&input).into(), (&output).into()])?;
    context.record("leaf", |cx| {
        kernel.record(cx, [(inputs.len() as u32).div_ceil(64), 1, 1]);
        Ok::<_, GpuError>(())
    })?;
    let found: Vec<f32> = context.read_buffer(&output)?;
    let pairs = inputs.iter().zip(found.chunks_exact(RESULTS));
    let mut pairs = pairs.map(|(input, found)| compare(leaf, input, found));
    Ok(pairs.find(Result::is_err).unwrap_or(Ok(())))
}

/// A shader that calls the function for each input. Its parts live as long as the program, as those of
/// all shaders do.
fn shader(leaves: &Leaves, leaf: &Leaf) -> Shader {
    let entry = format!(
        "@group(0) @binding(0) var<storage, read> inputs: array<array<f32, {ARGUMENTS}>>;\n\
         @group(0) @binding(1) var<storage, read_write> outputs: array<vec4f>;\n\
         @compute @workgroup_size(64)\n\
         fn leaf(@builtin(global_invocation_id) id: vec3u) {{\n\
         if id.x >= arrayLength(&inputs) {{ return; }}\n\
         let a = inputs[id.x];\n\
         {}\n}}\n",
        leaf.wgsl
    );
    // What leaf functions may use, each once.
    let shared = [
        wgsl::MATH,
        wgsl::CUBE,
        LOBE_POWER,
        ANGLE,
        texels::leaves::LEAVES.wgsl,
    ];
    let mut parts = shared.to_vec();
    if !shared.contains(&leaves.wgsl) {
        parts.push(leaves.wgsl);
    }
    parts.push(entry.leak());
    Shader {
        label: "leaf function",
        parts: parts.leak(),
    }
}
