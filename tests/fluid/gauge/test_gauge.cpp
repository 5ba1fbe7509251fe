// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/gauge/gauge_kinds.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "riprap/core/selection.hpp"
#include "riprap/fluid/particle/state_equation.hpp"

namespace riprap::fluid {
namespace {

/// Water 1 x 0.5 (x 0.5 in 3D) on a lattice, lower corner at the origin, up is +y in 2D and +z in 3D.
struct Tank {
    SphSettings settings;
    ParticleState state;

    explicit Tank(int dimension, double spacing = 0.02) {
        settings.spacing = spacing;
        settings.sound_speed = 30;
        settings.domain.dimension = dimension;
        settings.particle_mass = settings.rest_density * std::pow(spacing, dimension);
        const auto count = [&](double length) { return static_cast<int>(std::lround(length / spacing)); };
        for (int k = 0; k < (dimension == 3 ? count(0.5) : 1); ++k) {
            for (int j = 0; j < count(0.5); ++j) {
                for (int i = 0; i < count(1); ++i) {
                    const double z = dimension == 3 ? (k + 0.5) * spacing : 0.0;
                    state.add({(i + 0.5) * spacing, (j + 0.5) * spacing, z}, {}, settings.rest_density, 0);
                }
            }
        }
    }
    Vec3 up() const { return settings.domain.dimension == 2 ? Vec3{0, 1, 0} : Vec3{0, 0, 1}; }
    double read(const GaugeKind* kind, const Vec3& point, const Vec3& end = {}) const {
        return read_gauge({"gauge", kind, point, end, up()}, settings, state)[0];
    }
};

TEST(Gauge, a_linear_velocity_field_is_read_exactly_inside_on_walls_and_in_corners) {
    for (const int dimension : {2, 3}) {
        Tank tank(dimension);
        const auto field = [](const Vec3& x) { return Vec3{1 + 2 * x.x - x.y + 3 * x.z, x.y, -x.x}; };
        for (std::size_t j = 0; j < tank.state.position.size(); ++j) {
            tank.state.velocity[j] = field(tank.state.position[j]);
        }
        const double z = dimension == 3 ? 0.21 : 0.0;
        for (const Vec3 x : {Vec3{0.5, 0.25, z}, Vec3{0.0, 0.25, z}, Vec3{1.0, 0.0, z}}) {
            const auto v = read_gauge({"v", &velocity_gauge, x, {}, tank.up()}, tank.settings, tank.state);
            EXPECT_NEAR(v[0], field(x).x, 1e-12);
            EXPECT_NEAR(v[1], field(x).y, 1e-12);
        }
    }
}

// A line that ended at 1e300 m took the program down, and one of 1e5 m never came to an end.
TEST(Gauge, a_line_far_longer_than_the_water_reads_what_a_short_one_does) {
    const Tank tank(2);
    for (const GaugeKind* kind : {&surface_gauge, &run_up_gauge}) {
        const double level = tank.read(kind, {0.5, 0.1, 0}, {0.5, 1, 0});
        EXPECT_NEAR(level, 0.4, 0.002);
        EXPECT_NEAR(tank.read(kind, {0.5, 0.1, 0}, {0.5, 1e5, 0}), level, 1e-4);
        EXPECT_NEAR(tank.read(kind, {0.5, 0.1, 0}, {0.5, 1e12, 0}), level, 1e-3);
        EXPECT_EQ(tank.read(kind, {0.5, 3, 0}, {0.5, 1e12, 0}), 0);
    }
    Tank ring(2);  // wet all the way, for ever
    ring.settings.domain.high = {1, 1, 0};
    ring.settings.domain.is_periodic[0] = true;
    EXPECT_EQ(ring.read(&surface_gauge, {0.5, 0.2, 0}, {1e9, 0.2, 0}), 1e9 - 0.5);
}

TEST(Gauge, one_that_a_body_carries_reads_where_the_body_has_taken_it) {
    const Tank tank(2);
    const Gauge fixed{"level", &level_gauge, {0.3, 0.2, 0}, {}, tank.up()};
    Gauge gauge = fixed;
    gauge.carrier = 1;
    gauge.point = {0, 0.4, 0};  // from a body that has turned by a quarter: 0.4 m to the left of its centre
    const std::vector<Vec3> position{{}, {0.7, 0.2, 0}};
    const std::vector<Quat> orientation{{}, from_rotation_vector({0, 0, std::numbers::pi / 2})};
    const Gauge now = carried(gauge, position, orientation);
    EXPECT_NEAR(norm(now.point - fixed.point), 0, 1e-15);
    EXPECT_NEAR(read_gauge(now, tank.settings, tank.state)[0], 0.3, 1e-3);  // half a metre of water, from 0.2 m up
    EXPECT_EQ(carried(fixed, position, orientation).point, fixed.point);
}

// One metre of water that repeats: there is no first place and no last.
TEST(Gauge, in_still_periodic_water_no_reading_depends_on_the_place) {
    for (const int dimension : {2, 3}) {
        Tank tank(dimension, 0.05);
        tank.settings.domain = {{0, 0, 0}, {1, 1, 1}, {true, false, false}, dimension};
        const double depth = 0.5;
        for (std::size_t j = 0; j < tank.state.position.size(); ++j) {
            const double height = dimension == 3 ? tank.state.position[j].z : tank.state.position[j].y;
            tank.state.density[j] = density_of(tank.settings, 1000 * 9.81 * (depth - height));
            tank.state.velocity[j] = {0.3, 0, 0};
        }
        const double y = dimension == 3 ? 0.25 : 0.0;
        const auto read = [&](const GaugeKind* kind, double x, double low, double high, double width = 0) {
            const Vec3 point = dimension == 3 ? Vec3{x, width > 0 ? 0 : y, low} : Vec3{x, low, 0};
            const Vec3 end = dimension == 3 ? Vec3{x + width, width > 0 ? 0.5 : y, high} : Vec3{x + width, high, 0};
            return tank.read(kind, point, end);
        };
        const auto flow_at = [&](double x) {
            const Vec3 top = dimension == 3 ? Vec3{x, 0.5, 0.8} : Vec3{x, 0.8, 0};
            return tank.read(&flow_gauge, {x, 0, 0}, top);
        };
        for (const double x : {0.0, 0.05, 0.95, 1.0}) {  // places that lie alike between particles
            const double middle = 0.5;
            EXPECT_NEAR(read(&pressure_gauge, x, 0.2, 0.2), read(&pressure_gauge, middle, 0.2, 0.2), 1e-8);
            EXPECT_NEAR(read(&pressure_gauge, x, 0.2, 0.2), 9810 * 0.3, 1);
            EXPECT_NEAR(read(&velocity_gauge, x, 0.2, 0.2), 0.3, 1e-12);
            EXPECT_NEAR(read(&level_gauge, x, 0, 0), read(&level_gauge, middle, 0, 0), 1e-12);
            EXPECT_NEAR(read(&level_gauge, x, 0, 0), depth, 2e-3);
            EXPECT_NEAR(read(&surface_gauge, x, 0.1, 0.9), read(&surface_gauge, middle, 0.1, 0.9), 1e-12);
            EXPECT_NEAR(read(&run_up_gauge, x, 0.1, 0.9), read(&run_up_gauge, middle, 0.1, 0.9), 1e-12);
            EXPECT_NEAR(flow_at(x), flow_at(middle), 1e-12);
        }
        // A box across the seam holds what the same box holds elsewhere; one wider than the domain holds all, once.
        EXPECT_NEAR(read(&volume_gauge, 0.9, 0, 1, 0.2), read(&volume_gauge, 0.4, 0, 1, 0.2), 1e-12);
        EXPECT_NEAR(read(&volume_gauge, -0.5, 0, 1, 2), read(&volume_gauge, 0, 0, 1, 1), 1e-12);
    }
}

TEST(Gauge, hydrostatic_pressure_is_read_on_the_bed_of_a_tank) {
    Tank tank(2);
    const double depth = 0.5;
    for (std::size_t j = 0; j < tank.state.position.size(); ++j) {
        const double p = 1000 * 9.81 * (depth - tank.state.position[j].y);
        tank.state.density[j] = density_of(tank.settings, p);
    }
    EXPECT_NEAR(tank.read(&pressure_gauge, {0.5, 0, 0}), 1000 * 9.81 * depth, 1e-3);
    EXPECT_NEAR(tank.read(&pressure_gauge, {0, 0.1, 0}), 1000 * 9.81 * 0.4, 1e-3);
}

TEST(Gauge, levels_integrate_the_water_and_surfaces_find_its_edge) {
    const Tank tank(2);
    EXPECT_NEAR(tank.read(&level_gauge, {0.5, 0, 0}), 0.5, 1e-12);
    EXPECT_NEAR(tank.read(&surface_gauge, {0.5, 0.1, 0}, {0.5, 0.9, 0}), 0.4, 1e-3);
    EXPECT_NEAR(tank.read(&run_up_gauge, {0.5, 0.1, 0}, {0.5, 0.9, 0}), 0.4, 1e-3);
    const Tank deep(3);
    EXPECT_NEAR(deep.read(&level_gauge, {0.5, 0.25, 0}), 0.5, 1e-12);
}

TEST(Gauge, a_void_lowers_the_level_but_not_the_surface) {
    Tank tank(2);
    ParticleState holed = tank.state;
    holed.position.clear();
    for (const Vec3& x : tank.state.position) {
        if (x.y < 0.2 || x.y > 0.3) {
            holed.position.push_back(x);
        }
    }
    holed.density.resize(holed.position.size());
    tank.state = holed;
    EXPECT_NEAR(tank.read(&level_gauge, {0.5, 0, 0}), 0.4, 1e-12);
    EXPECT_NEAR(tank.read(&surface_gauge, {0.5, 0.1, 0}, {0.5, 0.9, 0}), 0.4, 1e-3);
    EXPECT_NEAR(tank.read(&run_up_gauge, {0.5, 0.1, 0}, {0.5, 0.9, 0}), 0.1, 1e-3);
}

TEST(Gauge, a_uniform_stream_flows_through_a_section_at_speed_times_area) {
    for (const int dimension : {2, 3}) {
        Tank tank(dimension);
        for (Vec3& v : tank.state.velocity) {
            v = {1.5, 0.2, 0};
        }
        const double area = dimension == 2 ? 0.5 : 0.25;
        EXPECT_NEAR(tank.read(&flow_gauge, {0.5, 0, 0}, {0.5, 0.5, 0.5}), 1.5 * area, 1e-12);
    }
}

// Particles were counted by their centres: 0.154 for 0.160, as a side that cuts the water was off by half a layer.
TEST(Gauge, a_box_that_cuts_the_water_anywhere_has_its_volume) {
    for (const int dimension : {2, 3}) {
        const Tank tank(dimension, 0.05);
        const double deep = dimension == 3 ? 0.5 : 1;
        for (const double shift : {0.0, 0.007, 0.02, 0.025, 0.03, 0.049}) {
            const Vec3 low{0.2 + shift, 0.1 + shift, 0}, high{0.7 + shift, 0.4, 1};
            EXPECT_NEAR(tank.read(&volume_gauge, low, high), 0.5 * (0.3 - shift) * deep, 1e-12) << shift;
        }
        // What reaches from wall to wall and out of the water holds all of it.
        EXPECT_NEAR(tank.read(&volume_gauge, {0, 0, 0}, {1, 0.5, 1}), 0.5 * deep, 1e-12);
        EXPECT_NEAR(tank.read(&volume_gauge, {-1, -1, -1}, {2, 2, 2}), 0.5 * deep, 1e-12);
        EXPECT_NEAR(tank.read(&volume_gauge, {0, 0, 0}, {0.33, 2, 2}), 0.33 * 0.5 * deep, 1e-12);
        EXPECT_NEAR(tank.read(&volume_gauge, {0.4, 0.2, 0}, {0.41, 0.21, 0.5}), 1e-4 * deep, 1e-12);
    }
}

TEST(Gauge, particles_that_are_pressed_to_a_wall_count_whole_in_a_box_that_ends_there) {
    Tank tank(2, 0.05);
    for (Vec3& x : tank.state.position) {
        x.y *= 0.96;
    }
    EXPECT_NEAR(tank.read(&volume_gauge, {0, 0, 0}, {1, 1, 0}), 0.5, 1e-12);
    EXPECT_NEAR(tank.read(&volume_gauge, {0.3, 0, 0}, {0.5, 1, 0}), 0.1, 1e-12);
}

TEST(Gauge, the_water_in_a_box_has_its_volume_and_a_dry_place_reads_nothing) {
    const Tank tank(3);
    EXPECT_NEAR(tank.read(&volume_gauge, {0.8, 0, 0}, {2, 1, 1}), 0.2 * 0.25, 1e-12);
    for (const GaugeKind* kind : {&pressure_gauge, &velocity_gauge, &level_gauge}) {
        EXPECT_EQ(tank.read(kind, {3, 0.25, 0.25}), 0);
    }
    EXPECT_EQ(tank.read(&surface_gauge, {3, 0.25, 0}, {3, 0.25, 1}), 0);
}

TEST(Gauge, the_water_in_a_box_has_its_middle_and_its_mean_velocity) {
    for (const int dimension : {2, 3}) {
        Tank tank(dimension);
        for (std::size_t i = 0; i < tank.state.position.size(); ++i) {
            tank.state.velocity[i] = {2 * tank.state.position[i].y, 0.5, 0};
        }
        EXPECT_NEAR(tank.read(&centre_gauge, {0.2, 0.1, 0}, {0.6, 0.3, 1}), 0.4, 1e-12);
        EXPECT_NEAR(tank.read(&mean_velocity_gauge, {0.2, 0.1, 0}, {0.6, 0.3, 1}), 2 * 0.2, 1e-12);
        EXPECT_EQ(tank.read(&centre_gauge, {3, 0, 0}, {4, 1, 1}), 0) << "no water";
    }
}

// Whoever reads a gauge looks at the water near it alone, one particle by another; all particles are asked on all
// threads whether they are near.
TEST(Gauge, a_reading_looks_at_few_of_the_particles_and_has_the_same_bits_on_any_threads) {
    Tank tank(2, 0.004);
    const std::int64_t all = tank.state.size();
    for (std::size_t j = 0; j < tank.state.position.size(); ++j) {
        const Vec3& x = tank.state.position[j];
        tank.state.velocity[j] = {std::sin(7 * x.x + x.y), std::cos(5 * x.y), 0};
        tank.state.density[j] *= 1 + 1e-3 * std::sin(11 * x.x * x.y);
    }
    const Vec3 low{0.4, 0.2, 0}, high{0.5, 0.3, 0};
    for (const GaugeKind* kind : {&pressure_gauge, &velocity_gauge, &level_gauge, &surface_gauge, &run_up_gauge,
                                  &flow_gauge, &volume_gauge, &centre_gauge, &mean_velocity_gauge}) {
        const bool is_section = kind == &flow_gauge;
        const bool is_line = kind == &surface_gauge || kind == &run_up_gauge;
        const Vec3 end = is_section ? Vec3{0.4, 0.5, 0} : is_line ? Vec3{0.4, 0.9, 0} : high;
        parallel::set_thread_count(1);
        const std::int64_t before = parallel::entries_selected();
        const double value = tank.read(kind, low, end);
        const std::int64_t looks = parallel::entries_selected() - before;
        EXPECT_NE(value, 0) << kind->word;
        EXPECT_GT(looks, 0) << kind->word;
        EXPECT_LT(looks, all / 20) << kind->word;
        for (const int threads : {2, 4}) {
            parallel::set_thread_count(threads);
            EXPECT_EQ(tank.read(kind, low, end), value) << kind->word << ", " << threads << " threads";
        }
    }
    parallel::set_thread_count(1);
}

TEST(Gauge, every_kind_is_found_by_its_name) {
    for (const char* name : {"pressure", "velocity", "level", "surface", "run_up", "flow", "volume", "centre",
                             "mean_velocity", "flow_error", "changed", "wall_pressure"}) {
        const GaugeKind* kind = find_gauge_kind(name);
        ASSERT_NE(kind, nullptr) << name;
        EXPECT_EQ(kind->word, name);
    }
    EXPECT_EQ(find_gauge_kind("temperature"), nullptr);
}

}  // namespace
}  // namespace riprap::fluid
