//! Frisvad, Frisvad, Christensen and Falster, *Direct Radiance Mapping*.

mod bleeding;
mod caustic;
mod dynamic;
mod flashing;
mod materials;
mod mirrors;
mod rates;
mod rsm;

use super::scene_setup::SceneSetup;
use super::setup::InCode;
use super::{Claim, Experiment, Item, Paper};
use flashing::Flashing;
use rsm::LightPictures;

const NEARER: Claim = Claim {
    id: "C1",
    says: "Few samples are nearer to the truth than no indirect light, and in shape than ambient light.",
    rule: "A trial is a case and a backend: irradiance by 3×3 samples is nearer to path-traced truth, in \
        mean squared error and beyond its noise, than no indirect light at all; and, up to one factor on its \
        brightness, than the best uniform ambient light, which has the truth's mean colour.",
};

const ENOUGH: Claim = Claim {
    id: "C2",
    says: "Most of the truth's light arrives.",
    rule: "A trial is a case and a backend: more than half of the sum of the truth.",
};

/// Square lights that swing, wide enough to light several surfaces.
const fn swinging(source: &'static str) -> SceneSetup {
    SceneSetup::of(source).set(&[("light.angle", "95")])
}

pub(super) const EXPERIMENTS: &[Experiment] = &[
    Experiment {
        id: "frisvad.6",
        paper: Paper::Frisvad,
        item: Item::Figure(6),
        title: "positions, radiance and normals seen from the light",
        setup: &LightPictures {
            scene: SceneSetup::of("cornell-box"),
        },
        claims: &[],
    },
    Experiment {
        id: "frisvad.flashing",
        paper: Paper::Frisvad,
        item: Item::Section("5"),
        title: "flashing while the light moves",
        setup: &Flashing {
            scenes: [swinging("cornell-box"), swinging("cave")],
            texels: 16,
            samples: 3,
        },
        claims: &[
            Claim {
                id: "C1",
                says: "Few samples make the light flash while it moves.",
                rule: "A trial is a scene and a backend: flicker, the mean second difference from frame to \
                    frame over the mean, is more than twice that of a map of 64² texels, all taken. The \
                    light swings by 1° a frame.",
            },
            Claim {
                id: "C2",
                says: "Averaged radiance lessens the flashing.",
                rule: "A trial is a scene and a backend: flicker with averaging is less than 80 % of that \
                    without.",
            },
        ],
    },
    Experiment {
        id: "frisvad.bleeding",
        paper: Paper::Frisvad,
        item: Item::NotInThePaper,
        title: "few samples in the Cornell box against path tracing",
        setup: &InCode(bleeding::cornell_box),
        claims: &[
            NEARER,
            ENOUGH,
            Claim {
                id: "C3",
                says: "The light has the truth's colours.",
                rule: "A trial is an area or a spot light and a backend: the colours (red less green over \
                    their sum, weighted by the truth's brightness) correlate with the truth's by more \
                    than a half.",
            },
        ],
    },
    Experiment {
        id: "frisvad.lantern",
        paper: Paper::Frisvad,
        item: Item::NotInThePaper,
        title: "few samples of a lantern in the cave against path tracing",
        setup: &InCode(bleeding::cave),
        claims: &[NEARER, ENOUGH],
    },
    Experiment {
        id: "frisvad.caustic",
        paper: Paper::Frisvad,
        item: Item::NotInThePaper,
        title: "light over a mirror",
        setup: &InCode(caustic::run),
        claims: &[
            Claim {
                id: "C1",
                says: "Light that a mirror brings is in the map.",
                rule: "A trial is a backend: irradiance is nearer, in mean squared error, to the own model \
                    with the mirror than the same map is with a black mirror in its place. Path tracing \
                    finds no mirrored light of a point, so that the method's own model, an integral, is \
                    the reference.",
            },
            Claim {
                id: "C2",
                says: "As much of it arrives as the mirror brings.",
                rule: "A trial is a bound and a backend: of the light that the mirror brings to all points \
                    between half and twice as much arrives.",
            },
        ],
    },
    Experiment {
        id: "frisvad.rsm",
        paper: Paper::Frisvad,
        item: Item::NotInThePaper,
        title: "contents of the reflective shadow map, texel by texel",
        setup: &InCode(rsm::run),
        claims: &[
            Claim {
                id: "C1",
                says: "Photons lie on the surfaces that the light hits first.",
                rule: "A trial is a scene and a backend: less than one in a hundred photons lies elsewhere \
                    than the place that a ray along its texel meets first, by a thousandth of the way.",
            },
            Claim {
                id: "C2",
                says: "They hold the light that is reflected there.",
                rule: "A trial is a scene and a backend: radiance differs from ρ/π·E·cos α by less than \
                    1 % rms.",
            },
        ],
    },
    Experiment {
        id: "frisvad.motion",
        paper: Paper::Frisvad,
        item: Item::NotInThePaper,
        title: "a light that moves through a large scene",
        setup: &InCode(dynamic::run),
        claims: &[
            Claim {
                id: "C1",
                says: "Every frame is complete by itself.",
                rule: "A trial is a backend: over all frames a session that goes on from frame to frame \
                    estimates what a new one does, within a thousandth of the mean.",
            },
            Claim { id: "C2", ..NEARER },
        ],
    },
    Experiment {
        id: "frisvad.mirrors",
        paper: Paper::Frisvad,
        item: Item::NotInThePaper,
        title: "mirrors in the cave without, with faked and with indirect light",
        setup: &InCode(mirrors::run),
        claims: &[
            Claim {
                id: "C1",
                says: "Treating a mirror as diffuse hides that indirect light is missing in it.",
                rule: "A trial is a backend: at the pixels of mirrors the trick is nearer to the picture \
                    with path-traced light than nothing is, in mean squared error beyond the reference's \
                    noise. Indirect light of all pictures is brought to the truth's by one factor, from \
                    all surfaces that are seen.",
            },
            Claim {
                id: "C2",
                says: "Light estimated at the surfaces seen in a mirror is right.",
                rule: "A trial is a backend: as before, of included light against the trick.",
            },
        ],
    },
    Experiment {
        id: "frisvad.materials",
        paper: Paper::Frisvad,
        item: Item::NotInThePaper,
        title: "a Cornell box of glossy walls",
        setup: &InCode(materials::run),
        claims: &[Claim {
            id: "C1",
            says: "With true colours in the map, lit surfaces may reflect by any law.",
            rule: "A trial is a fidelity and a backend: irradiance is nearer to path-traced truth, in mean \
                squared error beyond its noise, where lit surfaces reflect by their whole material than by \
                Lambert's law.",
        }],
    },
    Experiment {
        id: "frisvad.rates",
        paper: Paper::Frisvad,
        item: Item::NotInThePaper,
        title: "frame rates over samples and triangles",
        setup: &InCode(rates::run),
        claims: &[
            Claim {
                id: "C1",
                says: "More samples take longer.",
                rule: "A trial is a scene and a backend: a frame of 5×5 samples takes longer than one of \
                    2×2, beyond the spread of both. Frames hold capture, preparation and shading at as \
                    many points.",
            },
            Claim {
                id: "C2",
                says: "More triangles take longer.",
                rule: "A trial is a number of samples and a backend: a frame of the scene of most \
                    triangles takes longer than one of the fewest, beyond the spread of both.",
            },
            Claim {
                id: "C3",
                says: "Frames are interactive.",
                rule: "A trial is a scene and a backend: a frame of 5×5 samples takes less than a second.",
            },
        ],
    },
];
