//! Command lines that make a part of the report again.

use crate::domain::record::{GivenOption, Invocation, Run, Scope};

/// Commands that run estimators on scenes.
const VERBS: [&str; 2] = ["bench", "sweep"];

/// Folder of what is made again, so that the whole stays what it is.
const OUT: &str = "again";

/// Makes commands from the one that made a report.
pub(super) struct Commands<'a> {
    whole: &'a Invocation,
}

impl<'a> Commands<'a> {
    /// Commands from a recorded one; `None` if that ran no estimators on scenes.
    pub(super) fn of(whole: &'a Invocation) -> Option<Self> {
        VERBS
            .contains(&whole.verb.as_str())
            .then_some(Self { whole })
    }

    /// The command for all runs of one scene and quantity.
    pub(super) fn section(&self, scene: &str, quantity: &str) -> String {
        let kept = |o: &&GivenOption| o.scope != Scope::Output && o.name != "quantity";
        let words = self.whole.options.iter().filter(kept).flat_map(words);
        self.with(
            &self.whole.verb,
            scene,
            words,
            &[("quantity", quantity.into())],
        )
    }

    /// The command for one run alone; `None` where a file or a range of values, not the command, says how
    /// it was made.
    pub(super) fn run(&self, run: &Run) -> Option<String> {
        let varied = |o: &GivenOption| {
            let value = o.value.as_deref().unwrap_or_default();
            o.name == "vary" && (value.starts_with("scene.") || value.starts_with("run."))
        };
        let from_file = self.whole.verb != VERBS[0]
            && !self.whole.operands.iter().any(|s| holds(s, &run.scene));
        if from_file || self.whole.options.iter().any(varied) {
            return None;
        }
        let of_scene = |o: &GivenOption| {
            let value = o.value.as_deref().unwrap_or_default();
            o.name == "set" && value.starts_with("scene.")
        };
        let kept = |o: &&GivenOption| o.scope == Scope::EveryRun || of_scene(o);
        let words = self.whole.options.iter().filter(kept).flat_map(words);
        let mut own = vec![
            ("estimator", run.estimator.clone()),
            ("quantity", run.quantity.clone()),
            ("backend", run.backend.to_string()),
        ];
        let params = run.params.0.iter();
        own.extend(params.map(|(name, value)| ("set", format!("{name}={value}"))));
        Some(self.with(VERBS[0], &run.scene, words, &own))
    }

    /// A command for one scene with these words and options.
    fn with(
        &self,
        verb: &str,
        scene: &str,
        words: impl Iterator<Item = String>,
        options: &[(&str, String)],
    ) -> String {
        let mut all = vec![self.whole.program.clone(), verb.into()];
        all.extend(self.sources(scene));
        all.extend(words);
        for (name, value) in options {
            all.extend([format!("--{name}"), value.clone()]);
        }
        all.extend(["--out".into(), OUT.into()]);
        quoted(&all)
    }

    /// Where a scene comes from: its name, unless the command line names a file that holds it.
    fn sources(&self, scene: &str) -> Vec<String> {
        let sources = &self.whole.operands;
        match sources.iter().find(|source| holds(source, scene)) {
            Some(source) => vec![source.clone()],
            None if sources.is_empty() => vec![scene.into()],
            // A file may give its scene another name: then all are run.
            None => sources.clone(),
        }
    }
}

/// Whether a source's own name is that of a scene.
fn holds(source: &str, scene: &str) -> bool {
    let stem = std::path::Path::new(source).file_stem();
    source == scene || stem.and_then(|s| s.to_str()) == Some(scene)
}

/// An option as words of a command line.
fn words(option: &GivenOption) -> impl Iterator<Item = String> {
    let name = format!("--{}", option.name);
    std::iter::once(name).chain(option.value.clone())
}

fn quoted(words: &[String]) -> String {
    // Only a NUL can't be quoted, which no argument holds.
    shlex::try_join(words.iter().map(String::as_str)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]
    use super::*;
    use crate::domain::record::Backend;
    use interreflect_scene::params::Value;

    /// `bench 'my room.toml' cave --backend both --set rays=4 --set scene.light=2 --quantity irradiance
    /// --samples 64 --seed 7 --json --estimator texels --points 100 --out results`.
    fn bench() -> Invocation {
        let option = |name: &str, value: &str, scope| GivenOption {
            name: name.into(),
            value: Some(value.into()).filter(|v: &String| !v.is_empty()),
            scope,
        };
        Invocation {
            program: "interreflect".into(),
            verb: "bench".into(),
            operands: vec!["my room.toml".into(), "cave".into()],
            options: vec![
                option("backend", "both", Scope::Selection),
                option("set", "rays=4", Scope::Selection),
                option("set", "scene.light=2", Scope::Selection),
                option("quantity", "irradiance", Scope::Selection),
                option("samples", "64", Scope::EveryRun),
                option("seed", "7", Scope::EveryRun),
                option("json", "", Scope::Output),
                option("estimator", "texels", Scope::Selection),
                option("points", "100", Scope::EveryRun),
                option("out", "results", Scope::Output),
            ],
        }
    }

    #[test]
    fn a_section_s_command_names_its_scene_and_quantity_only() {
        let bench = bench();
        let commands = Commands::of(&bench).unwrap();
        assert_eq!(
            commands.section("my room", "glossy_radiance"),
            "interreflect bench 'my room.toml' --backend both --set 'rays=4' --set 'scene.light=2' \
             --samples 64 --seed 7 --estimator texels --points 100 --quantity glossy_radiance \
             --out again"
        );
        assert!(
            commands
                .section("elsewhere", "irradiance")
                .contains("'my room.toml' cave")
        );
    }

    #[test]
    fn a_run_s_command_sets_all_of_its_parameters() {
        let run = Run {
            params: [("rays", Value::U32(8))].into_iter().collect(),
            ..Run::new("cave", "texels", Backend::Gpu, "irradiance")
        };
        assert_eq!(
            Commands::of(&bench()).unwrap().run(&run).unwrap(),
            "interreflect bench cave --set 'scene.light=2' --samples 64 --seed 7 --points 100 \
             --estimator texels --quantity irradiance --backend gpu --set 'rays=8' --out again"
        );
    }

    #[test]
    fn other_commands_are_left_alone() {
        let merge = Invocation {
            verb: "merge".into(),
            ..bench()
        };
        assert!(Commands::of(&merge).is_none());
    }
}
