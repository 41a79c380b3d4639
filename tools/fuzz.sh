# fuzz.sh: ./run fuzz, which runs the fuzz targets: random calls, recordings, snapshots, levels,
# geometry and calls of the JavaScript package. Sourced by ./run.
# shellcheck shell=sh

FUZZ_TARGETS="calls recordings snapshots levels geometry js"
# Seconds between two lines about the progress.
FUZZ_WORD_EVERY=30
# A target with as many findings is not run any longer. Chosen.
FUZZ_FINDINGS_MOST=8

fuzz_usage() {
    cat <<'END_OF_USAGE'
usage: ./run fuzz [--minutes N] [--keep] [TARGET...]

Runs random input on all processors, by libFuzzer under the address and undefined-behaviour
sanitizers, and checks what thud guarantees. The time is divided among the targets that are named,
or all:

  calls      any calls of the C API in any order, in two worlds whose results must be the same
  recordings any calls of the C API, which are recorded, and played to the same states
  snapshots  snapshots with changed bytes and a correct checksum
  levels     maps of the Tiled editor
  geometry   shapes, volumes and ground without a world
  js         any calls of the JavaScript package, in Node

  --minutes N  the whole time; default 10
  --keep       afterwards writes the packed inputs of tests/fuzz/corpus again, which ./run test runs

Inputs that reach new code are kept in build/fuzz/corpus, from which the next call starts. Findings
are in build/fuzz/findings; the exit code is 1 if there are any.
END_OF_USAGE
}

# fuzz_options WORD...: sets `minutes`, `keep` and `targets`; ends with an error for a wrong word.
fuzz_options() {
    minutes=10
    keep=no
    targets=
    while [ $# -gt 0 ]; do
        case $1 in
            --minutes)
                minutes=${2:-}
                case $minutes in
                    '' | *[!0-9]* | 0* | ??????*) die "--minutes needs a whole number" ;;
                esac
                shift
                ;;
            --keep) keep=yes ;;
            *)
                case " $FUZZ_TARGETS " in
                    *" $1 "*) targets="$targets $1" ;;
                    *) die "fuzz knows no target '$1', only: $FUZZ_TARGETS" ;;
                esac
                ;;
        esac
        shift
    done
    targets=${targets:-$FUZZ_TARGETS}
}

# fuzz_weight TARGET: the weight of a target by which the time is divided. Chosen.
fuzz_weight() {
    case $1 in
        calls) echo 6 ;;
        geometry) echo 1 ;;
        *) echo 2 ;;
    esac
}

# fuzz_command TARGET SECONDS SEED: runs a target once, until the time is over or it has a finding.
fuzz_command() {
    if [ "$1" = js ]; then
        node tests/fuzz/calls.mjs --seconds "$2" --seed "$3" --findings build/fuzz/findings
        return
    fi
    "build/fuzz/tests/fuzz/fuzz-$1" -max_total_time="$2" -max_len=4096 -timeout=120 \
        -report_slow_units=60 -rss_limit_mb=2048 -seed="$3" \
        -artifact_prefix="build/fuzz/findings/$1-" "build/fuzz/corpus/$1"
}

# fuzz_seed TARGET: copies the kept inputs of tests/fuzz/corpus to build/fuzz/corpus, from which the
# fuzzer starts.
fuzz_seed() {
    mkdir -p "build/fuzz/corpus/$1"
    [ "$1" != js ] || return 0
    # Recordings are made of the inputs of calls.
    seeds=$1
    [ "$1" != recordings ] || seeds=calls
    python3 -B tests/fuzz/pack.py unpack "tests/fuzz/corpus/$seeds.pack" "build/fuzz/corpus/$1"
    [ ! -d "tests/fuzz/corpus/$seeds" ] || cp "tests/fuzz/corpus/$seeds"/* "build/fuzz/corpus/$1"
}

# fuzz_worker TARGET NUMBER END: runs a target until the time END (seconds of `date +%s`), again
# after each finding. NUMBER: of the worker.
fuzz_worker() {
    FUZZ_PROGRESS=build/fuzz/progress/$1.$2
    export FUZZ_PROGRESS
    round=0
    while left=$(($3 - $(date +%s))) && [ "$left" -gt 0 ] &&
        [ "$(fuzz_findings "$1" | wc -l)" -lt "$FUZZ_FINDINGS_MOST" ]; do
        fuzz_command "$1" "$left" $(($3 % 1000000 * 100 + $2 * 10 + round)) \
            >>"build/fuzz/log/$1.$2" 2>&1 || :
        round=$((round + 1))
    done
}

# fuzz_findings TARGET: the paths of its findings.
fuzz_findings() {
    find build/fuzz/findings -type f -name "$1-*"
}

# fuzz_calls TARGET: the number of inputs that all its workers have run.
fuzz_calls() {
    find build/fuzz/progress -name "$1.*" -exec cat {} + | awk '{ calls += $1 } END { print calls + 0 }'
}

# fuzz_coverage TARGET: the largest number of covered edges that a worker has logged.
fuzz_coverage() {
    cat build/fuzz/log/"$1".* 2>/dev/null | grep -ao 'cov: [0-9]*' | awk '$2 > most { most = $2 }
        END { print most + 0 }'
}

# fuzz_target TARGET SECONDS: runs a target on all processors, prints its progress, and adds a line
# to `summary`.
fuzz_target() {
    began=$(date +%s)
    end=$((began + $2))
    workers=
    number=0
    while [ "$number" -lt "$jobs" ]; do
        fuzz_worker "$1" "$number" "$end" &
        workers="$workers $!"
        number=$((number + 1))
    done
    while [ "$(date +%s)" -lt "$end" ] && fuzz_alive "$workers"; do
        sleep 1
        seconds=$(($(date +%s) - began))
        if [ $((seconds % FUZZ_WORD_EVERY)) = 0 ]; then
            printf '.. %s, %s s of %s: %s calls, coverage %s, %s findings\n' "$1" "$seconds" "$2" \
                "$(fuzz_calls "$1")" "$(fuzz_coverage "$1")" "$(fuzz_findings "$1" | wc -l)"
        fi
    done
    wait
    summary="$summary
$(printf '%-10s %12s calls in %5s s, coverage %6s, %s findings' "$1" "$(fuzz_calls "$1")" \
        "$(($(date +%s) - began))" "$(fuzz_coverage "$1")" "$(fuzz_findings "$1" | wc -l)")"
}

# fuzz_alive PIDS: whether one of the processes is running.
fuzz_alive() {
    for worker in $1; do
        ! kill -0 "$worker" 2>/dev/null || return 0
    done
    return 1
}

# fuzz_reproduce TARGET FILE: prints the command that runs a finding again.
fuzz_reproduce() {
    case $1 in
        js) echo "node tests/fuzz/calls.mjs --replay $2" ;;
        *) echo "build/fuzz/tests/fuzz/replay-$1 $2" ;;
    esac
}

# Writes the inputs of build/fuzz/corpus that reach something to the packed files of
# tests/fuzz/corpus.
fuzz_keep() {
    say "Packing what reaches anything, into tests/fuzz/corpus"
    for target in $targets; do
        # Recordings are made of the inputs of calls.
        case $target in js | recordings) continue ;; esac
        rm -rf "build/fuzz/kept/$target"
        mkdir -p "build/fuzz/kept/$target"
        # Merged by edges alone, without counters, and limited in length, so that few and short
        # inputs are kept.
        "build/fuzz/tests/fuzz/fuzz-$target" -merge=1 -use_counters=0 -max_len=700 \
            "build/fuzz/kept/$target" "build/fuzz/corpus/$target" >"build/fuzz/log/$target.keep" 2>&1
        python3 -B tests/fuzz/pack.py pack "build/fuzz/kept/$target" "tests/fuzz/corpus/$target.pack"
    done
    du -sb tests/fuzz/corpus/*
}

# Builds the chosen `targets`.
fuzz_build() {
    case " $targets " in
        *' calls '* | *' recordings '* | *' snapshots '* | *' levels '* | *' geometry '*)
            cmake -B build/fuzz --preset fuzz -DTHUD_WERROR=ON
            # The list is meant to be split into words.
            # shellcheck disable=SC2046
            cmake --build build/fuzz --parallel "$jobs" --target \
                $(for target in $targets; do [ "$target" = js ] ||
                    echo "fuzz-$target replay-$target"; done)
            ;;
    esac
    case " $targets " in
        *' js '*)
            web_packages
            sh web/tools/build-wasm.sh
            (cd web && npm run build:package)
            ;;
    esac
}

# fuzz WORD...: ./run fuzz.
fuzz() {
    case ${1:-} in
        -h | --help)
            fuzz_usage
            return
            ;;
    esac
    fuzz_options "$@"
    ensure fuzz
    say "Building:$targets"
    fuzz_build
    rm -rf build/fuzz/findings build/fuzz/progress build/fuzz/log
    mkdir -p build/fuzz/findings build/fuzz/progress build/fuzz/log
    weights=0
    for target in $targets; do
        fuzz_seed "$target"
        weights=$((weights + $(fuzz_weight "$target")))
    done
    trap 'trap - TERM; kill -TERM 0' INT HUP
    say "Fuzzing for $minutes minutes, $jobs at a time:$targets"
    summary=
    for target in $targets; do
        fuzz_target "$target" $((minutes * 60 * $(fuzz_weight "$target") / weights))
    done
    [ "$keep" = no ] || fuzz_keep
    say "Summary"
    printf '%s\n' "$summary"
    found=0
    for target in $targets; do
        [ "$(fuzz_calls "$target")" -gt 0 ] || die "$target has played nothing: build/fuzz/log/$target.0"
        for input in $(fuzz_findings "$target"); do
            printf 'to see it again: %s\n' "$(fuzz_reproduce "$target" "$input")"
            found=$((found + 1))
        done
    done
    [ "$found" = 0 ] || die "fuzz came upon $found findings"
}
