"""Puts the shared libraries and the weights of this repository's build into the wheel."""
import os
import shutil

from setuptools import setup
from setuptools.command.build_py import build_py
from setuptools.dist import Distribution
from wheel.bdist_wheel import bdist_wheel

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
LIBRARIES = ("libdragmesh.so", "libdragmesh_gltf.so")
MODELS = ("kpp_net.safetensors", "dq_vae.safetensors", "ranker.safetensors")


class BuildWithLibraries(build_py):
    """Copies what is no Python. The environment variable DRAGMESH_LIBRARY_PATH names the folder of the libraries."""

    def run(self):
        super().run()
        package = os.path.join(self.build_lib, "dragmesh")
        folder = os.environ.get("DRAGMESH_LIBRARY_PATH", os.path.join(ROOT, "build", "release"))
        os.makedirs(os.path.join(package, "models"), exist_ok=True)
        for name in LIBRARIES:
            shutil.copy(os.path.join(folder, name), package)  # the file that a link leads to
        for name in MODELS:
            shutil.copy(os.path.join(ROOT, "sdk", "models", name), os.path.join(package, "models"))
        shutil.copy(os.path.join(ROOT, "LICENSE"), package)
        lab = os.path.join(package, "lab.py")  # calls a library of training, which the wheel has not
        if os.path.exists(lab):
            os.remove(lab)


class PlatformWheel(bdist_wheel):
    """For any Python 3 of one platform: nothing is compiled against Python. DRAGMESH_WHEEL_PLATFORM: its tag, where it
    is not that of this machine."""

    def get_tag(self):
        return ("py3", "none", os.environ.get("DRAGMESH_WHEEL_PLATFORM", super().get_tag()[2]))


class WithLibraries(Distribution):
    """Its wheel is of one platform."""

    def has_ext_modules(self):
        return True


setup(cmdclass={"build_py": BuildWithLibraries, "bdist_wheel": PlatformWheel}, distclass=WithLibraries)
