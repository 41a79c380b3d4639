"""The recipe of thud for Conan 2. In a copy of the repository or of its source archive:

    conan create packaging/conan

needs no network. A program then requires thud/0.2.0, and links thud::thud or thud::threads."""

import re
from pathlib import Path

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, rmdir


class ThudConan(ConanFile):
    name = "thud"
    description = "Rigid bodies in two dimensions, for games"
    license = "MIT"
    topics = ("physics", "2d", "games", "deterministic")
    package_type = "library"
    settings = "os", "compiler", "build_type", "arch"
    options = {"shared": [True, False]}
    default_options = {"shared": False}

    def set_version(self):
        header = Path(self.recipe_folder, "../../engine/include/thud/thud_version.h").read_text(encoding="utf-8")
        self.version = ".".join(re.findall(r"^#define THUD_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", header, re.MULTILINE))

    def configure(self):
        # The engine is C.
        self.settings.rm_safe("compiler.libcxx")
        self.settings.rm_safe("compiler.cppstd")

    def export_sources(self):
        root = Path(self.recipe_folder, "../..")
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "engine/*"):
            copy(self, pattern, root, self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        for option in ("THUD_DEMO", "THUD_TESTS"):
            toolchain.cache_variables[option] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, Path(self.package_folder, "licenses"))
        # Conan writes its own of what finds the library.
        for folder in ("lib/cmake", "lib/pkgconfig", "share"):
            rmdir(self, Path(self.package_folder, folder))

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "thud")
        library = self.cpp_info.components["thud"]
        library.set_property("cmake_target_name", "thud::thud")
        library.set_property("pkg_config_name", "thud")
        library.libs = ["thud"]
        library.defines = ["THUD_SHARED"] if self.options.shared else []
        threads = self.cpp_info.components["threads"]
        threads.set_property("cmake_target_name", "thud::threads")
        threads.set_property("pkg_config_name", "thud-threads")
        threads.requires = ["thud"]
        if self.settings.os in ("Linux", "FreeBSD"):
            library.system_libs = ["m"]
            threads.system_libs = ["pthread"]
