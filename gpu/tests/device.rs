//! Tests on a real device. Without an adapter they show as ignored, with the reason; with
//! `INTERREFLECT_REQUIRE_GPU=1` they then fail.

#[path = "device/capture.rs"]
mod capture;
#[path = "device/coarse.rs"]
mod coarse;
#[path = "device/compute.rs"]
mod compute;
#[path = "device/errors.rs"]
mod errors;
#[path = "device/grid.rs"]
mod grid;
#[path = "device/lighting.rs"]
mod lighting;
#[path = "device/oracle.rs"]
mod oracle;
#[path = "device/times.rs"]
mod times;

use interreflect_gpu::{GpuContext, GpuError};
use libtest_mimic::{Arguments, Failed, Trial};
use std::sync::Arc;

/// A test: what it is called, and what it does on the device.
type Case = (&'static str, fn(&Arc<GpuContext>) -> Result<(), Failed>);

fn main() {
    let arguments = Arguments::from_args();
    let context = GpuContext::new(None);
    match &context {
        Ok(context) => eprintln!("device tests run on {:?}", context.info()),
        Err(reason) => eprintln!("device tests can't run: {reason}"),
    }
    let required = std::env::var_os("INTERREFLECT_REQUIRE_GPU").is_some_and(|v| v == "1");
    let cases = [
        capture::CASES,
        coarse::CASES,
        lighting::CASES,
        compute::CASES,
        grid::CASES,
        times::CASES,
        errors::CASES,
    ]
    .concat();
    let trials = cases
        .into_iter()
        .map(|case| trial(case, &context, required));
    libtest_mimic::run(&arguments, trials.collect()).exit();
}

fn trial(case: Case, context: &Result<Arc<GpuContext>, GpuError>, required: bool) -> Trial {
    let (name, test) = case;
    match context.clone() {
        Ok(context) => Trial::test(name, move || test(&context)),
        Err(reason) if required => Trial::test(name, move || Err(reason.into())),
        Err(_) => Trial::test(name, || Ok(()))
            .with_ignored_flag(true)
            .with_kind("no Vulkan adapter"),
    }
}

/// Fails with a message unless the condition holds.
macro_rules! ensure {
    ($condition:expr, $($message:tt)*) => {
        let holds: bool = $condition;
        if !holds {
            return Err(format!($($message)*).into());
        }
    };
}
pub(crate) use ensure;
