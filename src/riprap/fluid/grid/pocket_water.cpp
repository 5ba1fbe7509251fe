// SPDX-License-Identifier: Apache-2.0
// Water that pockets hold, and what they cannot.
#include <algorithm>
#include <cmath>
#include <utility>

#include "riprap/fluid/grid/pockets.hpp"
#include "riprap/fluid/grid/surface.hpp"

namespace riprap::fluid::grid {

double room_of(const Pocket& pocket, const GridScratch& s) {
    double room = 0;
    for (const std::int64_t c : pocket.cells) {
        room += s.room.capacity[at(c)];
    }
    return room;
}

namespace {

/// What is missing from a pocket's water by less than this of it is round-off [-].
constexpr double round_off = 1e-13;

double water_now(const Pocket& pocket, const GridState& state, const GridScratch& s) {
    double water = 0;
    for (const std::int64_t c : pocket.cells) {
        water += state.fraction[at(c)] * s.room.capacity[at(c)];
    }
    return water;
}

/// Gives `missing` to the cells of a pocket in proportion to weight(c) C, at most weight(c) to each.
template <class Weight>
void give(const Pocket& pocket, GridState& state, const GridScratch& s, double missing, const Weight& weight) {
    std::vector<double> share;
    share.reserve(pocket.cells.size());
    double room = 0;
    for (const std::int64_t c : pocket.cells) {
        share.push_back(weight(c));
        room += share.back() * s.room.capacity[at(c)];
    }
    if (!(room > 0)) {
        return;
    }
    const double part = std::clamp(missing / room, -1.0, 1.0);
    for (std::size_t i = 0; i < share.size(); ++i) {
        state.fraction[at(pocket.cells[i])] += part * share[i];
    }
}

/// Whether a face leads from a cell to one on the other side of the surface.
bool is_beside(const CellBox& box, const GridState& state, const GridScratch& s, std::int64_t c, bool to_wet) {
    for (int a = 0; a < box.axes; ++a) {
        const std::int64_t t = box.stride[at(a)];
        for (const auto& [beside, face] : {std::pair{c - t, c}, std::pair{c + t, c + t}}) {
            if (s.room.area[at(a)][at(face)] > 0 && s.room.capacity[at(beside)] > 0 &&
                (state.fraction[at(beside)] > 0.5) == to_wet) {
                return true;
            }
        }
    }
    return false;
}

/// Water that came in through sides of the domain in the step [m^3].
double came_in(const CellBox& box, const GridScratch& s, const Pocket& pocket) {
    double water = 0;
    for (const std::int64_t c : pocket.cells) {
        for (int a = 0; a < box.axes; ++a) {
            const std::int64_t t = box.stride[at(a)];
            water += box.has_cell(c - t) ? 0 : s.moved.water_flux[at(a)][at(c)];
            water -= box.has_cell(c + t) ? 0 : s.moved.water_flux[at(a)][at(c + t)];
        }
    }
    return water;
}

void settle_pocket(const CellBox& box, GridState& state, const GridScratch& s, const Pocket& pocket, double held) {
    const auto missing = [&] { return held - water_now(pocket, state, s); };
    const auto mixed = [&](std::int64_t c) {
        const double f = state.fraction[at(c)];
        return std::max(0.0, f * (1 - f));
    };
    for (const std::int64_t c : pocket.cells) {  // over-full ones are made anew
        state.fraction[at(c)] = std::min(1.0, state.fraction[at(c)]);
    }
    give(pocket, state, s, missing(), mixed);
    give(pocket, state, s, missing(), mixed);  // what the first rounds off
    double rest = missing();
    if (std::abs(rest) > round_off * held) {
        const bool takes = rest > 0;
        give(pocket, state, s, rest, [&](std::int64_t c) {
            const double f = state.fraction[at(c)];
            return is_beside(box, state, s, c, takes) ? (takes ? 1 - f : f) : 0;
        });
        rest = missing();
    }
    if (rest > round_off * held) {  // all air there is
        give(pocket, state, s, rest, [&](std::int64_t c) { return 1 - state.fraction[at(c)]; });
        rest = missing();
    }
    if (rest > round_off * held) {
        give(pocket, state, s, rest, [](std::int64_t) { return most_overfull; });
    }
    if (rest < -round_off * held) {
        give(pocket, state, s, rest, [&](std::int64_t c) { return state.fraction[at(c)]; });
    }
}

/// Returns what a pocket shall hold of the water that it held: a full one becomes hollow by most_hollow at most.
double water_to_hold(const Pocket& pocket, const GridScratch& s, double held) {
    double before = 0;
    for (const std::int64_t c : pocket.cells) {
        before += s.room.before()[at(c)];
    }
    const double least = 1 - most_hollow;
    return held < (1 - round_off) * least * before ? held : std::max(held, least * room_of(pocket, s));
}

}  // namespace

std::vector<double> water_of_pockets(const GridSettings& settings, const GridState& state, const GridScratch& s) {
    const CellBox& box = settings.mesh.box;
    const std::vector<double>& before = s.room.before();
    std::vector<double> held(s.pockets.size());
    std::vector<std::int64_t> counted;  // cells that solids have filled
    for (std::size_t p = 0; p < s.pockets.size(); ++p) {
        std::vector<std::int64_t> filled;
        for (const std::int64_t c : s.pockets[p].cells) {
            held[p] += state.fraction[at(c)] * before[at(c)];
            for (int a = 0; a < box.axes; ++a) {
                for (const std::int64_t beside : {c - box.stride[at(a)], c + box.stride[at(a)]}) {
                    if (s.room.capacity[at(beside)] == 0 && before[at(beside)] > 0 && box.has_cell(beside)) {
                        filled.push_back(beside);
                    }
                }
            }
        }
        std::sort(filled.begin(), filled.end());
        filled.erase(std::unique(filled.begin(), filled.end()), filled.end());
        std::erase_if(filled, [&](std::int64_t c) { return std::binary_search(counted.begin(), counted.end(), c); });
        for (const std::int64_t c : filled) {
            held[p] += state.fraction[at(c)] * before[at(c)];
        }
        counted.insert(counted.end(), filled.begin(), filled.end());
        std::sort(counted.begin(), counted.end());
    }
    return held;
}

void settle_pockets(const GridSettings& settings, GridState& state, const GridScratch& s,
                    const std::vector<double>& held) {
    for (std::size_t p = 0; p < held.size(); ++p) {
        const double water = held[p] + came_in(settings.mesh.box, s, s.pockets[p]);
        settle_pocket(settings.mesh.box, state, s, s.pockets[p], water_to_hold(s.pockets[p], s, water));
    }
}

double mean_fraction(const GridState& state, const GridScratch& s, const Pocket& pocket) {
    return water_now(pocket, state, s) / room_of(pocket, s);
}

}  // namespace riprap::fluid::grid
