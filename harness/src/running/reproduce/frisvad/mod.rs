//! Frisvad, Frisvad, Christensen and Falster, *Direct Radiance Mapping*.

mod bleeding;
mod caustic;
mod dynamic;
mod flashing;
mod materials;
mod mirrors;
mod rates;
mod rsm;

use super::{Experiment, Paper};

const RULE_OF_COLOUR: &str = "A trial is one of these with an area or a spot light on a backend: \
    irradiance by 3×3 samples is nearer to path-traced truth, in mean squared error and beyond its \
    noise, than no indirect light at all; and, up to one factor on its brightness, than the best \
    uniform ambient light, which has the truth's mean colour; without that factor more than half \
    of the truth's light arrives; and the colours (red less green over their sum, weighted by the \
    truth's brightness) correlate with the truth's by more than a half.";

const RULE_OF_LIGHT: &str = "A trial is one of these on a backend: irradiance by 3×3 samples is \
    nearer to path-traced truth, in mean squared error and beyond its noise, than no indirect \
    light at all; and, up to one factor on its brightness, than the best uniform ambient light, \
    which has the truth's mean colour; without that factor more than half of the truth's light \
    arrives.";

pub(super) const EXPERIMENTS: &[Experiment] = &[
    Experiment {
        id: "frisvad.3",
        paper: Paper::Frisvad,
        item: "Figure 3",
        title: "Cornell box against radiosity",
        claim: "Colour bleeding in the Cornell box is comparable with radiosity's. Path tracing \
            stands in for radiosity.",
        rule: RULE_OF_COLOUR,
        run: bleeding::cornell_box,
    },
    Experiment {
        id: "frisvad.4",
        paper: Paper::Frisvad,
        item: "Figure 4",
        title: "cave against a photon map",
        claim: "Light of a lantern in a cave is comparable with a photon map's. Path tracing \
            stands in for the photon map.",
        rule: RULE_OF_LIGHT,
        run: bleeding::cave,
    },
    Experiment {
        id: "frisvad.5",
        paper: Paper::Frisvad,
        item: "Figure 5",
        title: "light over a mirror",
        claim: "Surfaces that a mirror illuminates become lights as well. Test: the cave's lantern is \
            turned to its mirror.",
        rule: "A trial is a backend: with the mirror, irradiance is nearer, in mean squared error, \
            to the own model with the mirror than the same map is with a black mirror in its \
            place; and of the light that the mirror brings to all points between half and twice as \
            much arrives. Path tracing finds no mirrored light of a point, so that the method's \
            own model, an integral, is the reference.",
        run: caustic::run,
    },
    Experiment {
        id: "frisvad.6",
        paper: Paper::Frisvad,
        item: "Figure 6",
        title: "contents of the reflective shadow map",
        claim: "The reflective shadow maps hold position, radiance and normal of the surfaces that \
            the light hits first.",
        rule: "A trial is a scene and a backend: less than one in a hundred photons lies elsewhere \
            than the place that a ray along its texel meets first, by a thousandth of the way; and \
            radiance differs from ρ/π·E·cos α there by less than 1 % rms.",
        run: rsm::run,
    },
    Experiment {
        id: "frisvad.7",
        paper: Paper::Frisvad,
        item: "Figure 7",
        title: "a large scene in motion",
        claim: "Nothing restricts geometry or dynamics: every frame is complete by itself. Test: \
            a light that moves through a large scene.",
        rule: "A trial is a backend: over all frames a session that goes on from frame to frame \
            estimates what a new one does, within a thousandth of the mean; and in the middle of \
            the sequence it is nearer to the truth, beyond its noise, than no indirect light at \
            all, and, up to one factor on its brightness, than the best uniform ambient light.",
        run: dynamic::run,
    },
    Experiment {
        id: "frisvad.8",
        paper: Paper::Frisvad,
        item: "Figure 8",
        title: "mirrors without, with faked and with indirect light",
        claim: "In a mirror, (a) missing indirect light is seen, (b) treating the mirror as diffuse \
            hides it, (c) light estimated at the surfaces seen in it is right.",
        rule: "A trial is a pair on a backend: at the pixels of mirrors, (b) is nearer to the picture \
            with path-traced light than (a), and (c) is nearer than (b), in mean squared error \
            beyond the reference's noise. Indirect light of all three is brought to the truth's \
            by one factor, from all surfaces that are seen.",
        run: mirrors::run,
    },
    Experiment {
        id: "frisvad.9",
        paper: Paper::Frisvad,
        item: "Figure 9",
        title: "surfaces that are not Lambertian",
        claim: "With normals and true colours in the map, lit surfaces may reflect by any law. \
            Test: a Cornell box of glossy walls.",
        rule: "A trial is a fidelity and a backend: irradiance is nearer to path-traced truth, in \
            mean squared error beyond its noise, where lit surfaces reflect by their whole \
            material than by Lambert's law.",
        run: materials::run,
    },
    Experiment {
        id: "frisvad.table1",
        paper: Paper::Frisvad,
        item: "Table 1",
        title: "frame rates over samples and triangles",
        claim: "The frame rate falls with the number of samples, 2×2 to 5×5, and with that of \
            triangles, and stays interactive.",
        rule: "A trial is a scene or a number of samples, on a backend: a frame of 5×5 samples \
            takes longer than one of 2×2, and one of the scene of most triangles longer than one \
            of the fewest, each beyond the spread of both; and each frame takes less than a \
            second. Frames hold capture, preparation and shading at as many points.",
        run: rates::run,
    },
    Experiment {
        id: "frisvad.flashing",
        paper: Paper::Frisvad,
        item: "§5",
        title: "flashing while the light moves",
        claim: "Few samples make the light flash while it moves; mip averaging reduces that.",
        rule: "A trial is a scene and a backend: flicker, the mean second difference from frame to \
            frame over the mean, is without averaging more than twice that of a map of 64² texels, \
            all taken; and with averaging less than 80 % of that without. The light swings by 1° a \
            frame.",
        run: flashing::run,
    },
];
