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

# frame FILE SCENE ARGUMENT…: the first frame of a sequence
frame() {
    file=$1
    shift
    rm -rf "$out/frames"
    "${CARGO:-cargo}" run --quiet --release --package interreflect -- render "$@" --frames 1 \
        --out "$out/frames" >/dev/null
    cp "$out"/frames/*.png "$file"
    echo "$file"
}

for filter in triangles vertices; do
    frame "estimators/src/directional_ao/filter-$filter.png" dragons --receiver torus \
        --estimator directional_ao --quantity ambient_occlusion --shade-at vertices \
        --width 256 --height 256 --set filter="$filter" --set scene.ground.cells=12
done

# The picture of each method's limits, as the method says.
"${CARGO:-cargo}" run --quiet --release --package interreflect -- list --figures |
    while read -r id scene quantity settings; do
        set --
        for setting in $settings; do
            set -- "$@" --set "$setting"
        done
        figure "estimators/src/$id/limits.png" "$scene" "$quantity" --points 5600 \
            --estimator "$id" "$@" </dev/null
    done
