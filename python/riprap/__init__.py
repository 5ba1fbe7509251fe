# SPDX-License-Identifier: Apache-2.0
"""Riprap: discrete solid blocks in and under water.

    case = riprap.load("hello_block")
    simulation = riprap.Simulation(case)
    simulation.run()
    print(simulation.value("block.displacement.x"))

Everything is in SI. docs/howto/python.md shows what there is; help(riprap.Simulation) says it by name.
"""
import os as _os

from ._riprap import (
    _add_case_root,
    Bodies,
    Case,
    Fluid,
    Simulation,
    __version__,
    build,
    build_info,
    list,
    load,
    loads,
    run,
    set_threads,
    threads,
    waves,
)
from .errors import (
    CaseError,
    CheckpointError,
    Error,
    FileError,
    InternalError,
    NumericalError,
    Problem,
)
from .records import Frame, Run, Study, Table, ensemble, open, sweep  # noqa: A004

_add_case_root(_os.path.dirname(_os.path.abspath(__file__)))  # the examples that came with the package

# A child made by fork() has none of the threads that wait for loops: one is what it has, and what it says.
if hasattr(_os, "register_at_fork"):
    _os.register_at_fork(after_in_child=lambda: set_threads(1))

# Without `list` and `open`, which `from riprap import *` would put over Python's own.
__all__ = [
    "Bodies", "Case", "CaseError", "CheckpointError", "Error", "FileError", "Fluid", "Frame", "InternalError", "NumericalError",
    "Problem", "Run", "Simulation", "Study", "Table", "__version__", "build", "build_info", "ensemble", "load", "loads", "run",
    "set_threads", "sweep", "threads", "waves",
]
