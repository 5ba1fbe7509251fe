// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/fresh_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "riprap/fluid/grid/pockets.hpp"

namespace riprap::fluid::grid {

namespace {

struct Filled {
    std::int64_t cell;
    double fraction;
};

std::vector<std::int64_t> find_fresh_cells(const CellBox& box, const GridScratch& s) {
    std::vector<std::int64_t> fresh;
    for (std::int64_t row = 0; row < box.row_count(); ++row) {
        const std::int64_t start = box.row_start(row);
        for (std::int64_t c = start; c < start + box.cells[0]; ++c) {
            if (s.room.before()[at(c)] == 0 && s.room.capacity[at(c)] > 0) {
                fresh.push_back(c);
            }
        }
    }
    return fresh;
}

/// Along some axis a cell opens to the other side than before where its open areas on the two sides differ by more than
/// this share of a side, before and now [-].
constexpr double least_lean = 0.25;

bool has_turned(const Mesh& mesh, const GridScratch& s, const OpenShares& shares, std::int64_t c,
                const std::array<int, 3>& place) {
    for (int a = 0; a < mesh.box.axes; ++a) {
        const std::int64_t above = c + mesh.box.stride[at(a)];
        const double whole = mesh.face_area(a, place[0], place[1], place[2]);
        const double before = (s.room.area[at(a)][at(c)] - s.room.area[at(a)][at(above)]) / whole;
        const double now = shares.area[at(a)][at(c)] - shares.area[at(a)][at(above)];
        if (before * now < 0 && std::min(std::abs(before), std::abs(now)) > least_lean) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::vector<std::int64_t> find_turned_cells(const GridSettings& settings, const GridScratch& s,
                                            const OpenShares& shares) {
    const CellBox& box = settings.mesh.box;
    std::vector<std::int64_t> turned;
    for (std::int64_t row = 0; row < box.row_count(); ++row) {
        const std::int64_t start = box.row_start(row);
        for (std::int64_t c = start; c < start + box.cells[0]; ++c) {
            const double share = shares.volume[at(c)];
            if (share == 1 || share == 0 || s.room.capacity[at(c)] == 0) {
                continue;
            }
            if (has_turned(settings.mesh, s, shares, c, place_of(box, c))) {
                turned.push_back(c);
            }
        }
    }
    return turned;
}

void fill_fresh_cells(const GridSettings& settings, GridState& state, const GridScratch& s) {
    const CellBox& box = settings.mesh.box;
    std::vector<std::int64_t> unknown = find_fresh_cells(box, s);
    const auto is_unknown = [&](std::int64_t c) { return std::binary_search(unknown.begin(), unknown.end(), c); };
    while (!unknown.empty()) {
        std::vector<Filled> filled;
        std::vector<std::int64_t> rest;
        for (const std::int64_t c : unknown) {
            double water = 0, area = 0;
            for (int a = 0; a < box.axes; ++a) {
                const std::int64_t t = box.stride[at(a)];
                for (const auto& [face, beside] : {std::pair{c, c - t}, std::pair{c + t, c + t}}) {
                    if (s.room.capacity[at(beside)] > 0 && box.has_cell(beside) && !is_unknown(beside)) {
                        water += s.room.area[at(a)][at(face)] * state.fraction[at(beside)];
                        area += s.room.area[at(a)][at(face)];
                    }
                }
            }
            if (area > 0) {
                filled.push_back({c, water / area});
            } else {
                rest.push_back(c);
            }
        }
        if (filled.empty()) {
            return;  // shut off from all that holds fluid
        }
        for (const Filled& f : filled) {
            state.fraction[at(f.cell)] = f.fraction;
        }
        unknown = std::move(rest);
    }
}

}  // namespace riprap::fluid::grid
