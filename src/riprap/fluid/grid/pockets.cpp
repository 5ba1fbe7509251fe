// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/pockets.hpp"

#include <algorithm>

#include "riprap/fluid/grid/datum.hpp"
#include "riprap/fluid/grid/momentum.hpp"

namespace riprap::fluid::grid {

namespace {

/// Cells around a pocket, along each axis, that its pressure is taken from.
constexpr int reach = 2;

bool has_open_side(const GridSettings& settings) {
    return std::any_of(settings.side.begin(), settings.side.end(),
                       [](const Side& side) { return side.kind == SideKind::open; });
}

/// Groups of open cells joined by open faces.
struct Groups {
    std::vector<std::int32_t> of_cell;  ///< -1: closed or a ghost
    std::vector<std::vector<std::int64_t>> cells;
    std::vector<std::uint8_t> is_open;  ///< leads to a side with a given pressure
};

Groups find_groups(const GridSettings& settings, const GridScratch& s) {
    const CellBox& box = settings.mesh.box;
    Groups groups;
    groups.of_cell.assign(at(box.size), -1);
    const auto join = [&](std::int64_t start, std::int32_t number) {
        std::vector<std::int64_t>& cells = groups.cells.emplace_back(1, start);
        groups.is_open.push_back(0);
        groups.of_cell[at(start)] = number;
        for (std::size_t next = 0; next < cells.size(); ++next) {
            const std::int64_t c = cells[next];
            const std::array<int, 3> place = place_of(box, c);
            for (int side = 0; side < 2 * box.axes; ++side) {
                const int a = side / 2;
                const bool is_high = side % 2 == 1;
                const std::int64_t t = box.stride[at(a)], face = is_high ? c + t : c, beyond = is_high ? c + t : c - t;
                if (!(s.room.area[at(a)][at(face)] > 0)) {
                    continue;
                }
                if (place[at(a)] == (is_high ? box.cells[at(a)] - 1 : 0)) {
                    if (settings.side[at(side)].kind == SideKind::open) {
                        groups.is_open.back() = 1;
                    }
                } else if (groups.of_cell[at(beyond)] < 0 && s.room.capacity[at(beyond)] > 0) {
                    groups.of_cell[at(beyond)] = number;
                    cells.push_back(beyond);
                }
            }
        }
    };
    for (int k = 0; k < box.cells[2]; ++k) {
        for (int j = 0; j < box.cells[1]; ++j) {
            for (int i = 0; i < box.cells[0]; ++i) {
                const std::int64_t c = box.index(i, j, k);
                if (s.room.capacity[at(c)] > 0 && groups.of_cell[at(c)] < 0) {
                    join(c, static_cast<std::int32_t>(groups.cells.size()));
                }
            }
        }
    }
    return groups;
}

/// Cells of the water outside in a box of `reach` cells around a pocket.
std::vector<std::int64_t> cells_around(const CellBox& box, const std::vector<std::int64_t>& cells,
                                       const std::vector<std::uint8_t>& is_outside, const Groups& groups) {
    std::array<int, 3> first = place_of(box, cells.front()), last = first;
    for (const std::int64_t c : cells) {
        const std::array<int, 3> place = place_of(box, c);
        for (std::size_t a = 0; a < 3; ++a) {
            first[a] = std::min(first[a], place[a]);
            last[a] = std::max(last[a], place[a]);
        }
    }
    std::vector<std::int64_t> around;
    for (int k = std::max(0, first[2] - reach); k <= std::min(box.cells[2] - 1, last[2] + reach); ++k) {
        for (int j = std::max(0, first[1] - reach); j <= std::min(box.cells[1] - 1, last[1] + reach); ++j) {
            for (int i = std::max(0, first[0] - reach); i <= std::min(box.cells[0] - 1, last[0] + reach); ++i) {
                const std::int64_t c = box.index(i, j, k);
                const std::int32_t group = groups.of_cell[at(c)];
                if (group >= 0 && is_outside[at(group)] != 0) {
                    around.push_back(c);
                }
            }
        }
    }
    return around;
}

}  // namespace

std::array<int, 3> place_of(const CellBox& box, std::int64_t cell) {
    std::array<int, 3> place{};
    for (int a = 2; a >= 0; --a) {
        place[at(a)] = static_cast<int>(cell / box.stride[at(a)]) - box.pad[at(a)];
        cell %= box.stride[at(a)];
    }
    return place;
}

std::vector<Pocket> find_pockets(const GridSettings& settings, const GridScratch& s) {
    Groups groups = find_groups(settings, s);
    if (groups.cells.size() < 2) {
        return {};
    }
    std::vector<std::uint8_t> is_outside = groups.is_open;
    if (!has_open_side(settings)) {
        const auto largest = std::max_element(groups.cells.begin(), groups.cells.end(),
                                              [](const auto& a, const auto& b) { return a.size() < b.size(); });
        is_outside[at(largest - groups.cells.begin())] = 1;
    }
    std::vector<Pocket> pockets;
    for (std::size_t g = 0; g < groups.cells.size(); ++g) {
        if (is_outside[g] == 0) {
            std::vector<std::int64_t> around = cells_around(settings.mesh.box, groups.cells[g], is_outside, groups);
            pockets.push_back({std::move(groups.cells[g]), std::move(around)});
        }
    }
    return pockets;
}

void balance_pockets(const std::vector<Pocket>& pockets, GridScratch& s) {
    for (const Pocket& pocket : pockets) {
        double sum = 0, volume = 0;
        for (const std::int64_t c : pocket.cells) {
            sum += s.projection.right()[at(c)];
            volume += s.room.capacity[at(c)];
        }
        for (const std::int64_t c : pocket.cells) {
            s.projection.right()[at(c)] -= sum / volume * s.room.capacity[at(c)];
        }
    }
}

void level_pockets(const GridSettings& settings, GridState& state, const GridScratch& s,
                   const std::vector<Pocket>& pockets, double time) {
    const Mesh& mesh = settings.mesh;
    const Vec3 g = body_force(settings, time), datum = datum_of(mesh);
    const auto density = [&](std::int64_t c) { return density_of(settings, state.fraction[at(c)]); };
    for (const Pocket& pocket : pockets) {
        double volume = 0, level = 0, mass = 0, weight = 0;
        for (const std::int64_t c : pocket.cells) {
            const std::array<int, 3> place = place_of(mesh.box, c);
            volume += s.room.capacity[at(c)];
            mass += s.room.capacity[at(c)] * density(c);
            level += s.room.capacity[at(c)] * state.pressure[at(c)];
            weight += settings.has_surface ? s.room.capacity[at(c)] * density(c) *
                                                 dot(g, mesh.centre(place[0], place[1], place[2]) - datum)
                                           : 0;
        }
        double outside = 0, room = 0;
        for (const std::int64_t c : pocket.around) {  // p of the water there, less the weight of what the pocket holds
            const std::array<int, 3> place = place_of(mesh.box, c);
            const double potential =
                settings.has_surface ? dot(g, mesh.centre(place[0], place[1], place[2]) - datum) : 0;
            outside += s.room.capacity[at(c)] * (state.pressure[at(c)] + (density(c) - mass / volume) * potential);
            room += s.room.capacity[at(c)];
        }
        const double shift = (room > 0 ? outside / room : -weight / volume) - level / volume;
        for (const std::int64_t c : pocket.cells) {
            state.pressure[at(c)] += shift;
        }
    }
}

}  // namespace riprap::fluid::grid
