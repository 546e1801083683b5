# shellcheck shell=sh
# Sourced by the other scripts: installs packages of Debian or Ubuntu.

# apt_install WHY PACKAGE...: installs packages, and says why.
apt_install() {
    echo "interreflect: $1" >&2
    shift
    if ! command -v apt-get >/dev/null 2>&1; then
        echo "interreflect: install with your system's package manager: $*" >&2
        return 1
    fi
    # Package lists may be missing or old: refresh them once if the first try fails.
    apt_run install -y --no-install-recommends "$@" ||
        { apt_run update && apt_run install -y --no-install-recommends "$@"; }
}

# apt_run ARGUMENT...: apt-get without questions, as root directly, else through sudo; the command
# is shown before it runs, and its output goes to standard error.
apt_run() {
    set -- env DEBIAN_FRONTEND=noninteractive apt-get -q "$@"
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null 2>&1; then
            echo "interreflect: there is no sudo: run this as root: $*" >&2
            return 1
        fi
        set -- sudo "$@"
    fi
    echo "+ $*" >&2
    "$@" >&2 </dev/null
}
