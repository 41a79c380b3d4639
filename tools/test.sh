# test.sh: the parts of ./run test, in order, and their summary. Read by ./run.
# shellcheck shell=sh

# stage NAME COMMAND...: runs one part in a subshell, keeps what it printed, and remembers how it
# ended; 77 is a part that was skipped for the reason it gave last.
stage() {
    name=$1
    log=build/test/$(echo "$name" | tr -cs 'a-zA-Z0-9\n' '-').log
    shift
    say "$name"
    (
        set +e
        (
            set -e
            "$@"
        )
        echo $? >"$log.code"
    ) 2>&1 | tee "$log"
    case $(cat "$log.code") in
        0) verdict=passed ;;
        77) verdict="skipped ($(tail -n 1 "$log"))" ;;
        *)
            verdict="FAILED, see $log"
            failures=$((failures + 1))
            ;;
    esac
    # The runners' own closing lines: ctest's, and those of Node's.
    closing=$(grep -E '^[0-9]+% tests passed|^(#|ℹ) (tests|pass|fail|skipped) [0-9]+' "$log" || :)
    summary="$summary
$name: $verdict${closing:+
$closing}"
}

test_native() {
    build release --preset release -DTHUD_WERROR=ON
    ctest --preset release --parallel "$jobs"
}

# A quarter of an hour on two processors.
test_all_cases() {
    THUD_CASES=1000000 ctest --preset release --label-regex '^pairs$' --timeout 7200 \
        --parallel "$jobs"
}

test_clang() {
    clang=$(command -v clang-16 || command -v clang)
    build release-clang --preset release -DTHUD_WERROR=ON -DCMAKE_C_COMPILER="$clang"
    ctest --test-dir build/release-clang --no-tests=error --output-on-failure --timeout 300 \
        --parallel "$jobs"
}

test_sanitize() {
    build sanitize --preset sanitize -DTHUD_WERROR=ON
    ctest --preset sanitize --parallel "$jobs"
}

test_wasm() {
    build_page
    (cd web && npm run test:node)
}

test_page() {
    (cd web && npm run test:page)
}

test_baseline() {
    build_bench
    ctest --test-dir build/bench --output-on-failure --timeout 300
}

# test_everything [--full]
test_everything() {
    mkdir -p build/test
    failures=0
    summary=
    stage "native" test_native
    [ "${1:-}" != --full ] || stage "geometry, 10^6 cases a pair" test_all_cases
    stage "native, clang" test_clang
    stage "sanitizers" test_sanitize
    stage "wasm in Node" test_wasm
    stage "page in Chromium and Firefox" test_page
    stage "comparison with Box2D" test_baseline
    say "Summary"
    printf '%s\n' "$summary"
    [ "$failures" = 0 ] || die "$failures parts of the test failed"
}
