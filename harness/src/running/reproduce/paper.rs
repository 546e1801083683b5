//! The papers, and places in them.

use serde::Serialize;
use std::fmt;

/// The papers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Paper {
    /// Szirmay-Kalos and Lazányi.
    SzirmayKalos,
    /// Kautz, Daubert and Seidel.
    Kautz,
    /// Frisvad, Frisvad, Christensen and Falster.
    Frisvad,
    /// Umenhoffer and Szirmay-Kalos.
    Umenhoffer,
    /// Sattler, Sarlette, Zachmann and Klein.
    Sattler,
}

impl Paper {
    /// All of them, in the order in which they run.
    pub const ALL: [Self; 5] = [
        Self::SzirmayKalos,
        Self::Kautz,
        Self::Frisvad,
        Self::Umenhoffer,
        Self::Sattler,
    ];

    /// What its experiments' ids begin with.
    pub fn id(self) -> &'static str {
        match self {
            Self::SzirmayKalos => "szirmay-kalos",
            Self::Kautz => "kautz",
            Self::Frisvad => "frisvad",
            Self::Umenhoffer => "umenhoffer",
            Self::Sattler => "sattler",
        }
    }

    /// Authors and title.
    pub fn title(self) -> &'static str {
        match self {
            Self::SzirmayKalos => {
                "Szirmay-Kalos and Lazányi: Indirect Diffuse and Glossy Illumination on the GPU"
            }
            Self::Kautz => {
                "Kautz, Daubert and Seidel: Advanced Environment Mapping in VR Applications"
            }
            Self::Frisvad => "Frisvad, Frisvad, Christensen and Falster: Direct Radiance Mapping",
            Self::Umenhoffer => {
                "Umenhoffer and Szirmay-Kalos: Robust Diffuse Final Gathering on the GPU"
            }
            Self::Sattler => {
                "Sattler, Sarlette, Zachmann and Klein: Hardware-accelerated Ambient Occlusion \
                 Computation"
            }
        }
    }
}

/// A place in a paper; as text `Figure 3`, `Table 1`, `§5.1.1` or `not in the paper`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Item {
    /// A numbered figure.
    Figure(u8),
    /// A numbered table.
    Table(u8),
    /// A section, by its number.
    Section(&'static str),
    /// Nothing that the paper shows or says.
    NotInThePaper,
}

impl fmt::Display for Item {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = match self {
            Self::Figure(number) => format!("Figure {number}"),
            Self::Table(number) => format!("Table {number}"),
            Self::Section(number) => format!("§{number}"),
            Self::NotInThePaper => "not in the paper".into(),
        };
        f.pad(&text)
    }
}

impl Serialize for Item {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}
