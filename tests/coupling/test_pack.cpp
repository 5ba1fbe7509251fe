// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/pack.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "coupling/tank_scenes.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/coupling/fill.hpp"
#include "riprap/coupling/pack_sums.hpp"
#include "riprap/coupling/samples/sample_shapes.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"

namespace riprap::coupling {
namespace {

constexpr double dp = 0.05;

/// A tank of 1 x 1 (x 0.6) m, filled to `level`, whose lattice fits its floor and walls.
struct Tank : test::Scene {
    fluid::SphSettings settings;
    Vec3 up{0, 1, 0};
    double level = 0.8;

    explicit Tank(int dimension, double ratio = 1.5) {
        bodies.is_planar = dimension == 2;
        settings.spacing = dp;
        settings.smoothing_ratio = ratio;
        settings.sound_speed = 40;
        settings.domain = {
            {-0.2, -0.2, dimension == 3 ? -0.2 : 0}, {1.2, 1.2, dimension == 3 ? 0.8 : 0}, {}, dimension};
    }
    void add_walls(double floor = 0, double right = 1) {
        add_half_space({0, 1, 0}, floor);
        add_half_space({1, 0, 0}, 0);
        add_half_space({-1, 0, 0}, -right);
        if (settings.domain.dimension == 3) {
            add_half_space({0, 0, 1}, 0);
            add_half_space({0, 0, -1}, -0.6);
        }
    }
    /// The region spans the tank whatever stands in it.
    FillRegion region() const {
        const bool is_planar = bodies.is_planar;
        const Vec3 low{0, 0, is_planar ? -0.5 : 0}, high{1, 1, is_planar ? 0.5 : 0.6};
        return {{geometry::moved(geometry::box(high - low), {0.5 * (low + high), {}})}, level};
    }
    Filling filled(FillFaces faces = FillFaces::fitted) const {
        return fill(shapes, bodies, state, settings, up, std::vector<FillRegion>{region()}, {1'000'000, 1'000'000},
                    faces);
    }
    Packed packed(Filling& filling) const {
        const SampleSet samples =
            sample_shapes(shapes, bodies, state,
                          {dp, settings.support_radius(), settings.domain, filling.lattice_corner, 1'000'000, {}, {}});
        return pack(shapes, bodies, state, settings, samples, std::vector<FillRegion>{region()}, filling);
    }
    double nearest_face(const Vec3& x) const {
        double nearest = 1;
        for (const body::Part& part : bodies.parts) {
            const auto b = static_cast<std::size_t>(part.body.value);
            const Vec3 local = to_body({state.position[b], state.orientation[b]}, x);
            nearest = std::min(nearest, geometry::closest_surface_point(shapes.view(part.shape), local).distance);
        }
        return nearest;
    }
    Packed expect_even(double room, double slack) const {
        Filling filling = filled();
        EXPECT_NEAR(filling.regions[0].volume, room, slack);
        const Packed result = packed(filling);
        EXPECT_LT(result.unevenness, 1.5e-3);
        for (std::size_t i = 0; i < filling.particles.position.size(); ++i) {
            const Vec3& x = filling.particles.position[i];
            EXPECT_GE(nearest_face(x), (0.25 - 1e-5) * dp);
            EXPECT_LT(std::abs(result.lack[i]), 0.05) << x.x << ' ' << x.y << ' ' << x.z;
            EXPECT_LT(x.y, level + 0.5 * dp);
        }
        return result;
    }
};

Pose at(double x, double y, double angle, double z = 0) { return {{x, y, z}, from_rotation_vector({0, 0, angle})}; }

geometry::Polyhedron disc(double radius) {
    std::vector<geometry::Point2> corners;
    for (int k = 0; k < 48; ++k) {
        const double turn = 2 * std::numbers::pi * k / 48;
        corners.push_back({radius * std::cos(turn), radius * std::sin(turn)});
    }
    return geometry::planar_prism(corners).value();
}

geometry::Polyhedron rectangle(double a, double b) {
    const std::vector<geometry::Point2> corners{{-a, -b}, {a, -b}, {a, b}, {-a, b}};
    return geometry::planar_prism(corners).value();
}

// A floor between two rows, a wall half a cell off, an oblique and a round body: at all of them a void began.
TEST(Pack, water_is_even_beside_faces_that_the_lattice_does_not_follow) {
    for (const double ratio : {1.05, 1.5}) {
        for (const double off : {0.3, 0.5, 0.9}) {
            Tank tank(2, ratio);
            tank.add_walls(off * dp, 1 - 0.5 * off * dp);
            tank.expect_even((0.8 - off * dp) * (1 - 0.5 * off * dp), 3 * dp * dp);
        }
        Tank with_box(2, ratio);
        with_box.add_walls();
        with_box.add(rectangle(0.15, 0.1), at(0.5, 0.4, 0.6));
        with_box.expect_even(0.8 - 4 * 0.15 * 0.1, 2 * dp * dp);
        Tank with_disc(2, ratio);
        with_disc.add_walls();
        with_disc.add(disc(0.2), at(0.47, 0.41, 0));
        with_disc.expect_even(0.8 - 24 * std::sin(2 * std::numbers::pi / 48) * 0.04, 2 * dp * dp);
    }
}

/// The least distance between two particles [m].
double least_distance(const std::vector<Vec3>& position) {
    double least = 1;
    for (std::size_t i = 0; i < position.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            least = std::min(least, norm(position[i] - position[j]));
        }
    }
    return least;
}

// The slope of the kernel vanishes where two particles share a place: three stayed in one corner of a tank.
TEST(Pack, pairs_nearer_than_half_a_spacing_push_each_other_away) {
    const double volume = dp * dp * dp;
    const fluid::WendlandC2 kernel(2 * dp, 3);
    const auto push = [&](double share) {
        const double r = share * dp;
        double sum[3] = {0, 0, 0};
        const double d[3] = {0, r, 0};
        fluid::PackedSlope::of(kernel, dp, volume).operator()<3, double>(nullptr, nullptr, d, r * r, r, sum);
        return -volume * dp * (sum[1] - kernel.slope_over_r(r) * r);
    };
    EXPECT_NEAR(push(0.25), 0.25, 1e-12);
    EXPECT_NEAR(push(0.01), 0.49, 1e-12);
    EXPECT_EQ(push(0.51), 0);
}

// Along the edge of a floor and a wall that halves cells, rows that were too full went into the walls, and were put
// back to one place: at rest by the smooth weight, thrown out by the published one.
TEST(Pack, no_two_particles_share_a_place_in_corners_of_tanks) {
    for (const auto& [ratio, off] : {std::pair{1.05, 0.25}, {1.5, 0.5}, {1.55, 0.75}}) {
        Tank tank(3, ratio);
        tank.add_walls(0, 1 - off * dp);
        Filling filling = tank.filled();
        tank.packed(filling);
        EXPECT_GT(least_distance(filling.particles.position), 0.5 * dp) << ratio << ' ' << off;
    }
}

TEST(Pack, water_is_even_about_bodies_in_space) {
    Tank with_ball(3);
    with_ball.add_walls();
    with_ball.add(geometry::icosahedron(0.2), {{0.5, 0.4, 0.3}, from_rotation_vector({0.3, 0.2, 0.1})});
    const double ball = geometry::mass_properties(geometry::icosahedron(0.2)).volume;
    const Packed about_ball = with_ball.expect_even(0.8 * 0.6 - ball, 4 * dp * dp * dp);
    Tank with_cube(3);
    with_cube.add_walls();
    with_cube.add(geometry::cube(0.25), {{0.5, 0.41, 0.3}, {}});
    const Packed about_cube = with_cube.expect_even(0.8 * 0.6 - 0.25 * 0.25 * 0.25, 4 * dp * dp * dp);
    // Both have pockets that stay uneven: sweeps end where they gain no more.
    for (const Packed& packed : {about_ball, about_cube}) {
        EXPECT_GT(packed.unevenness, 1e-4);
        EXPECT_GT(packed.sweeps, 110);
        EXPECT_LT(packed.sweeps, 190);
    }
}

// The rows above and below were left out: the surface rose by half a row, and two voids of half a row closed.
TEST(Pack, faces_on_rows_have_half_of_these_rows) {
    Tank tank(2);
    tank.add_walls();
    tank.add(rectangle(0.25, 0.125), at(0.5, 0.4, 0));
    const Filling filling = tank.filled();
    const auto in_row = [&](double y) {
        return std::ranges::count_if(filling.particles.position, [&](const Vec3& x) {
            return std::abs(x.y - y) < 0.3 * dp && std::abs(x.x - 0.5) < 0.25;
        });
    };
    EXPECT_EQ(in_row(0.275), 5);  // of ten places
    EXPECT_EQ(in_row(0.525), 5);
    EXPECT_EQ(in_row(0.575), 10);
    EXPECT_NEAR(filling.regions[0].room, 0.8 - 0.5 * 0.25, 1e-9);
}

TEST(Pack, the_surface_stays_where_it_is) {
    Tank tank(2);
    tank.add_walls(0, 1 - 0.5 * dp);
    Filling filling = tank.filled();
    tank.packed(filling);
    double sum = 0;
    std::array<double, 20> highest{};  // by columns one spacing wide
    for (const Vec3& x : filling.particles.position) {
        double& top = highest[static_cast<std::size_t>(x.x / dp)];
        top = std::max(top, x.y);
        sum += x.y;
    }
    for (std::size_t k = 0; k + 1 < highest.size(); ++k) {
        EXPECT_NEAR(highest[k], 0.8 - 0.5 * dp, 0.95 * dp) << k;
    }
    EXPECT_NEAR(2 * sum / static_cast<double>(filling.particles.position.size()), 0.8, 0.05 * dp);
}

// Of a last layer that the surface cuts some cells had a particle, alone on the water: it fell in.
TEST(Pack, a_surface_that_cuts_cells_has_its_last_layer_packed_below_it) {
    for (const int dimension : {2, 3}) {
        for (const double share : {0.3, 0.5, 0.8}) {
            SCOPED_TRACE(std::to_string(dimension) + ", " + std::to_string(share));
            Tank tank(dimension);
            tank.level = 0.6 + share * dp;
            tank.add_walls();
            Filling filling = tank.filled();
            const Packed result = tank.packed(filling);
            EXPECT_FALSE(filling.misfits.empty());
            EXPECT_LT(result.unevenness, 1.5e-3);
            double highest = 0, sum = 0;
            for (const Vec3& x : filling.particles.position) {
                highest = std::max(highest, x.y);
                sum += x.y;
            }
            EXPECT_LT(highest, tank.level - 0.3 * dp);
            EXPECT_NEAR(2 * sum / static_cast<double>(filling.particles.position.size()), tank.level, 0.08 * dp);
            EXPECT_EQ(filling.particles.position.size(), tank.filled(FillFaces::lattice).particles.position.size());
        }
    }
}

TEST(Pack, a_surface_that_cuts_cells_of_a_dam_without_a_gate_stays_within_its_side) {
    Tank tank(2);
    tank.level = 0.625;
    tank.add_walls();
    FillRegion left = tank.region();
    left.pieces = {geometry::moved(geometry::box({0.5, 1, 1}), {{0.25, 0.5, 0}, {}})};
    const std::vector<FillRegion> regions{{left.pieces, tank.level}};
    Filling filling = fill(tank.shapes, tank.bodies, tank.state, tank.settings, tank.up, regions, {10'000, 10'000},
                           FillFaces::fitted);
    const SampleSet samples = sample_shapes(
        tank.shapes, tank.bodies, tank.state,
        {dp, tank.settings.support_radius(), tank.settings.domain, filling.lattice_corner, 1'000'000, {}, {}});
    pack(tank.shapes, tank.bodies, tank.state, tank.settings, samples, regions, filling);
    for (const Vec3& x : filling.particles.position) {
        EXPECT_LT(x.x, 0.5 - 0.2 * dp);
        EXPECT_LT(x.y, tank.level - 0.2 * dp);
    }
}

// Boundary particles of walls thinner than a spacing hold no even count.
TEST(Pack, leaves_the_lattice_beside_walls_thinner_than_a_spacing) {
    for (const double thickness : {0.75, 1.5}) {
        Tank tank(2);
        tank.add_walls();
        tank.add(rectangle(0.5 * thickness * dp, 0.2), at(0.51, 0.4, 0.3));
        const Filling filling = tank.filled();
        EXPECT_EQ(filling.misfits.empty(), thickness < 1) << thickness;
    }
}

// Water beside a plate stays on its side, however it is packed.
TEST(Pack, no_particle_comes_through_a_thin_plate) {
    for (const double thickness : {0.05, 0.2}) {
        Tank tank(2);
        tank.add_walls();
        tank.add(rectangle(0.5 * thickness * dp, 0.6), at(0.505, 0.6, 0));
        tank.add(disc(0.15), at(0.32, 0.41, 0));
        tank.add(rectangle(0.1, 0.1), at(0.64, 0.41, 0.5));
        Filling filling = tank.filled();
        const std::vector<Vec3> before = filling.particles.position;
        tank.packed(filling);
        for (std::size_t i = 0; i < before.size(); ++i) {
            EXPECT_EQ(before[i].x < 0.505, filling.particles.position[i].x < 0.505)
                << before[i].x << ' ' << before[i].y;
        }
    }
}

TEST(Pack, a_tank_that_the_lattice_fits_keeps_its_bits) {
    for (const int dimension : {2, 3}) {
        Tank tank(dimension);
        tank.add_walls();
        tank.add(dimension == 3 ? geometry::cube(0.2) : rectangle(0.1, 0.1), at(0.5, 0.4, 0, dimension == 3 ? 0.3 : 0));
        Filling filling = tank.filled();
        const Packed result = tank.packed(filling);
        EXPECT_EQ(filling.particles.position, tank.filled(FillFaces::lattice).particles.position);
        EXPECT_TRUE(filling.misfits.empty());
        EXPECT_EQ(std::ranges::count(result.lack, 0.0), static_cast<std::ptrdiff_t>(result.lack.size()));
    }
}

TEST(Pack, places_far_from_what_does_not_fit_stay_on_the_lattice) {
    Tank tank(2);
    tank.add_walls(0, 1 - 0.5 * dp);
    Filling filling = tank.filled();
    const std::vector<Vec3> before = filling.particles.position;
    tank.packed(filling);
    std::int64_t moved = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const bool is_near = before[i].x > 1 - 5.6 * dp;
        moved += filling.particles.position[i] != before[i] ? 1 : 0;
        ASSERT_TRUE(is_near || filling.particles.position[i] == before[i]) << before[i].x;
        ASSERT_TRUE(before[i].x < 1 - 4.9 * dp || filling.particles.position[i] != before[i]) << before[i].x;
    }
    EXPECT_GT(moved, 70);
}

// With a share of the last move half as large it never becomes even.
TEST(Pack, less_than_a_hundred_sweeps_make_water_even_about_a_disc) {
    Tank tank(2);
    tank.add_walls();
    tank.add(disc(0.19), at(0.5, 0.41, 0));
    Filling filling = tank.filled();
    const Packed result = tank.packed(filling);
    EXPECT_LT(result.sweeps, 100);
    EXPECT_LT(result.unevenness, 1e-4);
    EXPECT_GT(result.unevenness, 5e-5);
}

TEST(Pack, a_body_across_a_period_has_the_water_of_one_in_the_middle) {
    std::array<std::size_t, 2> count{};
    for (const int where : {0, 1}) {
        Tank tank(2);
        tank.settings.domain = {{0, -0.2, 0}, {1, 1.2, 0}, {true, false, false}, 2};
        tank.add_half_space({0, 1, 0}, 0);
        tank.add(rectangle(0.125, 0.125), at(where == 0 ? 0.5 : 1.0, 0.4, 0));
        Filling filling = tank.filled();
        const Packed result = tank.packed(filling);
        EXPECT_LT(result.unevenness, 1e-3);
        for (std::size_t i = 0; i < filling.particles.position.size(); ++i) {
            ASSERT_LT(std::abs(result.lack[i]), 0.05);
            ASSERT_TRUE(tank.settings.domain.holds(filling.particles.position[i]));
        }
        count[static_cast<std::size_t>(where)] = filling.particles.position.size();
    }
    EXPECT_EQ(count[0], count[1]);
}

TEST(Pack, gives_the_same_bits_with_any_number_of_threads) {
    const int before = parallel::thread_count();
    std::vector<std::vector<Vec3>> places;
    for (const int threads : {1, 2, 4}) {
        parallel::set_thread_count(threads);
        Tank tank(3);
        tank.level = 0.6;
        tank.add_walls();
        tank.add(geometry::cube(0.23), {{0.5, 0.41, 0.3}, from_rotation_vector({0.3, 0.2, 0.1})});
        Filling filling = tank.filled();
        tank.packed(filling);
        places.push_back(filling.particles.position);
    }
    parallel::set_thread_count(before);
    EXPECT_EQ(places[0], places[1]);
    EXPECT_EQ(places[0], places[2]);
}

}  // namespace
}  // namespace riprap::coupling
