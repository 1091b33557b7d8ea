#!/usr/bin/env bash
# Make the virtual environment ready, quickly when nothing changed.
#
#   scripts/environment.sh product    Maestra and what it needs to run, and a voice if it can
#   scripts/environment.sh developer  that, the planning extra and every tool of `make test`: also
#                                     PostgreSQL, Chromium and espeak-ng, installed if root asks
#   scripts/environment.sh nightly    the tools of `make fuzz`, `make mutation`, `make oracle`
#
# PYTHON names the interpreter to build it with; VENV the folder (.venv).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

level=${1:?product, developer or nightly}
venv=${VENV:-.venv}
needed="3.11"

refuse() {
    printf 'maestra: %s\n' "$1" >&2
    exit 1
}

new_enough() {
    "$1" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null
}

# The interpreter to build with: the one named, else python3, else a newer one beside it.
find_python() {
    local candidate
    if [[ -n ${PYTHON:-} ]]; then
        new_enough "$PYTHON" || refuse "$PYTHON is not Python $needed or newer"
        echo "$PYTHON"
        return
    fi
    for candidate in python3 python3.14 python3.13 python3.12 python3.11; do
        if command -v "$candidate" >/dev/null && new_enough "$candidate"; then
            command -v "$candidate"
            return
        fi
    done
    if command -v python3 >/dev/null; then
        refuse "Python $needed or newer is needed, and python3 here is $(python3 --version 2>&1); install a newer one, or name it: make PYTHON=/path/to/python3 ..."
    fi
    refuse "Python $needed or newer is needed, and there is no python3 here; install it (on Debian, as root: apt-get install python3 python3-venv)"
}

# Debian ships python3 without venv; as root we may add it, otherwise we say so.
ensure_venv_module() {
    local python=$1 package
    if "$python" -c 'import ensurepip, venv' 2>/dev/null; then
        return
    fi
    package=$("$python" -c 'import sys; print("python%d.%d-venv" % sys.version_info[:2])')
    if [[ $(id -u) -eq 0 ]] && command -v apt-get >/dev/null; then
        echo "Installing $package, which $python lacks"
        if apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq "$package" >/dev/null; then
            return
        fi
    fi
    refuse "$python cannot make virtual environments; install its venv module first (on Debian, as root: apt-get install $package)"
}

can_install() {
    [[ $(id -u) -eq 0 ]] && command -v apt-get >/dev/null
}

# Debian's packages, with what is said of them.
install_packages() {
    local why=$1
    shift
    echo "Installing $*, $why"
    apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq \
        --no-install-recommends -o Dpkg::Options::=--force-confold "$@" >/dev/null
}

# The tests start a PostgreSQL server of their own; only its programs must be there.
ensure_postgresql() {
    if compgen -G '/usr/lib/postgresql/*/bin/initdb' >/dev/null || command -v initdb >/dev/null; then
        return
    fi
    if can_install; then
        # No server of the system's own: the tests bring their folder and their user's rights.
        mkdir -p /etc/postgresql-common
        [[ -e /etc/postgresql-common/createcluster.conf ]] ||
            echo 'create_main_cluster = false' >/etc/postgresql-common/createcluster.conf
        if install_packages "which the tests of the record need" postgresql; then
            return
        fi
    fi
    refuse "the tests need the programs of PostgreSQL; install them first (on Debian, as root: apt-get install postgresql)"
}

# The tests of the pages drive the system's own browser: nothing is fetched by Playwright.
ensure_chromium() {
    if command -v chromium >/dev/null; then
        return
    fi
    if can_install && install_packages "which the tests of the pages need" chromium; then
        return
    fi
    refuse "the tests need Chromium; install it first (on Debian, as root: apt-get install chromium)"
}

# The robot's voice. Without it what it says is only read, so nobody is kept from using Maestra.
offer_espeak() {
    if command -v espeak-ng >/dev/null; then
        return
    fi
    if can_install && install_packages "the voice of the robot" espeak-ng; then
        return
    fi
    echo "maestra: without espeak-ng the robot only writes what it says; to hear it, install it (on Debian, as root: apt-get install espeak-ng)" >&2
}

ensure_espeak() {
    offer_espeak
    command -v espeak-ng >/dev/null ||
        refuse "the tests need espeak-ng; install it first (on Debian, as root: apt-get install espeak-ng)"
}

# False for a folder that was moved or copied (its programs name their old place), or whose
# interpreter is gone or too old.
environment_is_sound() {
    [[ -f $venv/maestra.location && $(<"$venv/maestra.location") == "$PWD/$venv" ]] &&
        [[ -x $venv/bin/python ]] && new_enough "$venv/bin/python"
}

if ! environment_is_sound; then
    python=$(find_python)
    ensure_venv_module "$python"
    echo "Creating $venv with $("$python" --version)"
    rm -rf "$venv"
    "$python" -m venv "$venv"
    echo "$PWD/$venv" >"$venv/maestra.location"
fi

[[ $level == product ]] || ensure_postgresql
if [[ $level == developer ]]; then
    ensure_chromium
    ensure_espeak
fi

# What is installed follows from pyproject.toml alone, so its content is the stamp.
wanted=$(cat pyproject.toml scripts/environment.sh | sha256sum | cut -d ' ' -f 1)
stamp=$venv/maestra-$level.stamp
if [[ $level == product && -f $venv/maestra-developer.stamp ]]; then
    stamp=$venv/maestra-developer.stamp
    level=developer
fi
if [[ -f $stamp && $(<"$stamp") == "$wanted" ]]; then
    exit 0
fi
rm -f "$venv"/maestra-*.stamp
echo "Installing Maestra in $venv ($level); the first time takes about a minute"
pip=("$venv/bin/python" -m pip --disable-pip-version-check -qq)
case $level in
product)
    offer_espeak
    "${pip[@]}" install --editable .
    ;;
developer)
    "${pip[@]}" install --upgrade 'pip>=25.1' # the first with --group
    "${pip[@]}" install --editable '.[planning,postgresql]' --group dev
    ;;
nightly)
    "${pip[@]}" install --upgrade 'pip>=25.1'
    "${pip[@]}" install --editable '.[planning,postgresql]' --group nightly
    ;;
*) refuse "unknown level $level: product, developer or nightly" ;;
esac
echo "$wanted" >"$stamp"
