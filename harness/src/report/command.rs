//! Command lines that make a part of the report again.

use crate::cli::Cli;
use crate::record::Run;
use clap::CommandFactory as _;

/// Folder of what is made again, so that the whole stays what it is.
const OUT: &str = "again";

/// A bench's command line, taken apart.
pub(super) struct BenchCommand {
    program: String,
    scenes: Vec<String>,
    options: Vec<GivenOption>,
}

/// An option as it was given.
struct GivenOption {
    name: String,
    /// Whether it is one of those that change scenes, references or the machine's part.
    shared: bool,
    value: Option<String>,
}

impl BenchCommand {
    /// Takes a command apart; `None` if it is not a bench's.
    pub(super) fn parse(command: &str) -> Option<Self> {
        let mut words = shlex::split(command)?.into_iter();
        let (program, verb) = (words.next()?, words.next()?);
        let cli = Cli::command();
        let bench = cli.find_subcommand(&verb).filter(|_| verb == "bench")?;
        let mut parsed = Self {
            program,
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
                shared: known.get_help_heading().is_some() || ["points", "repeat"].contains(&name),
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
        let kept =
            |o: &&GivenOption| !["quantity", "json", "tev", "out"].contains(&o.name.as_str());
        let words = self
            .options
            .iter()
            .filter(kept)
            .flat_map(GivenOption::words);
        self.with(scene, words, &[("quantity", quantity.into())])
    }

    /// The command for one run alone.
    pub(super) fn run(&self, run: &Run) -> String {
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
        self.with(&run.scene, words, &own)
    }

    /// A bench of one scene with these words and options.
    fn with(
        &self,
        scene: &str,
        words: impl Iterator<Item = String>,
        options: &[(&str, String)],
    ) -> String {
        let mut all = vec![self.program.clone(), "bench".into()];
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
        let holds = |source: &&String| {
            let stem = std::path::Path::new(source.as_str()).file_stem();
            source.as_str() == scene || stem.and_then(|s| s.to_str()) == Some(scene)
        };
        match self.scenes.iter().find(holds) {
            Some(source) => vec![source.clone()],
            None if self.scenes.is_empty() => vec![scene.into()],
            // A file may give its scene another name: then all are run.
            None => self.scenes.clone(),
        }
    }
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
            "interreflect bench 'my room.toml' --backend both --set rays=4 --set scene.light=2 \
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
            BenchCommand::parse(COMMAND).unwrap().run(&run),
            "interreflect bench cave --set scene.light=2 --samples 64 --seed 7 --points 100 \
             --estimator texels --quantity irradiance --backend gpu --set rays=8 --out again"
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
