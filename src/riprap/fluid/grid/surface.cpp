// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/surface.hpp"

#include <cmath>
#include <utility>

#include "riprap/fluid/grid/pockets.hpp"

namespace riprap::fluid::grid {

namespace {

using Normal = std::array<double, 3>;

double sum_of_sizes(const Normal& m) { return std::abs(m[0]) + std::abs(m[1]) + std::abs(m[2]); }
Normal scaled(const Normal& m) {
    const double sum = sum_of_sizes(m);
    return sum > 0 ? Normal{m[0] / sum, m[1] / sum, m[2] / sum} : m;
}
double largest(const Normal& m) { return std::max({std::abs(m[0]), std::abs(m[1]), std::abs(m[2])}); }

/// Sum of the three fractions of a column through the cell.
double column(const std::vector<double>& f, std::int64_t c, std::int64_t s) {
    return f[at(c - s)] + f[at(c)] + f[at(c + s)];
}

/// - grad of the fraction over the 3 x 3 (x 3) cells around, weights 1 2 1.
Normal youngs(const CellBox& box, const std::vector<double>& f, std::int64_t c) {
    Normal m{};
    for (int a = 0; a < box.axes; ++a) {
        const std::int64_t s = box.stride[at(a)];
        double sum = 0;
        const int b1 = (a + 1) % 3, b2 = (a + 2) % 3;
        const int r1 = b1 < box.axes ? 1 : 0, r2 = b2 < box.axes ? 1 : 0;
        for (int q = -r2; q <= r2; ++q) {
            for (int p = -r1; p <= r1; ++p) {
                const double weight = (p == 0 ? 2 : 1) * (q == 0 ? 2 : 1);
                const std::int64_t i = c + p * box.stride[at(b1)] + q * box.stride[at(b2)];
                sum += weight * (f[at(i - s)] - f[at(i + s)]);
            }
        }
        m[at(a)] = sum;
    }
    return scaled(m);
}

}  // namespace

Normal surface_normal(const CellBox& box, const std::vector<double>& f, std::int64_t c) {
    const Normal by_youngs = youngs(box, f, c);
    Normal best{};
    for (int a = 0; a < box.axes; ++a) {
        const std::int64_t s = box.stride[at(a)];
        Normal m{};
        const double rise =
            column(f, c - s, box.stride[at((a + 1) % box.axes)]) - column(f, c + s, box.stride[at((a + 1) % box.axes)]);
        m[at(a)] = rise > 0 || (rise == 0 && by_youngs[at(a)] > 0) ? 1 : -1;
        for (int b = 0; b < box.axes; ++b) {
            if (b != a) {
                const std::int64_t t = box.stride[at(b)];
                m[at(b)] = 0.5 * (column(f, c - t, s) - column(f, c + t, s));
            }
        }
        m = scaled(m);
        if (std::abs(m[at(a)]) > largest(best) || a == 0) {
            best = m;
        }
    }
    return largest(best) > largest(by_youngs) && sum_of_sizes(by_youngs) > 0 ? by_youngs : best;
}

void reconstruct_surface(const Mesh& mesh, const std::vector<double>& fraction, CellPlanes& planes) {
    const CellBox& box = mesh.box;
    std::array<int, 3> first{}, last = box.cells;
    for (int a = 0; a < box.axes; ++a) {
        first[at(a)] = -1;
        last[at(a)] += 1;
    }
    const std::int64_t rows_y = last[1] - first[1], rows = rows_y * (last[2] - first[2]);
    const auto for_mixed = [&](const auto& in_row) {  // in_row(row, first flat index, last)
        parallel::for_ranges(rows, box.row_grain(), [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t row = begin; row < end; ++row) {
                const std::int64_t start = box.index(first[0], first[1] + static_cast<int>(row % rows_y),
                                                     first[2] + static_cast<int>(row / rows_y));
                in_row(row, start, start + last[0] - first[0]);
            }
        });
    };
    planes.number.assign(at(box.size), -1);
    planes.row_begin.assign(at(rows) + 1, 0);
    for_mixed([&](std::int64_t row, std::int64_t begin, std::int64_t end) {
        std::int32_t count = 0;
        for (std::int64_t c = begin; c < end; ++c) {
            count += is_mixed(fraction[at(c)]) ? 1 : 0;
        }
        planes.row_begin[at(row) + 1] = count;
    });
    for (std::size_t row = 0; row < at(rows); ++row) {
        planes.row_begin[row + 1] += planes.row_begin[row];
    }
    planes.plane.resize(at(planes.row_begin.back()));
    for_mixed([&](std::int64_t row, std::int64_t begin, std::int64_t end) {
        std::int32_t next = planes.row_begin[at(row)];
        for (std::int64_t c = begin; next < planes.row_begin[at(row) + 1] && c < end; ++c) {
            if (is_mixed(fraction[at(c)])) {
                planes.plane[at(next)] = place_plane(surface_normal(box, fraction, c), fraction[at(c)]);
                planes.number[at(c)] = next++;
            }
        }
    });
}

double water_volume(const GridSettings& settings, const GridState& state, const GridScratch& scratch) {
    return sum_cells(settings.mesh.box, [&](std::int64_t c, int, int, int) {
        return state.fraction[at(c)] * scratch.room.capacity[at(c)];
    });
}

namespace {

/// Cells that the books of all water settle: pockets settle theirs.
class Outside {
 public:
    Outside(const CellBox& box, const std::vector<Pocket>& pockets) {
        is_in_pocket_.assign(pockets.empty() ? 0 : at(box.size), 0);
        for (const Pocket& pocket : pockets) {
            for (const std::int64_t c : pocket.cells) {
                is_in_pocket_[at(c)] = 1;
            }
        }
    }
    bool holds(std::int64_t c) const { return is_in_pocket_.empty() || is_in_pocket_[at(c)] == 0; }

 private:
    std::vector<std::uint8_t> is_in_pocket_;
};

/// Gives what is missing to cells on either side of a surface that lies on faces, where no cell is mixed: water to
/// cells beside wet ones, air to cells beside dry ones.
void settle_beside_surface(const GridSettings& settings, GridState& state, GridScratch& s, const Outside& outside,
                           double missing) {
    const CellBox& box = settings.mesh.box;
    auto& f = state.fraction;
    const bool takes = missing > 0;
    std::vector<double>& settling = s.stress.viscosity;  // [-]: how much a cell can take or give; found anew after it
    for_cells(box, [&](std::int64_t c, int, int, int) {
        bool is_beside = false;
        for (int a = 0; a < box.axes; ++a) {
            const std::int64_t t = box.stride[at(a)];
            for (const auto& [beside, face] : {std::pair{c - t, c}, std::pair{c + t, c + t}}) {
                is_beside = is_beside || (s.room.area[at(a)][at(face)] > 0 && s.room.capacity[at(beside)] > 0 &&
                                          (f[at(beside)] > 0.5) == takes);
            }
        }
        settling[at(c)] = is_beside && outside.holds(c) ? (takes ? 1 - f[at(c)] : f[at(c)]) : 0;
    });
    const double room =
        sum_cells(box, [&](std::int64_t c, int, int, int) { return settling[at(c)] * s.room.capacity[at(c)]; });
    if (room > 0) {
        const double share = std::clamp(missing / room, -1.0, 1.0);
        for_cells(box, [&](std::int64_t c, int, int, int) { f[at(c)] += share * settling[at(c)]; });
    }
}

}  // namespace

void settle_volume(const GridSettings& settings, GridState& state, GridScratch& scratch,
                   const std::vector<double>& in_pockets) {
    const CellBox& box = settings.mesh.box;
    const Outside outside(box, scratch.pockets);
    auto& f = state.fraction;
    for_cells(box, [&](std::int64_t c, int, int, int) {
        double& value = f[at(c)];
        value = value < least_fraction ? 0 : value > 1 - least_fraction ? 1 : value;
    });
    settle_pockets(settings, state, scratch, in_pockets);
    for (int pass = 0; pass < 2; ++pass) {  // the second takes what the first rounds off
        const double missing = state.water.held - water_volume(settings, state, scratch);
        const double room = sum_cells(box, [&](std::int64_t c, int, int, int) {
            return outside.holds(c) ? f[at(c)] * (1 - f[at(c)]) * scratch.room.capacity[at(c)] : 0;
        });
        if (!(room > 0)) {
            break;
        }
        const double share = std::clamp(missing / room, -1.0, 1.0);
        for_cells(box, [&](std::int64_t c, int, int, int) {
            f[at(c)] += outside.holds(c) ? share * f[at(c)] * (1 - f[at(c)]) : 0;
        });
    }
    constexpr double round_off = 1e-13;
    const double missing = state.water.held - water_volume(settings, state, scratch);
    if (std::abs(missing) > round_off * std::abs(state.water.held)) {
        settle_beside_surface(settings, state, scratch, outside, missing);
    }
}

}  // namespace riprap::fluid::grid
