// SPDX-License-Identifier: Apache-2.0
// Deformable blocks of both three-dimensional DDAs, and polygons of the planar one, on ground of many faces.
#include <gtest/gtest.h>

#include "ground_case.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::run {
namespace {

/// @param step  of the implicit methods [s]
std::string method_of(const std::string& name, double stiffness = 1e7, double step = 5e-4) {
    return fmt::format("[solid]\nmethod = '{}'\nyoungs_modulus = 1e8\ncontact_stiffness = {}\n{}", name, stiffness,
                       name == "explicit_dda" ? "" : fmt::format("step = {}\n", step));
}

class DdaOnGround : public ::testing::TestWithParam<const char*> {
 protected:
    ~DdaOnGround() override { parallel::set_thread_count(1); }
};
INSTANTIATE_TEST_SUITE_P(Methods, DdaOnGround, ::testing::Values("explicit_dda", "implicit_dda"),
                         [](const auto& instance) { return std::string(instance.param); });

TEST_P(DdaOnGround, ABlockSlidesOverTrianglesAsOverAPlane) {
    const CaseFolder folder;
    folder.write_heights(21, 13, 0.17, [](double x, double) { return -slope_tangent * x; });
    folder.write("bed.obj", slope_strip());
    const std::string method = method_of(GetParam());
    const Vec3 smooth = place_of_last(run(folder, slope(slope_plane, slope_box, method)));
    const double way = norm(smooth - slope_start);
    EXPECT_NEAR(way, 0.5 * 9.81 * (0.5 - slope_tangent * 1.5 * std::tan(M_PI / 9)) * 0.25, 2e-3);
    for (const std::string& ground :
         {slope_grid, std::string("{ mesh = { file = 'bed.obj', units = 'm', thickness = 0.6 } }")}) {
        const Vec3 rough = place_of_last(run(folder, slope(ground, slope_box, method)));
        EXPECT_LT(norm(rough - smooth), 1e-3 * way) << ground;
    }
}

/// A prism of 24 sides rolls down the slope.
TEST_P(DdaOnGround, ARollingBlockKeepsItsSpeedOverInnerEdges) {
    const CaseFolder folder;
    folder.write_heights(21, 13, 0.17, [](double x, double) { return -slope_tangent * x; });
    std::string points;
    for (int i = 0; i < 24; ++i) {
        const double angle = M_PI * (i + 0.5) / 12;
        for (const double y : {-0.15, 0.15}) {
            points += fmt::format("[{:.17g}, {}, {:.17g}], ", 0.1 * std::sin(angle), y, 0.1 * std::cos(angle));
        }
    }
    const double radius = 0.1 * std::cos(M_PI / 24);
    const std::string roller =
        fmt::format("shape = {{ hull = {{ points = [{}] }} }}\nposition = [{:.17g}, 0.02, {:.17g}]", points,
                    0.5 * radius, 0.8660254037844386 * radius);
    const std::string method = method_of(GetParam());
    const auto smooth = run(folder, slope(slope_plane, roller, method));
    const auto rough = run(folder, slope(slope_grid, roller, method));
    const double speed = norm(smooth->state().bodies.velocity.back());
    EXPECT_GT(norm(body::angular_velocity(smooth->model().bodies, smooth->state().bodies, BodyId{1})), 5);
    EXPECT_LT(norm(rough->state().bodies.velocity.back() - smooth->state().bodies.velocity.back()), 1e-3 * speed);
    EXPECT_LT(norm(place_of_last(rough) - place_of_last(smooth)), 1e-3 * norm(place_of_last(smooth)));
}

/// Bumps of a fifth of the block's width.
std::string on_bumps(const std::string& method, const std::string& block, double end,
                     const std::string& drive = "fixed = true") {
    return text_of(
        {.ground = "shape = { terrain = { file = 'bed.asc' } }\n" + drive,
         .block = block,
         .method = method,
         .end = end,
         .material = "density = 2500.0\nnormal_stiffness = 1.0e7\nfriction_angle_deg = 35.0\ndamping_ratio = 0.3\n"});
}

double bumps(double x, double y) { return 0.05 * std::sin(4 * x) + 0.03 * std::cos(5 * y); }

TEST_P(DdaOnGround, ABlockAtRestOnBumpsStays) {
    const CaseFolder folder;
    folder.write_heights(15, 11, 0.15, bumps);
    const std::string block = "shape = { box = [0.4, 0.3, 0.2] }\nposition = [0.1, -0.2, 0.2]";
    const std::string method = method_of(GetParam(), 1e6, 2e-3);
    const auto simulation = start(folder, on_bumps(method, block, 3.5));
    Vec3 before{};
    while (simulation->steps_left() > 0) {
        ASSERT_NE(simulation->step(sim::Measure::flow).kind, StepOutcome::Kind::refused);
        before = simulation->state().time < 2 ? simulation->state().bodies.position.back() : before;
    }
    EXPECT_GT(place_of_last(simulation).z, 0.1);
    EXPECT_LT(norm(place_of_last(simulation) - before), 1e-5);  // of its width of 0.4
    EXPECT_LT(norm(simulation->state().bodies.velocity.back()), 1e-4);
}

TEST(ExplicitDdaOnGround, ABlockWithoutFrictionKeepsItsEnergyOverRidgesAndValleys) {
    const CaseFolder folder;
    folder.write_heights(15, 11, 0.25, bumps);
    const auto end = run(
        folder,
        text_of({.ground = "fixed = true\nshape = { terrain = { file = 'bed.asc' } }",
                 .block = "shape = { box = [0.3, 0.3, 0.1] }\nposition = [-0.3, 0.2, 0.2]\nvelocity = [2.0, 0.5, 0.0]",
                 .method = "time_step_factor = 0.2\n" + method_of("explicit_dda", 1e6),
                 .end = 0.4,
                 .material = "density = 900.0\nnormal_stiffness = 1.0e6\n"}));
    const body::BodySet& bodies = end->model().bodies;
    const body::BodyState& state = end->state().bodies;
    const Vec3 spin = body::angular_velocity(bodies, state, BodyId{1});
    EXPECT_GT(norm(spin), 0.3);             // it has met bumps
    EXPECT_GT(state.position[1].z, -0.05);  // and has not sunk in
    const double before = bodies.mass[1] * (0.5 * 4.25 + 9.81 * 0.2);
    const double after = bodies.mass[1] * (0.5 * norm_squared(state.velocity[1]) + 9.81 * state.position[1].z) +
                         0.5 * dot(spin, state.angular_momentum[1]);
    EXPECT_NEAR(after, before, 5e-3 * before);  // but for what the springs hold now
}

TEST_P(DdaOnGround, DrivenGroundCarriesABlock) {
    const CaseFolder folder;
    folder.write_heights(15, 11, 0.15, bumps);
    const std::string block = "shape = { box = [0.4, 0.3, 0.2] }\nposition = [0.1, -0.2, 0.2]";
    const std::string drive = "motion = { linear = { velocity = [0.3, 0.1, 0.05] } }";
    const auto carried = run(folder, on_bumps(method_of(GetParam(), 1e6, 2e-3), block, 2.0, drive));
    const Vec3 velocity{0.3, 0.1, 0.05};
    EXPECT_LT(norm(carried->state().bodies.velocity.back() - velocity), 1e-3);
    EXPECT_LT(norm(place_of_last(carried) - 2.0 * velocity - Vec3{0.03, -0.23, 0.12}),
              0.1);  // slid until it went along
}

TEST_P(DdaOnGround, TheBitsAreTheSameAtAnyThreadCountAndFromAFreshScratch) {
    const CaseFolder folder;
    folder.write_heights(15, 11, 0.15, bumps);
    const std::string blocks =
        "shape = { box = [0.2, 0.15, 0.1] }\nposition = [-0.2, -0.3, 0.16]\n"
        "repeat = { counts = [4, 4, 2], pitch = [0.22, 0.17, 0.12] }\nvelocity = [0.5, 0, -0.5]";
    const auto walk = [&](int threads, std::int64_t fresh_every) {
        parallel::set_thread_count(threads);
        scene::LoadedCase loaded =
            scene::read_case_text(on_bumps(method_of(GetParam(), 1e6), blocks, 1.0), "case.toml", folder.path());
        sim::initialise(loaded.model, loaded.state);
        auto scratch = std::make_unique<sim::Scratch>();
        for (int i = 0; i < 60; ++i) {
            if (fresh_every > 0 && i % fresh_every == 0) {
                scratch = std::make_unique<sim::Scratch>();
            }
            const double dt = sim::choose_time_step(loaded.model, loaded.state, *scratch).dt;
            const sim::StepReport report = sim::advance(loaded.model, loaded.state, *scratch, dt, sim::Measure::flow);
            EXPECT_TRUE(report.status.ok()) << report.status.text;
        }
        return state_hash(loaded.state);
    };
    const std::uint64_t straight = walk(1, 0);
    for (const int threads : {2, 4}) {
        EXPECT_EQ(walk(threads, 0), straight) << threads << " threads";
    }
    EXPECT_EQ(walk(2, 7), straight);
}

/// Ground under a line through points.
std::string section(const std::string& points) {
    return "fixed = true\nshape = { terrain = { profile = [" + points + "], thickness = 1 } }";
}

TEST(PlanarDdaOnGround, ABlockSlidesOverASectionLineAsOverAPlane) {
    std::string points;
    for (const double x : {-1.0, -0.3, 0.05, 0.21, 0.5, 0.72, 1.5}) {
        points += fmt::format("[{}, {:.17g}], ", x, -slope_tangent * x);
    }
    const auto text = [](const std::string& ground) {
        return text_of({.ground = ground,
                        .block =
                            "orientation = { angle_deg = -30 }\nshape = { box = [0.5, 0.25] }\nposition = [0.0625, "
                            "0.1082531754730548]",
                        .method = method_of("planar_dda"),
                        .is_planar = true,
                        .material = "density = 2500.0\nnormal_stiffness = 1.0e7\nfriction_angle_deg = 20.0\n"});
    };
    const CaseFolder folder;
    const Vec3 smooth = place_of_last(
        run(folder, text("fixed = true\nshape = { half_space = { normal = [0.5, 0.8660254037844386] } }")));
    const Vec3 rough = place_of_last(run(folder, text(section(points))));
    const double way = norm(smooth - Vec3{0.0625, 0.1082531754730548, 0});
    EXPECT_NEAR(way, 0.2265, 2e-3);
    EXPECT_LT(norm(rough - smooth), 1e-3 * way);
}

TEST(PlanarDdaOnGround, ABlockComesToRestInTheValleysOfASection) {
    const CaseFolder folder;
    const auto simulation =
        start(folder,
              text_of({.ground = section("[-1, 0.3], [-0.4, 0.0], [-0.1, 0.06], [0.1, -0.02], [0.3, 0.04], [0.5, 0.0], "
                                         "[1, 0.3]"),
                       .block = "shape = { box = [0.4, 0.2] }\nposition = [0.1, 0.2]",
                       .method = method_of("planar_dda", 1e6, 2e-3),
                       .end = 3.0,
                       .is_planar = true}));
    Vec3 before{};
    while (simulation->steps_left() > 0) {
        ASSERT_NE(simulation->step(sim::Measure::flow).kind, StepOutcome::Kind::refused);
        before = simulation->state().time < 2.5 ? simulation->state().bodies.position.back() : before;
    }
    EXPECT_GT(place_of_last(simulation).y, 0.1);
    EXPECT_LT(norm(place_of_last(simulation) - before), 1e-4);
}

}  // namespace
}  // namespace riprap::run
