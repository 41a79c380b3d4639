#!/bin/sh
# Builds the WebAssembly modules with emcc: thud.wasm, thud-scalar.wasm, thud-threads.wasm and
# thud-recorded.wasm into the package, thud-demo.wasm for the page. THUD_WASM_BUILD names another
# build directory than build/wasm.
set -eu
cd "$(dirname "$0")/../.."
build=${THUD_WASM_BUILD:-build/wasm}

if ! command -v emcc >/dev/null 2>&1; then
    echo "build-wasm: emcc is missing; on Debian: apt-get install emscripten" >&2
    exit 1
fi
# Debian's emscripten finds its Node.js helpers without this only if node is Debian's package, too.
if [ -d /usr/share/nodejs ]; then
    NODE_PATH=/usr/share/nodejs${NODE_PATH:+:$NODE_PATH}
    export NODE_PATH
fi
# emcc, which starts once for each file, starts in half the time with Debian's Python where the
# first python3 in PATH is a shim of another one.
if [ -z "${EMSDK_PYTHON:-}" ] && [ -d /usr/share/emscripten ] && [ -x /usr/bin/python3 ]; then
    export EMSDK_PYTHON=/usr/bin/python3
fi

# emcc is a program in Python that starts clang, and takes longer to start than clang takes for most
# files. So it is asked once how it calls clang for size and how for speed, and files are compiled by
# these commands, in a script that is CMake's compiler launcher (its first argument is emcc). Linking
# stays emcc's. As emcc does, a file counts as compiled for size where any of its options is -Oz.
# Where the answer is not understood, emcc compiles.
command_for() {
    emcc -v "$1" -c "$build/empty.c" -o "$build/empty.o" 2>&1 |
        sed -n "1s/ -v $1 -c .*//p" | grep -E '^ *"?/' || :
}
mkdir -p "$build"
printf 'extern int unused;\n' >"$build/empty.c"
size=$(command_for -Oz)
speed=$(command_for -O3)
launcher=
if [ -n "$size" ] && [ -n "$speed" ]; then
    launcher=$(cd "$build" && pwd)/compile.sh
    cat >"$launcher" <<END
#!/bin/sh
shift
level=speed
for option; do
    case \$option in
        -Oz) level=size ;;
    esac
done
[ "\$level" = size ] && exec $size "\$@"
exec $speed "\$@"
END
    chmod +x "$launcher"
fi

# compile DIRECTORY FLAGS THREADS TARGET...: configures and builds targets with these compiler flags,
# with a pool of threads (ON) or without (OFF).
# With make: Ninja archives objects in another order, with which the module is 2 % larger
# compressed.
compile() {
    directory=$1
    flags=$2
    threads=$3
    shift 3
    emcmake cmake -G "Unix Makefiles" -S . -B "$directory" -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_FLAGS="$flags" \
        -DTHUD_WEB_THREADS="$threads" -DCMAKE_C_COMPILER_LAUNCHER="$launcher" --log-level=WARNING >/dev/null
    cmake --build "$directory" --parallel 2 --target "$@"
}

compile "$build" -msimd128 OFF thud-web thud-demo thud-recorded
# For browsers without WebAssembly SIMD: the same source gives the same results, but is slower.
compile "$build-scalar" "" OFF thud-web
# For pages that are cross-origin isolated, and Node.js: shares large steps among threads.
compile "$build-threads" "-msimd128 -matomics -mbulk-memory -mmutable-globals" ON thud-web

mkdir -p web/package/dist web/generated
cp -p "$build/web/thud-web.wasm" web/package/dist/thud.wasm
cp -p "$build-scalar/web/thud-web.wasm" web/package/dist/thud-scalar.wasm
cp -p "$build-threads/web/thud-web.wasm" web/package/dist/thud-threads.wasm
cp -p "$build/web/thud-recorded.wasm" web/package/dist/thud-recorded.wasm
cp -p "$build/web/thud-demo.wasm" web/generated/thud-demo.wasm
