#!/bin/sh
# Builds the two WebAssembly modules with emcc: thud.wasm into the package, thud-demo.wasm into
# the page's public folder. THUD_WASM_BUILD names another build directory than build/wasm.
set -eu
cd "$(dirname "$0")/../.."
build=${THUD_WASM_BUILD:-build/wasm}

if ! command -v emcc >/dev/null 2>&1; then
    echo "build-wasm: emcc is missing; on Debian: apt-get install emscripten" >&2
    exit 1
fi
# Debian's emscripten finds its Node.js helpers only so when node itself is not Debian's.
if [ -d /usr/share/nodejs ]; then
    NODE_PATH=/usr/share/nodejs${NODE_PATH:+:$NODE_PATH}
    export NODE_PATH
fi

emcmake cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_FLAGS=-msimd128 \
    --log-level=WARNING >/dev/null
cmake --build "$build" --parallel 2 --target thud-web thud-demo

mkdir -p web/package/dist web/generated
cp -p "$build/web/thud-web.wasm" web/package/dist/thud.wasm
cp -p "$build/web/thud-demo.wasm" web/generated/thud-demo.wasm
