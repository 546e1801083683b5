#!/bin/sh
# Makes the documents' figures: the truth beside estimates, and their signed errors.
set -eu
cd "$(dirname "$0")/.."
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

# figure FILE SCENE QUANTITY ARGUMENT…: the overview of a bench of one scene and quantity
figure() {
    file=$1 scene=$2 quantity=$3
    shift 3
    rm -rf "$out/bench"
    "${CARGO:-cargo}" run --quiet --release --package interreflect -- bench "$scene" --backend cpu \
        --quantity "$quantity" --repeat 1 --out "$out/bench" "$@" >/dev/null
    mkdir -p "$(dirname "$file")"
    cp "$out/bench/images/$scene/$quantity/overview.png" "$file"
    echo "$file"
}

figure harness/figure/cornell-box.png cornell-box irradiance --points 5600 \
    --estimator classic_envmap --estimator localized_cubemap
figure estimators/src/constant_ambient/limits.png cornell-box irradiance --points 5600 \
    --estimator constant_ambient
figure estimators/src/classic_envmap/limits.png colored-room glossy_radiance --points 5600 \
    --estimator classic_envmap --set scene.receiver.place=wall
figure estimators/src/localized_cubemap/limits.png cornell-box irradiance --points 5600 \
    --estimator localized_cubemap
figure estimators/src/point_form_factor/limits.png cornell-box irradiance --points 5600 \
    --estimator point_form_factor
figure estimators/src/polygon_form_factor/limits.png divided-room irradiance --points 5600 \
    --estimator polygon_form_factor --set polygon_form_factor.resolution=8 \
    --set polygon_form_factor.bounces=8 --set scene.reference=passage
figure estimators/src/sh_mip_envmap/limits.png studio glossy_radiance --points 5600 \
    --estimator sh_mip_envmap --set sh_mip_envmap.lod=5 --set sh_mip_envmap.f_lambda=1
figure estimators/src/phong_envmap/limits.png studio glossy_radiance --points 5600 \
    --estimator phong_envmap
figure estimators/src/direct_radiance_map/limits.png cornell-box irradiance --points 5600 \
    --estimator direct_radiance_map --set direct_radiance_map.samples_per_side=5
figure estimators/src/directional_ao/limits.png studio ambient_occlusion --points 5600 \
    --estimator directional_ao
figure estimators/src/path_reference/limits.png cornell-box irradiance --points 5600 \
    --estimator path_reference --set path_reference.samples=16
