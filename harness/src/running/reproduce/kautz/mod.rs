//! Kautz, Daubert and Seidel, *Advanced Environment Mapping in VR Applications*.

mod border;
mod environments;
mod grid;
mod objects;
mod phong;

use super::{Experiment, Paper};

pub(super) const EXPERIMENTS: &[Experiment] = &[
    Experiment {
        id: "kautz.3",
        paper: Paper::Kautz,
        item: "Figure 3",
        title: "diffuse and glossy objects",
        claim: "Nine spherical harmonics, projected from a cube map of 8² texels a face, light a \
            diffuse object as the whole environment does, and are made anew in every frame. Test: \
            the irradiance of a model under several environments, against the exact \
            convolution.",
        rule: "A trial is an environment and a backend: the irradiance differs from the exact \
            convolution by less than 5 % rms of its mean; and preparing both maps takes less time \
            than convolving one cube map, beyond the spread of both.",
        run: objects::run,
    },
    Experiment {
        id: "kautz.4",
        paper: Paper::Kautz,
        item: "Figure 4",
        title: "seams of filtering each face by itself",
        claim: "Mip levels that are filtered face by face show seams along the edges of the cube; \
            filtering across a border removes them.",
        rule: "A trial is an environment, level and backend: across the cube's edges the published \
            map steps more than three times as far as inside its faces, over the same angle; and \
            the map that is filtered across edges steps less than half as far as the published one \
            there.",
        run: border::run,
    },
    Experiment {
        id: "kautz.5",
        paper: Paper::Kautz,
        item: "Figure 5",
        title: "box filter against the Phong filter, N = 225",
        claim: "The box filter of mip levels looks like the Phong filter of N = 225, and is fast \
            enough for every frame.",
        rule: "A trial is an environment and a backend: at the matching level pictures of mirrored \
            light alone, clipped and encoded as they are shown, differ by less than 5 % of white, \
            rms, from the Phong filter's; and preparation takes less than a tenth of the Phong \
            filter's time, beyond the spread of both.",
        run: phong::run,
    },
    Experiment {
        id: "kautz.6",
        paper: Paper::Kautz,
        item: "Figure 6",
        title: "bias b and Fresnel term f_λ",
        claim: "The bias b on the mip level sets how blurred an object's reflections are, f_λ how \
            strong they are. Test: a grid of pictures over both.",
        rule: "A trial is a step of the grid on a backend: with each step of b neighbouring pixels \
            differ less, f_λ kept; with each step of f_λ the picture is farther from that of f_λ = \
            0, rms, b kept.",
        run: grid::run,
    },
];
