// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "riprap/fluid/open/leaving.hpp"
#include "riprap/fluid/open/open_boundary.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::fluid {
namespace {

SphSettings settings() {
    SphSettings s;
    s.spacing = 0.1;
    s.particle_mass = 10;
    s.sound_speed = 50;
    s.domain = {{-5, -5, 0}, {5, 5, 0}, {}, 2};
    return s;
}

Opening line(double x, double way) { return {"opening", {x, 0, 0}, {x, 1, 0}, 0, way}; }

/// A stream of one metre height: in at x = 0, out at x = 2.
OpenBoundaries stream(OutflowKind kind) {
    OpenBoundaries open;
    Inflow inflow{line(0, 1), 0.7, 0, {}};
    inflow.rows = rows_of(inflow.opening, settings(), {0, 1, 0}, 1e300);
    open.inflows.push_back(inflow);
    open.outflows.push_back({line(2, 1), kind, 0.7, 1, {0, 1, 0}, 9.81});
    open.most_particles = 10000;
    return open;
}

/// Steps of water that keeps its speed; all that happens is at the openings.
struct Stream {
    OpenBoundaries open;
    OpenState state;
    ParticleState water;
    BoundaryParticles walls;
    std::int64_t entered{0}, left{0};
    double energy{0}, time{0};

    explicit Stream(OutflowKind kind) : open(stream(kind)) {
        for (int i = 0; i < 20; ++i) {
            for (int j = 0; j < 10; ++j) {
                water.add({0.05 + 0.1 * i, 0.05 + 0.1 * j, 0}, {0.7, 0, 0}, 1000,
                          static_cast<std::int32_t>(water.size()));
            }
        }
        start_openings(open, settings(), water, state);
    }
    void step(double dt) {
        walls = {};
        place_openings(open, state, settings(), time, 0, walls);
        const std::size_t layers = walls.position.size();
        walls = {};
        place_openings(open, state, settings(), time + 0.5 * dt, 0.5 * dt, walls);
        ASSERT_EQ(walls.position.size(), layers);
        walls.pressure.assign(layers, 2000);
        for (Vec3& x : water.position) {
            x.x += 0.7 * dt;
        }
        time += dt;
        const Passage passage = pass_openings(open, settings(), walls, 0, {0, -9.81, 0}, time, dt, state, water);
        ASSERT_EQ(passage.problem, "");
        entered += passage.entered;
        left += passage.left;
        energy += passage.energy;
    }
};

TEST(OpenBoundary, an_inflow_continues_the_lattice_of_the_water_in_front_of_it) {
    Stream stream(OutflowKind::free);
    place_openings(stream.open, stream.state, settings(), 0, 0, stream.walls);
    ASSERT_EQ(stream.walls.size(), 4 * 10);  // three layers for the support, one that is on its way
    EXPECT_NEAR(stream.walls.position[0].x, -0.05, 1e-15);
    EXPECT_NEAR(stream.walls.position[0].y, 0.05, 1e-15);
    EXPECT_NEAR(stream.walls.position[39].x, -0.35, 1e-15);
    EXPECT_EQ(stream.walls.velocity[7], (Vec3{0.7, 0, 0}));
    EXPECT_LT(stream.walls.given_pressure[0], 0);
}

TEST(OpenBoundary, every_particle_in_and_out_is_counted_and_a_uniform_stream_stays_as_it_is) {
    Stream stream(OutflowKind::free);
    for (int k = 0; k < 1000; ++k) {
        stream.step(0.003 + 0.001 * std::sin(k));
    }
    EXPECT_EQ(stream.water.size(), 200 + stream.entered - stream.left);
    EXPECT_EQ(stream.entered, stream.state.entered[0]);
    EXPECT_EQ(stream.left, stream.state.left[0]);
    // 0.7 m/s over all that time, in layers of 10 particles; the first is half a spacing from the plane.
    EXPECT_EQ(stream.entered, 10 * static_cast<std::int64_t>(std::floor(0.7 * stream.time / 0.1 + 0.5)));
    EXPECT_EQ(stream.water.size(), 200);
    for (std::size_t i = 0; i < stream.water.position.size(); ++i) {
        const double x = stream.water.position[i].x;
        const double first = std::fmod(0.7 * stream.time + 0.05, 0.1);  // place of the newest layer
        EXPECT_NEAR(std::remainder(x - first, 0.1), 0, 1e-9);
    }
}

TEST(OpenBoundary, those_who_are_left_keep_their_order_and_all_that_is_theirs) {
    const auto rest_after = [](const std::vector<std::size_t>& gone) {
        ParticleState water;
        for (int i = 0; i < 100; ++i) {
            water.add({0.1 * i, 0, 0}, {0, 0.2 * i, 0}, 1000 + i, i);
        }
        leave_out(gone, water);
        std::vector<int> rest;
        for (std::size_t i = 0; i < water.position.size(); ++i) {
            const int id = water.id[i];
            EXPECT_EQ(water.position[i].x, 0.1 * id);
            EXPECT_EQ(water.velocity[i].y, 0.2 * id);
            EXPECT_EQ(water.density[i], 1000 + id);
            rest.push_back(id);
        }
        return rest;
    };
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < 100; ++i) {
        all.push_back(i);
    }
    for (const std::vector<std::size_t>& gone : {std::vector<std::size_t>{}, {0}, {99}, {0, 1, 50, 52, 98, 99}, all}) {
        std::vector<int> expected;
        for (int i = 0; i < 100; ++i) {
            if (!std::binary_search(gone.begin(), gone.end(), static_cast<std::size_t>(i))) {
                expected.push_back(i);
            }
        }
        EXPECT_EQ(rest_after(gone), expected) << gone.size() << " gone";
    }
}

TEST(OpenBoundary, no_two_particles_share_an_id) {
    Stream stream(OutflowKind::free);
    for (int k = 0; k < 400; ++k) {
        stream.step(0.004);
    }
    std::vector<std::int32_t> ids = stream.water.id;
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(std::unique(ids.begin(), ids.end()), ids.end());
    EXPECT_EQ(ids.back() + 1, stream.state.next_id);
}

TEST(OpenBoundary, water_enters_with_the_pressure_in_front_of_it_and_its_energy) {
    Stream stream(OutflowKind::free);
    stream.water = {};
    start_openings(stream.open, settings(), stream.water, stream.state);
    while (stream.entered == 0) {
        stream.step(0.01);
    }
    const double density = stream.water.density[0];
    const double a = 2000 / (1000 * 50.0 * 50.0);  // p/(rho c^2): (1 + 7 a)^(1/7) to second order
    EXPECT_NEAR(density, 1000 * (1 + a - 3 * a * a), 1e-4);
    // Half a metre is the mean height of the rows; compression adds p^2/(2 rho^2 c^2) per kilogram.
    const double compression = 2000.0 * 2000.0 / (2 * 1e6 * 2500.0);
    EXPECT_NEAR(stream.energy, 100 * (0.5 * 0.49 + 9.81 * 0.5 + compression), 1e-3);
}

TEST(OpenBoundary, an_outflow_of_a_level_pushes_back_with_the_pressure_of_still_water) {
    Stream stream(OutflowKind::level);
    // From the start: the mirror image of the water, on its lattice.
    ASSERT_EQ(stream.state.position.size(), 40U);
    double nearest = 9;
    for (const Vec3& x : stream.state.position) {
        nearest = std::min(nearest, x.x);
    }
    EXPECT_NEAR(nearest, 2.05, 1e-12);
    for (int k = 0; k < 200; ++k) {
        stream.step(0.01);
        ASSERT_LE(stream.state.position.size(), 50U);  // layers end after the support
        ASSERT_GE(stream.state.position.size(), 30U);
    }
    EXPECT_GT(stream.left, 0);
    place_openings(stream.open, stream.state, settings(), 0, 0, stream.walls = {});
    ASSERT_EQ(stream.walls.position.size(), 40 + stream.state.position.size());
    for (std::size_t w = 40; w < stream.walls.position.size(); ++w) {
        EXPECT_NEAR(stream.walls.given_pressure[w], 9810 * (1 - stream.walls.position[w].y), 1e-6);
    }
}

TEST(OpenBoundary, an_inflow_grows_over_its_ramp_as_its_distance_does) {
    const Inflow inflow{line(0, 1), 2, 3, {}};
    EXPECT_EQ(inflow.speed_at(0), 0);
    EXPECT_EQ(inflow.speed_at(9), 2);
    for (const double t : {0.5, 1.7, 2.999, 4.0}) {
        EXPECT_NEAR((inflow.distance_at(t + 1e-5) - inflow.distance_at(t - 1e-5)) / 2e-5, inflow.speed_at(t), 1e-8);
        EXPECT_NEAR((inflow.speed_at(t + 1e-5) - inflow.speed_at(t - 1e-5)) / 2e-5, inflow.acceleration_at(t), 1e-4);
    }
}

TEST(OpenBoundary, more_particles_than_allowed_end_the_run) {
    Stream stream(OutflowKind::free);
    stream.open.most_particles = 205;
    stream.open.outflows.clear();
    start_openings(stream.open, settings(), stream.water, stream.state);
    Passage passage;
    for (double time = 0; passage.problem.empty() && time < 9; time += 0.01) {
        stream.walls = {};
        place_openings(stream.open, stream.state, settings(), time, 0, stream.walls);
        stream.walls.pressure.assign(stream.walls.position.size(), 0);
        passage = pass_openings(stream.open, settings(), stream.walls, 0, {}, time, 0.01, stream.state, stream.water);
    }
    EXPECT_NE(passage.problem.find("210 particles"), std::string::npos) << passage.problem;
}

}  // namespace
}  // namespace riprap::fluid
