#!/bin/sh
# Builds Rapier 2D, the third engine of the benchmark, from its Rust package and leaves
#   OUT/lib/librapier.a   the library behind rapier.h, optimised for the same processors as Box2D
#   OUT/rapier.cmake      sets RAPIER_LIBRARY, RAPIER_LINK and RAPIER_BUILD
# Exit codes: 0 built (or already there), 77 something it needs is missing (one line says what),
# anything else an error.
set -eu

usage() {
    echo "usage: build-rapier.sh [OUT]"
    echo "Builds Rapier 2D for the benchmark into OUT (default: build/baseline in this repository)."
    echo "Needs cargo >= 1.95."
}

here=$(cd "$(dirname "$0")" && pwd)
name=rapier
. "$here/rust.sh"
case "${1:-}" in
    -h | --help) usage; exit 0 ;;
    -*) usage >&2; exit 2 ;;
esac
[ $# -le 1 ] || { usage >&2; exit 2; }
out=${1:-$here/../../build/baseline}

need_rust

mkdir -p "$out/rapier/src" "$out/lib"
out=$(cd "$out" && pwd)
copy_package "$here/rapier" "$out/rapier"
cd "$out/rapier"
cargo fetch --quiet || missing "the package rapier2d could not be fetched"

# Rapier is compiled for one kind of processor; AVX2 and FMA are enabled here, as other engines of
# the comparison may use them.
flags=
case $(uname -m) in
    x86_64) flags="-C target-cpu=x86-64-v3" ;;
esac
RUSTFLAGS=$flags cargo build --quiet --release --offline -j 2 --target-dir "$out/rapier-cargo"
library=$out/rapier-cargo/release/librapier_baseline.a
[ -f "$library" ] || fail "cargo made no $library"

version=$(sed -n 's/^rapier2d = "=\(.*\)"$/\1/p' Cargo.toml)
cmp -s "$library" "$out/lib/librapier.a" || cp "$library" "$out/lib/librapier.a"
cat >"$out/rapier.cmake.new" <<END
# Written by tests/adapters/build-rapier.sh.
set(RAPIER_LIBRARY "$out/lib/librapier.a")
set(RAPIER_LINK pthread m dl)
set(RAPIER_BUILD "$version, $(rustc --version | cut -d '(' -f 1)-O3${flags:+ $flags}")
END
replace "$out/rapier.cmake"
echo "rapier: $version built${flags:+ with $flags}; in $out"
