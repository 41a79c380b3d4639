"""Tests the engine as other projects use it: single headers, installed and found from C++, as a
subdirectory of another project, as shared and as static library.

usage: test_package.py SOURCE BUILD CC [CXX]"""

import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

from command import run

sys.path.append(str(Path(__file__).parent.parent / "fuzz"))
from check_calls import declared  # noqa: E402

SOURCE, BUILD, CC = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3]
CXX = sys.argv[4] if len(sys.argv) > 4 else ""
HEADERS = sorted(path.name for path in (SOURCE / "engine/include/thud").glob("*.h"))
PROGRAM = """#include <thud/thud.h>
int main() {
    thud_world_def def = thud_default_world_def();
    thud_world *world;
    if (thud_world_create(&def, &world) != THUD_OK) return 1;
    thud_world_step(world);
    int wrong = thud_stats_of(world).steps != 1;
    thud_world_destroy(world);
    return wrong;
}
"""
FINDS = """cmake_minimum_required(VERSION 3.22)
project(game LANGUAGES CXX)
find_package(thud 0.2 REQUIRED)
add_executable(game game.cpp)
target_link_libraries(game PRIVATE thud::thud)
"""
ADDS = """cmake_minimum_required(VERSION 3.22)
project(game LANGUAGES CXX)
add_subdirectory({} thud)
add_executable(game game.cpp)
target_link_libraries(game PRIVATE thud::thud)
install(FILES game.cpp DESTINATION share)
"""


def project(folder, text):
    (folder / "CMakeLists.txt").write_text(text, encoding="utf-8")
    (folder / "game.cpp").write_text(PROGRAM, encoding="utf-8")


def names_shown(library):
    words = [line.split() for line in run("nm", "-D", "--defined-only", library).splitlines()]
    return {word[2] for word in words if word[1] in "TDRBG"}


class PackageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.held = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.held.name)
        cls.prefix = cls.folder / "prefix"
        run("cmake", "--install", BUILD, "--prefix", cls.prefix)
        cls.library = next(cls.prefix.rglob("libthud.a"))

    @classmethod
    def tearDownClass(cls):
        cls.held.cleanup()

    def made(self, name):
        folder = self.folder / name
        folder.mkdir()
        return folder

    def test_each_header_compiles_alone(self):
        ways = [(CC, "c", std) for std in ("c99", "c11", "c17")]
        ways += [(CXX, "c++", std) for std in ("c++11", "c++17") if CXX]
        for compiler, language, std in ways:
            for header in HEADERS + ["thud.hpp"] * (std == "c++17"):
                with self.subTest(header=header, std=std):
                    run(compiler, "-x", language, f"-std={std}", "-Wall", "-Wextra",
                        "-pedantic-errors", "-Werror", "-fsyntax-only",
                        f"-I{self.prefix / 'include'}", "-",
                        input=f"#include <thud/{header}>\nextern int here;\n")

    def test_who_ignores_that_nothing_was_made_is_warned(self):
        ways = [(CC, "c", std) for std in ("c99", "c17")]
        ways += [(CXX, "c++", std) for std in ("c++11", "c++17") if CXX]
        for compiler, language, std in ways:
            with self.subTest(std=std), self.assertRaisesRegex(AssertionError, "unused-result"):
                run(compiler, "-x", language, f"-std={std}", "-Werror", "-c", "-o", "/dev/null",
                    f"-I{self.prefix / 'include'}", "-",
                    input="#include <thud/thud.h>\nvoid f(thud_world *w, thud_body_def *d) "
                          "{ thud_body_create(w, d, 0); }\n")

    def test_licence_and_pkg_config_file_are_installed(self):
        licences = [path.read_text() for path in self.prefix.rglob("LICENSE")]
        self.assertEqual(licences, [(SOURCE / "LICENSE").read_text()])
        text = next(self.prefix.rglob("thud.pc")).read_text()
        self.assertRegex(text, r"Version: \d+\.\d+\.\d+\n")
        self.assertNotRegex(text, r"[@$]<|@\w+@")

    @unittest.skipUnless(CXX, "there is no C++ compiler")
    def test_project_in_cplusplus_alone_finds_it_by_version(self):
        folder = self.made("finds")
        project(folder, FINDS)
        run("cmake", "-B", folder / "build", "-S", folder, f"-DCMAKE_PREFIX_PATH={self.prefix}",
            f"-DCMAKE_CXX_COMPILER={CXX}")
        run("cmake", "--build", folder / "build")
        run(folder / "build/game")
        project(folder, FINDS.replace("thud::thud", "thud"))
        run("cmake", "-B", folder / "build", "-S", folder)
        run("cmake", "--build", folder / "build")
        project(folder, FINDS.replace("thud 0.2", "thud 0.3"))
        with self.assertRaisesRegex(AssertionError, "considered but not accepted"):
            run("cmake", "-B", folder / "later", "-S", folder,
                f"-DCMAKE_PREFIX_PATH={self.prefix}", f"-DCMAKE_CXX_COMPILER={CXX}")

    @unittest.skipUnless(CXX, "there is no C++ compiler")
    def test_threads_are_a_target_of_their_own(self):
        folder = self.made("threads")
        program = PROGRAM.replace("#include <thud/thud.h>", "#include <thud/thud_all.h>").replace(
            "    thud_world *world;", "    thud_threads *threads;\n    thud_world *world;\n"
            "    if (thud_threads_create(3, nullptr, &threads) != THUD_OK) return 2;\n"
            "    def.job_system = thud_job_system_of(threads);")
        for text in (FINDS, ADDS.format(SOURCE)):
            project(folder, text.replace("thud::thud", "thud::threads"))
            (folder / "game.cpp").write_text(program, encoding="utf-8")
            run("cmake", "-B", folder / "build", "-S", folder, f"-DCMAKE_CXX_COMPILER={CXX}",
                f"-DCMAKE_C_COMPILER={CC}", f"-DCMAKE_PREFIX_PATH={self.prefix}")
            if text == FINDS:
                run("cmake", "--build", folder / "build")
                run(folder / "build/game")
        text = next(self.prefix.rglob("thud-threads.pc")).read_text()
        self.assertRegex(text, r"Requires: thud = \d+\.\d+\.\d+\n")
        self.assertNotRegex(text, r"[@$]<|@\w+@")

    @unittest.skipUnless(CXX, "there is no C++ compiler")
    def test_project_in_cplusplus_alone_may_have_it_as_a_part(self):
        folder = self.made("adds")
        project(folder, ADDS.format(SOURCE))
        compilers = (f"-DCMAKE_CXX_COMPILER={CXX}", f"-DCMAKE_C_COMPILER={CC}")
        run("cmake", "-B", folder / "build", "-S", folder, *compilers)
        # Nothing of thud is installed; it is not even built.
        run("cmake", "--install", folder / "build", "--prefix", folder / "prefix")
        installed = [path.name for path in (folder / "prefix").rglob("*") if path.is_file()]
        self.assertEqual(installed, ["game.cpp"])
        project(folder, ADDS.format(SOURCE).replace("thud::thud", "thud"))
        run("cmake", "-B", folder / "build", "-S", folder, *compilers)

    @unittest.skipUnless(shutil.which("emcmake"), "there is no emcc")
    def test_part_of_a_project_for_browsers_does_not_bring_the_page(self):
        folder = self.made("browser")
        project(folder, ADDS.format(SOURCE))
        run("emcmake", "cmake", "-G", "Unix Makefiles", "-B", folder / "build", "-S", folder)
        targets = run("cmake", "--build", folder / "build", "--target", "help")
        self.assertIn("... thud\n", targets)
        self.assertNotIn("thud-web", targets)
        self.assertNotIn("thud-demo", targets)

    def test_static_library_becomes_part_of_a_shared_one_and_shows_only_its_interface(self):
        whole = self.folder / "libwhole.so"
        run(CC, "-shared", "-o", whole, "-Wl,--whole-archive", self.library,
            "-Wl,--no-whole-archive", "-lm", "-Wl,-z,defs")
        shown = names_shown(whole)
        self.assertEqual([name for name in shown if not name.startswith("thud_")], [])
        # All functions that the headers declare, with THUD_API or without.
        headers = SOURCE / "engine/include/thud"
        functions = declared(headers)
        constants = set()
        for header in HEADERS:
            constants |= set(re.findall(r"^extern (?:THUD_API )?const \w+ (thud_\w+);",
                                        (headers / header).read_text(), re.MULTILINE))
        recorded = set(re.findall(r"^#define thud_\w+ (thud_recorded_\w+)$",
                                  (headers / "thud_recorded.h").read_text(), re.MULTILINE))
        self.assertEqual(shown, functions | constants | recorded)
        program = self.folder / "all.c"
        calls = ", ".join(f"(any *){name}" for name in sorted(functions))
        program.write_text(f"#include <thud/thud_all.h>\ntypedef void any(void);\n"
                           f"any *all[] = {{{calls}}};\nint main(void) {{ return !all[0]; }}\n")
        run(CC, f"-I{self.prefix / 'include'}", program, "-o", self.folder / "all", whole, "-lm")
        run(self.folder / "all")

    def test_excess_precision_is_refused_with_the_reason(self):
        if "x86" not in run(CC, "-dumpmachine") or "clang" in run(CC, "--version"):
            self.skipTest("only gcc for x86 computes on the x87")
        with self.assertRaisesRegex(AssertionError, "without excess precision"):
            run(CC, "-std=c17", "-mfpmath=387", "-fsyntax-only", f"-I{SOURCE / 'engine/include'}",
                f"-I{SOURCE / 'engine/src'}", SOURCE / "engine/src/base/memory.c")

    def test_pkg_config_file_names_folders_that_are_relative_or_absolute(self):
        folder = self.made("folders")
        for library, headers, says in (
                ("lib64", "include/2d", ("${prefix}/lib64", "${prefix}/include/2d")),
                (folder / "libraries", folder / "headers", (folder / "libraries", folder / "headers"))):
            run("cmake", "-G", "Unix Makefiles", "-B", folder / "build", "-S", SOURCE, "-DTHUD_DEMO=OFF",
                f"-DCMAKE_C_COMPILER={CC}", f"-DCMAKE_INSTALL_PREFIX={folder / 'prefix'}",
                f"-DCMAKE_INSTALL_LIBDIR={library}", f"-DCMAKE_INSTALL_INCLUDEDIR={headers}")
            text = (folder / "build/engine/thud.pc").read_text(encoding="utf-8")
            self.assertIn(f"prefix={folder / 'prefix'}\n", text)
            self.assertIn(f"\nCflags: -I{says[1]} \n", text)
            self.assertIn(f"\nLibs: -L{says[0]} -lthud -lm\n", text)

    def test_shared_library_is_configured_where_it_is_asked_for(self):
        folder = self.made("shared")
        run("cmake", "-G", "Unix Makefiles", "-B", folder, "-S", SOURCE, "-DBUILD_SHARED_LIBS=ON",
            "-DTHUD_DEMO=OFF", f"-DCMAKE_C_COMPILER={CC}")
        link = (folder / "engine/CMakeFiles/thud.dir/link.txt").read_text()
        self.assertRegex(link, r"-shared .*libthud\.so")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
