#!/bin/sh
# Builds Box2D v3.2, the engine that thud is compared with, from its Rust package and leaves
#   OUT/include/box2d/*.h   its C headers
#   OUT/lib/libbox2d.a      the library, optimised as Box2D's own release is
#   OUT/baseline.cmake      sets BOX2D_INCLUDE_DIR, BOX2D_LIBRARY, BOX2D_LINK and BOX2D_BUILD
# Exit codes: 0 built (or already there), 77 something it needs is missing (one line says what),
# anything else an error.
set -eu

usage() {
    echo "usage: build.sh [OUT]"
    echo "Builds Box2D v3.2 for the comparison tests and the benchmark into OUT"
    echo "(default: build/baseline in this repository). Needs cargo >= 1.95 and clang."
}

first() {
    printf '%s\n' "$1" | sed '/./!d; q'
}

here=$(cd "$(dirname "$0")" && pwd)
name="box2d baseline"
. "$here/rust.sh"
case "${1:-}" in
    -h | --help) usage; exit 0 ;;
    -*) usage >&2; exit 2 ;;
esac
[ $# -le 1 ] || { usage >&2; exit 2; }
out=${1:-$here/../../build/baseline}

need_rust

# clang makes Box2D 10 to 15 % faster than gcc 12 does, so the comparison uses clang.
clang=
for candidate in clang-16 clang-19 clang-18 clang-17 clang; do
    if command -v "$candidate" >/dev/null 2>&1; then
        clang=$candidate
        break
    fi
done
[ -n "$clang" ] || missing "clang is missing (Debian package clang-16)"

mkdir -p "$out/crate/src" "$out/lib" "$out/include"
out=$(cd "$out" && pwd)
copy_package "$here" "$out/crate"
cd "$out/crate"
cargo fetch --quiet || missing "the package boxdd-sys 0.6.0 could not be fetched"

# The package's default is -O2 with assertions; these are the flags of Box2D's own release build.
# The debug output prints every compiler call, for the check below.
CC=$clang CFLAGS="-O3 -DNDEBUG" CC_ENABLE_DEBUG_OUTPUT=1 \
    cargo build --quiet --release --offline -j 2 --target-dir "$out/cargo"
library=$out/cargo/release/libbox2d_baseline.a
[ -f "$library" ] || fail "cargo made no $library"

# Checks the flags in the compiler calls that the newest build script printed: every Box2D source
# must have -O3 as its last level, and no assertions.
log=$(ls -t "$out"/cargo/release/build/boxdd-sys-*/output | head -n 1)
calls=$(sed -n 's/^running: //p' "$log" | grep '"-c" ".*/src/[a-z_]*\.c"$' || true)
[ -n "$calls" ] || fail "no compiler call found in $log"
count=$(printf '%s\n' "$calls" | wc -l | tr -d ' ')
simd=
bad=$(printf '%s\n' "$calls" | grep -v '"-O3" "-DNDEBUG"' || true)
bad=$bad$(printf '%s\n' "$calls" | grep '"-O3" "-DNDEBUG".*"\(-O[^3]*\|-UNDEBUG\)"' || true)
[ -z "$bad" ] || fail "not compiled with -O3 -DNDEBUG: $(first "$bad")"
case $(uname -m) in
    x86_64)
        simd=" -mavx2"
        bad=$(printf '%s\n' "$calls" | grep -v '"-mavx2".*"-DBOX2D_AVX2"' || true)
        [ -z "$bad" ] || fail "not compiled with AVX2: $(first "$bad")"
        ;;
esac
# Checks the library: enabled assertions call b2InternalAssert, and the contact solver must use
# 256-bit registers.
if command -v objdump >/dev/null 2>&1; then
    code=$(objdump -d --no-show-raw-insn --disassemble=b2SolveContactsTask "$library" 2>/dev/null)
    if [ -n "$simd" ] && ! printf '%s' "$code" | grep -q '%ymm'; then
        fail "the contact solver was compiled without 256-bit registers"
    fi
    ! nm "$library" 2>/dev/null | grep -q b2InternalAssert || fail "assertions are on"
fi

manifest=$(cargo metadata --quiet --offline --format-version 1 |
    grep -o '"manifest_path":"[^"]*boxdd-sys-0\.6\.0/Cargo\.toml"' | head -n 1 | cut -d '"' -f 4)
headers=${manifest%/Cargo.toml}/third-party/box2d/include/box2d
[ -f "$headers/box2d.h" ] || fail "no headers in $headers"

rm -rf "$out/include/box2d"
cp -R "$headers" "$out/include/box2d"
cmp -s "$library" "$out/lib/libbox2d.a" || cp "$library" "$out/lib/libbox2d.a"
cat >"$out/baseline.cmake.new" <<END
# Written by tests/adapters/build.sh.
set(BOX2D_INCLUDE_DIR "$out/include")
set(BOX2D_LIBRARY "$out/lib/libbox2d.a")
set(BOX2D_LINK pthread m dl)
set(BOX2D_BUILD "$("$clang" --version | head -n 1), -O3 -DNDEBUG$simd, $count sources")
END
replace "$out/baseline.cmake"
echo "box2d baseline: $count sources, $clang -O3 -DNDEBUG$simd, checked; in $out"
