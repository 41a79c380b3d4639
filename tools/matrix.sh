# matrix.sh: ./run matrix, which runs the same scenes, levels and snapshots with each compiler and
# set of options and on each machine of tests/matrix/rows.txt, and compares the hashes. Sourced by
# ./run.
# shellcheck shell=sh

MATRIX=tests/matrix
# Options of thud-matrix for emulated machines, which are slow: fewer steps and bodies.
MATRIX_SHORT="--steps 60 --bodies 150"

matrix_usage() {
    cat <<'END'
usage: ./run matrix [OPTION...]

Builds thud on every row of tests/matrix/rows.txt (compilers and their options, processors, systems,
browsers), runs all scenes and levels there, and continues snapshots of one row on another. Every
hash has to be that of the reference row, whose scenes have to end as tests/golden says.

  --rows NAME,...  these rows alone, and the reference
  --list           names the rows
  --quick          half the steps, and fewer bodies, on every row; emulated ones always have that
  --allow-missing  a row whose tools cannot be installed is left out instead of failing
  --report         writes the table into docs/platforms.md; for all rows, on a tree without changes

What a row builds and prints stays in build/matrix. With THUD_MATRIX_FLAGS_OF_ROW set to "ROW FLAGS"
the build of that row gets further compiler flags for the engine: to see that a row can fail.
END
}

# matrix_lines FILE: the lines of tests/matrix/FILE.txt without comments, and without blanks around
# the bars.
matrix_lines() {
    sed '/^#/d; s/ *| */|/g' "$MATRIX/$1.txt"
}

# Prints the names of all rows.
matrix_names() {
    matrix_lines rows | cut -d '|' -f 1
}

# matrix_field FILE NAME N: the Nth field of the line whose first field is NAME.
matrix_field() {
    matrix_lines "$1" | awk -F '|' -v name="$2" -v n="$3" '$1 == name { print $n }'
}

# Sets the variables for the options of ./run matrix; ends with an error for a wrong option.
check_matrix_options() {
    matrix_rows=$(matrix_names)
    matrix_short=
    allow_missing=no
    matrix_report=no
    matrix_all=yes
    while [ $# -gt 0 ]; do
        case $1 in
            --rows)
                matrix_all=no
                matrix_rows=$(echo "${2:-}" | tr ',' '\n')
                for row in $matrix_rows; do
                    matrix_names | grep -qxF -- "$row" ||
                        die "matrix has no row '$row'; ./run matrix --list names them"
                done
                [ -n "$matrix_rows" ] || die "--rows needs names of rows; see ./run matrix --list"
                shift
                ;;
            --quick) matrix_short=$MATRIX_SHORT ;;
            --allow-missing) allow_missing=yes ;;
            --report) matrix_report=yes ;;
            *) die "matrix knows no '$1'; see ./run matrix --help" ;;
        esac
        shift
    done
    if [ "$matrix_report" = yes ]; then
        [ "$matrix_all$matrix_short" = yes ] || die "--report is for all rows, at full length"
        git diff --quiet HEAD -- engine demo web/tools tests/matrix tools run ||
            die "--report is for a tree without changes, so that the table can name its commit"
    fi
    reference=$(matrix_names | head -n 1)
}

# matrix_tools ROW: the words by which need_matrix finds out what a row needs: compiler, runner,
# build.
matrix_tools() {
    build_name=$(matrix_field rows "$1" 2)
    compiler=$(matrix_field builds "$build_name" 2)
    echo "${compiler:-${build_name%% *}} $(matrix_field rows "$1" 3) $build_name"
}

# ---- building and running one row ----

# matrix_compiler NAME: the command of a compiler of builds.txt.
matrix_compiler() {
    case $1 in
        clang) command -v clang-16 || command -v clang ;;
        i686) echo i686-linux-gnu-gcc ;;
        *) echo "$1" ;;
    esac
}

# matrix_build NAME: configures and builds build/matrix/NAME, once in a run of this script.
matrix_build() {
    case " $matrix_built " in
        *" $1 "*) return 0 ;;
    esac
    compiler=$(matrix_field builds "$1" 2)
    flags=$(matrix_field builds "$1" 3)
    options=$(matrix_field builds "$1" 4)
    configure=cmake
    chosen=
    case $compiler in
        gcc | clang) chosen=-DCMAKE_C_COMPILER=$(matrix_compiler "$compiler") ;;
        emcc)
            # The same as in web/tools/build-wasm.sh.
            [ ! -d /usr/share/nodejs ] || export NODE_PATH=/usr/share/nodejs
            configure="emcmake cmake"
            ;;
        *) chosen=-DCMAKE_TOOLCHAIN_FILE=$root/$MATRIX/toolchains/$compiler.cmake ;;
    esac
    directory=build/matrix/$1
    grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$directory/CMakeCache.txt" ||
        rm -rf "$directory"
    # The options are meant to be split into words.
    # shellcheck disable=SC2086
    nice -n 5 $configure -S . -B "$directory" -DTHUD_MATRIX=ON "-DCMAKE_C_FLAGS_RELEASE=$flags" \
        -DCMAKE_BUILD_TYPE=Release $chosen $options "-DTHUD_MATRIX_ENGINE_FLAGS=$engine_flags" &&
        nice -n 5 cmake --build "$directory" --parallel "$jobs" --target thud-matrix || return 1
    matrix_built="$matrix_built $1"
}

# matrix_run ROW WORD...: runs thud-matrix of a row with these arguments, by the row's runner.
matrix_run() {
    runner=$(matrix_field rows "$1" 3)
    program=build/matrix/$(matrix_field rows "$1" 2)/tests/matrix/thud-matrix
    shift
    case $runner in
        'native baseline') "$program" --baseline "$@" ;;
        native*) "$program" "$@" ;;
        qemu-*)
            # The runner is meant to be split: the emulator, and its options.
            # shellcheck disable=SC2086
            set -- "$program" "$@"
            emulator=${runner%% *}-static
            [ "$runner" = "${runner%% *}" ] || set -- ${runner#* } "$@"
            "$emulator" "$@"
            ;;
        wine)
            env -u DISPLAY WINEDEBUG=-all WINEPREFIX="$root/build/matrix/wine" wine \
                "$program.exe" "$@" | tr -d '\r'
            ;;
        *) node web/tools/matrix.mjs "$runner" "$program.js" "$@" ;;
    esac
}

# matrix_length ROW: `short` for emulated rows and with --quick, else `full`.
matrix_length() {
    case $matrix_short$(matrix_field rows "$1" 3) in
        --steps* | qemu-*) echo short ;;
        *) echo full ;;
    esac
}

# matrix_words LENGTH: the options of thud-matrix for that length.
matrix_words() {
    [ "$1" = full ] || echo "$MATRIX_SHORT"
}

# The levels that are run: all but the map "wrong", which has mistakes.
matrix_levels() {
    ls assets/levels/*.tmj tests/levels/maps/*.tmj tests/levels/maps/*.tmx | grep -v '/wrong\.'
}

# Runs the reference row at both lengths, and keeps its output, with which all rows are compared.
matrix_reference() {
    folder=build/matrix/rows/reference
    mkdir -p "$folder"
    matrix_build "$reference" || return 1
    # The file names are meant to be split.
    # shellcheck disable=SC2046
    matrix_run "$reference" --make-plain "$folder/levels" $(matrix_levels) || return 1
    for length in full short; do
        # shellcheck disable=SC2046
        matrix_run "$reference" $(matrix_words $length) --plain "$folder/levels" \
            --keep "$folder/$length.plain" --take "$folder/$length.snapshots" \
            >"$folder/$length.out" || return 1
    done
}

# matrix_refused "COMPILER FLAGS": prints two numbers: of the engine's files that include base.h how
# many the compiler refuses with these flags, with an error that says what thud needs; and the
# number of all such files. Files without base.h have constants only.
matrix_refused() {
    compiler=$(matrix_compiler "${1%% *}")
    total=0
    refused=0
    for source in $(find engine/src -name '*.c' | sort); do
        gcc -MM -DTD_ISA=base -Iengine/include -Iengine/src "$source" | grep -q 'base/base\.h' ||
            continue
        total=$((total + 1))
        # shellcheck disable=SC2086
        if ! words=$($compiler ${1#* } -std=c17 -fsyntax-only -Wfatal-errors -DTD_ISA=base \
            -Iengine/include -Iengine/src "$source" 2>&1); then
            case $words in
                *'error'*'thud needs'*) refused=$((refused + 1)) ;;
            esac
        fi
    done
    echo "$refused $total"
}

# matrix_row ROW: builds and runs a row; its output goes to build/matrix/rows/ROW. It runs all
# scenes from the start, then continues the snapshots of the reference, and last a run that goes the
# other way: the reference continues the snapshots of this row, or, where the formats of snapshots
# differ, this row those of the first row with its format.
matrix_row() {
    row_build=$(matrix_field rows "$1" 2)
    if [ "$(matrix_field rows "$1" 3)" = refused ]; then
        matrix_refused "$row_build" >"$folder/refused"
        return
    fi
    matrix_build "$row_build" || return 1
    length=$(matrix_length "$1")
    words=$(matrix_words "$length")
    given=build/matrix/rows/reference
    plain="--plain $given/levels"
    case $(matrix_field rows "$1" 3) in
        'native plain') plain="--no-scenes --plain $given/$length.plain" ;;
        native | 'native baseline')
            # shellcheck disable=SC2046
            matrix_run "$1" --make-plain "$folder/levels" $(matrix_levels) || return 1
            plain="--plain $folder/levels"
            ;;
    esac
    # shellcheck disable=SC2086
    matrix_run "$1" $words $plain --take "$folder/$length.snapshots" >"$folder/own.out" || return 1
    # shellcheck disable=SC2086
    matrix_run "$1" $words $plain --continue "$given/$length.snapshots" \
        >"$folder/from-reference.out" || return 1
    leader=$(matrix_lines rows | awk -F '|' -v kind="$(matrix_field rows "$1" 4)" \
        '$4 == kind { print $1; exit }')
    if [ "$leader" = "$reference" ]; then
        matrix_run "$leader" $words --plain "$given/levels" --continue "$folder/$length.snapshots" \
            >"$folder/back.out" || return 1
        return
    fi
    # The snapshots of the first row with this format, which may be this row itself.
    theirs=build/matrix/rows/$leader/$length.snapshots
    [ -f "$theirs" ] || theirs=$folder/$length.snapshots
    # shellcheck disable=SC2086
    matrix_run "$1" $words $plain --continue "$theirs" >"$folder/back.out" || return 1
}

# Builds the reference again without the further flags of THUD_MATRIX_FLAGS_OF_ROW, so that no other
# row runs a program that was built with them.
matrix_undo_flags() {
    [ -n "$engine_flags" ] || return 0
    engine_flags=
    matrix_built=
    matrix_build "$reference" >>"$folder/log" 2>&1
}

# ---- all rows ----

# matrix_ensure ROWS: installs what these rows need; false, with the list in `missing`, where
# something cannot be installed.
matrix_ensure() {
    verb_rows=$1
    missing=
    need_matrix
    [ -n "$missing" ] || return 0
    (ensure matrix) && { missing= && need_matrix && [ -z "$missing" ]; }
}

# matrix WORD...: ./run matrix.
matrix() {
    case ${1:-} in
        -h | --help)
            matrix_usage
            return
            ;;
        --list)
            matrix_lines rows | awk -F '|' '{ printf "%-20s %s\n", $1, $5 }'
            return
            ;;
    esac
    check_matrix_options "$@"
    mkdir -p build/matrix/rows
    for row in $matrix_rows; do
        rm -rf "build/matrix/rows/$row"
    done
    matrix_built=
    engine_flags=
    verb_rows=$matrix_rows
    matrix_ensure "$reference $matrix_rows" || say "Not all rows can be had: see the table"
    for row in $matrix_rows; do
        case $(matrix_field rows "$row" 3) in
            chromium | firefox) ! have npm || web_packages ;;
        esac
    done
    say "Reference: $reference"
    matrix_reference >build/matrix/reference.log 2>&1 || die "the reference cannot be built and run:
$(tail -n 20 build/matrix/reference.log)"
    for row in $matrix_rows; do
        folder=build/matrix/rows/$row
        mkdir -p "$folder"
        began=$(date +%s)
        if ! matrix_ensure "$row" >"$folder/log" 2>&1; then
            printf '%s' "$missing" >"$folder/missing"
        else
            engine_flags=
            case ${THUD_MATRIX_FLAGS_OF_ROW:-} in
                "$row "*) engine_flags=${THUD_MATRIX_FLAGS_OF_ROW#* } matrix_built= ;;
            esac
            matrix_row "$row" >>"$folder/log" 2>&1 || echo "$?" >"$folder/failed"
            matrix_undo_flags
        fi
        echo $(($(date +%s) - began)) >"$folder/seconds"
        matrix_version "$row" >"$folder/version" 2>/dev/null || :
        python3 $MATRIX/verdict.py row "$row"
    done
    say "Summary"
    set -- summary
    [ "$allow_missing" = no ] || set -- "$@" --allow-missing
    python3 $MATRIX/verdict.py "$@" $matrix_rows || failed=yes
    if [ "$matrix_report" = yes ]; then
        python3 $MATRIX/verdict.py report "$(git rev-parse --short HEAD)"
        say "The table is in docs/platforms.md"
    fi
    [ "${failed:-no}" = no ] || die "rows differ, are refused or missing: see the table"
}

# matrix_version ROW: prints the versions of the row's compiler, and of its emulator, browser and so
# on.
matrix_version() {
    build_name=$(matrix_field rows "$1" 2)
    compiler=$(matrix_field builds "$build_name" 2)
    case ${compiler:-${build_name%% *}} in
        gcc) gcc -dumpfullversion | sed 's/^/gcc /' ;;
        clang | *-clang) "$(matrix_compiler clang)" -dumpversion | sed 's/^/clang /' ;;
        emcc) emcc -dumpversion | sed 's/^/emcc /' ;;
        windows) x86_64-w64-mingw32-gcc -dumpfullversion | sed 's/^/gcc /' ;;
        *) "${compiler:-i686}-linux-gnu-gcc" -dumpfullversion | sed 's/^/gcc /' ;;
    esac
    case $(matrix_field rows "$1" 3) in
        qemu-*) qemu-aarch64-static --version | sed -n '1s/.*version \([0-9.]*\).*/qemu \1/p' ;;
        wine) wine --version | sed 's/^wine-\([0-9.]*\).*/Wine \1/' ;;
        node) node --version | sed 's/^v/Node.js /' ;;
        chromium) "$(command -v chromium || command -v chromium-browser)" --version |
            sed -n 's/.*Chromium \([0-9]*\).*/Chromium \1/p' ;;
        firefox) "$(command -v firefox-esr || command -v firefox)" --version |
            sed -n 's/.*Firefox \([0-9]*\).*/Firefox \1/p' ;;
    esac
}
