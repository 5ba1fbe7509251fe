// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "io/temporary_folder.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/geometry/polyhedra/random_bits.hpp"
#include "riprap/run/simulate/restart.hpp"
#include "riprap/sim/advance.hpp"

namespace riprap::run {
namespace {

/// RIPRAP_FULL: the scenes at their full size, 1000 steps each.
bool is_full() { return std::getenv("RIPRAP_FULL") != nullptr; }

/// A tray of five half-spaces and what lies in it.
std::string in_a_tray(double half_width, const std::string& floor, const std::string& bodies) {
    std::string text = R"(
end     = 100
time_step_factor = 0.4
gravity = [0, 0, -9.81]
[material.rock]
density              = 2500.0
normal_stiffness     = "0.3 MPa"
friction_coefficient = 0.5
damping_ratio        = 0.1
)" + bodies;
    text += fmt::format(
        "[[body]]\nname = 'floor'\nmaterial = 'rock'\nshape = {{ half_space = {{ normal = [0, 0, 1] }} "
        "}}\n{}\n",
        floor);
    for (const auto& [name, x, y] : {std::tuple{"west", 1, 0}, {"east", -1, 0}, {"south", 0, 1}, {"north", 0, -1}}) {
        text += fmt::format(
            "[[body]]\nname = '{}'\nmaterial = 'rock'\nshape = {{ half_space = {{ normal = [{}, {}, 0], offset = {} }} "
            "}}\nfixed = true\n",
            name, x, y, -half_width);
    }
    return text;
}

/// `columns` x `columns` x `layers` bodies of one shape, the lowest layer at height z.
std::string many(const std::string& name, const std::string& shape, int columns, int layers, const Vec3& pitch,
                 double z, const std::string& more = {}) {
    return fmt::format(
        "[[body]]\nname = '{}'\nmaterial = 'rock'\nshape = {}\nposition = [{}, {}, {}]\n"
        "repeat = {{ counts = [{}, {}, {}], pitch = [{}, {}, {}] }}\n{}\n",
        name, shape, -0.5 * pitch.x * (columns - 1), -0.5 * pitch.y * (columns - 1), z, columns, columns, layers,
        pitch.x, pitch.y, pitch.z, more);
}

/// Bent bodies of five cubes each fall and hook into each other, in waves: the upper ones hang until they are released.
std::string hooks_text() {
    std::string parts;
    for (const char* place : {"-0.1, 0, 0", "0, 0, 0", "0.1, 0, 0", "0.1, 0, 0.1", "-0.1, 0.1, 0"}) {
        parts += fmt::format("{{ shape = {{ cube = 0.1 }}, position = [{}] }}, ", place);
    }
    const int columns = is_full() ? 6 : 3;
    const double pitch = 0.42;
    std::string text;
    for (int wave = 0; wave < 3; ++wave) {
        text += many(
            fmt::format("hook{}", wave), "{ union = [" + parts + "] }", columns, 1, {pitch, pitch, 1},
            0.22 + 0.4 * wave,
            fmt::format(
                "orientation = {{ axis_angle = {{ axis = [1, {}, 0.3], angle = {} }} }}\n{}", wave - 1, 0.4 + wave,
                wave == 0 ? "velocity = [0.4, 0.2, -2]" : fmt::format("fixed = true\nrelease_time = {}", 0.1 * wave)));
    }
    return in_a_tray(0.5 * pitch * columns + 0.05, "fixed = true", text);
}

/// Stones of sizes 1 : 4 and crates fall on each other over a floor that shakes.
std::string stones_text() {
    const int columns = is_full() ? 16 : 4;
    const double pitch = 0.26;
    const auto stone = [](double radius, int seed) {
        return fmt::format("{{ random_hull = {{ circumradius = {}, corners = 10, seed = {} }} }}", radius, seed);
    };
    const auto layer = [&](const char* name, const std::string& shape, int share, double z, const char* velocity) {
        return many(name, shape, columns / share, 1, {share * pitch, share * pitch, 1}, z, velocity);
    };
    return in_a_tray(0.5 * pitch * columns, "motion = { sinusoidal = { amplitude = [0.02, 0, 0.01], period = 0.2 } }",
                     layer("small", stone(0.1, 1), 1, 0.12, "velocity = [0.2, 0.1, -1]") +
                         layer("crate", "{ box = [0.18, 0.16, 0.14] }", 1, 0.34, "angular_velocity = [1, 2, 3]") +
                         layer("middle", stone(0.2, 2), 2, 0.65, "velocity = [0.3, 0, -3]") +
                         layer("large", stone(0.4, 3), 4, 1.25, "velocity = [0, 0, -4]"));
}

/// Layers of cubes, pressed together sideways and half a millimetre apart upwards: they spring open, fall shut and are
/// pushed apart again, wave after wave, with thousands of faces touching.
std::string wall_text() {
    const int columns = is_full() ? 14 : 10;
    return in_a_tray(
        0.1 * columns, "fixed = true",
        many("cube", "{ cube = 0.2 }", columns, 15, {0.1999, 0.1999, 0.2005}, 0.1001, "velocity = [0.05, 0.03, -0.4]"));
}

struct Scene {
    const char* name;
    std::string (*text)();
    std::int64_t steps;         ///< in the short run; 1000 in the full one
    std::size_t most_contacts;  ///< that must be there at one time, or the scene says nothing
};
void PrintTo(const Scene& scene, std::ostream* out) { *out << scene.name; }

/// A run of a scene, hashed on the way, so that a difference shows near where it began.
class Walk {
 public:
    explicit Walk(const Scene& scene) : loaded_(scene::read_case_text(scene.text(), "case.toml", ".")) {
        sim::initialise(loaded_.model, loaded_.state);
        initial_ = state = loaded_.state;
    }
    /// Advances and appends a hash every 5 steps.
    void go(std::int64_t last_step) {
        while (state.step < last_step) {
            const double dt = choose_time_step(model(), state, scratch_).dt;
            const sim::StepReport report = advance(model(), state, scratch_, dt, sim::Measure::flow);
            ASSERT_TRUE(report.status.ok()) << report.status.text;
            if (state.step % 5 == 0) {
                hashes.push_back(state_hash(state));
            }
        }
    }
    const sim::Model& model() const { return loaded_.model; }
    const sim::State& initial() const { return initial_; }

    sim::State state;
    std::vector<std::uint64_t> hashes;

 private:
    scene::LoadedCase loaded_;
    sim::State initial_;
    sim::Scratch scratch_;
};

/// Contacts that came and went over a run.
struct Turnover {
    std::size_t made{0}, lost{0}, most{0};
    std::vector<std::uint64_t> pairs;

    void look(const sim::State& state) {
        std::vector<std::uint64_t> now = state.contacts.pair, came, went;
        std::set_difference(now.begin(), now.end(), pairs.begin(), pairs.end(), std::back_inserter(came));
        std::set_difference(pairs.begin(), pairs.end(), now.begin(), now.end(), std::back_inserter(went));
        made += came.size();
        lost += went.size();
        most = std::max(most, now.size());
        pairs = std::move(now);
    }
};

class SameBits : public ::testing::TestWithParam<Scene> {
 protected:
    ~SameBits() override { parallel::set_thread_count(1); }
};

TEST_P(SameBits, AtAnyThreadCountAndAfterAnyResumeWithAnotherThreadCount) {
    const Scene& scene = GetParam();
    const std::int64_t steps = is_full() ? 1000 : scene.steps;
    const int resumes = is_full() ? 8 : 2;
    std::vector<std::int64_t> stops;
    for (int i = 0; i < resumes; ++i) {
        const double share = geometry::unit_interval(geometry::mix_bits(7, static_cast<std::uint64_t>(i)));
        stops.push_back(1 + static_cast<std::int64_t>(share * static_cast<double>(steps - 1)));
    }

    parallel::set_thread_count(1);
    Walk straight(scene);
    Turnover turnover;
    std::vector<sim::State> stopped(stops.size());
    for (std::int64_t step = 1; step <= steps; ++step) {
        ASSERT_NO_FATAL_FAILURE(straight.go(step));
        turnover.look(straight.state);
        for (std::size_t i = 0; i < stops.size(); ++i) {
            if (step == stops[i]) {
                stopped[i] = straight.state;
            }
        }
    }
    EXPECT_GT(turnover.made, scene.most_contacts);
    EXPECT_GT(turnover.lost, scene.most_contacts / 10);
    EXPECT_GE(turnover.most, scene.most_contacts);

    for (const int threads : {2, 3, 4}) {
        parallel::set_thread_count(threads);
        Walk walk(scene);
        ASSERT_NO_FATAL_FAILURE(walk.go(steps));
        EXPECT_EQ(walk.hashes, straight.hashes) << threads << " threads";
    }
    for (std::size_t i = 0; i < stops.size(); ++i) {
        parallel::set_thread_count(2 + static_cast<int>(i % 3));
        const TemporaryFolder place;
        const RunFolder folder{place.path()};
        io::make_folder(folder.checkpoint_latest().parent_path());
        Walk walk(scene);
        RunRecord record;
        record.end = record.frame_interval = record.row_interval = 1;
        record.csv_bytes = {0, 0};
        save_checkpoint(folder, walk.model(), stopped[i], record);
        walk.state = load_checkpoint(folder, walk.model(), walk.initial()).state;
        ASSERT_NO_FATAL_FAILURE(walk.go(steps));
        const std::vector<std::uint64_t> tail(straight.hashes.end() - static_cast<std::ptrdiff_t>(walk.hashes.size()),
                                              straight.hashes.end());
        EXPECT_EQ(walk.hashes, tail) << "stopped at step " << stops[i];
        EXPECT_FALSE(tail.empty());
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SameBits,
                         testing::Values(Scene{"hooks", hooks_text, 1000, 80}, Scene{"stones", stones_text, 1000, 80},
                                         Scene{"wall", wall_text, 25, 4200}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace riprap::run
