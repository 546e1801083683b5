//! Frisvad, Frisvad, Christensen and Falster, *Direct Radiance Mapping*.

mod bleeding;
mod caustic;
mod dynamic;
mod flashing;
mod materials;
mod mirror_balls;
mod mirrors;
mod rates;
mod rsm;
mod solid_angles;
mod steps;
mod table;
mod traced;

use super::scene_setup::SceneSetup;
use super::setup::InCode;
use super::{Claim, Experiment, Item, Paper};
use flashing::Flashing;
use mirror_balls::MirrorBalls;
use rsm::LightPictures;
use solid_angles::{BackSides, CloseToTheLight, Compared, NumberOfSamples};
use steps::Step::{
    BlinnPhong, Direct, Eq11, Eq14, Eq14MirrorsAsDiffuse, Eq14WithoutMirrored, Eq15,
};
use steps::{EverDearer, GRID};
use table::{FrameRates, Rates};
use traced::AgainstPathTracing;

/// The Cornell box under a distant area light, by eq. 9.
const BOX: SceneSetup = SceneSetup::of("cornell-box").set(&[("light", "area")]);
const BALLS: SceneSetup =
    SceneSetup::of("cornell-box").set(&[("light", "area"), ("inside", "mirror_balls")]);
const CAVE: SceneSetup = SceneSetup::of("cave");
const CAVE_WITHOUT_MIRRORS: SceneSetup = SceneSetup::of("cave").set(&[("mirrors", "false")]);

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
        id: "frisvad.3",
        paper: Paper::Frisvad,
        item: Item::Figure(3),
        title: "Cornell box: local shading, direct light, direct and indirect light",
        setup: &EverDearer {
            scenes: &[BOX],
            steps: &[BlinnPhong, Direct, Eq15],
            grid: GRID,
        },
        claims: &[Claim {
            id: "C1",
            says: "Direct light by eq. 9 is dearer than Blinn-Phong, and indirect light dearer still: 769, 137 and 48.6 frames a second.",
            rule: "A trial is a step to the next picture and a backend: its frame takes longer, beyond the \
                spread of both. Blinn-Phong has no shadows; direct light is Lambert's with shadows, and part of \
                the frame with indirect light. The lamp is a distant area light, seen 90° wide along its normal.",
        }],
    },
    Experiment {
        id: "frisvad.4",
        paper: Paper::Frisvad,
        item: Item::Figure(4),
        title: "the three solid angles",
        setup: &Compared {
            scene: BOX,
            grid: GRID,
        },
        claims: &[
            Claim {
                id: "C1",
                says: "Eq. 15 costs as much as eq. 11.",
                rule: "A trial is a backend: a frame, direct light included, takes less than 1.25 times as long.",
            },
            Claim {
                id: "C2",
                says: "Eq. 14 costs about 2.3 times as much.",
                rule: "A trial is a bound and a backend: a frame by eq. 14 over one by eq. 11 is within a \
                    factor of 1.5 of the paper's 2.33, beyond the spread of both.",
            },
            Claim {
                id: "C3",
                says: "Eq. 15 resembles eq. 14 more than eq. 11 does.",
                rule: "A trial is a backend: irradiance by eq. 15 is nearer to that by eq. 14, in mean squared \
                    error.",
            },
        ],
    },
    Experiment {
        id: "frisvad.5",
        paper: Paper::Frisvad,
        item: Item::Figure(5),
        title: "Cornell box by path tracing and by eq. 14",
        setup: &AgainstPathTracing {
            scene: BOX,
            grid: GRID,
        },
        claims: &[
            Claim {
                id: "C1",
                says: "The map is cruder, its bleeding more mixed over floor, ceiling and back wall.",
                rule: "A trial is a backend: red less green over their sum has a smaller standard deviation over \
                    these walls than path tracing's.",
            },
            Claim {
                id: "C2",
                says: "Regions in shadow are too bright.",
                rule: "A trial is a backend: the floor's mean irradiance where no direct light falls, over that \
                    where it does, is larger than path tracing's.",
            },
            Claim {
                id: "C3",
                says: "There is no bright spot above the tall box.",
                rule: "A trial is a backend: the ceiling within 8 cm above the tall box, over all of the ceiling, is \
                    less bright than path tracing's.",
            },
            Claim {
                id: "C4",
                says: "The tall box is greener in front.",
                rule: "A trial is a backend: green over red on the tall box's front is larger than path tracing's.",
            },
            Claim {
                id: "C5",
                says: "The map is thousands of times faster.",
                rule: "A trial is a backend: a frame, direct light included, is more than 1000 times as fast as \
                    path tracing the indirect light on all processors, beyond its spread.",
            },
        ],
    },
    Experiment {
        id: "frisvad.6",
        paper: Paper::Frisvad,
        item: Item::Figure(6),
        title: "positions, radiance and normals seen from the light",
        setup: &LightPictures { scene: BOX },
        claims: &[],
    },
    Experiment {
        id: "frisvad.7",
        paper: Paper::Frisvad,
        item: Item::Figure(7),
        title: "an object close to the light",
        setup: &CloseToTheLight {
            scene: SceneSetup::of("cornell-box")
                .with(&["blob"])
                .set(&[("light", "area"), ("receiver.place", "lamp")]),
            without: BOX,
            grid: GRID,
        },
        claims: &[
            Claim {
                id: "C1",
                says: "Eq. 11 overexposes, as one triangle near the light can cover all texels.",
                rule: "A trial is a comparison and a backend: mean irradiance by eq. 11 is more than twice that of \
                    path tracing, and more than by eq. 15 and by eq. 14.",
            },
            Claim {
                id: "C2",
                says: "By eq. 11 the light of every surface depends on where all samples fall.",
                rule: "A trial is another equation and a backend: with the object mean irradiance changes by a \
                    larger factor by eq. 11.",
            },
        ],
    },
    Experiment {
        id: "frisvad.8",
        paper: Paper::Frisvad,
        item: Item::Figure(8),
        title: "two mirror balls without, with faked and with indirect light",
        setup: &MirrorBalls {
            scene: BALLS,
            grid: GRID,
        },
        claims: &[
            Claim {
                id: "C1",
                says: "The trick costs nothing.",
                rule: "A trial is a backend: a frame with the trick takes less than 1.1 times as long as one \
                    without indirect light in mirrors, beyond the spread of both.",
            },
            Claim {
                id: "C2",
                says: "Included light is dearer.",
                rule: "A trial is a backend: a frame with the light included takes longer than with the trick, \
                    beyond the spread of both.",
            },
            Claim {
                id: "C3",
                says: "The trick looks nearer to included light than its absence does.",
                rule: "A trial is a backend: over the pixels that differ, the picture with the trick is nearer, in \
                    mean squared error, to that with the light included.",
            },
        ],
    },
    Experiment {
        id: "frisvad.9",
        paper: Paper::Frisvad,
        item: Item::Figure(9),
        title: "a cave: direct light, with eq. 15, with eq. 14",
        setup: &EverDearer {
            scenes: &[CAVE, CAVE_WITHOUT_MIRRORS],
            steps: &[Direct, Eq15, Eq14],
            grid: GRID,
        },
        claims: &[Claim {
            id: "C1",
            says: "Eq. 15 is dearer than direct light alone and eq. 14 than eq. 15, with mirrors (20.8, 11.9, 7.7 frames a second) and without (48.0, 18.4, 10.3).",
            rule: "A trial is a scene, a step to the next picture and a backend: its frame takes longer, beyond the \
                spread of both.",
        }],
    },
    Experiment {
        id: "frisvad.table1",
        paper: Paper::Frisvad,
        item: Item::Table(1),
        title: "frame rates of the figures' scenes and of a large dragon",
        setup: &FrameRates {
            rows: &[
                Rates {
                    scene: BOX,
                    steps: &[BlinnPhong, Direct, Eq15],
                    rates: &[769.231, 137.3, 48.622],
                },
                Rates {
                    scene: BOX,
                    steps: &[Eq11, Eq15, Eq14],
                    rates: &[48.622, 48.622, 20.87],
                },
                Rates {
                    scene: BALLS,
                    steps: &[Eq14WithoutMirrored, Eq14MirrorsAsDiffuse, Eq14],
                    rates: &[15.178, 15.178, 9.898],
                },
                Rates {
                    scene: CAVE,
                    steps: &[Direct, Eq15, Eq14],
                    rates: &[20.761, 11.888, 7.695],
                },
                Rates {
                    scene: CAVE_WITHOUT_MIRRORS,
                    steps: &[Direct, Eq15, Eq14],
                    rates: &[48.0, 18.4, 10.3],
                },
                Rates {
                    scene: SceneSetup::of("cornell-box")
                        .with(&["dragon_871k"])
                        .set(&[("light", "area"), ("receiver.size", "0.25")]),
                    steps: &[Eq15, Eq14],
                    rates: &[1.8, 0.92],
                },
            ],
            grid: GRID,
        },
        claims: &[Claim {
            id: "C1",
            says: "In each row times stand in the ratios of the table.",
            rule: "A trial is a bound, a picture beside the first of its row, and a backend: the ratio of their \
                frames' times is within a factor of 2 of the paper's, beyond the spread of both.",
        }],
    },
    Experiment {
        id: "frisvad.samples",
        paper: Paper::Frisvad,
        item: Item::Section("5"),
        title: "number of samples",
        setup: &NumberOfSamples {
            scene: BOX,
            texels: 16,
            samples: [2, 3, 4, 5],
        },
        claims: &[
            Claim {
                id: "C1",
                says: "2×2 samples are better than a constant ambient term.",
                rule: "A trial is a backend: up to one factor on its brightness irradiance by 2×2 samples is \
                    nearer to path tracing, in mean squared error beyond its noise, than the truth's mean colour.",
            },
            Claim {
                id: "C2",
                says: "They miss changing shades of bleeding.",
                rule: "A trial is a backend: colours correlate less with the truth's than those of 4×4 samples.",
            },
            Claim {
                id: "C3",
                says: "4×4 samples are not markedly better than 3×3.",
                rule: "A trial is a backend: up to brightness the error of 3×3 samples is less than 1.5 times that \
                    of 4×4, beyond the reference's noise.",
            },
        ],
    },
    Experiment {
        id: "frisvad.back-sides",
        paper: Paper::Frisvad,
        item: Item::Section("6"),
        title: "surfaces that face away from a sample",
        setup: &BackSides {
            scene: SceneSetup::of("cornell-box").set(&[("light.angle", "20")]),
            below_m: 0.1,
            grid: GRID,
        },
        claims: &[Claim {
            id: "C1",
            says: "Eqs. 11 and 15 light back sides.",
            rule: "A trial is an equation and a backend: points below the floor that look up at it get more light \
                than by eq. 14. The spot light is so narrow that all samples lie on the floor and on a block's top.",
        }],
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
