# tradeoff.sh: ./run tradeoff, what accuracy costs in thud and in Box2D. Read by ./run.
# shellcheck shell=sh

need_tradeoff() {
    need_bench_picture
}

tradeoff() {
    measured_page tradeoff tradeoff/tradeoff.py tradeoff/thud-tradeoff "$@"
}
