// SPDX-License-Identifier: Apache-2.0
// The grid fluid: a dam break over an obstacle, water and air, about 100 000 cells.
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "riprap/bench/benches.hpp"
#include "riprap/bench/measure.hpp"
#include "riprap/core/bytes.hpp"
#include "riprap/fluid/grid/grid_step.hpp"

namespace riprap::bench {

namespace {

using namespace fluid::grid;

/// The tank of the published dam break with an obstacle, 1.61 m x 0.67 m x 0.4 m with a column 0.4 m long and 0.3 m
/// high; the obstacle of 0.12 m is closed cell by cell. One pass with one pressure a step, one with three, as other
/// programs count pressure corrections, or three passes, each solve to 1e-5 of its first residual.
GridSettings dam_break_tank() {
    GridSettings settings;
    settings.mesh = Mesh({uniform_edges(0, 1.6, 96), uniform_edges(0, 0.67, 40), uniform_edges(0, 0.45, 27)}, 3);
    settings.gravity = {0, 0, -9.81};
    settings.side[5].kind = SideKind::open;
    return settings;
}

OpenShares obstacle(const Mesh& mesh) {
    OpenShares open;
    open.has_bodies = true;
    open.volume.assign(at(mesh.box.size), 1.0);
    for (int a = 0; a < 3; ++a) {
        open.area[at(a)].assign(at(mesh.box.size), 1.0);
        open.body_velocity[at(a)].assign(at(mesh.box.size), 0.0F);
        open.wall_distance[at(a)].assign(at(mesh.box.size), 1e30F);
    }
    for_cells(mesh.box, [&](std::int64_t c, int i, int j, int k) {
        const Vec3 x = mesh.centre(i, j, k);
        if (x.x > 0.9 && x.x < 1.02 && x.y > 0.24 && x.y < 0.36) {
            open.volume[at(c)] = 0;
            for (int a = 0; a < 3; ++a) {
                open.area[at(a)][at(c)] = open.area[at(a)][at(c + mesh.box.stride[at(a)])] = 0;
            }
        }
    });
    return open;
}

/// Bytes of State and Scratch over the cells.
double bytes_per_cell(const GridState& state, const GridScratch& scratch, double cells) {
    std::size_t sum = scratch.bytes();
    GridState::visit_fields(state, [&sum](std::string_view, const auto& field) {
        if constexpr (requires { field.size(); }) {
            sum += bytes_of(field);
        }
    });
    return static_cast<double>(sum) / cells;
}

}  // namespace

void grid_dambreak(const Setting& setting, std::vector<Result>& results) {
    GridSettings settings = dam_break_tank();
    const auto cells = static_cast<double>(settings.mesh.box.cell_count());
    struct Row {
        const char* name;
        int passes, pressures;
    };
    for (const Row& row :
         {Row{"grid.dambreak", 1, 1}, Row{"grid.dambreak.3_pressures", 1, 3}, Row{"grid.dambreak.3_passes", 3, 1}}) {
        settings.outer_corrections = row.passes;
        settings.pressure_corrections = row.pressures;
        const std::string name = row.name;
        double alone = 0;
        for (std::size_t t = 0; t < setting.thread_counts.size(); ++t) {
            const int threads = setting.thread_counts[t];
            const ThreadScope scope(threads);
            GridState state = make_state(settings, [](const Vec3& x) { return x.x < 0.4 && x.z < 0.3; });
            GridScratch scratch;
            set_open_shares(settings, state, scratch, obstacle(settings.mesh));
            int iterations = 0, most = 0, steps = 0;
            const auto step = [&] {
                const double dt = std::min(1e-3, stable_step(settings, state, scratch));
                const int count = advance(settings, state, scratch, dt).pressure_iterations;
                iterations += count;
                most = std::max(most, count);
                ++steps;
            };
            for (int i = 0; i < 20; ++i) {  // until the column moves
                step();
            }
            iterations = most = steps = 0;
            const Timing timing = time_calls(step, {20, 2.0});
            const double per_cell = timing.median / cells, bytes = bytes_per_cell(state, scratch, cells);
            const std::string share =
                t < setting.machine.by_threads.size()
                    ? fmt::format(", {:.0f} % of the bandwidth if each byte goes in and out once",
                                  100 * 2 * bytes / per_cell / setting.machine.by_threads[t].triad)
                    : "";
            const std::string note = fmt::format(
                "{}, {:.0f} cells of {:.0f} B{}, {:.1f} pressure iterations a solve, at most {}, t = {:.3f} s",
                spread(timing), cells, bytes, share, static_cast<double>(iterations) / steps, most, state.time);
            results.push_back({name, threads, per_cell * 1e9, "ns per cell-step", note});
            results.push_back({name + ".rate", threads, 1e-6 / per_cell, "M cell-steps/s", ""});
            if (threads == 1) {
                alone = per_cell;
            } else {
                results.push_back({name + ".speedup", threads, alone / per_cell, "-", ""});
            }
        }
    }
}

}  // namespace riprap::bench
