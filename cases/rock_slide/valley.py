#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes valley.asc, the ground of this case, from a formula: python3 valley.py > valley.asc

A valley along y, slopes of 35 degrees in the west and 28 degrees in the east, rounded at the toes of both, with
hummocks 0.4 m high but for the smooth plane in the west that the rock slides on.
"""
import math

WEST, EAST = math.tan(math.radians(35)), math.tan(math.radians(28))  # slopes [-]
HALF_BED, ROUNDING = 14.0, 1.5                                        # of the floor of the valley [m]
COLUMNS, ROWS, CELL = 64, 32, 2.0
X0, Y0 = -64.0, -26.0                                                 # of the first height [m]


def rise(distance):
    """Distance beyond the toe of a slope, rounded [m]."""
    return ROUNDING * math.log1p(math.exp(distance / ROUNDING))


def height(x, y):
    hummocks = 0.4 * math.sin(0.45 * x) * math.cos(0.38 * y)
    share = 1 / (1 + math.exp(-(x + 17) / 1.0))  # none on the western slope
    return WEST * rise(-x - HALF_BED) + EAST * rise(x - HALF_BED) + share * hummocks


print(f"ncols {COLUMNS}\nnrows {ROWS}\nxllcenter {X0}\nyllcenter {Y0}\ncellsize {CELL}\nNODATA_value -9999")
for row in reversed(range(ROWS)):
    print(" ".join(f"{height(X0 + CELL * i, Y0 + CELL * row):.4f}" for i in range(COLUMNS)))
