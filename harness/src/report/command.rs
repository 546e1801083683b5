//! Command lines that make a part of the report again.

use crate::cli::Cli;
use crate::record::Run;
use clap::CommandFactory as _;

/// Commands that run estimators on scenes.
const VERBS: [&str; 2] = ["bench", "sweep"];

/// Headings of options that hold for every run alike.
const SHARED: [&str; 4] = ["Timing", "Scene", "Reference", "Run"];

/// Options that are not for a part.
const WHOLE: [&str; 4] = ["quantity", "json", "tev", "out"];

/// Folder of what is made again, so that the whole stays what it is.
const OUT: &str = "again";

/// A command line that runs estimators, taken apart.
pub(super) struct BenchCommand {
    program: String,
    verb: String,
    scenes: Vec<String>,
    options: Vec<GivenOption>,
}

/// An option as it was given.
struct GivenOption {
    name: String,
    /// Whether it holds for every run alike.
    shared: bool,
    value: Option<String>,
}

impl BenchCommand {
    /// Takes a command apart; `None` if it is another.
    pub(super) fn parse(command: &str) -> Option<Self> {
        let mut words = shlex::split(command)?.into_iter();
        let (program, verb) = (words.next()?, words.next()?);
        let cli = Cli::command();
        let known_verb = VERBS.contains(&verb.as_str());
        let bench = cli.find_subcommand(&verb).filter(|_| known_verb)?;
        let mut parsed = Self {
            program,
            verb,
            scenes: Vec::new(),
            options: Vec::new(),
        };
        while let Some(word) = words.next() {
            let Some(option) = word.strip_prefix("--") else {
                parsed.scenes.push(word);
                continue;
            };
            let (name, value) = match option.split_once('=') {
                Some((name, value)) => (name, Some(value.to_owned())),
                None => (option, None),
            };
            let known = bench.get_arguments().find(|a| a.get_long() == Some(name))?;
            let takes = known.get_action().takes_values() && !known.is_require_equals_set();
            parsed.options.push(GivenOption {
                name: name.into(),
                shared: !WHOLE.contains(&name)
                    && (known
                        .get_help_heading()
                        .is_some_and(|h| SHARED.contains(&h))
                        || ["points", "repeat"].contains(&name)),
                value: if takes {
                    value.or_else(|| words.next())
                } else {
                    value
                },
            });
        }
        Some(parsed)
    }

    /// The command for all runs of one scene and quantity.
    pub(super) fn section(&self, scene: &str, quantity: &str) -> String {
        let kept = |o: &&GivenOption| !WHOLE.contains(&o.name.as_str());
        let words = self.options.iter().filter(kept);
        let words = words.flat_map(GivenOption::words);
        self.with(&self.verb, scene, words, &[("quantity", quantity.into())])
    }

    /// The command for one run alone; `None` where a file or a range of values, not the command, says how
    /// it was made.
    pub(super) fn run(&self, run: &Run) -> Option<String> {
        let varied = |o: &GivenOption| {
            let value = o.value.as_deref().unwrap_or_default();
            o.name == "vary" && (value.starts_with("scene.") || value.starts_with("run."))
        };
        let from_file = self.verb != VERBS[0] && !self.scenes.iter().any(|s| holds(s, &run.scene));
        if from_file || self.options.iter().any(varied) {
            return None;
        }
        let of_scene = |o: &GivenOption| {
            let value = o.value.as_deref().unwrap_or_default();
            o.name == "set" && value.starts_with("scene.")
        };
        let kept = |o: &&GivenOption| o.shared || of_scene(o);
        let words = self
            .options
            .iter()
            .filter(kept)
            .flat_map(GivenOption::words);
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
        let mut all = vec![self.program.clone(), verb.into()];
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
        match self.scenes.iter().find(|source| holds(source, scene)) {
            Some(source) => vec![source.clone()],
            None if self.scenes.is_empty() => vec![scene.into()],
            // A file may give its scene another name: then all are run.
            None => self.scenes.clone(),
        }
    }
}

/// Whether a source's own name is that of a scene.
fn holds(source: &str, scene: &str) -> bool {
    let stem = std::path::Path::new(source).file_stem();
    source == scene || stem.and_then(|s| s.to_str()) == Some(scene)
}

impl GivenOption {
    fn words(&self) -> impl Iterator<Item = String> {
        let name = format!("--{}", self.name);
        std::iter::once(name).chain(self.value.clone())
    }
}

fn quoted(words: &[String]) -> String {
    // Only a NUL can't be quoted, which no argument holds.
    shlex::try_join(words.iter().map(String::as_str)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]
    use super::*;
    use crate::record::Backend;
    use interreflect_scene::params::Value;

    const COMMAND: &str = "interreflect bench 'my room.toml' cave --backend=both --set rays=4 \
        --set scene.light=2 --quantity irradiance --samples 64 --seed 7 --json --tev \
        --estimator texels --points 100 --out results";

    #[test]
    fn a_section_s_command_names_its_scene_and_quantity_only() {
        let command = BenchCommand::parse(COMMAND).unwrap();
        assert_eq!(
            command.section("my room", "glossy_radiance"),
            "interreflect bench 'my room.toml' --backend both --set 'rays=4' --set 'scene.light=2' \
             --samples 64 --seed 7 --estimator texels --points 100 --quantity glossy_radiance \
             --out again"
        );
        assert!(
            command
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
            BenchCommand::parse(COMMAND).unwrap().run(&run).unwrap(),
            "interreflect bench cave --set 'scene.light=2' --samples 64 --seed 7 --points 100 \
             --estimator texels --quantity irradiance --backend gpu --set 'rays=8' --out again"
        );
    }

    #[test]
    fn other_commands_are_left_alone() {
        for other in [
            "",
            "interreflect",
            "interreflect reproduce all",
            "x bench --unknown 3",
        ] {
            assert!(BenchCommand::parse(other).is_none(), "{other}");
        }
    }
}
