# Sums up what `cargo test --no-fail-fast` printed; `status` is what it ended with.

# A program begins, and the one before it is over: without a result it crashed.
/^ +(Running|Doc-tests) / {
    crashed()
    # The name of a binary without its folder and digest, or that of a crate.
    program = $NF
    sub(/.*[\/(]/, "", program)
    sub(/-[0-9a-f]+\)$/, "", program)
    count = 0
}

# The names of those that failed are listed before the result, after their messages.
/^failures:$/ { listing = 1; count = 0; next }
listing && /^    [^ ]/ { names[count++] = substr($0, 5); next }
{ listing = 0 }

/^test result: / {
    for (i = 4; i < NF; i++) {
        if ($(i + 1) == "passed;") passed += $i
        if ($(i + 1) == "failed;") failed += $i
        if ($(i + 1) == "ignored;") skipped += $i
    }
    for (i = 0; i < count; i++) list = list "\n    " program ": " names[i]
    program = ""
    count = 0
}

function crashed() {
    if (program == "") return
    failed++
    list = list "\n    " program ": ended without a result"
}

END {
    crashed()
    if (status != 0 && !failed) {
        failed = 1
        list = "\n    cargo test: ended with " status
    }
    print ""
    if (list != "") print "failed:" list
    printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped
}
