# test.sh: the parts of ./run test, the two lanes in which they run side by side, and their summary.
# Sourced by ./run.
# shellcheck shell=sh

TEST_PARTS="native sanitizers wasm page baseline"
# Seconds between two lines about the progress of the parts.
TEST_WORD_EVERY=30

test_usage() {
    cat <<'END'
usage: ./run test [--full] [PART...]

Builds and tests everything, or only the parts that are named:

  native      the library, the examples, the tools and Python's package, by the system's compiler
  sanitizers  most tests of the engine once more, compiled by clang with the address and
              undefined-behaviour sanitizers: the same golden hashes and bits as by the system's
              compiler. Long ones run one of 7 of their cases; all cases: cmake -DTHUD_TEST_SHARE=1
  wasm        the engine as WebAssembly, in Node; the package in bundlers and other runtimes
  page        the page in Chromium and Firefox
  baseline    the comparison with Box2D

  --full      gives every pair of shapes 10^6 random cases instead of hundreds to thousands, and
              tries each guarantee (docs/guarantees.md) on every combination of settings instead
              of some twenty, runs all tests under the address and undefined-behaviour sanitizers
              (tests/CMakeLists.txt), the tests of clang's release build, those of the memory
              sanitizer, and those of threads and the kept inputs of ./run fuzz under the thread
              sanitizer, compiles the one file without each of its parts, builds the packages
              of other tools than CMake, makes the files of ./run release twice and compares them,
              and measures anew what the generated pages in docs/ say, more than an hour; all this in the part native. In the part page, tests of
              what the page's own code decides run in Firefox, too, and not in Chromium alone, and
              native players and those in WebAssembly play 10^4 steps over the worst network

THUD_LATE=MS or THUD_LATE=MS:SEED in the environment makes the files of the page arrive up to MS
milliseconds late, in an order by the seed: the part page then fails where a test, or the page, relies
on what has not been loaded yet (tests/web/support/late.mjs).

Two lanes run side by side: one begins with wasm, the other with native and then page, to which all
others give way; sanitizers and baseline run in the lane that is free first. What a part prints is in
build/test/PART.log and shown as it ends.
END
}

# check_test_options WORD...: sets `parts`, in the order of TEST_PARTS, and `full`; ends with an
# error for a wrong word.
check_test_options() {
    full=no
    wanted=
    for word; do
        case " $TEST_PARTS " in
            *" $word "*) wanted="$wanted $word" ;;
            *)
                [ "$word" = --full ] ||
                    die "test knows no part '$word', only --full and: $TEST_PARTS"
                full=yes
                ;;
        esac
    done
    parts=
    for part in $TEST_PARTS; do
        case " ${wanted:-$TEST_PARTS} " in
            *" $part "*) parts="$parts $part" ;;
        esac
    done
    case "$full $parts " in
        yes*' native '* | yes*' page '*) ;;
        yes*) die "--full belongs to the parts native and page" ;;
    esac
}

# test_PART: builds and tests a part.
test_native() {
    python_packages
    build release --preset release -DTHUD_WERROR=ON
    ctest --preset release --parallel "$jobs"
    [ "$full" = no ] || {
        test_all_cases
        test_clang
        test_memory
        test_threads
        test_releases
        test_pages_at_length
    }
}

# The tests that run under clang's memory and thread sanitizers: only those that use no libraries
# but cmocka and the C library, since other libraries would have to be built with the sanitizers,
# too.
MEMORY_TESTS="test_determinism test_error test_event_ledger test_failing_memory test_float_mode
    test_distances test_islands_bits test_joints_edits test_query test_recording test_snapshot test_snapshot_random
    test_workers test_wrong_input"
THREADS_TESTS="test_determinism test_error test_distances test_float_mode test_islands_bits test_threads test_workers"

# test_under PRESET TARGET...: builds with a sanitizer's preset, and runs these tests and the kept
# inputs of two targets of ./run fuzz.
test_under() {
    preset=$1
    shift
    cmake -B "build/$preset" --preset "$preset" -DTHUD_WERROR=ON
    cmake --build "build/$preset" --parallel "$jobs" --target replay-calls replay-snapshots "$@"
    FUZZ_THREADS=1 ctest --test-dir "build/$preset" --no-tests=error --output-on-failure \
        --timeout 1800 --parallel "$jobs" \
        --tests-regex "^($(echo fuzz_calls fuzz_snapshots "$@" | tr ' ' '|'))\$"
}

# The memory sanitizer. The lists are meant to be split into words.
# shellcheck disable=SC2086
test_memory() {
    test_under memory $MEMORY_TESTS
}

# The thread sanitizer; each kept input runs with a pool of three threads.
# shellcheck disable=SC2086
test_threads() {
    test_under threads $THREADS_TESTS
}

# All cases of the guarantees, a million random cases of each pair of shapes, a hundred thousand steps
# over the worst network by each number of players, the one file without each of its parts, and packages
# that other tools than CMake build. Takes 40 minutes on two processors.
test_all_cases() {
    THUD_GUARANTEES=full ctest --preset release --label-regex '^guarantees$' --timeout 3600 \
        --parallel "$jobs"
    THUD_CASES=1000000 ctest --preset release --label-regex '^pairs$' --timeout 7200 \
        --parallel "$jobs"
    THUD_NETWORK_STEPS=100000 ctest --preset release --tests-regex '^test_play$' --timeout 3600
    THUD_PARTS=full ctest --preset release --tests-regex '^test_parts$' --timeout 3600
    pip_packages build/conan packaging/conan/requirements.txt "Conan"
    THUD_PACKAGES=full ctest --preset release --label-regex '^packages$' --timeout 3600
}

# The files of a release, made twice, but for the site, which differs from folder to folder. Takes
# some ten minutes.
test_releases() {
    (umask 022 && python3 -B tests/package/test_release.py . source one-file npm python rust)
}

# Measures again what the generated pages in docs/ state, and compares; times only where Box2D can
# be built. Takes some ten minutes.
test_pages_at_length() {
    release=build/release/tests
    set -- tradeoff=$release/tradeoff/thud-tradeoff stability=$release/stability/thud-envelope \
        catalogue=$release/bench/thud-catalogue network=$release/network/thud-network \
        performance=$release/bench/thud-bench
    if build_bench; then
        set -- "$@" times=build/bench/tests/bench/thud-bench
    fi
    python3 -B tests/pages/check_pages.py fresh --long "$@"
}

# clang's release build. What it may change that gcc's does not is found without --full, too: the
# sanitizers' build is clang's, with the same golden hashes, and the WebAssembly modules are clang's
# optimised code, with the native hashes of all scenes.
test_clang() {
    clang=$(command -v clang-16 || command -v clang)
    build release-clang --preset release -DTHUD_WERROR=ON -DTHUD_TEST_SHARE=7 \
        -DCMAKE_C_COMPILER="$clang"
    ctest --test-dir build/release-clang --no-tests=error --output-on-failure --timeout 600 \
        --parallel "$jobs" --label-exclude '^(once|not_clang)$'
}

test_sanitizers() {
    set -- -DTHUD_WERROR=ON
    # What the preset leaves out, as tests/CMakeLists.txt says.
    [ "$full" = no ] || set -- "$@" -DTHUD_LONG_TESTS=ON -DTHUD_BASE_FLAGS= \
        "-DCMAKE_C_FLAGS_DEBUG=-g1 -fsanitize=null,object-size"
    build sanitize --preset sanitize "$@"
    ctest --preset sanitize --label-exclude '^once$' --parallel "$jobs"
}

# The bundlers are downloaded while the page is built.
test_wasm() {
    npm_packages tests/web/bundlers "bundlers to try the package with" &
    bundlers=$!
    build_page
    touch build/test/page.ready
    wait "$bundlers"
    (cd web && npm run test:node && npm run test:bundlers)
}

# The part wasm, where it runs beside this one, builds the page for both.
test_page() {
    case " $parts " in
        *' wasm '*)
            until [ -f build/test/page.ready ] || [ -f build/test/wasm.code ]; do
                sleep 1
            done
            ;;
    esac
    build_page
    if [ "$full" = yes ]; then
        export THUD_FULL=1 THUD_NETWORK_STEPS=10000
    fi
    (cd web && npm run test:page)
}

# The tests of build/bench: programs that compare thud with Box2D, and the pages made of their
# results.
test_baseline() {
    build_bench
    # No test here asserts a time.
    ctest --test-dir build/bench --no-tests=error --output-on-failure --timeout 600 \
        --parallel "$jobs"
}

# run_part PART: runs a part. Its output is in build/test/PART.log; its exit code is written to
# PART.code when it ends. 77: the part was skipped, and its last line says why.
run_part() {
    log=build/test/$1.log
    set +e
    (
        set -e
        date +%s >"build/test/$1.began"
        "test_$1"
    ) >"$log" 2>&1
    echo $? >"build/test/$1.ended"
    mv "build/test/$1.ended" "build/test/$1.code"
}

# longest_tests LOG: the five tests of a log that took longest, in one line: those of ctest, and
# those of Node.js, whose subtests are left out.
longest_tests() {
    awk '
        /^ *[0-9]+\/[0-9]+ Test +#[0-9]+: .* sec *$/ { print $(NF - 1), $4 }
        /^(not )?ok [0-9]+ - / { name = $0; sub(/^(not )?ok [0-9]+ - /, "", name) }
        name == "the_next_file_is_imported" { name = "" } # see tests/web/support/lane.mjs
        /^  duration_ms: / && name { printf "%.3f %s\n", $2 / 1000, name; name = "" }
    ' "$1" | sort -rn | head -n 5 |
        awk '{ seconds = $1; sub(/^[^ ]+ /, ""); printf "%s%s (%.0f s)", comma, $0, seconds; comma = ", " }'
}

# failed_tests LOG: the tests that failed in a log, of ctest and of Node.js, a line each with the first
# line of what was wrong.
failed_tests() {
    awk '
        function tell(what) {
            if (name == "") return
            printf "%sfailed: %s%s", separator, name, what
            separator = "\n"
            name = ""
        }
        /^ *[0-9]+\/[0-9]+ Test +#[0-9]+: / { tell("") }
        /^ *[0-9]+\/[0-9]+ Test +#[0-9]+: .*\*\*\*/ { name = $4 }
        /^\[  ERROR   \] --- / && name { sub(/^\[  ERROR   \] --- /, ": "); tell($0) }
        /^(not )?ok [0-9]+ - / { tell("") }
        /^not ok [0-9]+ - / { name = $0; sub(/^not ok [0-9]+ - /, "", name) }
        below && name { sub(/^ */, ": "); tell($0) }
        { below = /^  error: [|>]/ }
        /^  error: / && !below && name { sub(/^  error: /, ": "); tell($0) }
        END { tell("") }
    ' "$1"
}

# part_ended PART: prints the output of a part, and adds its result to `summary`.
part_ended() {
    log=build/test/$1.log
    say "$1"
    cat "$log"
    case $(cat "build/test/$1.code") in
        0) verdict=passed ;;
        77) verdict="skipped ($(tail -n 1 "$log"))" ;;
        *)
            verdict="FAILED, see $log"
            failures=$((failures + 1))
            ;;
    esac
    seconds=$(($(date +%s) - $(cat "build/test/$1.began")))
    # The last lines of the test runners, ctest and Node.js.
    closing=$(grep -E '^[0-9]+% tests passed|^(#|ℹ) (tests|pass|fail|skipped) [0-9]+' "$log" || :)
    longest=$(longest_tests "$log")
    failed=$(failed_tests "$log")
    summary="$summary
$1: $verdict, ${seconds} s${failed:+
$failed}${closing:+
$closing}${longest:+
longest: $longest}"
}

# tell_progress PARTS: prints the time and the last line of output of each part that is running.
tell_progress() {
    for part in $1; do
        [ -f "build/test/$part.began" ] && [ ! -f "build/test/$part.code" ] || continue
        seconds=$(($(date +%s) - $(cat "build/test/$part.began")))
        printf '.. %s, %s s: %s\n' "$part" "$seconds" \
            "$(tail -n 1 "build/test/$part.log" | cut -c 1-80)"
    done
}

# Builds what both lanes need before they start, so that they do not build it at the same time:
# thud-run, with the engine and the scenes, which the part baseline uses as they are.
prepare_test() {
    built=$root/build/release
    case " $parts " in
        *' native '* | *' wasm '* | *' baseline '*)
            say "Building thud-run"
            cmake -B build/release --preset release -DTHUD_WERROR=ON >/dev/null
            cmake --build build/release --parallel "$jobs" --target thud-run
            ;;
    esac
}

# run_lane PART...: runs those of these parts that are in `parts` and that the other lane has not
# begun, one after the other. The folder PART.taken is made by the lane that runs the part.
run_lane() {
    for lane_part; do
        case " $parts " in
            *" $lane_part "*)
                if mkdir "build/test/$lane_part.taken" 2>/dev/null; then
                    run_part "$lane_part"
                fi
                ;;
        esac
    done
}

# Lowers the priority of this shell, so that the browsers of the part page get processor time.
give_way() {
    renice -n 5 -p "$(exec sh -c 'echo "$PPID"')" >/dev/null 2>&1 || :
}

# test_everything: runs `parts` in two lanes, and prints a summary.
test_everything() {
    # make itself takes a tenth of the time of a build. Existing directories keep their generator.
    export CMAKE_GENERATOR="${CMAKE_GENERATOR:-Ninja}"
    mkdir -p build/test
    failures=0
    summary=
    waiting=
    for part in $parts; do
        rm -rf "build/test/$part.began" "build/test/$part.code" "build/test/$part.taken" \
            build/test/page.ready
        waiting="$waiting $part"
    done
    prepare_test
    # Without this the lanes would go on when the shell is interrupted.
    trap 'trap - TERM; kill -TERM 0' INT HUP
    say "Testing:$parts"
    # Browsers wait much, and sanitizers do not: side by side they keep both processors busy.
    (give_way && run_lane wasm sanitizers baseline) &
    (
        (give_way && run_lane native)
        run_lane page
        give_way && run_lane sanitizers baseline
    ) &
    ticks=0
    while [ -n "$waiting" ]; do
        sleep 1
        ticks=$((ticks + 1))
        for part in $waiting; do
            [ -f "build/test/$part.code" ] || continue
            part_ended "$part"
            waiting=$(echo "$waiting" | sed "s/ $part\$//; s/ $part / /")
        done
        [ $((ticks % TEST_WORD_EVERY)) != 0 ] || tell_progress "$waiting"
    done
    say "Summary"
    printf '%s\n' "$summary"
    [ "$failures" = 0 ] || die "of the parts of the test, $failures failed"
}
