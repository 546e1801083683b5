//! Material libraries (MTL): every line that counts is checked before tobj reads it, because tobj
//! names no lines and takes malformed colours for granted.

use super::text::{self, Line};
use crate::validate::{LARGEST_POWER, is_physical};
use crate::{Material, Place, SceneError};
use glam::Vec3;
use std::path::Path;

/// The lines of an MTL file that count, checked.
#[derive(Debug)]
pub(super) struct CheckedMtl {
    /// `newmtl`, `Kd`, `Ks`, `Ke` and `Ns` lines, for tobj.
    pub(super) text: String,
    /// The materials' names.
    pub(super) names: Vec<String>,
}

/// Reads and checks an MTL file. `mentioned` is where an OBJ file names it.
pub(super) fn read(path: &Path, mentioned: Place) -> Result<CheckedMtl, SceneError> {
    let content = text::read(path).map_err(|e| {
        let remedy = "put the MTL file beside the OBJ file, or remove the line";
        mentioned.error(format!("cannot read material library: {e}"), remedy)
    })?;
    let mut checked = CheckedMtl {
        text: String::new(),
        names: Vec::new(),
    };
    let mut current: Option<(Line<'_>, Material)> = None;
    for line in text::lines(path, &content) {
        match line.keyword {
            "newmtl" if line.rest.is_empty() => {
                return Err(line.error("`newmtl` without a name", "name the material"));
            }
            "newmtl" => {
                check_whole(current.replace((line, Material::diffuse(Vec3::ZERO))))?;
                checked.names.push(line.rest.into());
            }
            "Kd" | "Ks" | "Ke" | "Ns" => check_value(&line, current.as_mut())?,
            _ => continue,
        }
        checked.text += line.text;
        checked.text.push('\n');
    }
    check_whole(current)?;
    Ok(checked)
}

fn check_value(
    line: &Line<'_>,
    current: Option<&mut (Line<'_>, Material)>,
) -> Result<(), SceneError> {
    let Some((_, material)) = current else {
        let what = format!("`{}` before any `newmtl`", line.keyword);
        return Err(line.error(what, "name the material first"));
    };
    if line.keyword == "Ns" {
        let [ns] = line.numbers::<1>()?;
        material.shininess = ns;
        return match ns >= 0.0 {
            true => Ok(()),
            false => Err(line.error(format!("shininess Ns is {ns}"), "use 0 or more")),
        };
    }
    let colour = Vec3::from(line.numbers::<3>()?);
    let limit = if line.keyword == "Ke" {
        LARGEST_POWER
    } else {
        1.0
    };
    if colour.min_element() < 0.0 || colour.max_element() > limit {
        let what = format!("{} is {:?}", line.keyword, colour.to_array());
        return Err(line.error(what, format!("use numbers from 0 to {limit:?}")));
    }
    match line.keyword {
        "Kd" => material.albedo = colour,
        "Ks" => material.specular = colour,
        _ => material.emission = colour,
    }
    Ok(())
}

/// A surface must not reflect more than it receives: unlimited bounces would never end.
fn check_whole(material: Option<(Line<'_>, Material)>) -> Result<(), SceneError> {
    match material {
        Some((line, m)) if !is_physical(&m) => Err(line.error(
            format!(
                "material `{}` reflects more than it receives: Kd {} + Ks {} exceeds 1",
                line.rest, m.albedo, m.specular
            ),
            "lower Ks or Kd",
        )),
        _ => Ok(()),
    }
}

/// The material of an MTL entry; what it does not give is 0, but for a shininess of 5.
pub(super) fn material(mtl: &tobj::Material) -> Material {
    let colour = |c: Option<[f32; 3]>| c.map_or(Vec3::ZERO, Vec3::from);
    let black = Material::diffuse(Vec3::ZERO);
    Material {
        albedo: colour(mtl.diffuse),
        specular: colour(mtl.specular),
        shininess: mtl.shininess.unwrap_or(black.shininess),
        emission: colour(mtl.emissive),
        mirror: false,
    }
}
