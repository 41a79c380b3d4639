# release.sh: ./run release, which makes the files of a release from the last commit. Sourced by
# ./run.
# shellcheck shell=sh

RELEASE_PARTS="source one-file npm python rust site"

release_usage() {
    cat <<'END_OF_USAGE'
usage: ./run release [PART...]

Makes the files of a release in build/release-files, or only the parts that are named:

  source    thud-VERSION.tar.gz: every file of the repository; and thud.wrap, by which a project that
            Meson builds has it as a subproject
  one-file  thud-VERSION-one-file.tar.gz: thud.h, thud.c, thud_recorded.h, thud.hpp and the license
  npm       thud-VERSION.tgz: the JavaScript package
  python    python/thud-VERSION-*.whl, the Python package for this system and its version of Python,
            and the sources for all others, python/thud-VERSION.tar.gz
  rust      thud-sys-VERSION.crate and thud-VERSION.crate; left out where cargo is missing
  site      thud-VERSION-site.tar.gz: the page and the site of documentation, for a web server

and SHA256SUMS, the sums of what was made. All is built from the last commit in a folder of its
own, so changes that are not committed are refused. Two calls of the same commit with the same
compilers give the same bytes, in any folder and at any time: times are that of the commit. The
site alone may differ.
END_OF_USAGE
}

# release_options WORD...: sets `parts`; ends with an error for a wrong word.
release_options() {
    for word; do
        case " $RELEASE_PARTS " in
            *" $word "*) ;;
            *) die "release knows no part '$word', only: $RELEASE_PARTS" ;;
        esac
    done
    parts=
    for part in $RELEASE_PARTS; do
        case " ${*:-$RELEASE_PARTS} " in
            *" $part "*) parts="$parts $part" ;;
        esac
    done
}

# release_clean: ends with an error where the tree is not the last commit.
release_clean() {
    git rev-parse --verify --quiet HEAD >/dev/null ||
        die "release needs the repository with its history, and git"
    changes=$(git status --porcelain)
    [ -z "$changes" ] || die "release makes files of the last commit; these changes are not committed:
$changes"
}

# release_archive OUT WORD...: tools/archive.py, into build/release-files.
release_archive() {
    made=$files/$1
    shift
    python3 -B "$root/tools/archive.py" "$made" "$@"
}

# release_PART: makes a part, in the folder of a fresh copy of the last commit.
release_source() {
    release_archive "thud-$version.tar.gz" "$work/source.tar"
    sum=$(sha256 "$files/thud-$version.tar.gz")
    sed "s/@VERSION@/$version/; s/@SHA256@/${sum%% *}/" packaging/meson/thud.wrap.in >"$files/thud.wrap"
}

release_one_file() {
    python3 -B tools/amalgamate.py "$work/one-file"
    release_archive "thud-$version-one-file.tar.gz" "thud-$version" "$work/one-file" LICENSE
}

release_npm() {
    release_page
    (cd web/package && npm pack --silent --pack-destination "$work" >/dev/null)
    release_archive "thud-$version.tgz" "$work/thud-$version.tgz"
}

release_site() {
    release_page
    release_archive "thud-$version-site.tar.gz" "thud-$version-site" web/dist
}

# Builds the package, and what else `parts` asks for, once.
release_page() {
    [ ! -f "$work/page.built" ] || return 0
    cp -R "$root/web/node_modules" web/node_modules
    sh web/tools/build-wasm.sh
    (cd web && npm run build:package)
    case " $parts " in
        *' site '*) (cd web && npm run build:page) ;;
    esac
    touch "$work/page.built"
}

# The wheel is built from the sources that are packed for others.
release_python() {
    (cd bindings/python && "$root/build/python/bin/python3" -B setup.py --quiet sdist --dist-dir "$work/sdist")
    mkdir "$files/python"
    release_archive "python/thud-$version.tar.gz" "$work/sdist/thud-$version.tar.gz"
    CFLAGS="-g0 ${CFLAGS:-}" "$root/build/python/bin/python3" -B -m pip --quiet --disable-pip-version-check wheel \
        --no-index --no-deps --no-build-isolation --wheel-dir "$files/python" \
        "$files/python/thud-$version.tar.gz"
}

# The lock file, which belongs to programs, would hold the versions of this day.
release_rust() {
    if ! have cargo; then
        say "The crates are left out: cargo is missing"
        return 0
    fi
    python3 -B tools/amalgamate.py bindings/rust/thud-sys
    cp LICENSE bindings/rust/thud-sys
    cp LICENSE bindings/rust/thud
    (cd bindings/rust && cargo package --quiet --workspace --no-verify --allow-dirty --exclude-lockfile \
        --target-dir "$work/crates")
    for crate in thud-sys thud; do
        release_archive "$crate-$version.crate" "$work/crates/package/$crate-$version.crate"
    done
}

need_release() {
    need "Python 3" python3 have python3
    case " $parts " in
        *' npm '* | *' site '*) need_demo ;;
    esac
    case " $parts " in
        *' python '*)
            need "a C compiler with make" build-essential compiles
            need "Python's environments" python3-venv have_python_environments
            need "Python's headers" python3-dev have_python_header
            ;;
    esac
}

# sha256 FILE...: as coreutils print it, which macOS lacks.
sha256() {
    if have sha256sum; then sha256sum "$@"; else shasum -a 256 "$@"; fi
}

# release WORD...: ./run release.
release() {
    case ${1:-} in
        -h | --help)
            release_usage
            return
            ;;
    esac
    release_options "$@"
    release_clean
    ensure release
    files=$root/build/release-files
    work=$root/build/release-work
    rm -rf "$files" "$work"
    mkdir -p "$files" "$work"
    SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
    LC_ALL=C TZ=UTC
    export SOURCE_DATE_EPOCH LC_ALL TZ
    umask 022
    version=$(sed -n 's/^  "version": "\(.*\)",$/\1/p' web/package/package.json)
    git -c tar.umask=0022 archive --prefix="thud-$version/" --output "$work/source.tar" HEAD
    tar -xf "$work/source.tar" -C "$work"
    case " $parts " in
        *' npm '* | *' site '*) web_packages ;;
    esac
    case " $parts " in
        *' python '*) python_packages ;;
    esac
    for part in $parts; do
        say "Making $part"
        cd "$work/thud-$version"
        "release_$(echo "$part" | tr - _)"
        cd "$root"
    done
    rm -rf "$work"
    # In two steps, since the shell makes the file before the others are listed.
    sums=$(cd "$files" && find . -type f | sed 's:^\./::' | sort | while read -r name; do sha256 "$name"; done)
    printf '%s\n' "$sums" >"$files/SHA256SUMS"
    say "In build/release-files"
    cat "$files/SHA256SUMS"
}
