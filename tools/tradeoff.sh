# tradeoff.sh: ./run tradeoff, what accuracy costs in thud and in Box2D. Read by ./run.
# shellcheck shell=sh

need_tradeoff() {
    need_bench_picture
}

# Wrong options are refused before anything is built, and writing the page anew needs no build.
tradeoff() {
    case " $* " in
        *' -h '* | *' --help '*) exec python3 tests/tradeoff/tradeoff.py "" --help ;;
    esac
    ensure tradeoff
    python3 tests/tradeoff/tradeoff.py "" --check "$@" || exit
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
    exec python3 "$root/tests/tradeoff/tradeoff.py" \
        "$root/build/bench/tests/tradeoff/thud-tradeoff" "$@"
}
