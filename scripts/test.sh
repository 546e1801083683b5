#!/bin/sh
# Runs all tests, whatever fails, and says at the end how many passed, failed and were skipped, and
# which failed.
#
#   scripts/test.sh               all of them
#   scripts/test.sh ARGUMENTS...  those that `cargo test ARGUMENTS...` runs
#
# Ends as cargo does: with 0 if nothing failed. The last line is always `N passed, N failed, N skipped`;
# a program that crashed, or could not be built, counts as one that failed.
set -eu
cd "$(dirname "$0")/.."
[ "$#" -gt 0 ] || set -- --workspace

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' HUP INT TERM

# A pipe ends as its last command does: cargo's status goes past it.
echo 130 >"$work/status"
{
    status=0
    "${CARGO:-cargo}" test --no-fail-fast "$@" 2>&1 || status=$?
    echo "$status" >"$work/status"
} | tee "$work/log"
status=$(cat "$work/status")
awk -v status="$status" -f scripts/summary.awk "$work/log"
exit "$status"
