// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "coupling/tank_scenes.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/coupling/samples/sample_shapes.hpp"
#include "riprap/geometry/polyhedra/clip.hpp"

namespace riprap::coupling {
namespace {

using test::Scene;

constexpr double dp = 0.1;
constexpr double support = 3 * dp;  // h = 1.5 dp

SampleSettings settings_of(const Vec3& low, const Vec3& high, int dimension = 3) {
    SampleSettings settings;
    settings.spacing = dp;
    settings.reach = support;
    settings.domain = {low, high, {}, dimension};
    settings.limit = 1'000'000;
    return settings;
}

SampleSet sample(const Scene& scene, const SampleSettings& settings) {
    return sample_shapes(scene.shapes, scene.bodies, scene.state, settings);
}

double total_volume(const SampleSet& samples) {
    return std::accumulate(samples.volume.begin(), samples.volume.end(), 0.0);
}

/// Places in whole spacings from the low corner of a lattice, so that sets of them can be compared.
std::set<std::array<long, 3>> lattice_places(const Scene& scene, const SampleSet& samples, const Vec3& corner) {
    std::set<std::array<long, 3>> places;
    for (std::size_t i = 0; i < samples.anchor.size(); ++i) {
        const auto body = static_cast<std::size_t>(samples.body[i].value);
        const Vec3 x = to_world({scene.state.position[body], scene.state.orientation[body]}, samples.anchor[i]);
        std::array<long, 3> place{};
        for (int axis = 0; axis < 3; ++axis) {
            const double cell = (x[axis] - corner[axis]) / dp - 0.5;
            EXPECT_NEAR(cell, std::round(cell), 1e-6);
            place[static_cast<std::size_t>(axis)] = std::lround(cell);
        }
        EXPECT_TRUE(places.insert(place).second) << "two samples in one place";
    }
    return places;
}

TEST(SampleShapes, a_cube_that_a_lattice_fits_gets_exactly_its_lattice) {
    for (const int n : {1, 2, 3, 5, 6}) {  // even: layers meet in the middle; odd: the middle is a layer
        Scene scene;
        scene.add(geometry::cube(n * dp), {{0.3, -0.2, 0.1}, {}});
        const SampleSet samples = sample(scene, settings_of({-9, -9, -9}, {9, 9, 9}));
        ASSERT_EQ(samples.size(), n * n * n);
        for (const double volume : samples.volume) {
            EXPECT_NEAR(volume, dp * dp * dp, 1e-8 * dp * dp * dp);
        }
        lattice_places(scene, samples, Vec3{0.3, -0.2, 0.1} - 0.5 * n * dp * Vec3{1, 1, 1});
    }
}

TEST(SampleShapes, a_large_cube_is_sampled_down_to_the_support_only) {
    Scene scene;
    scene.add(geometry::cube(10 * dp), {});
    const SampleSet samples = sample(scene, settings_of({-9, -9, -9}, {9, 9, 9}));
    EXPECT_EQ(samples.size(), 10 * 10 * 10 - 4 * 4 * 4);
    EXPECT_LT(*std::max_element(samples.depth.begin(), samples.depth.end()), support);
}

TEST(SampleShapes, a_planar_square_gets_its_square_lattice) {
    Scene scene;
    scene.bodies.is_planar = true;
    scene.add(geometry::planar_prism(std::vector<geometry::Point2>{{0, 0}, {5 * dp, 0}, {5 * dp, 4 * dp}, {0, 4 * dp}})
                  .value(),
              {});
    const SampleSet samples = sample(scene, settings_of({-9, -9, 0}, {9, 9, 0}, 2));
    ASSERT_EQ(samples.size(), 20);
    for (std::size_t i = 0; i < 20; ++i) {
        EXPECT_NEAR(samples.volume[i], dp * dp, 1e-8 * dp * dp);
        EXPECT_EQ(samples.anchor[i].z, 0);
    }
}

TEST(SampleShapes, a_planar_square_gets_its_square_lattice_where_the_spacing_is_more_than_a_metre) {
    // Prisms of planar scenes are one unit thick: their ends carried layers of their own, and walls let water through.
    for (const double spacing : {1.0, 1.6, 2.5}) {
        Scene scene;
        scene.bodies.is_planar = true;
        scene.add(geometry::planar_prism(std::vector<geometry::Point2>{
                                             {0, 0}, {5 * spacing, 0}, {5 * spacing, 4 * spacing}, {0, 4 * spacing}})
                      .value(),
                  {});
        SampleSettings settings = settings_of({-90, -90, 0}, {90, 90, 0}, 2);
        settings.reach *= spacing / settings.spacing;
        settings.spacing = spacing;
        const SampleSet samples = sample(scene, settings);
        ASSERT_EQ(samples.size(), 20) << spacing;
        for (std::size_t i = 0; i < 20; ++i) {
            EXPECT_NEAR(samples.volume[i], spacing * spacing, 1e-8 * spacing * spacing);
        }
    }
}

TEST(SampleShapes, volumes_of_a_body_that_no_lattice_fits_add_up_to_its_volume) {
    Scene scene;
    const Pose turned{{}, from_rotation_vector({0.3, 0.4, 0.5})};
    scene.add(geometry::box({3.3 * dp, 5.7 * dp, 4.45 * dp}), turned);
    scene.add(geometry::icosahedron(2.3 * dp), turned);
    scene.add(geometry::regular_tetrahedron(9 * dp), turned);
    const SampleSet samples = sample(scene, settings_of({-9, -9, -9}, {9, 9, 9}));
    std::array<double, 3> volume{};
    for (std::size_t i = 0; i < samples.volume.size(); ++i) {
        volume[static_cast<std::size_t>(samples.body[i].value)] += samples.volume[i];
        EXPECT_GT(samples.volume[i], 0);
    }
    for (std::int32_t b = 0; b < 3; ++b) {
        const double exact = scene.shapes.volume(ShapeId{b});
        // Simpson's rule is exact but where a Voronoi cell meets an edge between the three depths.
        EXPECT_NEAR(volume[static_cast<std::size_t>(b)], exact, 0.01 * exact) << "body " << b;
    }
}

/// Sum of V x over the samples of a body, from its centre of mass.
Vec3 first_moment(const SampleSet& samples) {
    Vec3 sum{};
    for (std::size_t i = 0; i < samples.volume.size(); ++i) {
        sum += samples.volume[i] * samples.anchor[i];
    }
    return sum;
}

// Points at the depth of the middle of their layer stood 0.014 spacings too deep under a disc of four spacings, whose
// lift was 0.6 % too small: it sank where it should have stayed.
TEST(SampleShapes, the_middle_of_all_points_is_that_of_the_body) {
    const auto expect_middle = [](const geometry::Polyhedron& shape, bool is_planar) {
        Scene scene;
        scene.bodies.is_planar = is_planar;
        scene.add(shape, {});
        const SampleSet samples = sample(scene, settings_of({-9, -9, -9}, {9, 9, 9}, is_planar ? 2 : 3));
        EXPECT_NEAR(norm(first_moment(samples)) / total_volume(samples), 0, 3e-3 * dp) << shape.vertices.size();
    };
    expect_middle(geometry::planar_prism(std::vector<geometry::Point2>{{0, 0}, {7 * dp, 0}, {0, 4 * dp}}).value(),
                  true);
    expect_middle(geometry::planar_prism(
                      std::vector<geometry::Point2>{{0, 0}, {5.3 * dp, 0}, {3.1 * dp, 2.7 * dp}, {0.4 * dp, 3 * dp}})
                      .value(),
                  true);
    expect_middle(
        geometry::clip_convex(geometry::box({4 * dp, 4.7 * dp, 5 * dp}), {normalized(Vec3{1, 2, 3}), 0.8 * dp}), false);
}

TEST(SampleShapes, volumes_under_a_wall_add_up_to_area_times_depth) {
    Scene scene;
    scene.add_half_space({0, 0, 1}, 0);
    const SampleSettings settings = settings_of({0, 0, 0}, {1, 2, 1});
    const SampleSet samples = sample(scene, settings);
    // The domain is grown by the support and one spacing.
    const double area = (1 + 8 * dp) * (2 + 8 * dp);
    EXPECT_NEAR(total_volume(samples), area * 3 * dp, 1e-9);
    for (std::size_t i = 0; i < samples.depth.size(); ++i) {
        EXPECT_NEAR(samples.depth[i], -samples.anchor[i].z, 1e-12);
        EXPECT_NEAR(samples.normal[i].z, 1, 1e-12);
    }
}

TEST(SampleShapes, the_corner_of_a_tank_is_filled_once_and_completely) {
    Scene scene;
    scene.add_half_space({0, 0, 1}, 0);
    scene.add_half_space({1, 0, 0}, 0);
    scene.add_half_space({0, 1, 0}, 0);
    const SampleSet samples = sample(scene, settings_of({0, 0, 0}, {0.5, 0.5, 0.5}));
    const auto places = lattice_places(scene, samples, {});
    std::size_t expected = 0;
    for (long k = -3; k < 9; ++k) {
        for (long j = -3; j < 9; ++j) {
            for (long i = -3; i < 9; ++i) {
                const bool is_wall = i < 0 || j < 0 || k < 0;
                EXPECT_EQ(places.contains({i, j, k}), is_wall) << i << ' ' << j << ' ' << k;
                expected += is_wall ? 1 : 0;
            }
        }
    }
    // Beyond the third layer only the rest of the domain's margin can follow.
    EXPECT_GE(samples.size(), static_cast<std::int64_t>(expected));
}

/// Sum of V W over the samples at a place: the share of the kernel's support that walls fill [-].
double wall_share(const Scene& scene, const SampleSet& samples, const Vec3& x) {
    double sum = 0;
    for (std::size_t i = 0; i < samples.anchor.size(); ++i) {
        const auto body = static_cast<std::size_t>(samples.body[i].value);
        const Vec3 sample_place =
            to_world({scene.state.position[body], scene.state.orientation[body]}, samples.anchor[i]);
        sum += test::wendland(norm(sample_place - x), 1.5 * dp, 2) * samples.volume[i];
    }
    return sum;
}

/// The same by the integral over what lies below y = 0 or below y = slope (x - toe).
double exact_wall_share(double toe, double slope, const Vec3& x) {
    constexpr int n = 120;
    const double step = 6 * dp / n;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const Vec3 d{(i + 0.5) * step - 3 * dp, (j + 0.5) * step - 3 * dp, 0};
            const bool is_solid = x.y + d.y < std::max(0.0, slope * (x.x + d.x - toe));
            sum += is_solid ? test::wendland(norm(d), 1.5 * dp, 2) * step * step : 0;
        }
    }
    return sum;
}

TEST(SampleShapes, the_seam_of_a_bed_and_a_slope_is_as_full_as_either) {
    // Whatever place the seam has in the rows of either side. Whole samples left gaps here: in a sliding wedge's
    // channel a particle of water was pressed into the corner of bed and slope until the guard held it. What samples
    // half a spacing apart from the wall and one from each other make of the exact integral over a plane wall.
    const double plane = 0.936;
    for (const double slope : {0.04, 0.4663, 1.7}) {
        for (int k = 0; k < 7; ++k) {
            Scene scene;
            scene.bodies.is_planar = true;
            const double toe = 1 + 0.13 * k * dp;
            const Vec3 normal = normalized(Vec3{-slope, 1, 0});
            scene.add_half_space({0, 1, 0}, 0);
            scene.add_half_space(normal, normal.x * toe);
            const SampleSet samples = sample(scene, settings_of({0, -0.1, 0}, {2, 2, 0}, 2));
            for (int i = -8; i <= 8; ++i) {  // half a spacing from the nearer of both
                const double beyond = dp * (0.5 * (std::sqrt(1 + slope * slope) - 1) / slope);
                const double x = toe - beyond + 0.25 * i * dp;
                const double rise = 0.5 * dp * std::sqrt(1 + slope * slope);
                const Vec3 place{x, std::max(0.5 * dp, slope * (x - toe) + rise), 0};
                const double exact = exact_wall_share(toe, slope, place);
                EXPECT_NEAR(wall_share(scene, samples, place) / exact, plane, 0.04)
                    << "slope " << slope << ", toe at " << toe << ", x " << x;
            }
        }
    }
}

TEST(SampleShapes, a_corner_that_no_lattice_fits_holds_the_volume_of_its_walls) {
    // Floor and side wall with rows at any phase: within the margin all of the solid is there, once.
    for (int k = 0; k < 10; ++k) {
        Scene scene;
        scene.bodies.is_planar = true;
        scene.add_half_space({0, 1, 0}, 0);
        scene.add_half_space({1, 0, 0}, 0);
        const double margin = 0.1 * k * dp;
        const SampleSet samples = sample(scene, settings_of({-margin, -1.7 * margin, 0}, {1, 1, 0}, 2));
        double in_corner = 0;
        for (std::size_t i = 0; i < samples.anchor.size(); ++i) {
            const Vec3& x = samples.anchor[i];
            in_corner += x.x < 1 && x.y < 1 && x.x > -3 * dp && x.y > -3 * dp ? samples.volume[i] : 0;
        }
        // Rows are cut off where they leave the square looked at: at either end up to half a spacing of three rows.
        EXPECT_NEAR(in_corner, 2 * (1 + 3 * dp) * 3 * dp - 9 * dp * dp, 4 * dp * dp) << "margin " << margin;
    }
}

// Where the rows of floor and wall do not meet, the wall left the cells on the bisector of the corner to the floor,
// which had none there: half a cell of each layer was missing, and water under pressure went out through the corner.
TEST(SampleShapes, a_corner_is_as_full_as_its_walls_wherever_its_rows_meet) {
    const auto share_in_corner = [](double off) {
        Scene scene;
        scene.bodies.is_planar = true;
        const double right = 1 - off * dp;
        scene.add_half_space({0, 1, 0}, 0);
        scene.add_half_space({-1, 0, 0}, -right);
        const SampleSet samples = sample(scene, settings_of({0, 0, 0}, {1.3, 1, 0}, 2));
        const Vec3 place{right - 0.5 * dp, 0.5 * dp, 0};
        constexpr int n = 120;
        const double step = 6 * dp / n;
        double exact = 0;
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n; ++j) {
                const Vec3 d{(i + 0.5) * step - 3 * dp, (j + 0.5) * step - 3 * dp, 0};
                const bool is_solid = place.y + d.y < 0 || place.x + d.x > right;
                exact += is_solid ? test::wendland(norm(d), 1.5 * dp, 2) * step * step : 0;
            }
        }
        return wall_share(scene, samples, place) / exact;
    };
    const double fitted = share_in_corner(0);
    for (int k = 1; k < 10; ++k) {
        EXPECT_NEAR(share_in_corner(0.1 * k), fitted, 0.03) << 0.1 * k;
    }
}

TEST(SampleShapes, samples_in_three_walls_and_none_in_two_lie_in_a_vertex) {
    Scene scene;
    scene.add_half_space({0, 0, 1}, 0);
    scene.add_half_space({1, 0, 0}, 0);
    scene.add_half_space({0, 1, 0}, 0);
    const SampleSet samples = sample(scene, settings_of({0, 0, 0}, {1, 1, 1}));
    int found = 0;
    for (std::size_t i = 0; i < samples.anchor.size(); ++i) {
        const auto body = static_cast<std::size_t>(samples.body[i].value);
        const Vec3 x = to_world({scene.state.position[body], scene.state.orientation[body]}, samples.anchor[i]);
        const bool is_in_all = x.x < 0 && x.y < 0 && x.z < 0;
        EXPECT_EQ(samples.is_in_vertex[i] != 0, is_in_all) << x.x << ' ' << x.y << ' ' << x.z;
        found += is_in_all ? 1 : 0;
    }
    EXPECT_GT(found, 0);
}

TEST(SampleShapes, samples_in_two_walls_of_a_plane_lie_in_a_vertex) {
    Scene scene;
    scene.bodies.is_planar = true;
    scene.add_half_space({0, 1, 0}, 0);
    scene.add_half_space({1, 0, 0}, 0);
    const SampleSet samples = sample(scene, settings_of({0, 0, 0}, {1, 1, 0}, 2));
    for (std::size_t i = 0; i < samples.anchor.size(); ++i) {
        const auto body = static_cast<std::size_t>(samples.body[i].value);
        const Vec3 x = to_world({scene.state.position[body], scene.state.orientation[body]}, samples.anchor[i]);
        EXPECT_EQ(samples.is_in_vertex[i] != 0, x.x < 0 && x.y < 0) << x.x << ' ' << x.y;
    }
}

TEST(SampleShapes, walls_of_a_plane_that_meet_at_less_than_18_degrees_make_no_vertex) {
    for (const double degrees : {16.0, 22.0}) {  // sine squared of 0.076 and 0.14
        const double angle = degrees * std::numbers::pi / 180;
        const Vec3 slope{-std::sin(angle), std::cos(angle), 0};
        Scene scene;
        scene.bodies.is_planar = true;
        scene.add_half_space({0, 1, 0}, 0);
        scene.add_half_space(slope, 0);
        const SampleSet samples = sample(scene, settings_of({-1, -1, 0}, {1, 1, 0}, 2));
        int in_both = 0, in_vertex = 0;
        for (std::size_t i = 0; i < samples.anchor.size(); ++i) {
            const auto body = static_cast<std::size_t>(samples.body[i].value);
            const Vec3 x = to_world({scene.state.position[body], scene.state.orientation[body]}, samples.anchor[i]);
            in_both += x.y < -1e-9 && dot(slope, x) < -1e-9 ? 1 : 0;
            in_vertex += samples.is_in_vertex[i];
        }
        EXPECT_GT(in_both, 0);
        EXPECT_EQ(in_vertex, degrees < 18 ? 0 : in_both) << degrees;
    }
}

TEST(SampleShapes, wall_and_water_together_make_the_kernel_sum_of_a_full_lattice) {
    // Water on a lattice beside an inner corner of the tank: every kernel sum equals that far from any wall.
    Scene scene;
    scene.add_half_space({0, 0, 1}, 0);
    scene.add_half_space({1, 0, 0}, 0);
    const SampleSet samples = sample(scene, settings_of({0, 0, 0}, {1, 1, 1}));
    const double h = 1.5 * dp;
    double bulk = 0, near_corner = 0;
    const Vec3 target{0.5 * dp, 4.5 * dp, 0.5 * dp};
    for (int k = -4; k < 10; ++k) {
        for (int j = -4; j < 14; ++j) {
            for (int i = -4; i < 10; ++i) {
                const Vec3 x = dp * Vec3{i + 0.5, j + 0.5, k + 0.5};
                const double w = test::wendland(norm(x - target), h, 3) * dp * dp * dp;
                bulk += w;
                near_corner += i >= 0 && k >= 0 ? w : 0;
            }
        }
    }
    for (std::size_t s = 0; s < samples.anchor.size(); ++s) {
        near_corner += test::wendland(norm(samples.anchor[s] - target), h, 3) * samples.volume[s];
    }
    EXPECT_NEAR(near_corner, bulk, 1e-6);
}

TEST(SampleShapes, the_re_entrant_corner_of_a_union_is_filled) {
    // An L of three glued cubes; without the corner cube's own layers under the glue, its re-entrant edge is hollow.
    Scene scene;
    const double edge = 8 * dp;
    const auto part = [&](std::initializer_list<int> glued, const Vec3& place) {
        geometry::Polyhedron cube = geometry::cube(edge);
        cube.is_internal.assign(cube.faces.size(), 0);
        for (std::size_t f = 0; f < cube.faces.size(); ++f) {
            const Vec3 n = geometry::face_plane(cube.vertices, cube.faces[f]).normal;
            for (const int side : glued) {
                const double along = std::abs(side) == 1 ? n.x : n.y;
                cube.is_internal[f] |= along * side > 0.5 ? 1 : 0;
            }
        }
        return body::Part{BodyId{}, scene.shapes.add_convex(cube), {place, {}}};
    };
    scene.add_parts({part({1, 2}, {}), part({-1}, {edge, 0, 0}), part({-2}, {0, edge, 0})}, {});
    const SampleSet samples = sample(scene, settings_of({-9, -9, -9}, {9, 9, 9}));
    const Vec3 shift = scene.state.position[0];
    const Vec3 corner = Vec3{0.5 * edge, 0.5 * edge, 0} - shift;
    int in_quarter = 0;
    for (const Vec3& x : samples.anchor) {
        const Vec3 d = x - corner;
        in_quarter += d.x < 0 && d.y < 0 && d.x * d.x + d.y * d.y < 4 * dp * dp && std::abs(d.z) < dp ? 1 : 0;
    }
    EXPECT_EQ(in_quarter, 2 * 3);  // (1/2, 1/2), (3/2, 1/2) and (1/2, 3/2) dp in each of two rows
}

TEST(SampleShapes, a_fixed_body_larger_than_the_domain_is_sampled_within_it) {
    Scene scene;
    scene.add(geometry::box({1000, 1000, 1000}), {{0, 0, -500}, {}}, body::Drive::fixed);
    const SampleSet samples = sample(scene, settings_of({0, 0, 0}, {1, 1, 1}));
    EXPECT_EQ(samples.size(), 18 * 18 * 3);
    EXPECT_NEAR(total_volume(samples), 1.8 * 1.8 * 0.3, 1e-9);
}

TEST(SampleShapes, dry_bodies_get_no_samples) {
    Scene scene;
    scene.add(geometry::cube(3 * dp), {});
    scene.add(geometry::cube(3 * dp), {{1, 0, 0}, {}});
    SampleSettings settings = settings_of({-9, -9, -9}, {9, 9, 9});
    const std::vector<std::uint8_t> is_dry{1, 0};
    settings.is_dry = is_dry;
    const SampleSet samples = sample(scene, settings);
    EXPECT_EQ(samples.size(), 27);
    EXPECT_THAT(samples.body, testing::Each(BodyId{1}));
}

TEST(SampleShapes, too_many_samples_are_refused_before_they_are_made) {
    Scene scene;
    scene.add(geometry::cube(100), {});
    EXPECT_THROW(sample(scene, settings_of({-9, -9, -9}, {9, 9, 9})), CaseError);
}

TEST(SampleShapes, those_of_a_tank_share_most_of_their_values) {
    Scene scene;
    scene.add_half_space({0, 0, 1}, 0);
    scene.add_half_space({1, 0, 0}, 0);
    scene.add_half_space({0, -1, 0}, -4);
    const SampleSet samples = sample(scene, settings_of({0, 0, 0}, {4, 4, 4}));
    ASSERT_GT(samples.size(), 10'000);
    EXPECT_LT(samples.bytes(), 14 * static_cast<std::size_t>(samples.size()));  // 69 without
}

TEST(SampleShapes, samples_are_the_same_at_any_thread_count) {
    Scene scene;
    scene.add(geometry::dodecahedron(6.1 * dp), {{0.5, 0.5, 0.2}, from_rotation_vector({1, 2, 3})});
    scene.add_half_space({0, 0, 1}, 0);
    scene.add_half_space({0.1, 0, 1}, 0);
    const int threads = parallel::thread_count();
    parallel::set_thread_count(1);
    const SampleSet one = sample(scene, settings_of({0, 0, 0}, {1, 1, 1}));
    parallel::set_thread_count(2);
    const SampleSet two = sample(scene, settings_of({0, 0, 0}, {1, 1, 1}));
    parallel::set_thread_count(threads);
    EXPECT_EQ(one.anchor, two.anchor);
    EXPECT_EQ(one.volume, two.volume);
    EXPECT_EQ(one.body, two.body);
}

}  // namespace
}  // namespace riprap::coupling
