# envelope.sh: ./run envelope, which drives thud and Box2D to the extremes and writes
# docs/stability.md. Read by ./run.
# shellcheck shell=sh

need_envelope() {
    need_bench_picture
}

# Wrong options are refused before anything is built, and writing the page anew needs no build.
envelope() {
    case " $* " in
        *' -h '* | *' --help '*) exec python3 tests/stability/envelope.py "" --help ;;
    esac
    ensure envelope
    python3 tests/stability/envelope.py "" --check "$@" || exit
    case " $* " in
        *' --again '*) ;;
        *)
            sh tests/adapters/build.sh build/baseline
            build bench --preset release -DTHUD_WERROR=ON -DTHUD_TESTS=OFF \
                -DTHUD_BOX2D="$root/build/baseline"
            ;;
    esac
    name_commit
    cd "$caller"
    exec python3 "$root/tests/stability/envelope.py" \
        "$root/build/bench/tests/stability/thud-envelope" "$@"
}
