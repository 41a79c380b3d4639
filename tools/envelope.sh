# envelope.sh: ./run envelope, which measures errors of thud and Box2D in extreme scenes and writes
# docs/stability.md. Sourced by ./run.
# shellcheck shell=sh

need_envelope() {
    need_bench_picture
}

envelope() {
    measured_page envelope stability/envelope.py stability/thud-envelope "$@"
}
