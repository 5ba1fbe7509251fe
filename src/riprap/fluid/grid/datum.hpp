// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/fluid/grid/mesh.hpp"

namespace riprap::fluid::grid {

/// Place that heights of weights in P = p - rho g.(x - datum) and of potential energy count from [m]: the origin, or
/// the low corner along axes on which the mesh is more than a hundred of its lengths away from it (that far costs two
/// digits of sixteen). At map coordinates rho g.x is 1e8 times the pressure of shallow water, and round-off of it moves
/// water.
inline Vec3 datum_of(const Mesh& mesh) {
    constexpr double most_lengths = 100;
    Vec3 datum{};
    for (int a = 0; a < 3; ++a) {
        const double low = mesh.edge[at(a)].front(), high = mesh.edge[at(a)].back();
        datum[a] = std::max(std::abs(low), std::abs(high)) > most_lengths * (high - low) ? low : 0;
    }
    return datum;
}

/// Share of a cell below which a place differs from a side of the cell by round-off alone: 1e-9, and at map coordinates
/// what four last digits of these are [-]. Slivers as thin as that led water along under bodies.
inline double share_of_round_off(const Mesh& mesh) {
    constexpr double least = 1e-9, digits = 4;
    double farthest = 0;
    for (int a = 0; a < mesh.box.axes; ++a) {
        farthest = std::max({farthest, std::abs(mesh.edge[at(a)].front()), std::abs(mesh.edge[at(a)].back())});
    }
    return std::max(least, digits * std::numeric_limits<double>::epsilon() * farthest / mesh.smallest_width());
}

}  // namespace riprap::fluid::grid
