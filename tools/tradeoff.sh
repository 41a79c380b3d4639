# tradeoff.sh: ./run tradeoff, which measures the cost of accuracy in thud and in Box2D, and writes
# docs/tradeoff.md. Sourced by ./run.
# shellcheck shell=sh

need_tradeoff() {
    need_bench_picture
}

tradeoff() {
    measured_page tradeoff tradeoff/tradeoff.py tradeoff/thud-tradeoff "$@"
}
