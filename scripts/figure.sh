#!/bin/sh
# Makes the README's figure: the truth beside three estimates, and their signed errors.
set -eu
cd "$(dirname "$0")/.."
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
"${CARGO:-cargo}" run --release --package interreflect -- bench cornell-box --backend cpu \
    --estimator classic_envmap --estimator localized_cubemap --quantity irradiance \
    --points 5600 --out "$out"
mkdir -p harness/figure
cp "$out/images/cornell-box/irradiance/overview.png" harness/figure/cornell-box.png
