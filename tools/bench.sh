# bench.sh: the functions of ./run bench: the native benchmark, the one for WebAssembly,
# docs/performance.md with the results of both, and docs/catalogue.md. Sourced by ./run.
# shellcheck shell=sh

# Prints the help of ./run bench.
bench_usage() {
    cat <<'END'
usage: ./run bench [OPTION...]

thud and its rivals side by side: Box2D v3.2 always, Rapier 2D where Rust can build it. Without
options every scene, as a table.

  --growth             time per body from 1,000 to 1,000,000 bodies, bytes per body and contact
  --pay                what each feature costs: a scene with it and without it
  --workers            what a second thread brings
  --profile            the time of a step by stage, scene by scene
  --scenes, --all      every scene (also beside the above); all five
  --scene NAME[:SIZE]  only this scene; may be given several times
  --against ENGINE     only this rival, box2d, rapier or, where its library is found, chipmunk; may
                       be given several times
  --steps N            times N steps instead of the scene's own number
  --repeat N           repetitions of every scene (default 3)
  --quick              shows that it runs, compares little
  --json FILE          also writes everything to FILE
  --picture FILE.svg   also draws the scenes' ratios
  --list               lists the scenes, and which steps of each are timed

  --wasm [OPTION...]   instead: thud.wasm against the WebAssembly builds of its rivals; its own
                       options with ./run bench --wasm --help
  --report [OPTION...] instead: measures all of this, which takes a quarter of an hour, and writes
                       docs/performance.md, its picture and docs/performance.json; its own options
                       with ./run bench --report --help
  --catalogue [OPTION...] instead: measures what each system costs and gets wrong, which takes
                       some minutes, and writes docs/catalogue.md, its pictures and
                       docs/catalogue.json; its own options with ./run bench --catalogue --help
END
}

# Builds Box2D, and the programs that measure it beside thud. Ends with exit code 77 where Box2D
# cannot be built; tests/adapters/build.sh prints why. If the variable `built` names a build
# directory, the engine of that directory is used.
build_beside_box2d() {
    sh tests/adapters/build.sh build/baseline
    build bench --preset release -DTHUD_WERROR=ON -DTHUD_TESTS=OFF \
        -DTHUD_BOX2D="$root/build/baseline" -DTHUD_BUILT="${built:-}"
}

# The same with Rapier, which is left out where it cannot be built.
build_bench() {
    sh tests/adapters/build-rapier.sh build/baseline || [ $? = 77 ]
    build_beside_box2d
}

# measured_page VERB SCRIPT PROGRAM OPTION...: builds and runs PROGRAM in build/bench/tests, and
# writes the page in docs/ that tests/SCRIPT makes of its measurements. Wrong options are refused
# before the build. With --again the page is written from the last measurements, without a build.
measured_page() {
    verb=$1
    script=$root/tests/$2
    program=$root/build/bench/tests/$3
    shift 3
    case " $* " in
        *' -h '* | *' --help '*) exec python3 "$script" "" --help ;;
    esac
    ensure "$verb"
    python3 "$script" "" --check "$@" || exit
    case " $* " in
        *' --again '*) ;;
        *) build_beside_box2d ;;
    esac
    name_commit
    cd "$caller"
    exec python3 "$script" "$program" "$@"
}

# Sets THUD_COMMIT, the commit to which measurements belong, with "-dirty" appended where sources
# have changes that are not committed; tests/pages/measured.py refuses to write docs/ for such a
# tree.
name_commit() {
    THUD_COMMIT=$(git rev-parse --short=12 HEAD 2>/dev/null | cut -c 1-12)
    changed=$(git status --porcelain --untracked-files=no -- CMakeLists.txt assets cmake demo engine \
        tests web ':(exclude)*.md' ':(exclude)*.py' 2>/dev/null) || changed=
    [ -z "$changed" ] || THUD_COMMIT=$THUD_COMMIT-dirty
    THUD_COMMIT=${THUD_COMMIT:-unknown}
    export THUD_COMMIT
}

# Runs the native benchmark with these options.
bench_native() {
    ensure bench
    build_bench
    cd "$caller"
    exec "$root/build/bench/tests/bench/thud-bench" "$@"
}

# Runs the native benchmark, and draws its results to the file `picture`, from the JSON file `json`,
# or one in build/ where no name was given.
bench_picture() {
    case $picture in
        *.svg) ;;
        *) die "--picture writes SVG and wants a name that ends in .svg, not '$picture'" ;;
    esac
    ensure bench_picture
    build_bench
    [ -n "$json" ] || set -- "$@" --json "${json:=$root/build/bench/results.json}"
    cd "$caller"
    "$root/build/bench/tests/bench/thud-bench" "$@"
    exec python3 "$root/tests/bench/pages/performance_picture.py" "$json" "$picture"
}

# Runs the benchmark for WebAssembly with these options.
bench_wasm() {
    ensure bench_wasm
    build_page
    cd "$caller"
    exec node "$root/web/tools/bench-wasm.mjs" "$@"
}

# Measures both and writes docs/performance.md; --again and --skip wasm need less to be built.
bench_report() {
    case " $* " in
        *' --again '*) ensure bench_picture ;;
        *' --skip wasm '*)
            ensure bench_picture
            build_bench
            ;;
        *)
            ensure bench_report
            build_bench
            build_page
            ;;
    esac
    cd "$caller"
    exec python3 "$root/tests/bench/pages/performance.py" \
        "$root/build/bench/tests/bench/thud-bench" "$@"
}

# Measures the cost and errors of each system and writes docs/catalogue.md.
bench_catalogue() {
    ensure bench_picture
    case " $* " in
        *' --again '*) ;;
        *) build_bench ;;
    esac
    cd "$caller"
    exec python3 "$root/tests/bench/pages/catalogue.py" \
        "$root/build/bench/tests/bench/thud-catalogue" "$@"
}

# bench OPTION...: ./run bench. Its own options may be at any place; the others are passed to the
# program that measures.
bench() {
    what=native
    help=no
    picture=
    json=
    before=
    for option; do
        shift
        case $before in
            --picture)
                picture=$option
                what=picture
                before=
                continue
                ;;
            --json) json=$option ;;
        esac
        before=$option
        case $option in
            --wasm) what=wasm ;;
            --report) what=report ;;
            --catalogue) what=catalogue ;;
            --picture) ;;
            -h | --help) help=yes ;;
            *) set -- "$@" "$option" ;;
        esac
    done
    [ "$before" != --picture ] || die "--picture wants the name of a file"
    name_commit
    case $what-$help in
        wasm-yes) exec node web/tools/bench-wasm.mjs --help ;;
        report-yes) exec python3 tests/bench/pages/performance.py "" --help ;;
        catalogue-yes) exec python3 tests/bench/pages/catalogue.py "" --help ;;
        *-yes) bench_usage ;;
        wasm-no) bench_wasm "$@" ;;
        report-no) bench_report "$@" ;;
        catalogue-no) bench_catalogue "$@" ;;
        picture-no) bench_picture "$@" ;;
        native-no) bench_native "$@" ;;
    esac
}
