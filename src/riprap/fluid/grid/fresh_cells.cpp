// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/fresh_cells.hpp"

#include <algorithm>
#include <utility>

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

}  // namespace

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
