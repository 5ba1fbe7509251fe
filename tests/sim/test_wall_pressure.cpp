// SPDX-License-Identifier: Apache-2.0
// Gauges in faces and on bodies, in water that a step has moved.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/gauge/gauge_kinds.hpp"
#include "riprap/sim/quantity.hpp"
#include "sim/basin.hpp"

namespace riprap::sim {
namespace {

/// Puts a gauge into the face next to a place; its column.
Column add_gauge(Basin& basin, const Vec3& place) {
    OutputSettings& output = basin.model.output;
    fluid::Gauge gauge;
    gauge.name = "gauge" + std::to_string(output.gauges.size());
    gauge.kind = &fluid::wall_pressure_gauge;
    gauge.point = place;
    gauge.face = static_cast<std::int32_t>(output.faces.size());
    output.faces.push_back(
        coupling::find_face(basin.model.shapes, basin.model.bodies, basin.state.bodies, {}, place, dp).value());
    output.gauges.push_back(gauge);
    return find_column(basin.model, gauge.name).value();
}

TEST(WallPressure, still_water_presses_with_its_depth_on_walls_floor_and_corner) {
    Basin basin;
    basin.fill_pool(1, 1);
    const std::vector<Vec3> places{{1, 0.5, 0}, {1, 0.3, 0}, {0, 0.4, 0}, {0.5, 0, 0}, {0.32, 0, 0}};
    const std::vector<Vec3> corner{{1, 0.025, 0}, {1, 0.05, 0}, {0.96, 0, 0}, {0.03, 0, 0}};
    std::vector<Column> columns, corner_columns;
    for (const Vec3& place : places) {
        columns.push_back(add_gauge(basin, place));
    }
    for (const Vec3& place : corner) {
        corner_columns.push_back(add_gauge(basin, place));
    }
    const State initial = basin.state;
    EXPECT_TRUE(std::isnan(evaluate(columns[0], {basin.model, initial, basin.state, nullptr, nullptr})));
    Scratch scratch;
    const StepReport report = basin.steps(3, scratch);
    ASSERT_TRUE(report.status.ok());
    const Moment moment{basin.model, initial, basin.state, &scratch, &report};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double head = 9810 * (1 - places[i].y);
        EXPECT_NEAR(evaluate(columns[i], moment), head, 0.005 * head) << i;
    }
    for (std::size_t i = 0; i < corner.size(); ++i) {
        const double head = 9810 * (1 - corner[i].y);
        EXPECT_NEAR(evaluate(corner_columns[i], moment), head, 0.02 * head) << i;
    }
}

void add_box(Basin& basin, const Vec3& low, const Vec3& high) {
    const Vec3 half = 0.5 * (high - low);
    const std::vector<geometry::Point2> corners{
        {-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}};
    basin.add("box", basin.add_shape(geometry::planar_prism(corners).value()), {0.5 * (low + high), {}},
              body::Drive::fixed);
}

/// The reading on the left face of a box that stands free in still water 1 m deep, over the pressure at its height.
double reading_on_box(double thickness, const fluid::SchemeSettings& scheme, double width, double place) {
    Basin basin;
    add_box(basin, {place, 0, 0}, {place + thickness, 0.8, 0});
    basin.fill_pool(width, 1);
    coupling::ParticleFluid& water = *basin.model.particles();
    const fluid::ParticleSettings settings = water.settings();
    water.scheme = scheme;
    const double ratio = water.settings().smoothing_ratio;
    const fluid::StateEquation equation = water.settings().state_equation;
    water.settings() = settings;
    water.settings().smoothing_ratio = ratio;
    water.settings().state_equation = equation;
    const Column column = add_gauge(basin, {place, 0.4, 0});
    const State initial = basin.state;
    Scratch scratch;
    const StepReport report = basin.steps(3, scratch);
    EXPECT_TRUE(report.status.ok());
    return evaluate(column, {basin.model, initial, basin.state, &scratch, &report}) / (9810 * 0.6);
}

TEST(WallPressure, a_face_of_a_thin_box_feels_its_own_side_of_still_water_in_every_scheme) {
    for (const int spacings : {2, 3, 4, 5, 6}) {
        const double thick = spacings * dp, width = 1 + thick;
        EXPECT_NEAR(reading_on_box(thick, fluid::SphSettings{}, width, 0.5), 1, 0.02) << spacings;
        EXPECT_NEAR(reading_on_box(thick, fluid::WcmpsSettings{}, width, 0.5), 1, 0.03) << spacings;
    }
}

TEST(WallPressure, a_face_of_a_thin_box_feels_nothing_of_water_on_its_other_side_alone) {
    Basin basin;
    add_box(basin, {}, {3 * dp, 1.5, 0});
    basin.add_wall({0, 1, 0}, 0);
    basin.add_wall({-1, 0, 0}, -1.15);
    basin.fill({3 * dp, 0, 0}, {1.15, 2, 0}, {1, dp, 0}, 1, {0, -9.81, 0});
    const Column dry = add_gauge(basin, {0, 0.4, 0}), wet = add_gauge(basin, {3 * dp, 0.4, 0});
    const State initial = basin.state;
    Scratch scratch;
    const StepReport report = basin.steps(3, scratch);
    ASSERT_TRUE(report.status.ok());
    const Moment moment{basin.model, initial, basin.state, &scratch, &report};
    EXPECT_NEAR(evaluate(dry, moment), 0, 0.01 * 9810 * 0.6);
    EXPECT_NEAR(evaluate(wet, moment), 9810 * 0.6, 0.02 * 9810 * 0.6);
}

TEST(WallPressure, a_run_taken_up_again_reads_the_same_bits_at_any_thread_count) {
    Basin basin;
    basin.add_square(0.3, 700, {0.4, 0.8, 0});
    basin.fill_pool(1, 1);
    const Column wall = add_gauge(basin, {1, 0.5, 0}), block = add_gauge(basin, {0.4, 0.65, 0});
    const State initial = basin.state;
    Scratch scratch;
    ASSERT_TRUE(basin.steps(20, scratch).status.ok());
    const State middle = basin.state;
    const int before = parallel::thread_count();
    std::vector<double> readings;
    for (const int threads : {1, 2, 4}) {
        parallel::set_thread_count(threads);
        basin.state = middle;
        Scratch fresh;
        const StepReport report = basin.steps(7, fresh);
        const Moment moment{basin.model, initial, basin.state, &fresh, &report};
        readings.push_back(evaluate(wall, moment));
        readings.push_back(evaluate(block, moment));
    }
    parallel::set_thread_count(before);
    basin.state = middle;
    const StepReport report = basin.steps(7, scratch);
    const Moment moment{basin.model, initial, basin.state, &scratch, &report};
    for (std::size_t i = 0; i < readings.size(); i += 2) {
        EXPECT_EQ(readings[i], evaluate(wall, moment));
        EXPECT_EQ(readings[i + 1], evaluate(block, moment));
    }
    EXPECT_GT(readings[0], 1000);
    EXPECT_GT(readings[1], 1000);
}

TEST(WallPressure, a_gauge_in_the_water_goes_and_turns_with_the_body_that_it_names) {
    Basin basin;
    const BodyId block = basin.add_square(0.3, 700, {0.4, 0.8, 0}, {0.3, 0, 0}, 2);
    basin.fill_pool(1, 1);
    fluid::Gauge gauge{"velocity", &fluid::velocity_gauge, {0.05, -0.25, 0}, {}, {0, 1, 0}};  // below the block
    gauge.carrier = block.value;
    basin.model.output.gauges.push_back(gauge);
    const State initial = basin.state;
    Scratch scratch;
    const StepReport report = basin.steps(100, scratch);
    ASSERT_TRUE(report.status.ok());
    const Moment moment{basin.model, initial, basin.state, &scratch, &report};
    const Pose pose{basin.state.bodies.position[0], basin.state.bodies.orientation[0]};
    ASSERT_GT(norm(pose.position - initial.bodies.position[0]), 0.01);
    gauge.carrier = -1;
    gauge.point = to_world(pose, gauge.point);
    const auto expected = read_gauge(gauge, basin.model.particles()->settings(), basin.state.fluid);
    EXPECT_EQ(evaluate(find_column(basin.model, "velocity.x").value(), moment), expected[0]);
    EXPECT_EQ(evaluate(find_column(basin.model, "velocity.y").value(), moment), expected[1]);
    EXPECT_GT(std::hypot(expected[0], expected[1]), 0.01);
}

/// Momentum that a particle loses when it hits a wall at a given speed, and the impulse that gauges along the wall
/// read.
struct Hit {
    double lost, read;
};
Hit hit_wall(double speed, coupling::WallTreatment treatment) {
    Basin basin;
    basin.add_walls(1);
    basin.fill({0.7, 0.5, 0}, {0.7 + dp, 0.5 + dp, 0}, {1, 1, 0}, 2, {});
    basin.model.particles()->wall = treatment;
    if (treatment == coupling::WallTreatment::penalty) {
        basin.model.particles()->samples = {};
    }
    basin.model.particles()->sph().viscosity.get<fluid::ArtificialViscosity>().alpha = 0;  // gauges read pressure alone
    basin.state.fluid.velocity[0] = {speed, 0, 0};
    std::vector<Column> columns;
    constexpr double pitch = 0.2 * dp;
    for (double y = 0.525 - 5.1 * dp; y < 0.525 + 5 * dp; y += pitch) {
        columns.push_back(add_gauge(basin, {1, y, 0}));
    }
    const State initial = basin.state;
    Scratch scratch;
    double impulse = 0;
    while (basin.state.time * speed < 0.5) {
        const double before = basin.state.time;
        const StepReport report = basin.steps(1, scratch);
        EXPECT_TRUE(report.status.ok());
        const Moment moment{basin.model, initial, basin.state, &scratch, &report};
        for (const Column& column : columns) {
            impulse += pitch * evaluate(column, moment) * (basin.state.time - before);
        }
    }
    return {1000 * dp * dp * (speed - basin.state.fluid.velocity[0].x), impulse};
}

TEST(WallPressure, a_single_particle_that_hits_a_wall_gives_it_the_impulse_it_loses_and_no_more) {
    for (const coupling::WallTreatment treatment :
         {coupling::WallTreatment::boundary_particles, coupling::WallTreatment::penalty}) {
        for (const double speed : {0.5, 2.0, 10.0}) {  // the last is pressed to the guard of the face
            const Hit hit = hit_wall(speed, treatment);
            ASSERT_GT(hit.lost, 0.9 * 1000 * dp * dp * speed);
            EXPECT_NEAR(hit.read, hit.lost, 1e-3 * hit.lost) << speed;
        }
    }
}

}  // namespace
}  // namespace riprap::sim
