//! `verify`: every check that an estimator faces.

mod extremes;
mod table;

use super::{print_json, print_line};
use crate::command_line::cli::Verify;
use crate::command_line::error::CommandError;
use crate::domain::files::write_json;
use crate::domain::record::Backend;
use crate::running::context::Context;
use interreflect_conformance::verify::{
    Check, Checked, MethodUnderTest, TestBackend, Verdict, checks, quick,
};
use interreflect_estimators::{Configured, Quantity, Registry};
use interreflect_gpu::GpuError;
use interreflect_scene::params::FIDELITY;
use serde::Serialize;

/// What `verify --json` prints.
#[derive(Serialize)]
struct Verified {
    checks: Vec<Record>,
}

/// One check of one estimator in one fidelity, quantity and backend.
#[derive(Serialize)]
struct Record {
    estimator: &'static str,
    fidelity: Option<&'static str>,
    quantity: &'static str,
    backend: Backend,
    check: &'static str,
    verdict: &'static str,
    /// The worst that was met; `null` where nothing ran.
    value: Option<f64>,
    bound: Option<f64>,
    cases: usize,
    /// Where the worst was met, why there is a bound, or why nothing ran.
    note: String,
    /// How to see it fail.
    #[serde(skip_serializing_if = "Option::is_none")]
    command: Option<String>,
}

pub(super) fn run(
    command: &Verify,
    registry: Registry,
    own: Vec<Check>,
) -> Result<(), CommandError> {
    let context = Context::new(registry, &command.run.context())?;
    let ids = estimators(&context, command)?;
    context.check_owners(&ids, &command.settings)?;
    let chosen = chosen(command, own)?;
    let mut methods = Vec::new();
    for id in &ids {
        methods.extend(variants(&context, command, id)?);
    }
    // A device that is not there is a reason where both backends are asked for.
    if command.backend.list() == [Backend::Gpu] {
        context.gpu()?;
    }
    if command.extremes {
        return extremes::run(&context, command, &methods);
    }
    let mut records = Vec::new();
    let total = methods.len() * command.backend.list().len();
    let bar = crate::command_line::progress::bar("checking", total as u64);
    for (method, quantity) in &methods {
        for &backend in command.backend.list() {
            bar.set_message(format!("{} on {backend}", method.info().id));
            records.extend(checked(
                &context,
                command,
                &chosen,
                (&**method, *quantity),
                backend,
            ));
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    finish(command, Verified { checks: records })
}

/// The estimators that are asked for, all if none is.
fn estimators(context: &Context, command: &Verify) -> Result<Vec<String>, CommandError> {
    for id in &command.estimators {
        context.registry.get(id)?;
    }
    if !command.estimators.is_empty() {
        return Ok(command.estimators.clone());
    }
    let all = context.registry.entries().iter();
    Ok(all.map(|e| e.info().id.to_owned()).collect())
}

/// The checks that are asked for.
fn chosen(command: &Verify, own: Vec<Check>) -> Result<Vec<Check>, CommandError> {
    let all: Vec<Check> = checks().chain(own).collect();
    for name in &command.checks {
        if !all.iter().any(|check| check.name == name) {
            let names: Vec<&str> = all.iter().map(|check| check.name).collect();
            return Err(CommandError::Usage(format!(
                "there is no check `{name}`; known: {}",
                names.join(", ")
            )));
        }
    }
    let asked = |check: &Check| {
        command.checks.is_empty() || command.checks.iter().any(|name| name == check.name)
    };
    Ok(all.into_iter().filter(asked).collect())
}

type Variant = (Box<dyn Configured>, Quantity);

/// A method in each fidelity, unless one is set, with each quantity that is asked for.
fn variants(context: &Context, command: &Verify, id: &str) -> Result<Vec<Variant>, CommandError> {
    let mut method = context.registry.get(id)?.configure();
    quick(&mut *method);
    let method = context.configured(method, &command.settings)?;
    let set = command.settings.iter().any(|setting| {
        let (owner, name) = setting.split();
        name == FIDELITY && owner.is_none_or(|owner| owner == id)
    });
    let fidelities = match set {
        true => vec![method],
        false => method.in_each_fidelity(),
    };
    let mut variants = Vec::new();
    for method in fidelities {
        for &quantity in method.quantities() {
            if command.quantities.is_empty() || command.quantities.contains(&quantity) {
                variants.push((method.boxed_clone(), quantity));
            }
        }
    }
    Ok(variants)
}

/// All checks of one variant on one backend.
fn checked(
    context: &Context,
    command: &Verify,
    chosen: &[Check],
    (method, quantity): (&dyn Configured, Quantity),
    backend: Backend,
) -> Vec<Record> {
    let under_test = under_test(context, command, (method, quantity), backend);
    let carry_out = |check: &Check| match &under_test {
        Ok(under_test) => check.run(under_test),
        Err(error) => no_device(error),
    };
    let record = |check: &Check| {
        let checked = carry_out(check);
        let failed = checked.verdict == Verdict::Failed;
        let command = || reproduction(command, (method, quantity), backend, check, &checked);
        let finding = checked.finding.as_ref();
        let note = finding.map_or("", |f| &f.note);
        let parts = [checked.reason.as_str(), note];
        let parts: Vec<&str> = parts.into_iter().filter(|p| !p.is_empty()).collect();
        Record {
            estimator: method.info().id,
            fidelity: method.fidelity(),
            quantity: quantity.name(),
            backend,
            check: check.name,
            verdict: checked.verdict.name(),
            value: finding.map(|f| f.value).filter(|v| v.is_finite()),
            bound: finding.map(|f| f.bound),
            cases: finding.map_or(0, |f| f.cases),
            note: parts.join("; "),
            command: failed.then(command),
        }
    };
    chosen.iter().map(record).collect()
}

/// A variant on a backend, if it is there.
fn under_test<'a>(
    context: &'a Context,
    command: &Verify,
    (method, quantity): (&'a dyn Configured, Quantity),
    backend: Backend,
) -> Result<MethodUnderTest<'a>, GpuError> {
    Ok(MethodUnderTest {
        backend: match backend {
            Backend::Cpu => TestBackend::Cpu(&context.cpu),
            Backend::Gpu => TestBackend::Gpu(&context.cpu, context.gpu()?),
        },
        method,
        quantity,
        cases: command.cases as u32,
        seed: context.seed,
        case: command.case.clone(),
    })
}

fn no_device(error: &GpuError) -> Checked {
    Checked {
        verdict: Verdict::NotApplicable,
        finding: None,
        reason: error.to_string(),
    }
}

/// The command that reproduces a failed check in its smallest box scene.
fn reproduction(
    command: &Verify,
    (method, quantity): (&dyn Configured, Quantity),
    backend: Backend,
    check: &Check,
    checked: &Checked,
) -> String {
    let id = method.info().id;
    let mut words = format!(
        "interreflect verify --estimator {id} --quantity {} --backend {backend} --check {}",
        quantity.name(),
        check.name
    );
    if let Some(fidelity) = method.fidelity() {
        words += &format!(" --set {FIDELITY}={fidelity}");
    }
    for setting in &command.settings {
        let (owner, name) = setting.split();
        if owner.is_none_or(|owner| owner == id) && name != FIDELITY {
            words += &format!(" --set {name}={}", setting.value);
        }
    }
    let case = checked
        .finding
        .as_ref()
        .and_then(|f| f.counterexample.as_ref());
    match case {
        Some(case) => words + &format!(" --case '{case}'"),
        None => words + &format!(" --cases {} --seed {}", command.cases, command.run.seed),
    }
}

fn finish(command: &Verify, verified: Verified) -> Result<(), CommandError> {
    if let Some(folder) = &command.out {
        write_json(&folder.join("verify.json"), &verified)?;
    }
    if command.json {
        print_json(&verified)?;
    } else {
        let detailed = !command.estimators.is_empty() || !command.checks.is_empty();
        print_line(&table::of(&verified.checks, detailed))?;
    }
    let with = |verdict: Verdict| {
        let records = verified.checks.iter();
        records.filter(|r| r.verdict == verdict.name()).count()
    };
    match with(Verdict::Failed) {
        0 => Ok(()),
        failed => Err(CommandError::Falsified {
            failed,
            checks: verified.checks.len() - with(Verdict::NotApplicable),
        }),
    }
}
