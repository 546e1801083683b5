//! What a campaign does: scenes × what varies in them × quantities × methods × backends, as a list.
//!
//! Longer than most: from options to tasks is one way, and its unit tests stand with it.

use super::axis::Axis;
use super::run_settings::RunSettings;
use crate::domain::record::{Backend, ParamMap};
use crate::running::context::{Context, request};
use crate::running::error::RunError;
use crate::running::settings::{SCENE, SceneChanges, Setting};
use crate::running::view::Shade;
use crate::running::warning::Warning;
use interreflect_estimators::{Configured, OwnModel, Quantity};
use interreflect_gpu::GpuError;
use interreflect_scene::Scene;
use interreflect_scene::load::open;
use interreflect_scene::params::{self, Choice, FIDELITY, FieldInfo, Value};
use std::collections::BTreeSet;

/// What runs on the scenes of a campaign, and how.
#[derive(Clone, Debug)]
pub(crate) struct Selection {
    /// Methods' ids; all methods if there is none.
    pub(crate) estimators: Vec<String>,
    /// All that a method offers if there is none.
    pub(crate) quantities: Vec<Quantity>,
    pub(crate) settings: Vec<Setting>,
    pub(crate) backends: &'static [Backend],
    /// Points on what is shaded of each scene.
    pub(crate) points: Option<usize>,
    /// Which surfaces are shaded.
    pub(crate) shade: Shade,
    /// Threads of the CPU backend.
    pub(crate) threads: Option<usize>,
    pub(crate) scene_changes: SceneChanges,
}

/// A scene as it is set, and how it is run.
#[derive(Clone, Debug)]
pub(crate) struct Setup {
    /// Name of the scene, with what varies.
    pub(crate) name: String,
    /// Opened once, when the plan was checked.
    pub(crate) scene: Scene,
    pub(crate) run: RunSettings,
    /// What varies of the scene and the run.
    pub(crate) varied: ParamMap,
}

/// Everything that a campaign does, checked before anything is measured.
pub(crate) struct Plan {
    pub(crate) setups: Vec<Setup>,
    pub(crate) methods: Vec<Box<dyn Configured>>,
    pub(crate) quantities: Vec<Quantity>,
    pub(crate) backends: &'static [Backend],
    /// Nothing was asked for by name: what only compares the truth with itself is left out.
    unasked: bool,
}

impl Plan {
    /// Scenes with all that is said of them.
    ///
    /// # Errors
    /// [`RunError`] if a name or a value is wrong.
    pub(crate) fn new(
        context: &Context,
        scenes: &[String],
        what: &Selection,
        axes: &[Axis],
    ) -> Result<Self, RunError> {
        check_axes(axes)?;
        let (of_setup, of_methods): (Vec<&Axis>, Vec<&Axis>) =
            axes.iter().partition(|a| [SCENE, RUN].contains(&&*a.owner));
        let ids = estimators(context, what, &of_methods);
        context.check_owners(&ids, &what.settings)?;
        let mut methods = Vec::new();
        for id in &ids {
            methods.extend(variants(context, id, &what.settings, &of_methods)?);
        }
        Ok(Self {
            setups: setups(scenes, what, &of_setup)?,
            quantities: quantities(what, &methods, &ids)?,
            methods,
            backends: what.backends,
            unasked: what.quantities.is_empty() && what.estimators.is_empty(),
        })
    }

    /// The methods that offer a quantity; none if only path tracing does and nobody asked for it: the
    /// truth would be compared with itself.
    pub(crate) fn methods_for(&self, quantity: Quantity) -> Vec<&dyn Configured> {
        let offered = self.methods.iter().map(|m| &**m);
        let offered: Vec<_> = offered
            .filter(|m| m.quantities().contains(&quantity))
            .collect();
        let mut models = offered.iter().map(|m| m.model(quantity));
        match self.unasked && models.all(|m| matches!(m, OwnModel::LightTransport(_))) {
            true => Vec::new(),
            false => offered,
        }
    }

    /// A GPU that was asked for by name, or alone, has to be there; else its runs are skipped, of which the
    /// warning tells.
    ///
    /// # Errors
    /// [`RunError`] if it is not there.
    pub(crate) fn check_gpu(&self, context: &Context) -> Result<Option<Warning>, RunError> {
        if !self.backends.contains(&Backend::Gpu) {
            return Ok(None);
        }
        let Err(error) = context.gpu() else {
            return Ok(None);
        };
        let alone = self.backends == [Backend::Gpu];
        if alone || matches!(error, GpuError::UnknownAdapter { .. }) {
            return Err(error.into());
        }
        Ok(Some(Warning::NoGpu(error)))
    }
}

/// Owner of the settings of the run.
const RUN: &str = "run";

fn check_axes(axes: &[Axis]) -> Result<(), RunError> {
    for (i, axis) in axes.iter().enumerate() {
        if axes[..i]
            .iter()
            .any(|a| (&a.owner, &a.name) == (&axis.owner, &axis.name))
        {
            return Err(RunError::Usage(format!(
                "--vary {}.{}: it varies already; give all its values at once",
                axis.owner, axis.name
            )));
        }
    }
    Ok(())
}

/// What runs: what is asked for by name and what varies; all, if nothing is said.
fn estimators(context: &Context, what: &Selection, axes: &[&Axis]) -> Vec<String> {
    let named = what.estimators.iter().chain(axes.iter().map(|a| &a.owner));
    let mut ids: Vec<String> = named.cloned().collect();
    if ids.is_empty() {
        let entries = context.registry.entries().iter();
        ids = entries.map(|e| e.info().id.to_owned()).collect();
    }
    keep_first_of_each(&mut ids);
    ids
}

/// A method once for each combination of what varies of it, and in each fidelity unless that is set.
fn variants(
    context: &Context,
    id: &str,
    settings: &[Setting],
    axes: &[&Axis],
) -> Result<Vec<Box<dyn Configured>>, RunError> {
    let own: Vec<&Axis> = axes.iter().copied().filter(|a| a.owner == id).collect();
    let method = context.configure(id, settings)?;
    let set = settings.iter().map(Setting::split);
    let chosen = set
        .filter(|(owner, _)| owner.is_none_or(|owner| owner == id))
        .map(|(_, name)| name)
        .chain(own.iter().map(|a| &*a.name))
        .any(|name| name == FIDELITY);
    let fidelities = match chosen {
        true => vec![method],
        false => method.in_each_fidelity(),
    };
    let mut variants = Vec::new();
    for method in fidelities {
        for combination in combinations(&own) {
            variants.push(context.configured(method.boxed_clone(), &combination)?);
        }
    }
    Ok(variants)
}

/// Every choice of one value of each axis.
fn combinations(axes: &[&Axis]) -> Vec<Vec<Setting>> {
    axes.iter().fold(vec![Vec::new()], |chosen, axis| {
        let with = |settings: &Vec<Setting>| {
            let settings = settings.clone();
            axis.settings().map(move |s| [&settings[..], &[s]].concat())
        };
        chosen.iter().flat_map(with).collect()
    })
}

fn setups(scenes: &[String], what: &Selection, axes: &[&Axis]) -> Result<Vec<Setup>, RunError> {
    let mut setups = Vec::new();
    let mut names = BTreeSet::new();
    for source in scenes {
        for varied in combinations(axes) {
            let mut run = RunSettings::new(what.points, what.shade, what.threads)?;
            for setting in &varied {
                if let (Some(RUN), name) = setting.split() {
                    run.set(name, &setting.value)?;
                }
            }
            let settings = [&what.settings[..], &varied].concat();
            // Everything that can be wrong is found before the first scene is measured.
            let request = request(source, &what.scene_changes, &settings);
            let scene = open(&request)?;
            let setup = Setup {
                name: varied.iter().fold(scene.name.clone(), |name, s| {
                    let short = s.name.strip_prefix("scene.").unwrap_or(&s.name);
                    format!("{name}+{short}={}", s.value)
                }),
                scene,
                varied: declared(&varied, &request.values()?, &params::values(&run)),
                run,
            };
            if !names.insert(setup.name.clone()) {
                return Err(RunError::Usage(format!(
                    "{source}: a scene named `{}` is there already; give each another name",
                    setup.name
                )));
            }
            setups.push(setup);
        }
    }
    Ok(setups)
}

/// Settings with the values that they have by their declaration, of the scene or of the run.
fn declared(
    settings: &[Setting],
    of_scene: &[(FieldInfo, Value)],
    of_run: &[(FieldInfo, Value)],
) -> ParamMap {
    let value = |setting: &Setting| {
        let (owner, name) = setting.split();
        let values = if owner == Some(RUN) { of_run } else { of_scene };
        let (_, value) = values.iter().find(|(field, _)| field.name == name)?;
        Some((setting.name.clone(), *value))
    };
    settings.iter().filter_map(value).collect()
}

fn quantities(
    what: &Selection,
    methods: &[Box<dyn Configured>],
    ids: &[String],
) -> Result<Vec<Quantity>, RunError> {
    let mut quantities = match what.quantities.is_empty() {
        true => Quantity::all().into_iter().map(|(_, q)| q).collect(),
        false => what.quantities.clone(),
    };
    keep_first_of_each(&mut quantities);
    let offered = |q: &Quantity| methods.iter().any(|m| m.quantities().contains(q));
    if !quantities.iter().any(offered) {
        let names: Vec<_> = quantities.iter().map(|q| q.name()).collect();
        return Err(RunError::Usage(format!(
            "none of the estimators {} offers {}",
            ids.join(", "),
            names.join(" or ")
        )));
    }
    quantities.retain(offered);
    Ok(quantities)
}

fn keep_first_of_each<T: Clone + PartialEq>(list: &mut Vec<T>) {
    let mut kept: Vec<T> = Vec::new();
    list.retain(|item| {
        let new = !kept.contains(item);
        kept.push(item.clone());
        new
    });
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]
    use super::*;
    use crate::domain::record::ParamValue;

    /// Whatever their texts look like, and on the way through a file of results.
    #[test]
    fn settings_have_their_declared_types() {
        let settings = [
            ("scene.light", "2"),
            ("scene.receiver.gap", ".5"),
            ("scene.receivers", "3"),
            ("scene.receiver.place", "wall"),
            ("scene.block", "false"),
            ("scene.camera.orbit_deg_per_s", "90"),
            ("run.points", "60"),
        ]
        .map(|(name, value)| Setting {
            name: name.into(),
            value: value.into(),
        });
        let request = request("colored-room", &SceneChanges::default(), &settings);
        let mut run = RunSettings::default();
        run.set("points", "60").unwrap();
        let found = declared(&settings, &request.values().unwrap(), &params::values(&run));
        let values = [
            ParamValue::F32(2.0),
            ParamValue::F32(0.5),
            ParamValue::U32(3),
            ParamValue::Name("wall".into()),
            ParamValue::Bool(false),
            ParamValue::F32(90.0),
            ParamValue::U32(60),
        ];
        let names = settings.iter().map(|s| &*s.name);
        let expected: ParamMap = names.zip(values).collect();
        assert_eq!(found, expected);
        let json = serde_json::to_string(&found).unwrap();
        assert!(json.starts_with(r#"{"scene.light":2.0,"#), "{json}");
        assert_eq!(serde_json::from_str::<ParamMap>(&json).unwrap(), found);
    }
}
