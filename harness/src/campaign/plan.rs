//! What a campaign does: scenes × what varies in them × quantities × methods × backends, as a list.

use super::axis::Axis;
use super::run_settings::RunSettings;
use crate::cli::{SceneOptions, Setting, What};
use crate::error::HarnessError;
use crate::lab::{Lab, SCENE, request};
use crate::record::{Backend, ParamMap};
use interreflect_estimators::{Configured, OwnModel, Quantity};
use interreflect_gpu::GpuError;
use interreflect_scene::load::open;
use interreflect_scene::params::{self, Choice, FIDELITY, FieldInfo, Value};
use std::collections::BTreeSet;

/// A scene as it is set, and how it is run.
#[derive(Clone, Debug)]
pub(crate) struct Setup {
    /// Name of the scene, with what varies.
    pub(crate) name: String,
    /// Library name or file.
    pub(crate) source: String,
    pub(crate) settings: Vec<Setting>,
    pub(crate) run: RunSettings,
    /// What varies of the scene and the run.
    pub(crate) varied: ParamMap,
}

/// Everything that a campaign does, checked before anything is measured.
pub(crate) struct Plan {
    pub(crate) setups: Vec<Setup>,
    pub(crate) scene_options: SceneOptions,
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
    /// [`HarnessError`] if a name or a value is wrong.
    pub(crate) fn new(
        lab: &Lab,
        scenes: &[String],
        what: &What,
        axes: &[Axis],
    ) -> Result<Self, HarnessError> {
        check_axes(axes)?;
        let (of_setup, of_methods): (Vec<&Axis>, Vec<&Axis>) =
            axes.iter().partition(|a| [SCENE, RUN].contains(&&*a.owner));
        let ids = estimators(lab, what, &of_methods);
        lab.check_owners(&ids, &what.settings)?;
        let mut methods = Vec::new();
        for id in &ids {
            methods.extend(variants(lab, id, &what.settings, &of_methods)?);
        }
        Ok(Self {
            setups: setups(scenes, what, &of_setup)?,
            scene_options: what.scene.clone(),
            quantities: quantities(what, &methods, &ids)?,
            methods,
            backends: what.backend.list(),
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

    /// A GPU that was asked for by name, or alone, has to be there; else its runs are skipped.
    ///
    /// # Errors
    /// [`HarnessError`] if it is not there.
    pub(crate) fn check_gpu(&self, lab: &Lab) -> Result<(), HarnessError> {
        if !self.backends.contains(&Backend::Gpu) {
            return Ok(());
        }
        let Err(error) = lab.gpu() else {
            return Ok(());
        };
        let alone = self.backends == [Backend::Gpu];
        if alone || matches!(error, GpuError::UnknownAdapter { .. }) {
            return Err(error.into());
        }
        eprintln!("warning: no GPU runs: {error}");
        Ok(())
    }
}

/// Owner of the settings of the run.
const RUN: &str = "run";

fn check_axes(axes: &[Axis]) -> Result<(), HarnessError> {
    for (i, axis) in axes.iter().enumerate() {
        if axes[..i]
            .iter()
            .any(|a| (&a.owner, &a.name) == (&axis.owner, &axis.name))
        {
            return Err(HarnessError::Usage(format!(
                "--vary {}.{}: it varies already; give all its values at once",
                axis.owner, axis.name
            )));
        }
    }
    Ok(())
}

/// What runs: what is asked for by name and what varies; all, if nothing is said.
fn estimators(lab: &Lab, what: &What, axes: &[&Axis]) -> Vec<String> {
    let named = what.estimators.iter().chain(axes.iter().map(|a| &a.owner));
    let mut ids: Vec<String> = named.cloned().collect();
    if ids.is_empty() {
        let entries = lab.registry.entries().iter();
        ids = entries.map(|e| e.info().id.to_owned()).collect();
    }
    keep_first_of_each(&mut ids);
    ids
}

/// A method once for each combination of what varies of it, and in each fidelity unless that is set.
fn variants(
    lab: &Lab,
    id: &str,
    settings: &[Setting],
    axes: &[&Axis],
) -> Result<Vec<Box<dyn Configured>>, HarnessError> {
    let own: Vec<&Axis> = axes.iter().copied().filter(|a| a.owner == id).collect();
    let method = lab.configure(id, settings)?;
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
            variants.push(lab.configured(method.boxed_clone(), &combination)?);
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

fn setups(scenes: &[String], what: &What, axes: &[&Axis]) -> Result<Vec<Setup>, HarnessError> {
    let mut setups = Vec::new();
    let mut names = BTreeSet::new();
    for source in scenes {
        for varied in combinations(axes) {
            let mut run = RunSettings::new(what.points, what.run.threads)?;
            for setting in &varied {
                if let (Some(RUN), name) = setting.split() {
                    run.set(name, &setting.value)?;
                }
            }
            let settings = [&what.settings[..], &varied].concat();
            // Everything that can be wrong is found before the first scene is measured.
            let request = request(source, &what.scene, &settings);
            let scene = open(&request)?;
            let setup = Setup {
                name: varied.iter().fold(scene.name, |name, s| {
                    let short = s.name.strip_prefix("scene.").unwrap_or(&s.name);
                    format!("{name}+{short}={}", s.value)
                }),
                varied: declared(&varied, &request.values()?, &params::values(&run)),
                source: source.clone(),
                settings,
                run,
            };
            if !names.insert(setup.name.clone()) {
                return Err(HarnessError::Usage(format!(
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
    what: &What,
    methods: &[Box<dyn Configured>],
    ids: &[String],
) -> Result<Vec<Quantity>, HarnessError> {
    let mut quantities = match what.quantities.is_empty() {
        true => Quantity::all().into_iter().map(|(_, q)| q).collect(),
        false => what.quantities.clone(),
    };
    keep_first_of_each(&mut quantities);
    let offered = |q: &Quantity| methods.iter().any(|m| m.quantities().contains(q));
    if !quantities.iter().any(offered) {
        let names: Vec<_> = quantities.iter().map(|q| q.name()).collect();
        return Err(HarnessError::Usage(format!(
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
    use crate::record::ParamValue;

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
        let request = request("colored-room", &SceneOptions::default(), &settings);
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
