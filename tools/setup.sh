# setup.sh: checks what each verb of ./run needs, and installs what is missing. Sourced by ./run.
# shellcheck shell=sh

# have COMMAND: whether a command is in PATH.
have() {
    command -v "$1" >/dev/null 2>&1
}

# need WHAT PACKAGES COMMAND...: unless COMMAND succeeds, adds a line to `missing`: the Debian
# packages that contain WHAT (a|b, of which the first that apt knows is installed).
need() {
    what=$1
    packages=$2
    shift 2
    "$@" >/dev/null 2>&1 || missing="$missing$(printf '  %-18s %s' "$packages" "$what")
"
}

# have_any COMMAND...: whether one of the commands is in PATH.
have_any() {
    for name in "$@"; do
        ! have "$name" || return 0
    done
    return 1
}

# has_header NAME: whether the C compiler finds a header.
has_header() {
    printf '#include <stdarg.h>\n#include <stddef.h>\n#include <setjmp.h>\n#include <%s>\n' "$1" |
        cc -E -
}

# Whether there are make and a C compiler with the C library's headers.
compiles() {
    have make && has_header stdio.h
}

node_is_new() {
    node -e 'process.exit(parseInt(process.versions.node) >= 18 ? 0 : 1)'
}

# need_VERB: calls `need` for each tool of a verb, or of a part of it.
need_native() {
    need "a C compiler with make" build-essential compiles
    need "CMake 3.22 or later" cmake have cmake
    need "cJSON's headers" libcjson-dev has_header cjson/cJSON.h
    need "Expat's headers" libexpat1-dev has_header expat.h
    need "zlib's headers" zlib1g-dev has_header zlib.h
    need "Zstandard's headers" libzstd-dev has_header zstd.h
}

need_demo() {
    need "CMake 3.22 or later" cmake have cmake
    need "make" make have make
    need "the compiler to WebAssembly, emcc" emscripten have emcc
    need "Node.js 18 or later" nodejs node_is_new
    need "Node's package manager, npm" npm have npm
}

need_play() {
    need_native
    need "SDL2's headers" libsdl2-dev has_header SDL2/SDL.h
}

need_bench() {
    need_native
    # Without apt-get Chipmunk is not required: the envelope then leaves it out.
    ! have apt-get || need "Chipmunk's headers" libchipmunk-dev has_header chipmunk/chipmunk.h
    need "cmocka's headers" libcmocka-dev has_header cmocka.h
    need "clang, which builds Box2D" "clang-16|clang" have_any clang-16 clang
}

need_bench_wasm() {
    need_demo
    need "Chromium" "chromium|chromium-browser" \
        have_any chromium chromium-browser google-chrome
}

need_bench_picture() {
    need_bench
    need "Python 3" python3 have python3
}

need_bench_report() {
    need_bench_picture
    need_bench_wasm
}

# need_matrix: what the rows in `verb_rows` need, by the compilers and runners of matrix_tools.
need_matrix() {
    need_native
    need "Python 3" python3 have python3
    for tool in $(for row in $verb_rows; do matrix_tools "$row"; done | tr ' ' '\n' | sort -u); do
        case $tool in
            clang | *-clang) need "clang" "clang-16|clang" have_any clang-16 clang ;;
            emcc) need_demo ;;
            qemu-*) need "emulators of processors" qemu-user-static have "$tool-static" ;;
            clang-lto) need "an archiver that knows what clang 16 writes" llvm-16 \
                have llvm-ar-16 ;;
            wine)
                need "Wine" wine have wine
                need "Wine for programs of 64 bits" wine64 have_wine64
                ;;
            chromium) need "Chromium" "chromium|chromium-browser" \
                have_any chromium chromium-browser google-chrome ;;
            firefox) need "Firefox" "firefox-esr|firefox" have_any firefox-esr firefox ;;
        esac
        case $tool in
            i686) need_cross i686 i386 ;;
            aarch64 | aarch64-clang) need_cross aarch64 arm64 ;;
            riscv64 | s390x) need_cross "$tool" "$tool" ;;
            windows | windows-clang) need "a compiler for Windows" gcc-mingw-w64-x86-64 \
                have x86_64-w64-mingw32-gcc ;;
        esac
    done
}

# need_cross PROCESSOR DEBIAN-NAME: gcc for another processor and the C library for it.
need_cross() {
    need "gcc for $1" "gcc-$1-linux-gnu" have "$1-linux-gnu-gcc"
    need "the C library for $1" "libc6-dev-$2-cross" test -f "/usr/$1-linux-gnu/include/stdio.h"
}

have_wine64() {
    have wine64 || [ -x /usr/lib/wine/wine64 ]
}

# Whether clang 16 links libFuzzer. It must be the version that the preset fuzz names, so that kept
# inputs have the same effect on all machines.
links_fuzzer() {
    echo 'int LLVMFuzzerTestOneInput(const char *d, unsigned long n) { return d && n > 9; }' |
        clang-16 -fsanitize=fuzzer,address,undefined -x c - -o /dev/null
}

links_sanitizers() {
    echo 'int main(void) { return 0; }' |
        clang-16 -fsanitize=address,undefined -fuse-ld=lld -x c - -o /dev/null
}

need_fuzz() {
    need_native
    need_demo
    need "clang 16" clang-16 have clang-16
    need "libFuzzer and the sanitizers of clang 16" libclang-rt-16-dev links_fuzzer
    need "cmocka's headers" libcmocka-dev has_header cmocka.h
    need "Python 3" python3 have python3
}

# Whether Python makes environments, and extensions of C can be compiled for it.
have_python_environments() {
    python3 -c 'import ensurepip, venv'
}

have_python_header() {
    python3 -c 'import os, sysconfig
os.stat(os.path.join(sysconfig.get_path("include"), "Python.h"))'
}

need_test() {
    [ "${full:-no}" = no ] || {
        need_fuzz
        need "pkg-config" "pkgconf|pkg-config" have pkg-config
        # Debian's package is built on Debian alone.
        ! have dpkg || {
            need "the tools that build Debian's packages" dpkg-dev have dpkg-buildpackage
            need "what Debian's package is built by" debhelper have dh
            need "the checks of Debian's packages" lintian have lintian
        }
    }
    need "Python's environments" python3-venv have_python_environments
    need "Python's headers" python3-dev have_python_header
    need_play
    need_demo
    need "Ninja" ninja-build have ninja
    need "LuaJIT" luajit have luajit
    need "Meson" meson have meson
    need "clang-format 16" clang-format-16 have clang-format-16
    need "clang 16" clang-16 have clang-16
    need "LLVM's linker" lld-16 test -x /usr/lib/llvm-16/bin/ld.lld
    need "the sanitizers of clang 16" libclang-rt-16-dev links_sanitizers
    need "cmocka's headers" libcmocka-dev has_header cmocka.h
    need "libwebsockets' headers" libwebsockets-dev has_header libwebsockets.h
    need "ENet's headers" libenet-dev has_header enet/enet.h
    need "Python 3" python3 have python3
    need "Chromium" "chromium-headless-shell|chromium|chromium-browser" have_headless_chromium
    need "Firefox" "firefox-esr|firefox" have_any firefox-esr firefox
}

# Whether there is a Chromium for tests: the one without windows, which takes half of the processor
# time (web/tools/browser.mjs), or any other where apt does not know that one.
have_headless_chromium() {
    have chromium-headless-shell || {
        ! apt-cache show chromium-headless-shell &&
            have_any chromium chromium-browser google-chrome
    }
}

# ensure WHAT: installs what need_WHAT finds missing; without apt-get it prints the list and ends.
ensure() {
    missing=
    "need_$1"
    [ -n "$missing" ] || return 0
    if ! have apt-get; then
        printf 'run: %s needs (package names as in Debian):\n%s' "$verb" "$missing" >&2
        die "install these with this system's package manager, then call ./run $verb again"
    fi
    say "Some of what $verb needs is missing; asking apt for its list of packages"
    as_root apt-get -o DPkg::Lock::Timeout=600 update -qq
    list=$(printf '%s' "$missing" | while read -r packages what; do first_known "$packages"; done |
        sort -u | tr '\n' ' ')
    say "Installing with apt-get: $list"
    # The list is meant to be split into words.
    # shellcheck disable=SC2086
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600 install -y \
        --no-install-recommends $list
    missing=
    "need_$1"
    [ -z "$missing" ] || die "installed, yet still missing (package, what for):
$missing"
}

# as_root COMMAND...: runs a command as root, through sudo where needed.
as_root() {
    if [ "$(id -u)" = 0 ]; then
        "$@"
    elif have sudo; then
        sudo "$@"
    else
        die "this needs root, and sudo is missing; as root, run: $*"
    fi
}

# first_known A|B: the first of these packages that apt knows, or else the last.
first_known() {
    for package in $(echo "$1" | tr '|' ' '); do
        if apt-cache show "$package" >/dev/null 2>&1; then
            echo "$package"
            return
        fi
    done
    echo "$package"
}
