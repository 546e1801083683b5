//! A file with the words of a sweep: the same names as on the command line, so that there is one list.

use super::Stop;
use std::ffi::OsString;
use std::path::Path;
use toml::{Table, Value};

/// Arguments of a `sweep` with its file's words in the file's place, before all others: what the
/// command line says holds.
///
/// # Errors
/// [`Stop::Usage`] with the file and what is wrong in it.
pub fn expand(arguments: Vec<OsString>) -> Result<Vec<OsString>, Stop> {
    if arguments.get(1).is_none_or(|command| command != "sweep") {
        return Ok(arguments);
    }
    let files = arguments.iter().enumerate().skip(2);
    let named = files.filter_map(|(at, text)| Some((at, words(Path::new(text))?)));
    let Some((at, words)) = named.into_iter().next() else {
        return Ok(arguments);
    };
    let file = Path::new(&arguments[at]).display();
    let words = words.map_err(|why| Stop::Usage(format!("{file}: {why}")))?;
    let before = arguments[..2].iter().cloned();
    let others = arguments
        .iter()
        .enumerate()
        .skip(2)
        .filter(|(i, _)| *i != at);
    let others = others.map(|(_, text)| text.clone());
    Ok(before
        .chain(words.into_iter().map(Into::into))
        .chain(others)
        .collect())
}

/// Options that name files, and the scenes: relative to the sweep file, where such a file is there.
const FILES: [&str; 3] = ["scenes", "receiver", "environment"];

/// A sweep file's words; `None` if the path is of something else, a scene for instance.
fn words(path: &Path) -> Option<Result<Vec<String>, String>> {
    if path.extension().is_none_or(|e| e != "toml") {
        return None;
    }
    let text = std::fs::read_to_string(path).ok()?;
    let table = match text.parse::<Table>() {
        Ok(table) => table,
        // Whose fault it is, the scene loader tells, unless the text is clearly a sweep's.
        Err(error)
            if text
                .lines()
                .any(|line| line.trim_start().starts_with("scenes")) =>
        {
            return Some(Err(error.to_string().trim_end().replace('\n', " ")));
        }
        Err(_) => return None,
    };
    table.contains_key("scenes").then(|| {
        let folder = path.parent().unwrap_or(Path::new("."));
        let mut words = Vec::new();
        for (key, value) in &table {
            words.extend(of_entry(folder, key, value)?);
        }
        Ok(words)
    })
}

fn of_entry(folder: &Path, key: &str, value: &Value) -> Result<Vec<String>, String> {
    let values = match value {
        Value::Array(values) => values.clone(),
        Value::Table(table) => {
            // `[vary]` and `[set]`: a line for each parameter.
            let line = |(name, value): (&String, &Value)| {
                let values = match value {
                    Value::Array(values) => values.clone(),
                    one => vec![one.clone()],
                };
                let texts: Result<Vec<_>, _> = values.iter().map(|v| plain(key, v)).collect();
                Ok(Value::String(format!("{name}={}", texts?.join(","))))
            };
            table.iter().map(line).collect::<Result<_, String>>()?
        }
        Value::Boolean(true) => return Ok(vec![format!("--{key}")]),
        Value::Boolean(false) => return Ok(Vec::new()),
        one => vec![one.clone()],
    };
    let mut words = Vec::new();
    for value in values {
        let mut text = plain(key, &value)?;
        let beside = folder.join(&text);
        if FILES.contains(&key) && beside.is_file() {
            text = beside.to_string_lossy().into_owned();
        }
        words.push(match key {
            "scenes" => text,
            _ => format!("--{key}={text}"),
        });
    }
    Ok(words)
}

fn plain(key: &str, value: &Value) -> Result<String, String> {
    match value {
        Value::String(text) => Ok(text.clone()),
        Value::Integer(number) => Ok(number.to_string()),
        Value::Float(number) => Ok(number.to_string()),
        Value::Boolean(truth) => Ok(truth.to_string()),
        _ => Err(format!(
            "`{key}` takes texts and numbers, or a list of them"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    fn expanded(text: &str, more: &[&str]) -> Result<Vec<String>, Stop> {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("study.toml");
        fs::write(&file, text).expect("written");
        fs::write(folder.path().join("room.obj"), "").expect("written");
        let mut arguments: Vec<OsString> = vec!["interreflect".into(), "sweep".into(), file.into()];
        arguments.extend(more.iter().map(OsString::from));
        let words = expand(arguments)?;
        let folder = format!("{}/", folder.path().display());
        let plain = |w: OsString| w.to_string_lossy().replace(&folder, "@");
        Ok(words.into_iter().skip(2).map(plain).collect())
    }

    #[test]
    fn a_file_says_what_the_command_line_would() {
        let text = "scenes = [\"cornell-box\", \"room.obj\"]\npoints = 512\nbackend = \"cpu\"\njson = true\n\
                    [vary]\n\"localized_cubemap.resolution\" = \"2..8:log2\"\n\
                    \"scene.receiver.gap\" = [0.2, 0.05]\n[set]\n\"localized_cubemap.bounces\" = 1\n";
        let mut words = expanded(text, &["--points", "64"]).expect("a sweep file");
        assert_eq!(words.split_off(words.len() - 2), ["--points", "64"]);
        words.sort();
        assert_eq!(
            words,
            [
                "--backend=cpu",
                "--json",
                "--points=512",
                "--set=localized_cubemap.bounces=1",
                "--vary=localized_cubemap.resolution=2..8:log2",
                "--vary=scene.receiver.gap=0.2,0.05",
                "@room.obj",
                "cornell-box",
            ]
        );
    }

    #[test]
    fn scenes_are_left_alone_and_slips_named() {
        assert_eq!(
            expanded("name = \"x\"\n", &[]).expect("no sweep"),
            ["@study.toml"]
        );
        for text in ["scenes = [[1]]", "scenes = [", "scenes = [{a = 1}]"] {
            let Err(Stop::Usage(line)) = expanded(text, &[]) else {
                panic!("{text}");
            };
            assert!(
                line.contains("study.toml: ") && !line.contains('\n'),
                "{line}"
            );
        }
    }
}
