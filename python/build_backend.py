# SPDX-License-Identifier: Apache-2.0
"""What `pip install .` calls (PEP 517): builds the module with CMake in build/pip and packs it into a wheel. Needs
nothing but CMake, the compiler and the Debian packages of Riprap, so that an install needs no network.
"""
import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "pip"


def project():
    """Name, version, summary and Python asked for, from the one place that has them."""
    import tomllib  # Python 3.11, that of Debian 12

    return tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]


def version():
    return re.search(r"project\(riprap VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


def metadata():
    about = project()
    lines = ["Metadata-Version: 2.1", f"Name: {about['name']}", f"Version: {version()}",
             f"Summary: {about['description']}", "License: Apache-2.0", f"Requires-Python: {about['requires-python']}"]
    return "\n".join(lines + [f"Requires-Dist: {one}" for one in about["dependencies"]]) + "\n"


def compile_module():
    """Configures and builds what the package consists of; returns its folder."""
    if "RIPRAP_BUILD" in os.environ:  # scripts/package has built it
        return pathlib.Path(os.environ["RIPRAP_BUILD"]).resolve() / "python" / "riprap"
    configure = ["cmake", "-S", ROOT, "-B", BUILD, "-DCMAKE_BUILD_TYPE=Release", "-DRIPRAP_TESTS=OFF",
                 "-DRIPRAP_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}"]
    subprocess.run(configure, check=True)
    subprocess.run(["cmake", "--build", BUILD, "--target", "riprap_python", "--parallel", str(os.cpu_count())],
                   check=True)
    return BUILD / "python" / "riprap"


def examples():
    """The cases of cases/ with every file that they read."""
    return sorted(file for file in (ROOT / "cases").rglob("*") if file.is_file())


def tag():
    """Of the interpreter that runs this and of this machine: cp311-cp311-linux_x86_64."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def information():
    """Files of the .dist-info folder, without the record of what is in the wheel."""
    return {
        "METADATA": metadata().encode(),
        "LICENSE": (ROOT / "LICENSE").read_bytes(),
        "WHEEL": f"Wheel-Version: 1.0\nGenerator: riprap\nRoot-Is-Purelib: false\nTag: {tag()}\n".encode(),
    }


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    folder = pathlib.Path(metadata_directory, f"riprap-{version()}.dist-info")
    folder.mkdir()
    for name, data in information().items():
        (folder / name).write_bytes(data)
    return folder.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    package = compile_module()
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    files = sorted(file for file in package.iterdir() if file.suffix in (".py", ".pyi") or file.name == "py.typed" or file.name.endswith(suffix))
    info = f"riprap-{version()}.dist-info"
    contents = {f"riprap/{file.name}": file.read_bytes() for file in files}
    contents |= {f"riprap/{file.relative_to(ROOT).as_posix()}": file.read_bytes() for file in examples()}
    contents |= {f"{info}/{name}": data for name, data in information().items()}
    record = ""
    for name, data in contents.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode().rstrip("=")
        record += f"{name},sha256={digest},{len(data)}\n"
    contents[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    wheel = f"riprap-{version()}-{tag()}.whl"
    with zipfile.ZipFile(os.path.join(wheel_directory, wheel), "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in contents.items():
            archive.writestr(name, data)
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    raise NotImplementedError("riprap is installed from its source tree: pip install .")


if __name__ == "__main__":  # python3 python/build_backend.py FOLDER
    print(os.path.join(sys.argv[1], build_wheel(sys.argv[1])))
