"""Builds the libraries of the checkout that this file lies in: conan create scripts/packaging/conan --build=missing"""
import os
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load


class Throng(ConanFile):
    name = "throng"
    description = "Crowds of skinned characters, each in a pose of its own"
    license = "MIT"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False]}
    default_options = {"shared": False}

    def _checkout(self):
        return os.path.join(self.recipe_folder, "..", "..", "..")

    def set_version(self):
        header = load(self, os.path.join(self._checkout(), "engine/anim/include/throng/version.h"))
        self.version = ".".join(re.findall(r"#define THRONG_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", header))

    def export_sources(self):
        for part in ("CMakeLists.txt", "LICENSE", "engine/*", "shaders/palette/packed_palette.glsl"):
            copy(self, part, self._checkout(), self.export_sources_folder)

    def requirements(self):
        for part in ("glm/1.0.1", "highway/1.2.0", "tinygltf/2.9.0", "meshoptimizer/0.20", "draco/1.5.6",
                     "nlohmann_json/3.11.3", "libwebp/1.3.2", "xxhash/0.8.2"):
            self.requires(part)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.variables.update({"THRONG_DEMO": False, "THRONG_INSTALL": True, "THRONG_WARNINGS": False,
                                    "BUILD_SHARED_LIBS": bool(self.options.shared)})
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        self.cpp_info.set_property("cmake_find_mode", "none")  # the package's own throngConfig.cmake is found
        self.cpp_info.builddirs = ["lib/cmake/throng"]
