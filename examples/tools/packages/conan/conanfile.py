# A recipe for Conan 2, which make dist fills in: conan create PATH/TO/dist/conan
import os

from conan import ConanFile
from conan.tools.files import copy, get


class Ssgi(ConanFile):
    name = "ssgi"
    version = "@VERSION@"
    description = "screen-space illumination: C99 headers that return the GLSL of every pass"
    license = "MIT OR Unlicense"
    package_type = "header-library"
    settings = "os"
    no_copy_source = True

    def source(self):
        get(self, "@URL@/ssgi-@VERSION@.tar.gz", sha256="@SHA256@", strip_root=True)

    def package(self):
        copy(self, "ssgi*.h", self.source_folder, os.path.join(self.package_folder, "include"))
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))

    def package_id(self):
        self.info.clear()

    def package_info(self):
        self.cpp_info.bindirs = self.cpp_info.libdirs = []
        if self.settings.os != "Windows":
            self.cpp_info.system_libs = ["m"]
