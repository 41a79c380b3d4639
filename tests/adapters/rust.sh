# rust.sh: functions for both builds of Rust packages, sourced by build.sh and build-rapier.sh.
# `name` is the name of the package in messages.
# shellcheck shell=sh

# Ends with exit code 77: this part cannot be built here, for the given reason.
missing() {
    echo "$name skipped: $1" >&2
    exit 77
}

fail() {
    echo "$name: $1" >&2
    exit 1
}

need_rust() {
    command -v cargo >/dev/null 2>&1 ||
        missing "Rust is missing (cargo 1.95 or later, see rustup.rs)"
    rust=$(rustc --version 2>/dev/null | sed -n 's/^rustc 1\.\([0-9]*\)\..*/\1/p')
    [ -n "$rust" ] || missing "rustc does not run"
    [ "$rust" -ge 95 ] || missing "Rust 1.$rust is too old (1.95 or later is needed)"
}

# copy_package FROM TO: copies the package, so that cargo's lock file stays out of the source tree.
# Only changed files are copied, so that a second call builds nothing.
copy_package() {
    for file in Cargo.toml src/lib.rs; do
        cmp -s "$1/$file" "$2/$file" || cp "$1/$file" "$2/$file"
    done
}

# replace FILE: moves FILE.new to FILE unless both are equal, so that cmake sees no change.
replace() {
    if cmp -s "$1.new" "$1"; then
        rm "$1.new"
    else
        mv "$1.new" "$1"
    fi
}
