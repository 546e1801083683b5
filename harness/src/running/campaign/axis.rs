//! Parameters that vary: `id.name=VALUES`.

use crate::running::settings::Setting;
use std::str::FromStr;

/// A parameter of an estimator, of the scene or of the run, and the values that it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Whose it is: `scene`, `run` or an estimator's id.
    pub owner: String,
    /// The parameter.
    pub name: String,
    /// Its values, as they would be given to `--set`.
    pub values: Vec<String>,
}

/// More values than anyone would wait for are a slip of the pen.
const MOST: usize = 1000;

impl Axis {
    /// One setting for each value.
    pub fn settings(&self) -> impl Iterator<Item = Setting> {
        self.values.iter().map(|value| Setting {
            name: format!("{}.{}", self.owner, self.name),
            value: value.clone(),
        })
    }
}

impl FromStr for Axis {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let expected = "expected id.name=values, such as localized_cubemap.resolution=2..32:log2";
        let (name, values) = text.split_once('=').ok_or(expected)?;
        let (owner, name) = name.trim().split_once('.').ok_or(expected)?;
        let values = match values.split_once("..") {
            Some((first, rest)) => range(first, rest)?,
            None => values.split(',').map(|v| v.trim().to_owned()).collect(),
        };
        if owner.is_empty() || name.is_empty() || values.iter().any(String::is_empty) {
            return Err(expected.into());
        }
        if values.len() > MOST {
            return Err(format!("{} values are more than {MOST}", values.len()));
        }
        match twice(&values) {
            Some(value) => Err(format!("the value {value} is there twice")),
            None => Ok(Self {
                owner: owner.into(),
                name: name.into(),
                values,
            }),
        }
    }
}

fn twice(values: &[String]) -> Option<&String> {
    let mut sorted: Vec<_> = values.iter().collect();
    sorted.sort();
    sorted.windows(2).find(|w| w[0] == w[1]).map(|w| w[0])
}

/// `first..last`, `first..last:log2`, `first..last:log10` or `first..last:count`.
fn range(first: &str, rest: &str) -> Result<Vec<String>, String> {
    let (last, step) = match rest.split_once(':') {
        Some((last, step)) => (last, Some(step.trim())),
        None => (rest, None),
    };
    let number = |text: &str| {
        let number = text.trim().parse::<f64>().ok().filter(|n| n.is_finite());
        number.ok_or_else(|| format!("`{}` is not a number", text.trim()))
    };
    let (first, last) = (number(first)?, number(last)?);
    if first > last {
        return Err(format!("a range rises: write {last}..{first}"));
    }
    let values = match step {
        None => counted(first, last, 1.0 + last - first)?,
        Some("log2") => powers(first, last, 2.0)?,
        Some("log10") => powers(first, last, 10.0)?,
        Some(count) => {
            let count = count.parse::<u32>().ok().filter(|n| *n > 1);
            let unknown = || "after the colon: log2, log10, or how many values (2 or more)";
            counted(first, last, f64::from(count.ok_or_else(unknown)?))?
        }
    };
    Ok(values.into_iter().map(written).collect())
}

/// As many values at equal distances.
fn counted(first: f64, last: f64, count: f64) -> Result<Vec<f64>, String> {
    if count.fract() != 0.0 {
        return Err(format!(
            "{first}..{last} goes by ones and does not end at {last}; say how many values, as in {first}..{last}:5"
        ));
    }
    if count > MOST as f64 {
        return Err(format!("{count} values are more than {MOST}"));
    }
    let step = if count > 1.0 {
        (last - first) / (count - 1.0)
    } else {
        0.0
    };
    Ok((0..count as u32)
        .map(|i| first + step * f64::from(i))
        .collect())
}

/// The first value times the powers of a base, up to the last.
fn powers(first: f64, last: f64, base: f64) -> Result<Vec<f64>, String> {
    if first <= 0.0 {
        return Err(format!(
            "a logarithmic range begins above 0, not at {first}"
        ));
    }
    let values = std::iter::successors(Some(first), |v| Some(v * base));
    // Decimal ends such as .001..10 are met in spite of rounding.
    Ok(values.take_while(|v| *v <= last * (1.0 + 1e-9)).collect())
}

/// As short as single precision can be told.
fn written(value: f64) -> String {
    (value as f32).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(text: &str) -> Vec<String> {
        let axis: Axis = format!("a.b={text}").parse().expect(text);
        axis.values
    }

    #[test]
    fn values_are_lists_or_ranges() {
        assert_eq!(values("2..32:log2"), ["2", "4", "8", "16", "32"]);
        assert_eq!(values("3..20:log2"), ["3", "6", "12"]);
        assert_eq!(
            values(".001..10:log10"),
            ["0.001", "0.01", "0.1", "1", "10"]
        );
        assert_eq!(values("0..1:5"), ["0", "0.25", "0.5", "0.75", "1"]);
        assert_eq!(values("2..5"), ["2", "3", "4", "5"]);
        assert_eq!(values("-1..1:3"), ["-1", "0", "1"]);
        assert_eq!(values("7..7"), ["7"]);
        assert_eq!(values("published, corrected"), ["published", "corrected"]);
        assert_eq!(values(".2,.05,.01"), [".2", ".05", ".01"]);
    }

    #[test]
    fn names_have_an_owner_and_may_hold_dots() {
        let axis: Axis = "scene.receiver.gap=1,2".parse().expect("an axis");
        assert_eq!((&*axis.owner, &*axis.name), ("scene", "receiver.gap"));
        let settings: Vec<_> = axis.settings().map(|s| s.name + "=" + &s.value).collect();
        assert_eq!(settings, ["scene.receiver.gap=1", "scene.receiver.gap=2"]);
    }

    #[test]
    fn slips_are_told() {
        for (text, told) in [
            ("resolution=2", "expected id.name"),
            ("a.b", "expected id.name"),
            ("a.b=", "expected id.name"),
            ("a.b=1,,2", "expected id.name"),
            ("a.b=8..2", "write 2..8"),
            ("a.b=0..8:log2", "above 0"),
            ("a.b=1..8:log3", "log2, log10"),
            ("a.b=1..x", "`x` is not a number"),
            ("a.b=0..1.5", "does not end at 1.5"),
            ("a.b=1..5000", "more than 1000"),
            ("a.b=1,2,1", "twice"),
        ] {
            let error = text.parse::<Axis>().expect_err(text);
            assert!(error.contains(told), "{text}: {error}");
        }
    }
}
