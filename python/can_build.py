# SPDX-License-Identifier: Apache-2.0
"""Says whether the Python that runs this can build and use the package: exit code 0, or 1 and what is missing.

With --build: whether it can build it. pip builds in an environment of its own, where NumPy is not seen.
"""
import os
import sys
import sysconfig

if sys.version_info < (3, 9):
    sys.exit(f"{sys.executable} is older than 3.9")
if "--build" not in sys.argv:
    try:
        import numpy  # noqa: F401
    except ImportError:
        sys.exit(f"{sys.executable} has no NumPy (Debian: python3-numpy)")
if not os.path.exists(os.path.join(sysconfig.get_path("include"), "Python.h")):
    sys.exit(f"{sys.executable} has no headers (Debian: python3-dev)")
