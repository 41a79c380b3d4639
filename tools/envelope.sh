# envelope.sh: ./run envelope, which drives thud and Box2D to the extremes and writes
# docs/stability.md. Read by ./run.
# shellcheck shell=sh

# envelope OPTION...: what thud-envelope writes goes to docs/stability.md, unless --out names another
# place, or --only leaves rows out: then to standard output.
envelope() {
    place=docs
    for option; do
        case $option in
            --out | --only) place=elsewhere ;;
            -h | --help)
                envelope_usage
                return
                ;;
        esac
    done
    ensure bench
    sh tests/adapters/build.sh build/baseline
    build bench --preset release -DTHUD_WERROR=ON -DTHUD_TESTS=OFF \
        -DTHUD_BOX2D="$root/build/baseline"
    if [ "$place" = docs ]; then
        set -- "$@" --out "$root/docs/stability.md"
        say "Writing docs/stability.md"
    fi
    cd "$caller"
    exec "$root/build/bench/tests/stability/thud-envelope" \
        --notes "$root/tests/stability/notes.md" "$@"
}

envelope_usage() {
    cat <<'END'
usage: ./run envelope [OPTION...]

Drives thud, at each of its qualities, and Box2D v3.2 beside it to the extremes, and writes what they
reached to docs/stability.md.

  --only ROW       only this extreme, to standard output; may be given several times: mass-ratio,
                   columns, far-away, speed, sizes, time-step, energy, slopes, long-run,
                   crowding, wrong-input
  --quick          seconds of simulated time, as in the tests: shows that it runs
  --without-box2d  thud alone
  --out FILE       writes to FILE instead
END
}
