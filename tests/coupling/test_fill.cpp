// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "coupling/tank_scenes.hpp"
#include "riprap/core/error.hpp"
#include "riprap/coupling/fill.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"

namespace riprap::coupling {
namespace {

using test::Scene;

constexpr double dp = 0.05;
const Vec3 up{0, 0, 1};

fluid::SphSettings settings_of(const Vec3& low, const Vec3& high, int dimension = 3) {
    fluid::SphSettings settings;
    settings.spacing = dp;
    settings.sound_speed = 40;
    settings.domain = {low, high, {}, dimension};
    return settings;
}

geometry::Polyhedron box(const Vec3& low, const Vec3& high) {
    return geometry::moved(geometry::box(high - low), {0.5 * (low + high), {}});
}

Filling fill(const Scene& scene, const fluid::SphSettings& settings, const std::vector<FillRegion>& regions,
             std::int64_t limit = 1'000'000) {
    return fill(scene.shapes, scene.bodies, scene.state, settings, up, regions, {limit, limit});
}

TEST(Fill, a_box_that_the_lattice_fits_is_filled_to_its_volume) {
    const Filling filling = fill({}, settings_of({0, 0, 0}, {2, 2, 2}), {{{box({0, 0, 0}, {0.5, 0.25, 0.4})}}});
    EXPECT_EQ(filling.particles.size(), 10 * 5 * 8);
    EXPECT_NEAR(filling.regions[0].volume, 0.05, 1e-12);
    EXPECT_NEAR(filling.regions[0].region_volume, 0.05, 1e-12);
    EXPECT_EQ(filling.particles.position[0], (Vec3{0.025, 0.025, 0.025}));
}

// Two metres at a spacing of 0.16 m began 1.92 m deep.
TEST(Fill, a_pond_has_its_volume_whatever_the_spacing) {
    for (const double depth : {0.25, 0.252, 0.26, 0.275, 0.29}) {
        Scene floor;
        floor.add_half_space({0, 0, 1}, 0);
        const Filling pond = fill(floor, settings_of({0, 0, 0}, {2, 2, 2}), {{{box({0, 0, 0}, {2, 1.5, 1})}, depth}});
        EXPECT_NEAR(pond.regions[0].volume, depth * 2 * 1.5, 1e-3 * dp * 2 * 1.5) << depth;
        EXPECT_NEAR(pond.regions[0].surface, depth, 1e-12);
    }
}

TEST(Fill, what_a_last_layer_has_is_spread_evenly) {
    const Filling pond = fill({}, settings_of({0, 0, 0}, {2, 2, 2}), {{{box({0, 0, 0}, {2, 2, 1})}, 0.525}});
    std::array<int, 16> count{};  // of the particles of the last layer in squares of 10 by 10 places
    for (const Vec3& x : pond.particles.position) {
        if (x.z > 0.5) {
            count[static_cast<std::size_t>(x.x / 0.5) + 4 * static_cast<std::size_t>(x.y / 0.5)] += 1;
        }
    }
    for (const int n : count) {
        EXPECT_NEAR(n, 50, 3);
    }
}

TEST(Fill, a_region_below_whose_level_nothing_lies_does_not_move_the_lattice_of_others) {
    const std::vector<FillRegion> regions{{{box({0, 0, 0}, {0.5, 0.5, 0.5})}, -1},
                                          {{box({0, 0, 0}, {0.5, 0.25, 0.4})}}};
    const Filling filling = fill({}, settings_of({0, 0, 0}, {2, 2, 2}), regions);
    EXPECT_EQ(filling.particles.size(), 10 * 5 * 8);
    EXPECT_EQ(filling.lattice_corner, (Vec3{0, 0, 0}));
}

TEST(Fill, water_stays_a_quarter_of_a_spacing_away_from_every_solid) {
    Scene scene;
    scene.add(geometry::icosahedron(0.2), {{0.5, 0.5, 0.5}, from_rotation_vector({0.3, 0.2, 0.1})});
    scene.add(geometry::cube(0.21), {{0.3, 0.7, 0.3}, from_rotation_vector({0.1, -0.5, 0.4})});
    scene.add_half_space({0.1, 0, 1}, 0.1);
    const Filling filling = fill(scene, settings_of({0, 0, 0}, {1, 1, 1}), {{{}, 0.8}});
    EXPECT_GT(filling.particles.size(), 4000);
    double nearest = 1;
    for (const Vec3& x : filling.particles.position) {
        for (std::int32_t b = 0; b < 3; ++b) {
            const auto i = static_cast<std::size_t>(b);
            const Vec3 local = to_body({scene.state.position[i], scene.state.orientation[i]}, x);
            nearest = std::min(nearest, geometry::closest_surface_point(scene.shapes.view(ShapeId{b}), local).distance);
        }
        EXPECT_LE(x.z, 0.8 + 0.5 * dp);
    }
    EXPECT_GE(nearest, (0.25 - 1e-6) * dp);
    EXPECT_LT(nearest, 0.35 * dp);  // and fills the rest
}

// Places keep a quarter of a spacing from a slope: a lake over ground began a quarter of a layer too low.
TEST(Fill, the_surface_rises_by_what_slopes_leave_out) {
    constexpr int slopes = 40;
    for (int k = 0; k < slopes; ++k) {
        Scene scene;
        const double angle = 0.1 + 0.025 * k;
        const Vec3 normal{-std::sin(angle), 0, std::cos(angle)};
        scene.add_half_space(normal, 0.45 * normal.z + 0.5 * normal.x + 1e-3 * k * dp);  // through the tank
        const Filling filling = fill(scene, settings_of({0, 0, 0}, {1, 1, 4}), {{{box({0, 0, 0}, {1, 1, 2.5})}}});
        const double mean_height = (0.45 * normal.z + 1e-3 * k * dp) / normal.z;  // of the slope, in the tank
        const double low = mean_height - 0.5 * std::tan(angle), high = mean_height + 0.5 * std::tan(angle);
        const double over = low < 0 ? 0.5 * low * low / std::tan(angle) : 0;  // of the line below the floor
        ASSERT_LT(high, 2.4);
        const double room = 2.5 - mean_height - over;
        EXPECT_NEAR(filling.regions[0].volume, room, 0.01 * dp) << angle;
        EXPECT_NEAR(filling.regions[0].room, room, 0.01 * dp) << angle;
        EXPECT_NEAR(filling.regions[0].surface, 2.5, 1e-12);
    }
}

TEST(Fill, the_level_holds_over_a_floor_that_no_cell_follows) {
    for (const double offset : {0.1, 0.3, 0.6, 0.9}) {
        Scene scene;
        scene.add_half_space({0, 0, 1}, offset * dp);
        const Filling filling = fill(scene, settings_of({0, 0, 0}, {1, 1, 1}), {{{}, 0.5}});
        EXPECT_NEAR(filling.regions[0].volume, 0.5 - offset * dp, 0.01 * dp) << offset;
    }
}

// Two blocks of 12 x 12 cells leave a gap of 0.4 spacings between them: 58 cells, 18 of them along its rim.
TEST(Fill, a_gap_too_narrow_for_water_raises_the_surface_by_its_rim_alone) {
    Scene scene;
    scene.add(geometry::box({0.6, 0.49, 0.6}), {{0.5, 0.245, 0.5}, {}});
    scene.add(geometry::box({0.6, 0.49, 0.6}), {{0.5, 0.755, 0.5}, {}});
    const Filling filling = fill(scene, settings_of({0, 0, 0}, {1, 1, 1}), {{{}, 0.9}});
    EXPECT_NEAR(static_cast<double>(filling.particles.size()), 20 * 20 * 18 - 12 * 12 * 20, 22);
}

TEST(Fill, regions_that_overlap_share_one_lattice_and_the_first_gives_its_velocity) {
    const std::vector<FillRegion> regions{{{box({0, 0, 0}, {0.5, 0.5, 0.5})}, 9, {1, 0, 0}},
                                          {{box({0.13, 0, 0}, {1, 0.5, 0.25})}}};
    const Filling filling = fill({}, settings_of({0, 0, 0}, {1, 1, 1}), regions);
    EXPECT_EQ(filling.particles.size(), 10 * 10 * 10 + 10 * 10 * 5);
    EXPECT_EQ(filling.regions[0].count, 1000);
    EXPECT_EQ(filling.particles.velocity[0], (Vec3{1, 0, 0}));
    EXPECT_EQ(filling.particles.velocity[19], (Vec3{}));
}

TEST(Fill, density_at_rest_gives_hydrostatic_pressure_through_the_state_equation) {
    for (const auto equation : {fluid::StateEquation::tait, fluid::StateEquation::linear}) {
        fluid::SphSettings settings = settings_of({0, 0, 0}, {1, 1, 1});
        settings.state_equation = equation;
        Filling filling = fill({}, settings, {{{}, 0.6}});
        set_hydrostatic_density(filling, settings, {0, 0, -9.81});
        for (std::size_t i = 0; i < filling.particles.density.size(); ++i) {
            const double ratio = filling.particles.density[i] / 1000;
            const double c2 = 40.0 * 40.0;
            const double pressure = equation == fluid::StateEquation::tait ? 1000 * c2 / 7 * (std::pow(ratio, 7) - 1)
                                                                           : c2 * (filling.particles.density[i] - 1000);
            EXPECT_NEAR(pressure, 1000 * 9.81 * (0.6 - filling.particles.position[i].z), 1e-6);
        }
    }
}

TEST(Fill, a_planar_tank_is_filled_per_metre_of_width) {
    Scene scene;
    scene.bodies.is_planar = true;
    const fluid::SphSettings settings = settings_of({0, 0, 0}, {1, 1, 0}, 2);
    const Filling filling = fill(scene.shapes, scene.bodies, scene.state, settings, {0, 1, 0},
                                 std::vector<FillRegion>{{{}, 0.5}}, {1000, 1000});
    EXPECT_EQ(filling.particles.size(), 20 * 10);
    EXPECT_NEAR(filling.regions[0].region_volume, 0.5, 1e-12);
    EXPECT_EQ(filling.particles.position[0].z, 0);
}

TEST(Fill, too_many_particles_are_refused) {
    const std::vector<FillRegion> regions{{{}, 1}};
    EXPECT_THROW(fill({}, settings_of({0, 0, 0}, {1, 1, 1}), regions, 7999), CaseError);
    EXPECT_EQ(fill({}, settings_of({0, 0, 0}, {1, 1, 1}), regions, 8000).particles.size(), 8000);
    EXPECT_THROW(fill({}, settings_of({0, 0, 0}, {1e6, 1e6, 1e6}), regions, 8000), CaseError);
}

// A spacing a thousand times too small kept `check` counting for minutes.
TEST(Fill, counting_ends_where_the_limit_is_passed) {
    EXPECT_THAT(
        [] {
            fill({}, settings_of({0, 0, 0}, {10, 10, 10}), {{{}, 10}}, 1'000'000);
        },
        ::testing::ThrowsMessage<CaseError>(::testing::HasSubstr("more than 1000000 particles")));
}

TEST(Fill, a_period_that_the_lattice_does_not_fit_is_refused) {
    fluid::SphSettings settings = settings_of({0, 0, 0}, {1.02, 1, 1});
    settings.domain.is_periodic[0] = true;
    EXPECT_THROW(fill({}, settings, {{{}, 1}}), CaseError);
}

}  // namespace
}  // namespace riprap::coupling
