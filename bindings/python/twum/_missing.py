# SPDX-License-Identifier: Apache-2.0
"""What an import of twum says where the compiled part is not built."""
import pathlib


def how_to_build() -> str:
    folder = pathlib.Path(__file__).resolve().parent
    build = folder.parents[1]
    if (build / "CMakeCache.txt").is_file():
        return f"{folder} has no compiled part yet; build it: cmake --build {build} --target twum_python"
    return (f"{folder} has no compiled part; in the root of the sources run cmake --preset release && "
            "cmake --build --preset release --target twum_python, and set PYTHONPATH to build/release/python")
