#!/bin/sh
# Runs the tests again and again beside loops that keep every processor busy: they must not depend on
# how fast the machine is, or on what else runs there.
#
#   scripts/loaded.sh                        five passes of all tests
#   scripts/loaded.sh PASSES [ARGUMENTS...]  so many of `scripts/test.sh ARGUMENTS...`
set -eu
cd "$(dirname "$0")/.."
passes=${1:-5}
[ "$#" -eq 0 ] || shift

loops=
# shellcheck disable=SC2086 # One number a loop.
trap 'kill $loops' EXIT
trap 'exit 130' HUP INT TERM
processor=0
while [ "$processor" -lt "$(getconf _NPROCESSORS_ONLN)" ]; do
    sh -c 'while :; do :; done' &
    loops="$loops $!"
    processor=$((processor + 1))
done

pass=0 failed=0
while [ "$pass" -lt "$passes" ]; do
    pass=$((pass + 1))
    echo "pass $pass of $passes" >&2
    ./scripts/test.sh "$@" || failed=$((failed + 1))
done
echo "$((passes - failed)) of $passes passes without a failure"
[ "$failed" -eq 0 ]
