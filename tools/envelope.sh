# envelope.sh: ./run envelope, which drives thud and Box2D to the extremes and writes
# docs/stability.md. Read by ./run.
# shellcheck shell=sh

need_envelope() {
    need_bench_picture
}

envelope() {
    measured_page envelope stability/envelope.py stability/thud-envelope "$@"
}
