"""A recipe for Conan 2, of the sources that it lies in: conan create tools/packaging/conan"""
import os
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load

ROOT = os.path.join("..", "..", "..")


class Marrow(ConanFile):
    name = "marrow"
    description = "Compact skeletal animation for mobile games"
    license = "MIT"
    package_type = "library"
    settings = "os", "compiler", "build_type", "arch"
    options = {"shared": [True, False], "draco": [True, False], "meshopt": [True, False], "gles3": [True, False]}
    default_options = {"shared": False, "draco": False, "meshopt": False, "gles3": False}

    def set_version(self):
        header = load(self, os.path.join(self.recipe_folder, ROOT, "runtime", "include", "marrow", "version.h"))
        self.version = ".".join(re.findall(r"#define MARROW_VERSION_\w+ (\d+)", header))

    def export_sources(self):
        source = os.path.join(self.recipe_folder, ROOT)
        for pattern in ("CMakeLists.txt", "LICENSE", "CHANGELOG.md", "THIRD_PARTY.md", "cmake/*", "runtime/*", "platform/*", "shaders/*"):
            copy(self, pattern, source, self.export_sources_folder)

    def requirements(self):
        if self.options.draco:
            self.requires("draco/[>=1.5]")
        if self.options.draco or self.options.meshopt:
            self.requires("meshoptimizer/[>=0.18]")
        if self.options.gles3:
            self.requires("egl/system")

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        for name in ("draco", "meshopt"):
            toolchain.cache_variables["MARROW_" + name.upper()] = bool(self.options.get_safe(name))
        toolchain.cache_variables["MARROW_GLES"] = bool(self.options.gles3)
        for name in ("TOOLS", "TESTS", "WERROR"):
            toolchain.cache_variables["MARROW_" + name] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        libraries = {"runtime": [], "unpack": ["runtime"]}
        if self.options.draco:
            libraries["draco"] = ["unpack", "draco::draco", "meshoptimizer::meshoptimizer"]
        if self.options.meshopt:
            libraries["meshopt"] = ["unpack", "meshoptimizer::meshoptimizer"]
        if self.options.gles3:
            libraries["gles3"] = ["runtime"]
            libraries["egl"] = ["runtime", "egl::egl"]
        for name, needs in libraries.items():
            component = self.cpp_info.components[name]
            component.libs = ["marrow_" + name]
            component.requires = needs
            component.set_property("cmake_target_name", "marrow::" + name)
            component.set_property("pkg_config_name", "marrow" if name == "runtime" else "marrow-" + name)
