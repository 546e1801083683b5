//! Rows of pictures that belong together.

use crate::domain::image::HdrImage;
use crate::running::view::View;
use interreflect_scene::Estimate;

/// Pictures of one size beside each other, tone-mapped alike, by the first one.
pub struct Row {
    /// What the row shows.
    pub(crate) title: String,
    /// The pictures, each with what is written under it.
    pub(crate) pictures: Vec<(String, HdrImage)>,
    /// Which pixels show a surface, where the first picture is a reference: the others are then also
    /// shown by their signed errors against it.
    pub(crate) errors_at: Option<Vec<bool>>,
}

impl Row {
    /// Pictures without a reference.
    pub(crate) fn plain(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            pictures: Vec::new(),
            errors_at: None,
        }
    }

    /// Begun with a reference.
    pub(crate) fn against(
        title: impl Into<String>,
        caption: impl Into<String>,
        reference: HdrImage,
        surfaces: Vec<bool>,
    ) -> Self {
        Self {
            title: title.into(),
            pictures: vec![(caption.into(), reference)],
            errors_at: Some(surfaces),
        }
    }

    /// Begun with a reference at the points of a view.
    pub(crate) fn rendered(
        title: impl Into<String>,
        caption: impl Into<String>,
        view: &View,
        reference: &Estimate,
    ) -> Self {
        Self::against(title, caption, view.image(reference), view.surfaces())
    }

    /// Adds a picture.
    pub(crate) fn add(&mut self, caption: impl Into<String>, image: HdrImage) {
        self.pictures.push((caption.into(), image));
    }
}
