# network.sh: ./run network, which measures what the delay of a network costs, and writes
# docs/network.md. Sourced by ./run.
# shellcheck shell=sh

need_network() {
    need_bench_picture
}

network() {
    measured_page network network/network.py network/thud-network "$@"
}
