# bench.sh: the parts of ./run bench: the native benchmark, the one for WebAssembly, and the page
# that both are written to. Read by ./run.
# shellcheck shell=sh

bench_usage() {
    cat <<'END'
usage: ./run bench [OPTION...]

thud and its rivals side by side: Box2D v3.2 always, Rapier 2D where Rust can build it. Without
options every scene, as a table.

  --growth             time per body from 1,000 to 256,000 bodies, bytes per body and contact
  --pay                what each feature costs: a scene with it and without it
  --profile            the time of a step by stage, for every scene
  --scenes, --all      every scene (also beside the above); all four
  --scene NAME[:SIZE]  only this scene; may be given several times
  --against ENGINE     only this rival, box2d or rapier; may be given several times
  --steps N            times N steps instead of the scene's own number
  --repeat N           repetitions of every scene (default 3)
  --quick              shows that it runs, compares little
  --json FILE          also writes everything to FILE
  --list               lists the scenes, and which steps of each are timed

  --wasm [OPTION...]   instead: thud.wasm against the WebAssembly builds of its rivals; its own
                       options with ./run bench --wasm --help
  --report [OPTION...] instead: measures all of this and writes docs/performance.md, its picture
                       and docs/performance.json; its own options with ./run bench --report --help
END
}

# Builds Box2D, Rapier and what stands beside them. Ends with 77 where Box2D cannot be built, which
# tests/baseline/build.sh explains; without Rapier the rest goes on.
build_bench() {
    sh tests/baseline/build.sh build/baseline
    sh tests/baseline/build-rapier.sh build/baseline || [ $? = 77 ]
    build bench --preset release -DTHUD_WERROR=ON -DTHUD_TESTS=OFF \
        -DTHUD_BOX2D="$root/build/baseline"
}

# What the figures belong to.
name_commit() {
    THUD_COMMIT=$(git describe --always --dirty --abbrev=10 2>/dev/null || echo unknown)
    export THUD_COMMIT
}

bench_native() {
    ensure bench
    build_bench
    cd "$caller"
    exec "$root/build/bench/tests/bench/thud-bench" "$@"
}

bench_wasm() {
    ensure wasm_bench
    build_page
    cd "$caller"
    exec node "$root/web/tools/bench-wasm.mjs" "$@"
}

bench_report() {
    ensure report
    build_bench
    build_page
    exec "$(python_that_draws)" tests/bench/performance.py build/bench/tests/bench/thud-bench "$@"
}

# bench OPTION...: --wasm, --report and --help may stand anywhere; the rest goes to what they name.
bench() {
    what=native
    help=no
    for option; do
        shift
        case $option in
            --wasm) what=wasm ;;
            --report) what=report ;;
            -h | --help) help=yes ;;
            *) set -- "$@" "$option" ;;
        esac
    done
    name_commit
    case $what-$help in
        native-yes) bench_usage ;;
        wasm-yes) node web/tools/bench-wasm.mjs --help ;;
        report-yes) python3 tests/bench/performance.py --help ;;
        native-no) bench_native "$@" ;;
        wasm-no) bench_wasm "$@" ;;
        report-no) bench_report "$@" ;;
    esac
}
