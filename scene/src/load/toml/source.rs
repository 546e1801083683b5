//! Values of a scene file, checked, with the lines they stand in.

use crate::load::file::name_fault;
use crate::validate::{LARGEST_POWER, is_power};
use crate::{Place, SceneError, params};
use glam::Vec3;
use std::ops::Range;
use std::path::{Path, PathBuf};
use toml::Spanned;

/// Largest width or height of an image in pixels.
const MAX_RESOLUTION: u32 = 16_384;

/// The file that values come from.
pub(super) struct Source<'a> {
    pub(super) path: &'a Path,
    pub(super) text: &'a str,
}

impl Source<'_> {
    fn line_of(&self, span: Range<usize>) -> Place {
        let before = &self.text.as_bytes()[..span.start.min(self.text.len())];
        Place::line(
            self.path,
            1 + before.iter().filter(|b| **b == b'\n').count(),
        )
    }

    /// Where a value stands.
    pub(super) fn at<T>(&self, value: &Spanned<T>) -> Place {
        self.line_of(value.span())
    }

    /// What a parser's error says, with its line and, for an unknown name, the nearest known one.
    pub(super) fn refused(&self, error: &toml::de::Error) -> SceneError {
        let place = match error.span() {
            Some(span) => self.line_of(span),
            None => Place::file(self.path),
        };
        let message = error.message();
        // serde quotes the unknown name first, then the known ones.
        let mut quoted = message.split('`').skip(1).step_by(2);
        let remedy = match quoted.next() {
            Some(name) if message.starts_with("unknown") => match params::nearest(name, quoted) {
                Some(known) => format!("did you mean `{known}`?"),
                None => "use one of these names".into(),
            },
            Some(name) if message.starts_with("missing field") => format!("add `{name} = …`"),
            _ => "mend this line".into(),
        };
        place.error(message, remedy)
    }

    /// The path of a file named in this one.
    pub(super) fn path_of(&self, file: &Spanned<PathBuf>) -> Result<PathBuf, SceneError> {
        let path = self
            .path
            .parent()
            .unwrap_or(Path::new(""))
            .join(file.get_ref());
        match path.is_file() {
            true => Ok(path),
            false => Err(self.at(file).error(
                format!("there is no file `{}`", path.display()),
                "name a file relative to this one",
            )),
        }
    }

    /// The scene's name, which becomes a part of file names.
    pub(super) fn name(&self, value: Spanned<String>) -> Result<String, SceneError> {
        match name_fault(value.get_ref()) {
            None => Ok(value.into_inner()),
            Some(fault) => Err(self.at(&value).error(
                format!("the scene's `name` {fault}"),
                "choose a name that can be part of a file's name",
            )),
        }
    }

    /// Three finite numbers.
    pub(super) fn vector(&self, key: &str, value: &Spanned<[f32; 3]>) -> Result<Vec3, SceneError> {
        self.check(
            key,
            value,
            Vec3::from(*value.get_ref()).is_finite(),
            "use finite numbers",
        )
        .map(Vec3::from)
    }

    /// A direction of any length but zero, normalised.
    pub(super) fn direction(
        &self,
        key: &str,
        value: &Spanned<[f32; 3]>,
    ) -> Result<Vec3, SceneError> {
        let v = self.vector(key, value)?.as_dvec3();
        match v.try_normalize() {
            Some(unit) => Ok(unit.as_vec3()),
            None => Err(self
                .at(value)
                .error(format!("`{key}` has length zero"), "give a direction")),
        }
    }

    /// Radiance, intensity, flux or irradiance: finite, at least 0 and small enough
    /// to be summed.
    pub(super) fn power(&self, key: &str, value: &Spanned<[f32; 3]>) -> Result<Vec3, SceneError> {
        let v = self.vector(key, value)?;
        let remedy = format!("use numbers from 0 to {LARGEST_POWER:e}");
        self.check(key, value, is_power(v), &remedy)?;
        Ok(v)
    }

    /// A reflectance, each channel from 0 to 1.
    pub(super) fn reflectance(
        &self,
        key: &str,
        value: &Spanned<[f32; 3]>,
    ) -> Result<Vec3, SceneError> {
        let v = self.vector(key, value)?;
        self.check(
            key,
            value,
            v.min_element() >= 0.0 && v.max_element() <= 1.0,
            "use numbers from 0 to 1",
        )?;
        Ok(v)
    }

    /// A finite number.
    pub(super) fn number(&self, key: &str, value: &Spanned<f32>) -> Result<f32, SceneError> {
        self.check(
            key,
            value,
            value.get_ref().is_finite(),
            "use a finite number",
        )
    }

    /// A finite number of at least 0.
    pub(super) fn not_negative(&self, key: &str, value: &Spanned<f32>) -> Result<f32, SceneError> {
        let v = self.number(key, value)?;
        self.check(key, value, v >= 0.0, "use a number of at least 0")
    }

    /// A finite number above 0.
    pub(super) fn positive(&self, key: &str, value: &Spanned<f32>) -> Result<f32, SceneError> {
        let v = self.number(key, value)?;
        self.check(key, value, v > 0.0, "use a number above 0")
    }

    /// A number from `least` to `most`.
    pub(super) fn within(
        &self,
        key: &str,
        value: &Spanned<f32>,
        least: f32,
        most: f32,
    ) -> Result<f32, SceneError> {
        let holds = (least..=most).contains(value.get_ref());
        let remedy = format!("use a number from {least} to {most}");
        self.check(key, value, holds, &remedy)
    }

    /// A full angle in degrees, between 0 and 180.
    pub(super) fn angle(&self, key: &str, value: &Spanned<f32>) -> Result<f32, SceneError> {
        let v = *value.get_ref();
        self.check(
            key,
            value,
            v > 0.0 && v < 180.0,
            "use an angle between 0 and 180 degrees",
        )
    }

    /// Width and height in pixels.
    pub(super) fn resolution(&self, value: &Spanned<[u32; 2]>) -> Result<[u32; 2], SceneError> {
        let fits = value
            .get_ref()
            .iter()
            .all(|r| (1..=MAX_RESOLUTION).contains(r));
        self.check(
            "resolution",
            value,
            fits,
            &format!("use 1 to {MAX_RESOLUTION} pixels"),
        )
    }

    fn check<T: Copy + std::fmt::Debug>(
        &self,
        key: &str,
        value: &Spanned<T>,
        holds: bool,
        remedy: &str,
    ) -> Result<T, SceneError> {
        match holds {
            true => Ok(*value.get_ref()),
            false => Err(self
                .at(value)
                .error(format!("`{key}` is {:?}", value.get_ref()), remedy)),
        }
    }

    /// Refuses keys that mean nothing beside a choice such as `kind = "point"`.
    pub(super) fn only(
        &self,
        given: impl IntoIterator<Item = Option<Key>>,
        allowed: &[&str],
        choice: &str,
    ) -> Result<(), SceneError> {
        match given
            .into_iter()
            .flatten()
            .find(|k| !allowed.contains(&k.name))
        {
            None => Ok(()),
            Some(key) => Err(self.line_of(key.span).error(
                format!("`{}` means nothing to {choice}", key.name),
                match allowed {
                    [] => "remove it".into(),
                    _ => format!("remove it; allowed: {}", allowed.join(", ")),
                },
            )),
        }
    }

    /// The value of a key that must be there.
    pub(super) fn required<'v, V, T>(
        &self,
        table: &Spanned<T>,
        key: &str,
        value: &'v Option<V>,
        choice: &str,
    ) -> Result<&'v V, SceneError> {
        value.as_ref().ok_or_else(|| {
            self.at(table).error(
                format!("{choice} needs `{key}`"),
                format!("add `{key} = …`"),
            )
        })
    }
}

/// A key that is given.
pub(super) struct Key {
    name: &'static str,
    span: Range<usize>,
}

impl Key {
    /// The key, if its value is given.
    pub(super) fn of<T>(name: &'static str, value: &Option<Spanned<T>>) -> Option<Self> {
        value.as_ref().map(|v| Self {
            name,
            span: v.span(),
        })
    }
}
