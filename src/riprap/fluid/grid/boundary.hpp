// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"
#include "riprap/fluid/grid/state.hpp"

namespace riprap::fluid::grid {

inline constexpr int low_side(int axis) { return 2 * axis; }
inline constexpr int high_side(int axis) { return 2 * axis + 1; }
inline bool is_wall(SideKind kind) {
    return kind == SideKind::slip || kind == SideKind::no_slip || kind == SideKind::wall_function;
}

/// Calls f(ghost, inside, layer, i, j, k) for the two layers of ghosts beyond a side: `inside` is the cell that the
/// ghost mirrors, (i, j, k) the ghost's place along the two other axes and beyond the side.
template <class F>
void for_ghosts(const CellBox& box, int side, const F& f) {
    const int a = side / 2;
    const bool is_high = side % 2 == 1;
    const int n = box.cells[at(a)];
    std::array<int, 3> first{}, last = box.cells;
    for (int t = 0; t < a; ++t) {  // earlier axes have their ghosts already: corners come out filled
        first[at(t)] = -box.pad[at(t)];
        last[at(t)] += box.pad[at(t)];
    }
    for (int layer = 0; layer < Mesh::ghosts; ++layer) {
        const int ghost = is_high ? n + layer : -1 - layer,
                  inside = is_high ? std::max(n - 1 - layer, 0) : std::min(layer, n - 1);
        first[at(a)] = ghost;
        last[at(a)] = ghost + 1;
        const std::int64_t step = (inside - ghost) * box.stride[at(a)];
        for (int k = first[2]; k < last[2]; ++k) {
            for (int j = first[1]; j < last[1]; ++j) {
                for (int i = first[0]; i < last[0]; ++i) {
                    const std::int64_t index = box.index(i, j, k);
                    f(index, index + step, layer, i, j, k);
                }
            }
        }
    }
}

inline constexpr double von_karman = 0.41;  ///< kappa of the log law [-]

/// Shear velocity u_tau of the log law u/u_tau = ln(E u_tau y/nu)/kappa for a speed u at the distance y from a wall,
/// linear profile below y+ = 11.53 [Launder1974].
double shear_velocity(double speed, double distance, double viscosity);

/// Mirrors a cell field into the ghosts: its gradient across every side is zero.
void mirror_ghosts(const Mesh& mesh, std::vector<double>& field);

/// Fills the ghosts of the water fraction: mirrored at walls, given at openings where something comes in.
void fill_fraction_ghosts(const GridSettings& settings, const std::array<std::vector<double>, 3>& velocity, double time,
                          std::vector<double>& fraction);

/// Sets the velocity on the sides and in the ghosts beyond: zero through walls, given on inflow sides, mirrored or
/// reversed along walls by whether they slip, without gradient on open sides, whose normal velocity the pressure sets.
/// @param fraction  of water, whose level beside a side an absorber compares [-]
void fill_velocity_ghosts(const GridSettings& settings, double time, const std::vector<double>& fraction,
                          std::array<std::vector<double>, 3>& velocity);

}  // namespace riprap::fluid::grid
