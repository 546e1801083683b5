#!/bin/sh
# Compares what two builds compute on every built-in scene, on both backends, value for value and pixel
# for pixel; what may differ by nature is listed in scripts/same_results.py, with the reasons.
#
#   scripts/same-results.sh OLD NEW            all of them, then verify, probe and render: ten minutes a build
#   scripts/same-results.sh OLD NEW SCENE...   only bench, sweep and reference on these scenes
#
# OLD and NEW are each a program, a checkout whose target/release/interreflect is built, or a folder that
# an earlier run left: what the programs print and write is kept in target/same-results/old and new.
# Ends with 0 if all values are the same, with 1 if not.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
# shellcheck source=scripts/apt.sh
. "$root/scripts/apt.sh"
kept=${CARGO_TARGET_DIR:-$root/target}/same-results

# invocations: every command whose results are compared, in the current folder. Where builds want a command
# said in another way, this is the place. Budgets are small: costs, not what is reached, depend on them.
invocations() {
    record list list --needs --json
    for scene in ${scenes:-$(names scenes)}; do
        points=256 also=
        case $scene in
            cornell-box) vary=scene.light=spot,emitter ;;
            colored-room)
                vary=scene.receiver.gap=.1,.02
                # Its reference point was in the middle of the receiver before it could be moved.
                ! grep -q '"reference.offset"' list.json || also="--set scene.reference.offset=0"
                ;;
            divided-room) vary=scene.divider.depth=.4,.8 ;;
            studio) vary=scene.receiver.size=.5,1 ;;
            furnace) vary=scene.albedo=.3,.6 ;;
            cave) vary=scene.light.angle=20,95 ;;
            pit) vary=scene.sky=constant,procedural ;;
            dragons) vary=scene.neighbours.gap=.04,.2 points=64 ;;
            *) vary=scene.camera.orbit_deg_per_s=0,1 ;;
        esac
        # shellcheck disable=SC2086 # Words.
        record "bench-$scene" bench "$scene" $also --backend both --seed 7 --samples 8 --repeat 1 \
            --points "$points" --set path_reference.samples=8 --set classic_envmap.map_resolution=8 \
            --set phong_envmap.map_resolution=8 --json --out "bench-$scene"
        # shellcheck disable=SC2086 # Words.
        record "sweep-$scene" sweep "$scene" $also --backend both --seed 7 --samples 8 --repeat 1 \
            --vary localized_cubemap.resolution=2,4 --vary directional_ao.level=0,1 \
            --vary "$vary" --vary run.points=16,32 --json --out "sweep-$scene"
        # shellcheck disable=SC2086 # Words.
        record "reference-$scene" reference "$scene" $also --points 256 --samples 8 --seed 7 --json
    done
    [ -z "$scenes" ] || return 0
    record verify verify --cases 4 --json
    write_points >points.csv
    for estimator in $(names estimators); do
        # What an estimator does not offer, and where it does not run, is refused by both builds.
        for backend in cpu gpu; do
            for quantity in irradiance glossy_radiance ambient_occlusion; do
                record "probe-$estimator-$quantity-$backend" probe cornell-box --estimator "$estimator" \
                    --backend "$backend" --quantity "$quantity" --material .5,.5,5 --points points.csv --json
            done
            record "render-$estimator-$backend" render cave --estimator "$estimator" \
                --backend "$backend" --width 32 --height 24 --json --out "render-$estimator-$backend"
        done
    done
}

# record NAME ARGUMENT...: runs the program, and keeps what it prints and its exit code.
record() {
    name=$1 code=0
    echo "$name" >&2
    shift
    "$program" "$@" >"$name.json" 2>"$name.err" </dev/null || code=$?
    echo "{\"exit_code\": $code}" >"$name.code.json"
}

# names KIND: the names or identifiers of the scenes or estimators that the program lists.
names() {
    python3 -c "import json, sys
for entry in json.load(sys.stdin)[sys.argv[1]]: print(entry.get('id') or entry['name'])" "$1" <list.json
}

# write_points: places in the middle of a scene, with normals and directions to a viewer.
write_points() {
    echo "x,y,z,nx,ny,nz,vx,vy,vz"
    for place in 0,0,0 .1,-.2,.3 -.3,.2,-.1 .25,.3,.2; do
        for directions in 0,1,0,0,.6,.8 0,0,1,0,.6,.8 1,0,0,.8,0,.6 0,-1,0,.6,-.8,0; do
            echo "$place,$directions"
        done
    done
}

# results BUILD NAME: the folder of a build's results, made now unless there is one.
results() {
    if [ -e "$1/list.json" ]; then
        echo "$1"
        return
    fi
    program=$1
    [ ! -d "$1" ] || program=$1/target/release/interreflect
    program=$(realpath "$program")
    rm -rf "${kept:?}/$2"
    mkdir -p "$kept/$2"
    echo "running $program" >&2
    (cd "$kept/$2" && invocations)
    echo "$kept/$2"
}

[ "$#" -ge 2 ] || {
    sed -n '2,/^set /s/^# \{0,1\}//p' "$0" >&2
    exit 2
}
command -v python3 >/dev/null 2>&1 || apt_install "python3 is missing" python3-minimal
old=$1 new=$2
shift 2
scenes=$*
old=$(results "$old" old)
new=$(results "$new" new)
exec python3 "$root/scripts/same_results.py" "$old" "$new"
