//! `[[light]]` tables of kind `environment`.

use super::super::source::Source;
use super::LightTable;
use crate::validate::{LARGEST_POWER, is_power};
use crate::{Environment, SceneError, load};
use glam::Vec3;
use toml::Spanned;

impl LightTable {
    /// What arrives from infinitely far away, by the table.
    pub(super) fn environment(
        &self,
        source: &Source<'_>,
        whole: &Spanned<Self>,
    ) -> Result<Environment, SceneError> {
        let base = match (&self.file, &self.constant) {
            (Some(file), None) => Environment {
                image: load::open_image(&source.path_of(file)?)?,
                scale: 1.0,
                rotate_deg: 0.0,
            },
            (None, Some(radiance)) => Environment::constant(source.power("constant", radiance)?),
            _ => {
                let what = "an environment light needs either `file` or `constant`";
                return Err(source.at(whole).error(what, "give one of them"));
            }
        };
        let (scale, turn) = (self.scale.as_ref(), self.rotate_deg.as_ref());
        let brightest = base
            .image
            .texels
            .iter()
            .copied()
            .fold(Vec3::ZERO, Vec3::max);
        let scaled = |v: &Spanned<f32>| {
            let factor = source.not_negative("scale", v)?;
            match is_power(brightest * factor) {
                true => Ok(factor),
                false => Err(source.at(v).error(
                    format!("`scale` is {factor:e} and makes radiances above {LARGEST_POWER:e}"),
                    "lower it",
                )),
            }
        };
        Ok(Environment {
            scale: scale.map_or(Ok(1.0), scaled)?,
            rotate_deg: turn.map_or(Ok(0.0), |v| source.number("rotate_deg", v))?,
            ..base
        })
    }
}
