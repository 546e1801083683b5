#!/bin/sh
# Installs what a build and the GPU backend need and the machine lacks: a linker for Rust, a C++ compiler
# and a Vulkan driver; where INTERREFLECT_REQUIRE_BROWSER, INTERREFLECT_REQUIRE_NODE and
# INTERREFLECT_REQUIRE_PARALLEL are set, what the tests of the report's page, of its arithmetic and of sweeps
# in parts need. Says nothing and changes nothing if all is there.
set -eu
# shellcheck source=scripts/apt.sh
. "$(dirname "$0")/apt.sh"

# vulkan_driver: whether a Vulkan driver is registered, in the places where the loader looks.
vulkan_driver() {
    [ -n "${VK_DRIVER_FILES:-}${VK_ICD_FILENAMES:-}" ] && return 0
    for folder in "${XDG_CONFIG_HOME:-$HOME/.config}" /etc /usr/local/share /usr/share \
        "${XDG_DATA_HOME:-$HOME/.local/share}"; do
        for driver in "$folder"/vulkan/icd.d/*.json; do
            [ -e "$driver" ] && return 0
        done
    done
    return 1
}

# vulkan_loader: whether the dynamic linker finds libvulkan.
vulkan_loader() {
    PATH="$PATH:/sbin:/usr/sbin" ldconfig -p 2>/dev/null | grep -q 'libvulkan\.so\.1'
}

if ! command -v cargo >/dev/null 2>&1; then
    echo "interreflect: cargo is not in PATH: install Rust 1.95 or newer first" >&2
    exit 1
fi

if ! command -v cc >/dev/null 2>&1 || ! command -v c++ >/dev/null 2>&1; then
    apt_install "a linker for Rust, or a C++ compiler for FLIP, is missing" gcc g++ libc6-dev
fi

[ "$(uname -s)" = Linux ] || exit 0
if ! vulkan_driver; then
    apt_install "no Vulkan driver is registered; installing a software one for the GPU backend" \
        mesa-vulkan-drivers libvulkan1
elif ! vulkan_loader; then
    apt_install "the Vulkan loader is missing" libvulkan1
fi

# browser: whether there is one that the report's page can be tried in.
browser() {
    [ -n "${CHROME:-}" ] && return 0
    for name in chromium chromium-browser google-chrome-stable chrome; do
        command -v "$name" >/dev/null 2>&1 && return 0
    done
    return 1
}

if [ -n "${INTERREFLECT_REQUIRE_BROWSER:-}" ] && ! browser; then
    apt_install "no browser for the test of the report's page" chromium
fi

if [ -n "${INTERREFLECT_REQUIRE_NODE:-}" ] && ! command -v node >/dev/null 2>&1; then
    apt_install "no Node.js for the test of the page's arithmetic" nodejs
fi

if [ -n "${INTERREFLECT_REQUIRE_PARALLEL:-}" ] && ! command -v parallel >/dev/null 2>&1; then
    apt_install "no GNU parallel for the test of sweeps in parts" parallel
fi
