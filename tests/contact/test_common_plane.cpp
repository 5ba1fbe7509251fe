// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "contact/common_plane_support.hpp"
#include "riprap/contact/narrowphase/hull_size.hpp"
#include "riprap/contact/narrowphase/plane_section.hpp"

namespace riprap::contact {
namespace {

using namespace testing;
using geometry::box, geometry::cube;

Quat turn(const Vec3& axis, double angle) { return from_rotation_vector(angle * normalized(axis)); }

/// Returns the least gap of all contacts [m].
double deepest_of(const PlaneContacts& found) {
    double least = 1;
    for (int k = 0; k < found.count; ++k) {
        least = std::min(least, found.contacts[static_cast<std::size_t>(k)].gap);
    }
    return least;
}

PlaneContacts contacts_of(const Hull& a, const Hull& b) {
    const CommonPlane plane = common_plane(a.view(), b.view(), {}, 1);
    PlaneContacts found;
    find_plane_contacts(a.view(), b.view(), plane, contact_tolerance(a.view(), b.view(), plane), found);
    return found;
}

TEST(CommonPlane, two_stacked_cubes_overlap_along_the_face_they_share) {
    const Hull a(cube(1), {}), b(cube(1), {{0.2, 0.1, 0.99}, {}});
    const CommonPlane plane = common_plane(a.view(), b.view(), {}, 1);
    EXPECT_NEAR(plane.gap, -0.01, 1e-15);
    EXPECT_NEAR(plane.normal.z, 1, 1e-15);
}

TEST(CommonPlane, tolerances_follow_the_breadth_of_rods_and_the_radius_of_other_bodies) {
    const auto size = [](const Vec3& sides) { return size_of(Hull(box(sides), {}).view()); };
    EXPECT_DOUBLE_EQ(size({1, 1, 1}), std::sqrt(0.75));
    EXPECT_DOUBLE_EQ(size({1, 1, 0.01}), 0.5 * std::sqrt(2.0001));
    EXPECT_DOUBLE_EQ(size({1000, 250, 1}), 0.5 * std::sqrt(1000 * 1000 + 250 * 250 + 1));
    EXPECT_DOUBLE_EQ(size({1, 1, 12}), 0.5 * std::sqrt(146));
    // Corners of the far end lie twice as far from the diagonal as from the axis.
    EXPECT_NEAR(size({1e-3, 1e-3, 1}), 5 * std::sqrt(2) * 1e-3, 1e-7);
    const Hull section(box({1e-3, 1e-3, 1}), {}), above(box({1e-3, 1e-3, 1}), {{0, 1e-3 - 1e-9, 0}, {}});
    const CommonPlane plane = common_plane(section.view(), above.view(), {}, 1);
    EXPECT_NEAR(contact_tolerance(section.view(), above.view(), plane), 2e-9 + 5 * std::sqrt(2) * 1e-7, 1e-10);
}

TEST(CommonPlane, a_brick_beyond_an_edge_stands_on_it_however_small_its_section_is_beside_its_thickness) {
    for (const double size : {1e-4, 1e-3, 1.0, 100.0}) {
        const Hull support(box({2 * size, 0.5 * size, 1}), {{-size, -0.25 * size, 0}, {}});
        for (const double depth : {1e-7 * size, 2e-6 * size}) {
            for (const double angle : {1e-7, 1e-6, 1e-5, 1e-4}) {
                const Vec3 middle{0.02 * size + 0.125 * size * angle, 0.125 * size - 0.02 * size * angle - depth, 0};
                const Hull brick(box({size, 0.25 * size, 1}), {middle, turn({0, 0, -1}, angle)});
                const PlaneContacts found = contacts_of(support, brick);
                double deepest = 0;
                for (int k = 0; k < found.count; ++k) {
                    deepest = std::min(deepest, found.contacts[static_cast<std::size_t>(k)].gap);
                }
                EXPECT_NEAR(deepest, -depth, 0.05 * depth) << size << ' ' << depth << ' ' << angle;
            }
        }
    }
}

TEST(CommonPlane, the_pruned_search_finds_the_separating_axis_of_the_search_without_pruning) {
    Dice dice(11);
    int overlapping = 0;
    for (std::uint64_t k = 0; k < 600; ++k) {
        const Hull a(random_shape(dice, 2 * k), {{}, turn(dice.point(), 3 * dice())});
        const Hull b(random_shape(dice, 2 * k + 1), {1.1 * dice.point(), turn(dice.point(), 3 * dice())});
        const double oracle = widest_separating_gap(a.view(), b.view());
        const CommonPlane exact = common_plane_exact(a.view(), b.view());
        if (oracle <= 0) {
            ++overlapping;
            ASSERT_NEAR(exact.gap, oracle, 1e-12) << k;
        } else {
            ASSERT_GE(exact.gap, oracle - 1e-12) << k;  // corners and edges across widen it
        }
    }
    EXPECT_GT(overlapping, 200);
}

TEST(CommonPlane, the_fast_plane_with_its_fall_back_is_the_exact_one) {
    Dice dice(5);
    for (std::uint64_t k = 0; k < 600; ++k) {
        const Hull a(random_shape(dice, 2 * k), {{}, turn(dice.point(), 3 * dice())});
        const Hull b(random_shape(dice, 2 * k + 1), {1.5 * dice.point(), turn(dice.point(), 3 * dice())});
        const CommonPlane exact = common_plane_exact(a.view(), b.view());
        const CommonPlane plane = common_plane(a.view(), b.view(), {}, 10);
        if (plane.feature.kind == PlaneKind::faces) {
            ASSERT_GT(plane.gap, exact.gap - 1e-5) << k;  // a tie, put halfway
        } else {
            ASSERT_NEAR(plane.gap, exact.gap, 1e-12) << k;
        }
    }
}

TEST(CommonPlane, features_meet_where_they_have_a_contact) {
    Dice dice(9);
    int meeting = 0, missing = 0;
    for (std::uint64_t k = 0; k < 600; ++k) {
        // boxes along the axes, half of them a little turned, beside each other by more or less than they are wide
        const Quat turned = k % 2 == 0 ? Quat{} : turn(dice.point(), 1e-3 * dice());
        const Hull a(box({1, 0.7, 1}), {}), b(cube(1), {{1.5 * dice(), 1.5 * dice(), 0.999 + 0.002 * dice()}, turned});
        for (const double tolerance : {1e-9, 1e-3, 0.1}) {
            for (const CommonPlane& plane :
                 {CommonPlane{{0, 0, 1}, 0, {}}, common_plane_fast(a.view(), b.view(), {})}) {
                PlaneContacts found;
                find_plane_contacts(a.view(), b.view(), plane, tolerance, found);
                ASSERT_EQ(do_features_meet(a.view(), b.view(), plane, tolerance), found.count > 0) << k;
                (found.count > 0 ? meeting : missing) += 1;
            }
        }
    }
    EXPECT_GT(meeting, 1000);
    EXPECT_GT(missing, 100);
}

TEST(CommonPlane, the_gap_of_bodies_apart_is_the_distance_of_their_nearest_points) {
    // Corner to corner along the diagonal, and corner to edge.
    const Hull a(cube(1), {});
    const Hull b(cube(1), {{1.5, 1.5, 1.5}, {}});
    EXPECT_NEAR(common_plane(a.view(), b.view(), {}, 10).gap, std::sqrt(0.75), 1e-14);
    const Hull c(cube(1), {{1.5, 1.5, 0}, {}});
    EXPECT_NEAR(common_plane(a.view(), c.view(), {}, 10).gap, std::sqrt(0.5), 1e-14);
}

/// The gap found by Cundall's search as [Ding2021, eqs. 4.50-4.52] describes it: turns the normal by atan K in four
/// directions, keeps what widens the gap, halves K from tan 5 degrees down to tan 0.01 degrees. Exact to about the last
/// angle times the size of the contact.
double perturbed_search(const PlacedHull& a, const PlacedHull& b) {
    constexpr double degree = std::numbers::pi / 180;
    Vec3 n = normalized(b.centre - a.centre);
    double gap = plane_gap(a, b, n);
    int pass = 0;
    for (double k = std::tan(5 * degree); k > std::tan(0.01 * degree);) {
        Vec3 p = normalized(cross(n, std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
        Vec3 q = cross(n, p);
        if (pass++ % 2 == 1) {
            const Vec3 old = p;
            p = normalized(p + q);
            q = normalized(q - old);
        }
        Vec3 best = n;
        double best_gap = gap;
        for (const Vec3& step : {p, -p, q, -q}) {
            const Vec3 turned = normalized(n + k * step);
            const double turned_gap = plane_gap(a, b, turned);
            if (turned_gap > best_gap) {
                best = turned;
                best_gap = turned_gap;
            }
        }
        if (best_gap > gap) {
            n = best;
            gap = best_gap;
        } else if (pass % 2 == 0) {
            k /= 2;
        }
    }
    return gap;
}

TEST(CommonPlane, the_perturbed_search_never_passes_the_exact_gap_and_may_stall_on_a_ridge) {
    Dice dice(7);
    int apart = 0, stalled = 0;
    for (std::uint64_t k = 0; k < 60; ++k) {
        const Hull a(cube(1), {{}, turn(dice.point(), 3 * dice())});
        const Hull b(cube(1), {1.5 * normalized(dice.point()), turn(dice.point(), 3 * dice())});
        const double exact = common_plane_exact(a.view(), b.view()).gap;
        const double search = perturbed_search(a.view(), b.view());
        EXPECT_LE(search, exact + 1e-12);
        apart += exact > 0 ? 1 : 0;
        stalled += exact > 0 && search < exact - 1e-3 ? 1 : 0;
    }
    EXPECT_GT(stalled, 0);
    EXPECT_LT(2 * stalled, apart);
}

TEST(CommonPlane, turning_and_shifting_both_bodies_changes_nothing) {
    const Pose pose_b{{0.3, 0.2, 0.9}, turn({1, 2, 3}, 0.4)};
    const Hull a(cube(1), {}), b(box({1, 0.7, 0.6}), pose_b);
    const double gap = common_plane(a.view(), b.view(), {}, 1).gap;
    const Quat q = turn({-1, 1, 2}, 1.1);
    const Vec3 shift{10, -20, 5};
    const Hull moved_a(cube(1), {shift, q});
    const Hull moved_b(box({1, 0.7, 0.6}), {shift + rotate(q, pose_b.position), q * pose_b.orientation});
    EXPECT_NEAR(common_plane(moved_a.view(), moved_b.view(), {}, 1).gap, gap, 1e-13);
}

TEST(CommonPlane, two_equal_blocks_that_lean_on_each_other_share_the_plane_between_them) {
    const double lean = 0.02;
    const Hull a(cube(1), {{-0.51, 0, 0}, turn({0, 1, 0}, lean)}), b(cube(1), {{0.51, 0, 0}, turn({0, 1, 0}, -lean)});
    const Vec3 n = common_plane(a.view(), b.view(), {}, 1).normal;
    EXPECT_NEAR(n.x, 1, 1e-14);
    EXPECT_NEAR(n.z, 0, 1e-14);
}

TEST(CommonPlane, a_feature_survives_its_packing) {
    for (const PlaneFeature& f : {PlaneFeature{PlaneKind::face_a, 3, -1}, PlaneFeature{PlaneKind::face_b, -1, 0},
                                  PlaneFeature{PlaneKind::edges, 11, 7}, PlaneFeature{}}) {
        EXPECT_EQ(unpack_feature(pack(f)), f);
    }
}

TEST(CommonPlane, a_symmetric_contact_keeps_the_plane_it_had) {
    // A cube corner deep in the corner of another: three faces are equally good.
    const Hull a(cube(1), {}), b(cube(1), {{0.9, 0.9, 0.9}, {}});
    for (std::int32_t face = 0; face < 6; ++face) {
        const PlaneFeature before{PlaneKind::face_a, face, -1};
        const Vec3 n = feature_normal(a.view(), b.view(), before);
        if (n.x + n.y + n.z > 0) {
            const CommonPlane plane = common_plane(a.view(), b.view(), before, 1);
            EXPECT_EQ(plane.feature.a, face);
            EXPECT_LT(norm(plane.normal - n), 1e-14);
        }
    }
}

TEST(PlaneContacts, kinds_follow_from_the_corners_that_touch) {
    const double half = std::sqrt(0.5), corner = std::sqrt(0.75);
    const Quat on_edge = turn({0, 1, 0}, std::numbers::pi / 4);
    const Quat on_corner = from_rotation_vector(std::acos(1 / std::sqrt(3.0)) * normalized(Vec3{1, -1, 0}));
    const Hull base(cube(2), {});
    EXPECT_EQ(contacts_of(base, Hull(cube(1), {{0, 0, 1.499}, {}})).type, ContactType::face_face);
    EXPECT_EQ(contacts_of(base, Hull(cube(1), {{0, 0, 0.999 + half}, on_edge})).type, ContactType::face_edge);
    EXPECT_EQ(contacts_of(base, Hull(cube(1), {{0, 0, 0.999 + corner}, on_corner})).type, ContactType::face_vertex);
    const Hull ridge(cube(1), {{}, turn({1, 0, 0}, std::numbers::pi / 4)});
    EXPECT_EQ(contacts_of(ridge, Hull(cube(1), {{0, 0, 2 * half - 0.001}, on_edge})).type, ContactType::edge_edge);
}

TEST(PlaneContacts, faces_that_cross_without_a_corner_inside_touch_at_four_crossings) {
    const Hull a(box({4, 1, 1}), {}), b(box({1, 4, 1}), {{0, 0, 0.995}, {}});
    const PlaneContacts found = contacts_of(a, b);
    ASSERT_EQ(found.count, 4);
    EXPECT_NEAR(found.area, 1, 1e-12);
    for (int i = 0; i < 4; ++i) {
        const PlaneContact& c = found.contacts[static_cast<std::size_t>(i)];
        EXPECT_NEAR(c.gap, -0.005, 1e-14);
        EXPECT_NEAR(std::abs(c.on_a.x), 0.5, 1e-12);
        EXPECT_NEAR(std::abs(c.on_a.y), 0.5, 1e-12);
        EXPECT_NEAR(c.area, 0.25, 1e-12);
    }
}

TEST(PlaneContacts, a_brick_that_tilts_on_a_long_floor_keeps_the_end_that_is_still_in) {
    for (const double length : {1.5, 4.0, 40.0, 4000.0}) {
        for (const double depth : {1e-5, 1e-4, 1e-3}) {
            for (const double angle : {0.0, 0.5}) {  // of the floor and the brick about the vertical
                const Quat about = turn({0, 0, 1}, angle);
                const Hull floor(box({length, 2, 0.5}), {rotate(about, {-0.5 * length, 0, -0.25}), about});
                // Its right end is 0.48 beyond the end of the floor; its left one, 0.52 on it, is in by a twentieth.
                const double tilt = 0.95 * depth / 0.52;
                const Vec3 middle{-0.02, 0, 0.125 - depth + 0.02 * tilt};
                const Hull brick(box({1, 1, 0.25}), {rotate(about, middle), about * turn({0, 1, 0}, tilt)});
                const PlaneContacts found = contacts_of(floor, brick);
                ASSERT_EQ(found.count, 4) << length << ' ' << depth << ' ' << angle;
                std::array<double, 4> gaps;
                for (std::size_t k = 0; k < 4; ++k) {
                    gaps[k] = found.contacts[k].gap;
                }
                std::sort(gaps.begin(), gaps.end());
                EXPECT_NEAR(gaps[0], -depth, 0.02 * depth) << length << ' ' << depth << ' ' << angle;
                EXPECT_NEAR(gaps[3], -0.05 * depth, 0.02 * depth) << length << ' ' << depth << ' ' << angle;
            }
        }
    }
}

TEST(PlaneContacts, area_is_that_of_the_common_polygon_and_its_shares_add_up) {
    const Hull a(cube(1), {}), b(cube(1), {{0.3, 0.4, 0.99}, {}});
    const PlaneContacts found = contacts_of(a, b);
    EXPECT_NEAR(found.area, 0.7 * 0.6, 1e-12);
    double sum = 0;
    for (int i = 0; i < found.count; ++i) {
        sum += found.contacts[static_cast<std::size_t>(i)].area;
    }
    EXPECT_NEAR(sum, found.area, 1e-14);
    // A square and the same turned by 45 degrees: an octagon of 2 (sqrt 2 - 1).
    const Hull c(cube(1), {{0, 0, 0.99}, turn({0, 0, 1}, std::numbers::pi / 4)});
    const PlaneContacts octagon = contacts_of(a, c);
    EXPECT_EQ(octagon.count, 8);
    EXPECT_NEAR(octagon.area, 2 * (std::sqrt(2.0) - 1), 1e-12);
}

TEST(PlaneContacts, exchanging_the_bodies_exchanges_the_points) {
    const Hull a(box({2, 1, 1}), {}), b(cube(1), {{0.8, 0.2, 0.99}, turn({0, 0, 1}, 0.3)});
    const PlaneContacts there = contacts_of(a, b), back = contacts_of(b, a);
    ASSERT_EQ(there.count, back.count);
    EXPECT_NEAR(there.area, back.area, 1e-12);
    EXPECT_NEAR(norm(there.normal + back.normal), 0, 1e-14);
    for (int i = 0; i < there.count; ++i) {
        double nearest = 1;
        for (int j = 0; j < back.count; ++j) {
            nearest = std::min(nearest, norm(there.contacts[static_cast<std::size_t>(i)].on_a -
                                             back.contacts[static_cast<std::size_t>(j)].on_b));
        }
        EXPECT_LT(nearest, 1e-12);
    }
}

TEST(PlaneContacts, every_feature_is_named_once) {
    Dice dice(3);
    for (std::uint64_t k = 0; k < 300; ++k) {
        const Hull a(random_shape(dice, 2 * k), {{}, turn(dice.point(), 3 * dice())});
        const Hull b(random_shape(dice, 2 * k + 1), {0.9 * dice.point(), turn(dice.point(), 3 * dice())});
        const PlaneContacts found = contacts_of(a, b);
        ASSERT_GT(found.count, 0) << k;
        std::vector<std::uint64_t> names;
        for (int i = 0; i < found.count; ++i) {
            names.push_back(found.contacts[static_cast<std::size_t>(i)].feature);
        }
        std::sort(names.begin(), names.end());
        ASSERT_EQ(std::adjacent_find(names.begin(), names.end()), names.end()) << k;
    }
}

TEST(PlaneContacts, ridges_and_tips_that_are_deep_in_each_other_still_meet_where_they_are_deepest) {
    // Beyond half of their height the sides of two bars that cross touch the plane as well, and lie apart there.
    const double half = 0.025 * std::sqrt(2.0);
    const Hull lower(box({0.05, 1, 0.05}), {{}, turn({0, 1, 0}, std::numbers::pi / 4)});
    for (const double depth : {0.002, 0.02, 0.03, 0.05}) {
        const Hull upper(box({1, 0.05, 0.05}), {{0.03, 0.02, 2 * half - depth}, turn({1, 0, 0}, std::numbers::pi / 4)});
        const PlaneContacts found = contacts_of(lower, upper);
        ASSERT_EQ(found.count, 1) << depth;
        EXPECT_NEAR(found.contacts[0].gap, -depth, 1e-12);
        EXPECT_NEAR(found.contacts[0].on_a.x, 0, 1e-12);
        EXPECT_NEAR(found.contacts[0].on_b.y, 0.02, 1e-12);
    }
    // A tip so flat that the corners around it touch too.
    const auto flat = geometry::convex_hull(
        std::vector<Vec3>{{0, 0, -0.02}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 0, 1}});
    const Hull floor(box({4, 4, 1}), {{0, 0, -0.5}, {}});
    const PlaneContacts tip = contacts_of(floor, Hull(flat.value(), {{0, 0, 0.005}, {}}));
    ASSERT_GE(tip.count, 1);
    EXPECT_NEAR(deepest_of(tip), -0.015, 1e-12);
}

TEST(PlaneContacts, corners_of_a_prism_of_many_sides_come_in_one_by_one_as_it_sinks_into_a_face) {
    // The push of equal springs at the corners that are in, and its energy, have no jumps: each comes in with no depth.
    const double step = 2e-5;
    for (const int sides : {16, 32, 63}) {
        for (const double turned : {0.0, 0.03}) {
            std::vector<geometry::Point2> corners;
            for (int k = 0; k < sides; ++k) {
                const double angle = 2 * std::numbers::pi * k / sides + turned;
                corners.push_back({0.1 * std::sin(angle), -0.1 * std::cos(angle)});
            }
            const auto prism = geometry::planar_prism(corners).value();
            const Hull floor(box({0.6, 0.3, 1}), {{0, -0.15, 0}, {}});
            for (double depth = step; depth < 6e-3; depth += step) {
                for (const bool is_first : {false, true}) {
                    const Hull body(prism, {{0, 0.1 - depth, 0}, {}});
                    const PlaneContacts found = is_first ? contacts_of(body, floor) : contacts_of(floor, body);
                    double energy = 0, expected = 0;
                    for (int k = 0; k < found.count; ++k) {
                        const double gap = std::min(0.0, found.contacts[static_cast<std::size_t>(k)].gap);
                        energy += gap * gap;
                    }
                    for (const geometry::Point2& corner : corners) {
                        const double in = std::min(0.0, corner[1] + 0.1 - depth);
                        expected += 2 * in * in;
                    }
                    ASSERT_NEAR(energy, expected, 1e-6 * expected) << sides << ' ' << turned << ' ' << depth;
                }
            }
        }
    }
}

TEST(PlaneSection, grows_with_the_square_of_the_depth_where_ridges_cross_and_with_the_depth_of_an_edge_on_a_face) {
    const double half = std::sqrt(0.5);
    const Hull lower(box({1, 8, 1}), {{}, turn({0, 1, 0}, std::numbers::pi / 4)});
    const std::vector<Vec3> up{{0, 0, 1}};
    const PlacedHull ground{nullptr, {}, up, {}, half};
    for (const double angle : {30.0, 60.0, 90.0}) {
        const Quat crossed = turn({0, 0, 1}, std::numbers::pi / 180 * angle);
        const Hull upper(box({1, 8, 1}), {{0, 0, 2 * half - 0.01}, crossed * turn({0, 1, 0}, std::numbers::pi / 4)});
        for (const double depth : {0.01, 0.1}) {
            // Half of the depth below its edge a ridge is as wide as the depth.
            EXPECT_NEAR(common_section(lower.view(), upper.view(), {0, 0, 1}, depth),
                        depth * depth / std::sin(std::numbers::pi / 180 * angle), 1e-12);
            EXPECT_NEAR(common_section(ground, upper.view(), {0, 0, 1}, depth), 8 * depth, 1e-12);
            EXPECT_NEAR(common_section(upper.view(), ground, {0, 0, -1}, depth), 8 * depth, 1e-12);
        }
    }
}

TEST(PlaneContacts, a_cube_on_a_half_space_stands_on_its_four_lowest_corners) {
    const std::vector<Vec3> up{{0, 0, 1}};
    const PlacedHull ground{nullptr, {}, up, {}, 0};
    const Hull b(cube(1), {{3, 4, 0.499}, {}});
    const CommonPlane plane = common_plane(ground, b.view(), {}, 1);
    PlaneContacts found;
    find_plane_contacts(ground, b.view(), plane, 1e-4, found);
    EXPECT_EQ(found.count, 4);
    EXPECT_NEAR(plane.gap, -0.001, 1e-15);
    EXPECT_NEAR(found.area, 1, 1e-12);
}

}  // namespace
}  // namespace riprap::contact
