//! Values on the command line. Each parser says what it expected.

use crate::running::settings::Setting;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use glam::Vec3;
use interreflect_scene::params::Choice;

/// Reflection for glossy radiance, the same in all channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaterialArg {
    /// Diffuse albedo k_d in [0, 1].
    pub diffuse: f32,
    /// Specular albedo k_s in [0, 1].
    pub specular: f32,
    /// Blinn–Phong exponent, not negative.
    pub shininess: f32,
}

/// A parser of the names of a [`Choice`], which `--help` and error messages list.
pub(super) fn choice<C: Choice + Send + Sync>() -> impl TypedValueParser<Value = C> {
    let names = PossibleValuesParser::new(C::all().into_iter().map(|(name, _)| name));
    names.try_map(|given| {
        let found = C::all().into_iter().find(|(name, _)| *name == given);
        found.map(|(_, value)| value).ok_or("unknown name")
    })
}

pub(super) fn setting(text: &str) -> Result<Setting, String> {
    match text.split_once('=') {
        Some((name, value)) if !name.trim().is_empty() && !value.trim().is_empty() => {
            Ok(Setting::new(name.trim(), value.trim()))
        }
        _ => Err("expected name=value, such as resolution=8".into()),
    }
}

pub(super) fn rate(text: &str) -> Result<f32, String> {
    let rate = text
        .parse()
        .ok()
        .filter(|r: &f32| r.is_finite() && *r > 0.0);
    rate.ok_or_else(|| "expected a number above 0, such as 30".into())
}

pub(super) fn vector(text: &str) -> Result<Vec3, String> {
    let expected = "expected three numbers x,y,z, such as .2,-.1,.3";
    three_numbers(text)
        .map(Vec3::from_array)
        .ok_or_else(|| expected.into())
}

pub(super) fn material(text: &str) -> Result<MaterialArg, String> {
    let Some([diffuse, specular, shininess]) = three_numbers(text) else {
        return Err("expected three numbers kd,ks,shininess, such as .5,.5,5".into());
    };
    let albedo = 0.0..=1.0;
    if !albedo.contains(&diffuse) || !albedo.contains(&specular) || shininess < 0.0 {
        return Err("kd and ks must be from 0 to 1, shininess at least 0".into());
    }
    Ok(MaterialArg {
        diffuse,
        specular,
        shininess,
    })
}

fn three_numbers(text: &str) -> Option<[f32; 3]> {
    let numbers: Result<Vec<f32>, _> = text.split(',').map(|n| n.trim().parse()).collect();
    let numbers: [f32; 3] = numbers.ok()?.try_into().ok()?;
    numbers.iter().all(|n| n.is_finite()).then_some(numbers)
}

pub(super) fn count(text: &str) -> Result<usize, String> {
    let number = text.parse().ok().filter(|n| (1..=1 << 32).contains(n));
    number.ok_or_else(|| "expected a whole number, 1 or more".into())
}

/// More threads than any machine has processors only cost memory.
const MAX_THREADS: usize = 1024;

pub(super) fn threads(text: &str) -> Result<usize, String> {
    let number = text.parse().ok().filter(|n| (1..=MAX_THREADS).contains(n));
    number.ok_or_else(|| format!("expected a whole number, 1 to {MAX_THREADS}"))
}

pub(super) fn fraction(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|n| *n > 0.0 && *n < 1.0);
    number.ok_or_else(|| "expected a fraction between 0 and 1, such as .01".into())
}

pub(super) fn milliseconds(text: &str) -> Result<f64, String> {
    let number = positive(text);
    number.ok_or_else(|| "expected a time in milliseconds above 0, such as 400".into())
}

pub(super) fn positive_number(text: &str) -> Result<f64, String> {
    positive(text).ok_or_else(|| "expected a number above 0, such as 2.5".into())
}

fn positive(text: &str) -> Option<f64> {
    let number = text.parse().ok();
    number.filter(|n: &f64| *n > 0.0 && n.is_finite())
}

pub(super) fn seconds(text: &str) -> Result<f64, String> {
    positive(text).ok_or_else(|| "expected a time in seconds above 0, such as 30".into())
}
