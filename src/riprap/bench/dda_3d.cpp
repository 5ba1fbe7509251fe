// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "riprap/bench/benches.hpp"
#include "riprap/bench/block_wall.hpp"
#include "riprap/bench/measure.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/time_step.hpp"
#include "riprap/solid/affine/body_bridge.hpp"
#include "riprap/solid/affine/make_blocks.hpp"
#include "riprap/solid/explicit_dda/advance.hpp"
#include "riprap/solid/implicit_dda/advance.hpp"

namespace riprap::bench {

namespace {

namespace affine = solid::affine;
namespace implicit_dda = solid::implicit_dda;
namespace explicit_dda = solid::explicit_dda;

/// Makes the blocks of a wall for an engine.
void make_wall(const BlockWall& wall, affine::BlockSystem& system, affine::BlockState& state) {
    affine::Elasticity rock;
    rock.youngs_modulus = 1e9;
    rock.contact_stiffness = 1e7;
    if (const std::string problem = make_blocks(sim::solid_scene(wall.model), rock, system); !problem.empty()) {
        throw InternalError(problem);
    }
    read_bodies(wall.bodies, wall.model.bodies, state);
    system.gravity = wall.model.gravity.value;
}

struct Implicit {
    affine::BlockSystem system;
    implicit_dda::State state;
    implicit_dda::Scratch scratch;
    implicit_dda::Settings settings{};
    implicit_dda::StepReport report{};

    void step() {
        const auto outcome = advance(system, settings, 1e-3, {}, state, scratch, report);
        if (!outcome.ok()) {
            throw std::runtime_error(outcome.problem);
        }
    }
};

struct Explicit {
    affine::BlockSystem system;
    explicit_dda::State state{};
    explicit_dda::Scratch scratch;
    explicit_dda::Settings settings{};
    explicit_dda::StepReport report{};
    double dt{0};

    Explicit(int nx, int ny, int nz) {
        make_wall(wall_of_cubes(nx, ny, nz), system, state.blocks);
        settings.mass_damping = 10;
        dt = 0.5 * explicit_dda::stable_step(system, state.blocks);
    }
    void step() {
        const auto outcome = advance(system, settings, dt, {}, state, scratch, report);
        if (!outcome.ok()) {
            throw std::runtime_error(outcome.problem);
        }
    }
};

/// One thread is timed by the processor, which others on the machine hardly disturb; the solvers of both sides wait for
/// nothing.
Clock clock_for(int threads) { return threads == 1 ? Clock::processor : Clock::wall; }

/// Cubes of blocks, `sides` along an edge, and how time grows from one to the next.
void measure_walls(const Setting& setting, std::span<const int> sides, std::vector<Result>& results) {
    for (const int threads : setting.thread_counts) {
        const ThreadScope scope(threads);
        double first = 0;
        double before = 0;
        for (const int side : sides) {
            Explicit run(side, side, side);
            for (int i = 0; i < 3; ++i) {
                run.step();
            }
            const Timing timing = time_calls([&] { run.step(); });
            const double blocks = side * side * side;
            const auto points = static_cast<double>(run.report.contact_count);
            results.push_back({fmt::format("dda.explicit.{}", side * side * side), threads,
                               1e6 * timing.median / blocks, "us/block/step",
                               fmt::format("{:.0f} contact points, {:.2f} us each; {}", points,
                                           1e6 * timing.median / points, spread(timing))});
            if (first > 0) {
                results.push_back({"dda.explicit.slope", threads,
                                   std::log(timing.median / first) / std::log(blocks / before), "-",
                                   "of log time over log number of blocks"});
            }
            first = timing.median;
            before = blocks;
        }
    }
}

/// The wall of 1000 cubes as a case, moved by a solid method through whole steps of the driver.
struct WallCase {
    sim::Model model;
    sim::State state;
    sim::Scratch scratch;
    double dt{0};

    WallCase(const std::string& method, const std::string& more) {
        scene::LoadedCase loaded = scene::read_case_text(fmt::format(R"(
gravity = [0.0, 0.0, -9.81]
end = 10.0
[material.rock]
density = 2500.0
normal_stiffness = "10 MPa"
friction_coefficient = 0.6
damping_ratio = 0.2
[[body]]
name = "floor"
material = "rock"
fixed = true
shape = {{ half_space = {{ normal = [0.0, 0.0, 1.0] }} }}
[[body]]
name = "cube"
material = "rock"
shape = {{ cube = 1.0 }}
position = [0.0, 0.0, 0.4995]
repeat = {{ counts = [10, 10, 10], pitch = [0.999, 0.999, 0.999] }}
[solid]
method = "{}"
{}
)",
                                                                     method, more),
                                                         "bench", ".");
        sim::initialise(loaded.model, loaded.state);
        model = std::move(loaded.model);
        state = std::move(loaded.state);
        dt = 0.5 * choose_time_step(model, state, scratch).dt;
    }
    sim::StepReport step() {
        const sim::StepReport report = advance(model, state, scratch, dt, sim::Measure::flow);
        if (!report.status.ok()) {
            throw std::runtime_error(report.status.text);
        }
        return report;
    }
};

/// A step of explicit DDA over one of rigid polyhedra, on the same wall with the same pairs that touch.
void compare_with_rigid(int threads, std::vector<Result>& results) {
    WallCase blocks("explicit_dda", "youngs_modulus = 1e9\ncontact_stiffness = 1e7");
    for (const auto& [name, word] : {std::pair{"distance_potential", "contact = \"distance_potential\""},
                                     std::pair{"common_plane", "contact = \"common_plane_penalty\""}}) {
        WallCase rigid("distance_potential_dem", word);
        const std::int64_t pairs = blocks.step().contact_count, rigid_pairs = rigid.step().contact_count;
        const Timing ratio = compare_calls([&] { blocks.step(); }, [&] { rigid.step(); }, 15);
        results.push_back({fmt::format("dda.explicit.over_rigid.{}", name), threads, ratio.median, "-",
                           fmt::format("a step of 1000 cubes, {} touching pairs, over one of rigid polyhedra, {} "
                                       "touching pairs, in turn; {}",
                                       pairs, rigid_pairs, spread(ratio))});
    }
}

/// Moves `bytes` through memory by a[i] = b[i] + s c[i], as the machine's bandwidth is measured: what a product with
/// the matrix costs at least.
class Traffic {
 public:
    explicit Traffic(double bytes)
        : a_(static_cast<std::size_t>(bytes / (3 * sizeof(double))), 0), b_(a_.size(), 1), c_(a_.size(), 2) {}
    void move() {
        parallel::for_each(static_cast<std::int64_t>(a_.size()),
                           [&](std::int64_t i) { a_[at(i)] = b_[at(i)] + 0.5 * c_[at(i)]; });
    }

 private:
    std::vector<double> a_, b_, c_;
};

/// One solution from nothing over the memory traffic of its products, in turn.
void compare_with_traffic(int threads, Implicit& run, std::vector<Result>& results) {
    auto& equations = run.scratch.equations;
    linear::SolveReport solved;
    const auto solve_once = [&] {
        std::fill(equations.solution.begin(), equations.solution.end(), 0.0);
        std::fill(equations.is_new.begin(), equations.is_new.end(), std::uint8_t{1});
        solved = solve(run.settings.solve, equations);
    };
    solve_once();
    // of each iteration, and of the residual that it ends with
    const int products = solved.iterations + 1;
    Traffic traffic(equations.matrix.bytes_per_product());
    const auto move_as_often = [&] {
        for (int i = 0; i < products; ++i) {
            traffic.move();
        }
    };
    const Timing ratio = compare_calls(solve_once, move_as_often, 9, clock_for(threads));
    results.push_back(
        {"dda.implicit_3400.solve_over_traffic", threads, ratio.median, "-",
         fmt::format("one solution over the traffic of its {} products, in turn; {}", products, spread(ratio))});
}

}  // namespace

void dda_implicit_3400(const Setting& setting, std::vector<Result>& results) {
    Implicit run;
    make_wall(wall_of_cubes(17, 10, 20), run.system, run.state.blocks);
    run.settings.open_close = 20;
    for (int i = 0; i < 3; ++i) {
        run.step();
    }
    for (std::size_t t = 0; t < setting.thread_counts.size(); ++t) {
        const int threads = setting.thread_counts[t];
        const ThreadScope scope(threads);
        run.scratch.times = {};
        run.scratch.solve_time = 0;
        const Timing whole = time_calls([&] { run.step(); });
        const solid::SolidTimes times = run.scratch.times;
        const double solve_time = run.scratch.solve_time;
        results.push_back({"dda.implicit_3400", threads, 1e3 * whole.median, "ms/step",
                           fmt::format("3400 blocks, {} contact points, {} open-close iterations, {} of the solver; {}",
                                       run.report.contact_count, run.report.open_close, run.report.solver_iterations,
                                       spread(whole))});
        // One solution again from nothing, against the memory traffic of its products.
        auto& equations = run.scratch.equations;
        linear::SolveReport solved;
        const Timing one = time_calls([&] {
            std::fill(equations.solution.begin(), equations.solution.end(), 0.0);
            std::fill(equations.is_new.begin(), equations.is_new.end(), std::uint8_t{1});
            solved = solve(run.settings.solve, equations);
        });
        const Timing filled = time_calls([&] {
            std::fill(equations.is_stale.begin(), equations.is_stale.end(), std::uint8_t{1});
            assemble(run.scratch.contacts, equations);
        });
        const double bandwidth =
            t < setting.machine.by_threads.size() ? setting.machine.by_threads[t].triad : reference_core.triad;
        const double bound = solved.iterations * equations.matrix.bytes_per_product() / bandwidth;
        results.push_back({"dda.implicit_3400.solve", threads, 1e3 * one.median, "ms",
                           fmt::format("{} iterations, {:.2f} times the memory traffic of its products; assembly "
                                       "{:.1f} ms; {:.1f} blocks a row",
                                       solved.iterations, one.median / bound, 1e3 * filled.median,
                                       static_cast<double>(equations.matrix.pattern().entries()) /
                                           static_cast<double>(equations.matrix.rows()))});
        const double all = times.find_contacts + times.contact_loads + times.measure + times.move_bodies;
        results.push_back({"dda.implicit_3400.solve_share", threads, solve_time / all, "-",
                           "of a step; the rest finds contacts, assembles and moves"});
        results.push_back({"dda.implicit_3400.iteration_share", threads, times.contact_loads / all, "-",
                           "of a step: open and close, with assembly and solutions; the rest finds contacts"});
        compare_with_traffic(threads, run, results);
    }
}

void dda_explicit(const Setting& setting, std::vector<Result>& results) {
    measure_walls(setting, std::array{10, 20}, results);
    for (const int threads : setting.thread_counts) {
        const ThreadScope scope(threads);
        compare_with_rigid(threads, results);
    }
}

void dda_explicit_100k(const Setting& setting, std::vector<Result>& results) {
    measure_walls(setting, std::array{20, 46}, results);
}

}  // namespace riprap::bench
