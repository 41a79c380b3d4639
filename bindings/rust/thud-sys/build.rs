//! Compiles the engine in one file, thud.c, which a packed crate has beside this file; in the
//! repository tools/amalgamate.py makes it. With THUD_LIB_DIR set to a folder with libthud.a, that is
//! linked instead.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

fn main() {
    println!("cargo:rerun-if-env-changed=THUD_LIB_DIR");
    if let Ok(folder) = env::var("THUD_LIB_DIR") {
        println!("cargo:rustc-link-search=native={folder}");
        println!("cargo:rustc-link-lib=static=thud");
    } else {
        let source = source();
        println!("cargo:rerun-if-changed={}", source.display());
        let mut build = cc::Build::new();
        // The engine's own flags: the same bits everywhere, and sqrt in one instruction.
        build.file(source).std("c17").warnings(false).flag("-ffp-contract=off");
        build.flag("-fno-math-errno").flag_if_supported("-Wno-psabi");
        build.compile("thud");
    }
    if env::var("CARGO_CFG_UNIX").is_ok() {
        println!("cargo:rustc-link-lib=m");
    }
}

fn source() -> PathBuf {
    let here = PathBuf::from(env::var("CARGO_MANIFEST_DIR").unwrap());
    let packed = here.join("thud.c");
    if packed.is_file() {
        return packed;
    }
    let script = here.join("../../../tools/amalgamate.py");
    let made = Path::new(&env::var("OUT_DIR").unwrap()).join("made");
    println!("cargo:rerun-if-changed={}", here.join("../../../engine").display());
    let done = Command::new("python3").arg("-B").arg(&script).arg(&made).status();
    assert!(done.is_ok_and(|status| status.success()), "{} did not make thud.c", script.display());
    made.join("thud.c")
}
