#!/usr/bin/env bash
# Tests the tests: plants the bugs of tests/mutants/ one by one and runs what ought to notice them.
#
#   scripts/mutants.sh            all of them; writes tests/mutants/RESULTS.md
#   scripts/mutants.sh NAME...    only these patches; writes nothing
#
# Bugs are planted in a copy of the working tree's tracked files, a git worktree that is removed at
# the end; what was built for it is kept for the next run. Ends with 1 if a bug survives without a reason,
# and with 2 if one can't be tried: its patch does not apply, it does not compile, its tests do not end,
# or its command fails or runs no test without it.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
patches=$root/tests/mutants
work=$root/target/mutants
tree=$work/tree
export CARGO_TARGET_DIR=$work/build INTERREFLECT_REQUIRE_GPU=1
# The longest that a build or a test command may take, in seconds.
limit=900

fail() {
    echo "mutants: $*" >&2
    exit 2
}

child=
finish() {
    if [ -n "$child" ]; then
        kill "$child" 2>/dev/null && wait "$child" || true
    fi
    git -C "$root" worktree remove --force "$tree" 2>/dev/null || true
}

# bounded LOG COMMAND...: runs a command in the copy, within the limit, and adds its output to a log.
bounded() {
    local log=$1 status=0
    shift
    # Behind the script, so that an interrupt is looked at before the command ends.
    (cd "$tree" && exec timeout "$limit" "$@") >>"$log" 2>&1 &
    child=$!
    wait "$child" || status=$?
    child=
    return "$status"
}

# field NAME PATCH: a line of a patch's header.
field() {
    sed -n -e '/^diff /q' -e "s/^$1: //p" "$2"
}

# places PATCH: the files that a patch changes.
places() {
    sed -n 's|^+++ b/\(.*\)|`\1`|p' "$1" | paste -sd' '
}

# try TESTS LOG: builds and runs a test command. Sets `outcome` to "passed", "caught by TESTS", or to
# why nothing can be said, and `seconds`.
try() {
    local status=0 start=$SECONDS failed
    local -a tests targets
    read -ra tests <<<"$1"
    read -ra targets <<<"${1%% -- *}"
    : >"$2"
    if ! bounded "$2" "${CARGO:-cargo}" test --quiet --no-run "${targets[@]}"; then
        outcome="ERROR: it does not compile"
    else
        bounded "$2" "${CARGO:-cargo}" test "${tests[@]}" || status=$?
        failed=$(sed -n 's/^test *\([^ ].*[^ ]\) *\.\.\. FAILED.*/`\1`/p' "$2")
        if [ "$status" -eq 124 ]; then
            outcome="ERROR: the tests do not end within $limit s"
        elif grep -q 'the shader `.*` is not valid' "$2"; then
            outcome="ERROR: its shader does not compile"
        elif [ -n "$failed" ]; then
            outcome="caught by $(summary "$failed")"
        elif [ "$status" -ne 0 ]; then
            outcome="ERROR: the tests end with $status and name none that failed"
        elif ! grep -q '^test .* \.\.\. ok' "$2"; then
            outcome="ERROR: no test ran"
        else
            outcome=passed
        fi
    fi
    seconds=$((SECONDS - start))
}

# summary LINES: the first three lines on one, and how many more there are.
summary() {
    local count
    count=$(wc -l <<<"$1")
    head -n 3 <<<"$1" | paste -sd' '
    if [ "$count" -gt 3 ]; then
        echo "and $((count - 3)) more"
    fi
}

# plant PATCH: one row of the table; counts survivors and errors.
plant() {
    local patch=$1 name why
    name=$(basename "$patch" .patch)
    if ! git -C "$tree" apply "$patch" 2>"$work/logs/$name.log"; then
        outcome="ERROR: the patch does not apply" seconds=0
    else
        try "$(field Tests "$patch")" "$work/logs/$name.log"
        git -C "$tree" apply --reverse "$patch"
    fi
    case $outcome in
        passed)
            survivors=$((survivors + 1))
            why=$(field Survives "$patch")
            [ -n "$why" ] || unexplained=$((unexplained + 1))
            outcome="**SURVIVED**: ${why:-no test notices}"
            ;;
        ERROR*) errors=$((errors + 1)) ;;
        *) outcome=${outcome#caught by } ;;
    esac
    echo "| $(field Bug "$patch") | $(places "$patch") | ${outcome//$'\n'/ } | $seconds |" |
        tee -a "$work/rows"
}

# check_unchanged PATCH...: whether each test command passes where no bug is planted.
check_unchanged() {
    local patch tests
    for patch in "$@"; do
        [ -f "$patch" ] || fail "there is no $patch"
        [ -n "$(field Bug "$patch")" ] && [ -n "$(field Tests "$patch")" ] ||
            fail "$patch needs a line 'Bug: ...' and a line 'Tests: ...' before its diff"
    done
    for patch in "$@"; do field Tests "$patch"; done | sort -u >"$work/commands"
    while read -r tests; do
        try "$tests" "$work/logs/unchanged.log" </dev/null
        echo "mutants: without a bug, cargo test $tests: $outcome ($seconds s)" >&2
        [ "$outcome" = passed ] || fail "see $work/logs/unchanged.log"
    done <"$work/commands"
}

# table: the results as a document.
table() {
    local commit
    commit=$(git -C "$root" rev-parse --short HEAD)
    git -C "$root" diff --quiet HEAD || commit="$commit with changes"
    echo "# Planted bugs"
    echo
    echo "Written by \`make mutants\` on $(date -u +%F) for commit $commit: $(wc -l <"$work/rows") bugs,"
    echo "$survivors survived, $errors could not be tried, $(((SECONDS + 59) / 60)) minutes on $(getconf _NPROCESSORS_ONLN) processors."
    echo
    echo "| planted bug | where | caught by | s |"
    echo "|---|---|---|---|"
    cat "$work/rows"
}

[ ! -e "$tree" ] ||
    fail "another run uses $tree; if none does: git worktree remove --force $tree"
mkdir -p "$work/logs"
: >"$work/rows"
changed=$(git -C "$root" stash create)
trap finish EXIT
trap 'exit 130' HUP INT TERM
git -C "$root" worktree add --quiet --detach "$tree" "${changed:-HEAD}"

chosen=("${@/#/$patches/}")
chosen=("${chosen[@]/%/.patch}")
[ "$#" -gt 0 ] || chosen=("$patches"/*.patch)
survivors=0 unexplained=0 errors=0
check_unchanged "${chosen[@]}"
for patch in "${chosen[@]}"; do plant "$patch"; done

echo "mutants: ${#chosen[@]} bugs, $survivors survived, $errors not tried, $SECONDS s" >&2
if [ "$#" -eq 0 ]; then
    table >"$patches/RESULTS.md.partial"
    mv "$patches/RESULTS.md.partial" "$patches/RESULTS.md"
fi
[ "$errors" -eq 0 ] || fail "see $work/logs"
[ "$unexplained" -eq 0 ]
