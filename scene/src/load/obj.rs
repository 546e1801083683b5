//! Meshes from OBJ files, read by tobj after a check that knows line numbers.

use super::build::Model;
use super::mtl::{self, CheckedMtl};
use super::text::{self, Line};
use crate::{Material, Mesh, Place, SceneError, normals, params};
use glam::Vec3;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// What a model does about vertex normals that its file does not give.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MissingNormals {
    /// Shade each triangle flat.
    Flat,
    /// Smooth them by angle.
    Smooth,
}

/// Loads an OBJ file as one mesh in its own units; triangles without a material get `default`.
///
/// Faces of more than three corners are cut into fans, lines and points are left out, triangles of
/// zero area are dropped. Normals count only if every face has them. Textures are not read: `Kd`
/// stands for them.
///
/// # Errors
/// [`SceneError`] naming file and line for anything that is no mesh.
pub(crate) fn load(
    path: &Path,
    default: Material,
    missing: MissingNormals,
) -> Result<Model, SceneError> {
    let checked = check(path, &text::read(path)?)?;
    let options = tobj::LoadOptions {
        triangulate: true,
        single_index: true,
        ..tobj::LoadOptions::default()
    };
    let unreadable = |e: tobj::LoadError| {
        Place::file(path).error(format!("not a readable OBJ file: {e}"), "export it again")
    };
    let (models, materials) = tobj::load_obj_buf(&mut checked.text.as_bytes(), &options, |name| {
        let text = checked.libraries.get(name).map_or("", |l| l.text.as_str());
        tobj::load_mtl_buf(&mut text.as_bytes())
    })
    .map_err(unreadable)?;
    // Without any `mtllib`, tobj has an empty list here.
    let materials = materials.map_err(unreadable)?;
    let mut mesh = merge(&models, materials.len() as u32, checked.all_normals);
    drop_zero_area(&mut mesh);
    if mesh.triangles.is_empty() {
        let remedy = "give at least one triangle with three different corners";
        return Err(Place::file(path).error("no triangle has an area", remedy));
    }
    if mesh.normals.is_empty() && missing == MissingNormals::Smooth {
        normals::smooth(&mut mesh);
    }
    let materials = materials
        .iter()
        .map(mtl::material)
        .chain([default])
        .collect();
    Ok(Model { mesh, materials })
}

/// An OBJ file that tobj can read.
struct Checked {
    /// The lines that count, each as one keyword, a space and its values.
    text: String,
    /// The material libraries by name.
    libraries: BTreeMap<PathBuf, CheckedMtl>,
    /// Every corner of every face has a normal.
    all_normals: bool,
}

fn check(path: &Path, content: &str) -> Result<Checked, SceneError> {
    let mut checked = Checked {
        text: String::with_capacity(content.len()),
        libraries: BTreeMap::new(),
        all_normals: true,
    };
    // Positions, texture coordinates and normals so far, in the order of a corner's indices.
    let mut counts = [0; 3];
    let mut faces = 0;
    let folder = path.parent().unwrap_or(Path::new(""));
    for line in text::lines(path, content) {
        match line.keyword {
            "v" => {
                check_position(&line)?;
                counts[0] += 1;
            }
            "vt" => {
                line.numbers::<2>()?;
                counts[1] += 1;
            }
            "vn" => {
                if line.numbers::<3>()? == [0.0; 3] {
                    let remedy = "give a direction, or leave out all normals";
                    return Err(line.error("the normal has length zero", remedy));
                }
                counts[2] += 1;
            }
            "f" => {
                checked.all_normals &= check_face(&line, counts)?;
                faces += 1;
            }
            "mtllib" => {
                let library = mtl::read(&folder.join(line.rest), line.place())?;
                checked.libraries.insert(line.rest.into(), library);
            }
            "usemtl" => check_use(&line, &checked.libraries)?,
            _ => continue,
        }
        for part in [line.keyword, " ", line.rest, "\n"] {
            checked.text.push_str(part);
        }
    }
    match faces {
        0 => Err(Place::file(path).error("no face (`f`) found", "export a triangle mesh")),
        _ => Ok(checked),
    }
}

/// Three numbers, then none, a weight other than 0, or a colour.
fn check_position(line: &Line<'_>) -> Result<(), SceneError> {
    line.numbers::<3>()?;
    let extra: Vec<_> = line.rest.split_ascii_whitespace().skip(3).collect();
    match extra.len() {
        0 => Ok(()),
        1 if line.number(extra[0])? != 0.0 => Ok(()),
        1 => Err(line.error("the vertex has a weight of 0", "use a weight of 1, or none")),
        3 => extra.iter().try_for_each(|w| line.number(w).map(|_| ())),
        n => Err(line.error(format!("the vertex has {} numbers", n + 3), "give three")),
    }
}

fn check_use(line: &Line<'_>, libraries: &BTreeMap<PathBuf, CheckedMtl>) -> Result<(), SceneError> {
    let names = || {
        libraries
            .values()
            .flat_map(|l| l.names.iter().map(String::as_str))
    };
    if names().any(|n| n == line.rest) {
        return Ok(());
    }
    let remedy = match params::nearest(line.rest, names()) {
        Some(name) => format!("did you mean `{name}`?"),
        None if libraries.is_empty() => {
            "name the MTL file first, in a line `mtllib FILE.mtl`".into()
        }
        None => "define it in the MTL file".into(),
    };
    Err(line.error(format!("there is no material `{}`", line.rest), remedy))
}

/// Checks a face's indices against the numbers of positions, texture coordinates and normals
/// above it; whether all its corners have a normal.
fn check_face(line: &Line<'_>, counts: [i64; 3]) -> Result<bool, SceneError> {
    const KINDS: [&str; 3] = ["position", "texture coordinate", "normal"];
    let (mut corners, mut with_normals) = (0, true);
    for corner in line.rest.split_ascii_whitespace() {
        let mut last = 0;
        for (kind, index) in corner.split('/').enumerate() {
            if index.is_empty() && kind == 1 {
                continue;
            }
            let Some(index) = index.parse::<i64>().ok().filter(|_| kind < 3) else {
                let remedy = "write v, v/vt, v//vn or v/vt/vn";
                return Err(line.error(format!("`{corner}` is not a corner of a face"), remedy));
            };
            if index == 0 || index > counts[kind] || index < -counts[kind] {
                let what = format!(
                    "{} {index} of `{corner}` does not exist: there are {} above",
                    KINDS[kind], counts[kind]
                );
                return Err(line.error(what, "use an index from 1 to their number"));
            }
            last = kind;
        }
        with_normals &= last == 2;
        corners += 1;
    }
    match corners {
        0..3 => Err(line.error(
            format!("a face of {corners} corners"),
            "give at least three",
        )),
        _ => Ok(with_normals),
    }
}

/// All of tobj's models as one mesh; those without a material get index `default`.
fn merge(models: &[tobj::Model], default: u32, with_normals: bool) -> Mesh {
    let vectors =
        |flat: &[f32]| -> Vec<Vec3> { flat.as_chunks().0.iter().map(|v| Vec3::from(*v)).collect() };
    let mut merged = Mesh::default();
    for tobj::Model { mesh, .. } in models {
        let first = merged.positions.len() as u32;
        merged.positions.extend(vectors(&mesh.positions));
        if with_normals {
            let unit = |n: Vec3| n.as_dvec3().normalize().as_vec3();
            merged
                .normals
                .extend(vectors(&mesh.normals).into_iter().map(unit));
        }
        let triangles = mesh.indices.as_chunks().0;
        merged
            .triangles
            .extend(triangles.iter().map(|t: &[u32; 3]| t.map(|v| v + first)));
        let material = mesh.material_id.map_or(default, |m| m as u32);
        merged.materials.resize(merged.triangles.len(), material);
    }
    merged
}

/// Drops triangles whose corners lie on one line.
fn drop_zero_area(mesh: &mut Mesh) {
    let keep: Vec<bool> = (0..mesh.triangles.len())
        .map(|t| {
            let [a, b, c] = mesh.corners(t).map(|p| p.as_dvec3());
            (b - a).cross(c - a).length_squared() > 0.0
        })
        .collect();
    let mut kept = keep.iter();
    mesh.triangles.retain(|_| kept.next() == Some(&true));
    let mut kept = keep.iter();
    mesh.materials.retain(|_| kept.next() == Some(&true));
}
