//! Leaf functions: every `pub fn` of a method's math.rs gives, on the device, in float32, alone
//! and in lanes, and in float64 the same for one table of inputs as the WGSL function of its name.

mod table;

use crate::ensure;
use crate::world::{Outcome, on_gpu};
use interreflect_conformance::tolerance::Tolerance;
use interreflect_cpu::lane::{Lane, WIDTH, Wide};
use interreflect_gpu::{GpuContext, Shader, wgsl};
use libtest_mimic::{Failed, Trial};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use table::{CPU_ONLY, twins};

/// Numbers that a function takes, at most.
pub(crate) const ARGUMENTS: usize = 16;

/// Numbers that a function returns, at most.
pub(crate) const RESULTS: usize = 4;

/// A call in Rust, over numbers of one precision.
pub(crate) type Call<T> = fn(&[T; ARGUMENTS]) -> Vec<T>;

/// A function in the arithmetics that it is generic over.
pub(crate) struct Calls {
    pub(crate) f64: Call<f64>,
    pub(crate) f32: Option<Call<f32>>,
    /// Sixteen inputs side by side.
    pub(crate) lanes: Option<Call<Wide>>,
}

/// A leaf function with its table of inputs.
pub(crate) struct Twin {
    /// Folder of the method; empty for what all share.
    pub(crate) method: &'static str,
    /// Name in Rust and in WGSL.
    pub(crate) name: &'static str,
    /// The call in WGSL: a `vec4f` of the results, from the numbers in `a`.
    pub(crate) wgsl: &'static str,
    /// The calls in Rust.
    pub(crate) calls: Calls,
    /// The inputs.
    pub(crate) inputs: fn() -> Vec<[f32; ARGUMENTS]>,
    /// How far f32 may be from f64.
    pub(crate) tolerance: Tolerance,
}

pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = vec![Trial::test("twins/complete", complete)];
    for twin in twins() {
        let name = match twin.method {
            "" => format!("twins/{}", twin.name),
            method => format!("twins/{method}/{}", twin.name),
        };
        if let Some(f32) = twin.calls.f32 {
            trials.push(Trial::test(format!("{name}/cpu"), move || {
                on_cpu(twin, f32)
            }));
        }
        trials.push(on_gpu(format!("{name}/gpu"), move |context| {
            on_device(context, twin)
        }));
    }
    trials
}

fn on_cpu(twin: &Twin, f32: Call<f32>) -> Outcome {
    let inputs = (twin.inputs)();
    for input in &inputs {
        compare(twin, input, &f32(input))?;
    }
    match twin.calls.lanes {
        Some(lanes) => inputs
            .chunks(WIDTH)
            .try_for_each(|inputs| same_in_lanes(twin.name, inputs, f32, lanes)),
        None => Ok(()),
    }
}

/// Up to sixteen inputs side by side give the bits that each gives by itself.
fn same_in_lanes(
    name: &str,
    inputs: &[[f32; ARGUMENTS]],
    f32: Call<f32>,
    lanes: Call<Wide>,
) -> Outcome {
    let input = |lane: usize| &inputs[lane.min(inputs.len() - 1)];
    let side_by_side = std::array::from_fn(|k| Wide::by_lane(|lane| input(lane)[k]));
    let found = lanes(&side_by_side);
    for lane in 0..WIDTH {
        let found: Vec<f32> = found.iter().map(|all| all.lanes()[lane]).collect();
        let alone = f32(input(lane));
        let bits = |values: &[f32]| -> Vec<u32> { values.iter().map(|v| v.to_bits()).collect() };
        ensure!(
            bits(&found) == bits(&alone),
            "{name} of {:?} is {alone:?}, in lane {lane} {found:?}",
            input(lane)
        );
    }
    Ok(())
}

fn compare(twin: &Twin, input: &[f32; ARGUMENTS], found: &[f32]) -> Outcome {
    let exact = (twin.calls.f64)(&input.map(f64::from));
    for (i, (exact, found)) in exact.iter().zip(found).enumerate() {
        let checked = twin.tolerance.check(*exact, f64::from(*found));
        checked.map_err(|e| format!("{} of {input:?}, result {i}: {e}", twin.name))?;
    }
    Ok(())
}

/// The folder of the estimators' sources.
fn sources() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../estimators/src"))
}

fn read(path: &Path) -> Result<String, Failed> {
    std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()).into())
}

/// What methods share that sum over texels; their leaf functions may use its own.
const TEXELS: &str = "texels";

/// The WGSL leaf functions of a folder.
fn leaves(folder: &str) -> Result<String, Failed> {
    read(&sources().join(folder).join("math.wgsl"))
}

fn on_device(context: &Arc<GpuContext>, twin: &Twin) -> Outcome {
    let inputs = (twin.inputs)();
    let own = match twin.method {
        "" | TEXELS => String::new(),
        method => leaves(method)?,
    };
    let shader = shader([
        wgsl::MATH.into(),
        wgsl::CUBE.into(),
        read(&sources().join("lobe_power.wgsl"))?,
        read(&sources().join("angle.wgsl"))?,
        leaves(TEXELS)?,
        own,
        format!(
            "@group(0) @binding(0) var<storage, read> inputs: array<array<f32, {ARGUMENTS}>>;\n\
             @group(0) @binding(1) var<storage, read_write> outputs: array<vec4f>;\n\
             @compute @workgroup_size(64)\n\
             fn twin(@builtin(global_invocation_id) id: vec3u) {{\n\
             if id.x >= arrayLength(&inputs) {{ return; }}\n\
             let a = inputs[id.x];\n\
             {}\n}}\n",
            twin.wgsl
        ),
    ]);
    let input = context.storage("inputs", inputs.as_flattened())?;
    let output = context.storage_zeroed("outputs", (inputs.len() * 4 * RESULTS) as u64)?;
    let kernel = context.kernel(&shader, "twin", &[(&input).into(), (&output).into()])?;
    context.record("twin", |cx| {
        kernel.record(cx, [(inputs.len() as u32).div_ceil(64), 1, 1]);
        Ok::<_, interreflect_gpu::GpuError>(())
    })?;
    let found: Vec<f32> = context.read_buffer(&output)?;
    for (input, found) in inputs.iter().zip(found.chunks_exact(RESULTS)) {
        compare(twin, input, found)?;
    }
    Ok(())
}

/// A shader of parts that live as long as the program, as all shaders do.
fn shader(parts: [String; 7]) -> Shader {
    let parts = parts.map(|part| &*part.leak());
    Shader {
        label: "twin",
        parts: Vec::leak(parts.to_vec()),
    }
}

/// Names of the functions of a source that begin a line with `start`.
fn functions(source: &str, start: &str) -> Vec<String> {
    let rest = source.lines().filter_map(|line| line.strip_prefix(start));
    rest.map(|rest| {
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
        rest[..end.unwrap_or(rest.len())].to_owned()
    })
    .collect()
}

/// Each function of a math.rs has a WGSL twin and a table, or is listed as the host's alone; each
/// function of a math.wgsl has its original.
fn complete() -> Outcome {
    let mut known = 0;
    for entry in std::fs::read_dir(sources())? {
        let folder = entry?.path();
        if !folder.join("math.rs").exists() {
            continue;
        }
        let method = folder.file_name().unwrap_or_default().to_string_lossy();
        let rust = functions(&read(&folder.join("math.rs"))?, "pub fn ");
        let wgsl = functions(&read(&folder.join("math.wgsl"))?, "fn ");
        for name in &rust {
            let listed = CPU_ONLY.contains(&(&method, name));
            let tested = twins().any(|t| t.method == method && t.name == name);
            ensure!(
                wgsl.contains(name) != listed,
                "{method}: `{name}` has to have a WGSL twin or to be listed as the host's alone"
            );
            ensure!(
                tested != listed,
                "{method}: `{name}` has no table of inputs"
            );
            known += 1;
        }
        for name in &wgsl {
            ensure!(
                rust.contains(name),
                "{method}: WGSL's `{name}` has no original"
            );
        }
    }
    let shared = twins().filter(|t| t.method.is_empty()).count();
    ensure!(
        known + shared == twins().count() + CPU_ONLY.len(),
        "the table has functions that are not there any more"
    );
    Ok(())
}
