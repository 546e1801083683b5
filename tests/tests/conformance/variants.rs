//! The methods and backends that trials are made over.

use crate::test_scenes::TestScene;
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::execution::{BackendScene, CpuLoadedScene, Executor, GpuLoadedScene};
use interreflect_estimators::{
    Captures, Configured, EstimatorError, Quantity, Registry, Unsupported,
};
use interreflect_gpu::{GpuContext, GpuError};
use interreflect_scene::params::{Domain, FIDELITY};
use interreflect_scene::{Estimate, Points, SceneFacts};
use libtest_mimic::{Failed, Trial};
use std::rc::Rc;
use std::sync::{Arc, LazyLock};

/// What a trial comes to.
pub(crate) type Outcome = Result<(), Failed>;

/// All threads and the widest instructions.
pub(crate) static CPU: LazyLock<CpuCx> =
    LazyLock::new(|| CpuCx::new(None, None).expect("a pool of threads"));

static GPU: LazyLock<Result<Arc<GpuContext>, GpuError>> = LazyLock::new(|| GpuContext::new(None));

/// A trial on the device.
pub(crate) fn on_gpu(
    name: String,
    test: impl FnOnce(&Arc<GpuContext>) -> Outcome + Send + 'static,
) -> Trial {
    let required = std::env::var_os("INTERREFLECT_REQUIRE_GPU").is_some_and(|v| v == "1");
    match GPU.clone() {
        Ok(context) => Trial::test(name, move || test(&context)),
        Err(reason) if required => Trial::test(name, move || Err(reason.into())),
        Err(_) => ignored(name, "no Vulkan adapter"),
    }
}

/// A trial that does not apply, with the reason.
pub(crate) fn ignored(name: String, reason: &str) -> Trial {
    Trial::test(name, || Ok(()))
        .with_ignored_flag(true)
        .with_kind(reason)
}

/// A method in one fidelity, with one of its quantities.
pub(crate) struct Variant {
    pub(crate) method: Box<dyn Configured>,
    pub(crate) quantity: Quantity,
}

impl Variant {
    /// Name in trials.
    pub(crate) fn name(&self) -> String {
        let fidelity = self.method.fidelity().map(|f| format!(".{f}"));
        let id = self.method.info().id;
        format!(
            "{id}{}/{}",
            fidelity.unwrap_or_default(),
            self.quantity.name()
        )
    }

    /// Whether it runs on the device; if not, why.
    pub(crate) fn gpu(&self) -> Result<(), &'static str> {
        let registry = Registry::builtin();
        let entry = registry.get(self.method.info().id);
        entry.map_err(|_| "not registered")?.gpu()
    }

    /// Why it can't run in a scene on the CPU, if it can't: a result, which trials show.
    pub(crate) fn unsupported(&self, test_scene: &TestScene) -> Option<String> {
        let facts = test_scene.cpu.scene().facts();
        let needs = self.method.needs(self.quantity, &facts).map(drop);
        let opened = needs.and_then(|()| self.method.on_cpu().map(drop));
        opened.err().map(|why| why.to_string())
    }

    /// Why it can't run in a scene on the device, if there is one and it can't.
    pub(crate) fn unsupported_on_gpu(&self, test_scene: &TestScene) -> Option<String> {
        let facts = test_scene.cpu.scene().facts();
        let needs = self.method.needs(self.quantity, &facts).map(drop);
        let opened = needs.and_then(|()| match &*GPU {
            Ok(context) => self.method.on_gpu(context).map(drop),
            Err(_) => self.gpu().map_err(|why| Unsupported(why.into())),
        });
        opened.err().map(|why| why.to_string())
    }

    /// Whether it can run in a scene on the device that is there.
    pub(crate) fn runs_in(&self, test_scene: &TestScene) -> bool {
        self.unsupported_on_gpu(test_scene).is_none()
    }

    /// Runs it in a scene.
    pub(crate) fn executor<'s, S: BackendScene>(
        &self,
        loaded: &'s S,
        points: &'s Points,
    ) -> Result<Executor<'s, S::Backend>, EstimatorError> {
        loaded.executor(&*self.method, self.quantity, points)
    }

    pub(crate) fn copy(&self) -> Self {
        Self {
            method: self.method.boxed_clone(),
            ..*self
        }
    }
}

/// Every registered method in each fidelity and quantity; `captured` texels along the edge of a
/// captured cube, where the method lets that be chosen.
pub(crate) fn variants(captured: u32) -> Vec<Variant> {
    let mut variants = Vec::new();
    for entry in Registry::builtin().entries() {
        let mut method = entry.configure();
        // Not every method has these; those that sample need not sample long here, those that
        // convolve need not fill large maps.
        method.set("capture_resolution", &captured.to_string()).ok();
        method.set("samples", "64").ok();
        let convolves = method.values().iter().any(|(f, _)| f.name == "resolution");
        let map = if convolves { 8 } else { captured };
        method.set("map_resolution", &map.to_string()).ok();
        for method in method.in_each_fidelity() {
            variants.extend(method.quantities().iter().map(|&quantity| Variant {
                method: method.boxed_clone(),
                quantity,
            }));
        }
    }
    variants
}

/// Every variant with one of its switches (parameters that are one of a few names, or true or false)
/// away from its default, and that setting's name.
pub(crate) fn switched(captured: u32) -> Vec<(Variant, String)> {
    let mut all = Vec::new();
    for variant in variants(captured) {
        for (field, default) in variant.method.values() {
            let names: Vec<&str> = match &field.domain {
                Domain::OneOf(names) if field.name != FIDELITY => names.to_vec(),
                Domain::Bool => vec!["true", "false"],
                _ => continue,
            };
            for name in names.into_iter().filter(|n| *n != default.to_string()) {
                let mut switched = variant.copy();
                let set = switched.method.set(field.name, name);
                set.expect("a value of the parameter's own domain");
                all.push((switched, format!("{}={name}", field.name)));
            }
        }
    }
    all
}

/// A method of this id with these parameters set.
pub(crate) fn configured(
    id: &str,
    quantity: Quantity,
    settings: &[(&str, &str)],
) -> Result<Variant, Failed> {
    let mut method = Registry::builtin().get(id)?.configure();
    for (name, value) in settings {
        method.set(name, value)?;
    }
    Ok(Variant { method, quantity })
}

/// A check on a loaded of either backend.
type Check<S> = fn(&S, &'static TestScene) -> Outcome;

/// One trial on each backend.
pub(crate) fn on_both(
    name: &str,
    test_scene: impl Fn() -> &'static TestScene + Copy + Send + 'static,
    cpu: Check<CpuLoadedScene>,
    gpu: Check<GpuLoadedScene>,
) -> [Trial; 2] {
    let on_cpu = Trial::test(format!("{name}/cpu"), move || {
        cpu(&cpu_scene(test_scene()), test_scene())
    });
    let on_device = on_gpu(format!("{name}/gpu"), move |context| {
        gpu(&gpu_scene(context, test_scene())?, test_scene())
    });
    [on_cpu, on_device]
}

/// The variants whose captured radiance can hold further reflections, holding two.
pub(crate) fn bounced(captured: u32) -> Vec<Variant> {
    let mut all = variants(captured);
    let facts = SceneFacts {
        captured_surfaces: true,
        ..SceneFacts::default()
    };
    all.retain_mut(|variant| {
        let set = variant.method.set("bounces", "2").is_ok();
        let needs = variant.method.needs(variant.quantity, &facts);
        set && needs.is_ok_and(|needs| needs.cubes.iter().any(|spec| spec.bounces == 2))
    });
    all
}

/// A scene on the CPU.
pub(crate) fn cpu_scene(test_scene: &TestScene) -> CpuLoadedScene {
    CpuLoadedScene::new(&CPU, test_scene.cpu.clone())
}

/// A scene on the GPU.
pub(crate) fn gpu_scene(
    context: &Arc<GpuContext>,
    test_scene: &TestScene,
) -> Result<GpuLoadedScene, Failed> {
    Ok(GpuLoadedScene::new(context, cpu_scene(test_scene))?)
}

/// The captures that a method declares.
pub(crate) fn captures<S: BackendScene>(
    loaded: &S,
    variant: &Variant,
) -> Result<Rc<Captures<S::Backend>>, Failed> {
    let facts = loaded.scene().facts();
    let needs = variant.method.needs(variant.quantity, &facts)?;
    Ok(Rc::new(loaded.capture(&needs)?.0))
}

/// Prepares and shades with these captures.
pub(crate) fn estimate<S: BackendScene>(
    loaded: &S,
    variant: &Variant,
    captures: &Rc<Captures<S::Backend>>,
    points: &Points,
) -> Result<Estimate, Failed> {
    let mut executor = variant.executor(loaded, points)?;
    executor.set_captures(captures.clone());
    Ok(executor.estimate()?)
}

/// Captures, prepares and shades.
pub(crate) fn run<S: BackendScene>(
    loaded: &S,
    variant: &Variant,
    points: &Points,
) -> Result<Estimate, Failed> {
    Ok(variant.executor(loaded, points)?.estimate()?)
}
