use interreflect_scene::params::{Choice, Fidelity, Field, Params};

/// Which of the paper's solid angles a photon has. Read by `published` only.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SolidAngle {
    /// 2π/M for each of the M samples of a light.
    Eq11,
    /// cos θ'·A/(A + r²).
    #[default]
    Eq14,
    /// A'/|diag|², |diag| the diagonal of the scene's bounding box.
    Eq15,
}

impl Choice for SolidAngle {
    const ALL: &'static [(&'static str, Self)] = &[
        ("eq11", Self::Eq11),
        ("eq14", Self::Eq14),
        ("eq15", Self::Eq15),
    ];
}

/// Whose size a photon has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TexelOf {
    /// A cell of the sample grid: all light is counted.
    #[default]
    Grid,
    /// A texel of the map: with fewer samples than texels the light between them is lost.
    Texture,
}

impl Choice for TexelOf {
    const ALL: &'static [(&'static str, Self)] =
        &[("grid", Self::Grid), ("texture", Self::Texture)];
}

/// How lit surfaces reflect.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Surface {
    /// The same radiance in all directions.
    #[default]
    Lambertian,
    /// By k_d and k_s towards the shaded point, from true colours and normals.
    BlinnPhong,
}

impl Choice for Surface {
    const ALL: &'static [(&'static str, Self)] = &[
        ("lambertian", Self::Lambertian),
        ("blinn_phong", Self::BlinnPhong),
    ];
}

/// Parameters of [`super::DirectRadianceMap`].
#[derive(Clone, Debug, PartialEq)]
pub struct DirectRadianceMap {
    /// w: texels along the edge of a light's view.
    pub map_resolution: u32,
    /// Samples along the edge of the grid over a view.
    pub samples_per_side: u32,
    /// The paper as printed, or what it meant.
    pub fidelity: Fidelity,
    /// Which published solid angle.
    pub solid_angle: SolidAngle,
    /// Whose size a photon has.
    pub texel: TexelOf,
    /// A sample's radiance is the mean over its cell.
    pub mip: bool,
    /// How lit surfaces reflect.
    pub surface: Surface,
}

impl Default for DirectRadianceMap {
    fn default() -> Self {
        Self {
            map_resolution: 16,
            samples_per_side: 3,
            fidelity: Fidelity::Published,
            solid_angle: SolidAngle::Eq14,
            texel: TexelOf::Grid,
            mip: false,
            surface: Surface::Lambertian,
        }
    }
}

impl Params for DirectRadianceMap {
    fn fields() -> Vec<Field<Self>> {
        vec![
            Field::u32(
                "map_resolution",
                "texels along the edge of a picture from the light",
                1..=256,
                |p: &Self| p.map_resolution,
                |p, v| p.map_resolution = v,
            )
            .symbol("w")
            .unit("texels")
            .log(),
            Field::u32(
                "samples_per_side",
                "samples along the edge of the grid over a picture, at most its texels",
                1..=64,
                |p: &Self| p.samples_per_side,
                |p, v| p.samples_per_side = v,
            )
            .symbol("N")
            .log(),
            Field::fidelity(|p: &Self| p.fidelity, |p, v| p.fidelity = v),
            Field::choice(
                "solid_angle",
                "published only: a sample's solid angle by equation 11, 14 or 15",
                |p: &Self| p.solid_angle,
                |p, v| p.solid_angle = v,
            ),
            Field::choice(
                "texel",
                "a sample's size: that of its cell of the grid, or of a texel of the picture, \
                 which loses the light in between",
                |p: &Self| p.texel,
                |p, v| p.texel = v,
            ),
            Field::bool(
                "mip",
                "a sample's radiance is the mean over its cell, against flashing (§5)",
                |p: &Self| p.mip,
                |p, v| p.mip = v,
            ),
            Field::choice(
                "surface",
                "lit surfaces reflect by Lambert's law, or by their whole material",
                |p: &Self| p.surface,
                |p, v| p.surface = v,
            ),
        ]
    }
}
