# SPDX-License-Identifier: Apache-2.0
"""What the tests of the Python package step, and the command line that they compare it with."""
import os

import riprap

PROGRAM = os.environ["RIPRAP_PROGRAM"]

BLOCK = {
    "title": "A block falls onto the ground",
    "gravity": [0.0, 0.0, -9.81],
    "end": 0.3,
    "time_step": 1e-4,
    "material": {"rock": {"density": 2500.0, "normal_stiffness": "10 MPa", "friction_coefficient": 0.5}},
    "body": [
        {"name": "ground", "shape": {"half_space": {"normal": [0, 0, 1]}}, "material": "rock", "fixed": True},
        {"name": "block", "shape": {"cube": 1.0}, "position": [0, 0, 0.6], "material": "rock"},
    ],
    "solid": {"local_damping": 0.3},
}

POOL = """
title = "A box floats in a planar tank"
dimension = 2
gravity = [0.0, -9.81, 0.0]
end = 0.05
[material.wood]
density = 500.0
normal_stiffness = "1 MPa"
[fluid]
spacing = 0.05
domain = { low = [-0.2, -0.2, 0.0], high = [1.2, 1.5, 0.0] }
[[fluid.region]]
box = { low = [0.0, 0.0, 0.0], high = [1.0, 0.5, 0.0] }
[[body]]
name = "floor"
shape = { half_space = { normal = [0.0, 1.0, 0.0] } }
material = "wood"
fixed = true
[[body]]
name = "left"
shape = { half_space = { normal = [1.0, 0.0, 0.0] } }
material = "wood"
fixed = true
[[body]]
name = "right"
shape = { half_space = { normal = [-1.0, 0.0, 0.0], offset = -1.0 } }
material = "wood"
fixed = true
"""


def falling_block(**keys):
    return riprap.build({**BLOCK, **keys})
