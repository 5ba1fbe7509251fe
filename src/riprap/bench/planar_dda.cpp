// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "riprap/bench/benches.hpp"
#include "riprap/bench/block_wall.hpp"
#include "riprap/bench/measure.hpp"
#include "riprap/core/error.hpp"
#include "riprap/solid/planar_dda/assemble.hpp"
#include "riprap/solid/planar_dda/make_blocks.hpp"
#include "riprap/solid/planar_dda/state.hpp"
#include "riprap/solid/planar_dda/step.hpp"

namespace riprap::bench {

namespace {

using namespace solid::planar_dda;

/// A wall of bricks in bond on a fixed base.
struct Wall {
    Model model;
    State state;
    Settings settings;
    Scratch scratch;
    StepReport report;

    Wall(int columns, int rows) {
        const BlockWall wall = wall_of_bricks(columns, rows);
        const solid::SolidScene scene = sim::solid_scene(wall.model);
        solid::affine::Elasticity rock;
        rock.youngs_modulus = 1e10;
        rock.poisson_ratio = 0.2;
        rock.contact_stiffness = 1e9;
        SceneBlocks blocks = make_blocks(scene, wall.bodies, disc_around(scene, wall.bodies), rock, PlaneState::stress);
        if (!blocks.problems.empty()) {
            throw InternalError("the bench of planar DDA: " + blocks.problems.front().message);
        }
        model = std::move(blocks.model);
        state = std::move(blocks.state);
        settings.displacement_limit = 0.005 * 0.5 * columns;
        settings.close_tolerance = settings.open_tolerance = 1e-11 * 0.5 * columns;
    }
    void step() {
        const Outcome outcome = advance(model, settings, {1e-3, {0, -9.81}, {}, {}}, state, scratch, report);
        if (!outcome.ok()) {
            throw InternalError("the bench of planar DDA: " + outcome.problem);
        }
    }
    /// Assembles and solves the equations of the last step once more, from nothing.
    void solve() {
        assemble_matrix(model, state, 1e-3, scratch);
        assemble_right_side(model, state, 1e-3, scratch);
        std::fill(scratch.solution.begin(), scratch.solution.end(), Unknowns{});
        scratch.equations.prepare();
        scratch.equations.solve(scratch.right, scratch.solution);
    }
};

}  // namespace

void dda_planar(const Setting& setting, std::vector<Result>& results) {
    for (const int threads : setting.thread_counts) {
        const ThreadScope scope(threads);
        for (const auto& [columns, rows] : {std::pair{10, 10}, std::pair{40, 15}}) {
            Wall wall(columns, rows);
            for (int k = 0; k < 50; ++k) {
                wall.step();
            }
            std::vector<Vec2> corners;
            const Timing step = time_calls([&wall] { wall.step(); });
            const Timing solution = time_calls([&wall] { wall.solve(); });
            const Timing search = time_calls([&wall, &corners] {
                place_corners(wall.model, wall.state, corners);
                find_contacts(wall.model, wall.state, wall.settings, corners, wall.scratch.search,
                              wall.scratch.contacts);
            });
            const int count = columns * rows;
            results.push_back(
                {"dda.planar", threads, 1e6 * step.median / count, "us/block",
                 fmt::format("a step of {} bricks with {} closed contacts, {} solutions; {:.0f} % of it "
                             "finds contacts, {:.0f} % solves; {}",
                             count, wall.report.closed_contacts, wall.report.iterations,
                             100 * search.median / step.median,
                             100 * wall.report.iterations * solution.median / step.median, spread(step))});
        }
    }
}

}  // namespace riprap::bench
