// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/corner_foot.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "contact/narrowphase_support.hpp"

namespace riprap::contact {
namespace {

using namespace testing;

/// Pairs of blocks that meet by corners and by the potential.
class CornerFeet : public ::testing::Test {
 protected:
    Pairs pairs;
    std::mt19937_64 random{11};
    double share{0};
    Corners corners{Corners::field};
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
    Block add(const geometry::Polyhedron& shape, const Pose& pose, double stiffness = 1) {
        return {pairs.shapes.add_convex(shape), pose, stiffness};
    }
    NormalContact meet(const Block& a, const Block& b) {
        const geometry::ConvexView view_a = pairs.shapes.view(a.shape), view_b = pairs.shapes.view(b.shape);
        const Frame frame_a = to_frame(a.pose), frame_b = to_frame(b.pose);
        const PlacedShape placed_a{view_a, frame_a}, placed_b{view_b, frame_b};
        const CornerFoot foot(placed_a, placed_b,
                              a.stiffness / view_a.inscribed_radius + b.stiffness / view_b.inscribed_radius, corners);
        share = foot.share();
        NormalContact contact{};
        if (foot.is_whole()) {
            foot.stand(contact);
            foot.resist_spin(contact);
            return contact;
        }
        contact = pairs.fast(a, b);
        if (pairs.is_touching && share > 0) {
            foot.join(contact);
            foot.resist_spin(contact);
        }
        return contact;
    }
    /// Compares the wrench on A with the slopes of the energy as A moves and turns about its origin.
    void expect_gradient(const Block& a, const Block& b, double step = 1e-5) {
        const NormalContact contact = meet(a, b);
        const auto [force, moment] = energy_gradient(a.pose, step, [&](const Pose& pose) {
            return meet({a.shape, pose, a.stiffness}, b).energy;
        });
        expect_near(contact.force, force, 1e-6 * (1e-3 + norm(force)), "force");
        expect_near(moment_about(contact, a.pose.position), moment, 1e-6 * (1e-3 + norm(moment)), "moment");
    }
};

TEST_F(CornerFeet, PushWithTheGradientOfTheirEnergyInAnyPosture) {
    const Block floor = add(geometry::box({1.3, 1.1, 0.6}), {{0, 0, -0.3}, {}}, 0.7);
    const Block brick = add(geometry::box({1, 0.7, 0.4}), {}, 1.1);
    const Block column = add(geometry::prism(6, 0.5, 0.4).value(), {}, 1.3);
    int whole = 0, part = 0;
    for (int i = 0; i < 400; ++i) {
        Block top = i % 3 == 0 ? column : brick;
        const double tilt = uniform(0, 0.75), way = uniform(-3, 3);
        const Quat turn = from_rotation_vector({tilt * std::cos(way), tilt * std::sin(way), 0}) *
                          from_rotation_vector({0, 0, uniform(-3, 3)});
        top.pose = {{uniform(-0.8, 0.8), uniform(-0.7, 0.7), 0}, turn};
        double low = 0;
        for (int v = 0; v < pairs.shapes.view(top.shape).vertex_count; ++v) {
            low = std::min(low, rotate(turn, pairs.shapes.view(top.shape).vertex(v)).z);
        }
        top.pose.position.z = -low - uniform(0.002, 0.05);
        const Quat all = normalized(Quat{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)});
        const auto carried = [&](const Block& block) {
            return Block{
                block.shape, {rotate(all, block.pose.position), all * block.pose.orientation}, block.stiffness};
        };
        meet(carried(top), carried(floor));
        whole += share == 1 ? 1 : 0;
        part += share > 0 && share < 1 ? 1 : 0;
        i % 2 == 0 ? expect_gradient(carried(top), carried(floor)) : expect_gradient(carried(floor), carried(top));
        ASSERT_FALSE(HasFailure()) << "pair " << i << " share " << share << " tilt " << tilt;
    }
    EXPECT_GT(whole, 50);
    EXPECT_GT(part, 100);
}

TEST_F(CornerFeet, PushWithTheGradientOfTheirEnergyOnAWallByTheFieldOfTheBlockAlone) {
    const Block wall{pairs.shapes.add_half_space({0, 0.6, 0.8}, 0.1), {{0.2, 0.1, -0.1}, {}}, 1};
    Block brick = add(geometry::box({1, 0.7, 0.4}), {}, 1.1);
    const Quat upright = from_rotation_vector({-std::atan2(0.6, 0.8), 0, 0});
    for (const double tilt : {0.0, 0.003, 0.1, 0.3, 0.45, 0.55, 0.65}) {
        const Quat turn = from_rotation_vector({0.6 * tilt, 0.8 * tilt, 0}) * from_rotation_vector({0, 0, 0.4});
        double low = 0;
        for (const double x : {-0.5, 0.5}) {
            for (const double y : {-0.35, 0.35}) {
                low = std::min(low, rotate(turn, {x, y, -0.2}).z);
            }
        }
        brick.pose = {Vec3{0.2, 0.1, -0.1} + rotate(upright, {0.3, -0.2, 0.1 - low - 0.005}), upright * turn};
        SCOPED_TRACE(tilt);
        expect_gradient(brick, wall);
        expect_gradient(wall, brick);
        EXPECT_GT(share, 0);
    }
}

TEST_F(CornerFeet, PushWithTheGradientOfTheirEnergyWhereTheyMeetByALittleOfTheirFaces) {
    Block cube = add(geometry::cube(1), {});
    const Block other = add(geometry::box({1, 1.2, 0.8}), {{0, 0, 0}, from_rotation_vector({0.3, -0.2, 0.5})}, 0.6);
    int part = 0;
    for (int i = 0; i < 400; ++i) {
        corners = i < 200 ? Corners::field : Corners::stiff;
        const double least = i < 200 ? 0.02 : 0.01, most = i < 200 ? 0.1 : 0.05;
        const Vec3 overlap{uniform(least, most), uniform(0.02, 0.1), uniform(0.02, 0.9)};
        const Quat turn = from_rotation_vector({uniform(-0.02, 0.02), uniform(-0.02, 0.02), uniform(-0.02, 0.02)});
        cube.pose = {rotate(other.pose.orientation, Vec3{1, 1.1, 0.9} - overlap), other.pose.orientation * turn};
        meet(cube, other);
        part += share > 0 && share < 1 ? 1 : 0;
        if (share != 1 && std::abs(share - 0.5) > 0.499) {
            continue;  // the differences would reach over an end of the step
        }
        expect_gradient(cube, other, 2e-6);
        ASSERT_FALSE(HasFailure()) << "pair " << i << " share " << share;
    }
    EXPECT_GT(part, 100);
}

TEST_F(CornerFeet, DoNotTurnBlocksThatMeetEvenlyByAStripOfTheirFaces) {
    // A long block goes into a step of its floor: both bodies far beyond the strip are as deep as in it.
    const Block step = add(geometry::box({4, 1, 0.5}), {{2, 0, -0.25}, {}});
    Block block = add(geometry::box({0.7, 1, 0.3}), {});
    for (const double way : {0.003, 0.006, 0.007}) {
        SCOPED_TRACE(way);
        block.pose.position = {way - 0.35, 0, 0.15 - 0.005};
        const NormalContact contact = meet(block, step);
        EXPECT_GT(share, 0);
        EXPECT_LT(share, 1);
        const Vec3 corner{0.5 * way, 0, -0.0025};  // the overlap is here, half a centimetre wide
        EXPECT_LT(norm(moment_about(contact, corner)), 0.006 * norm(contact.force));
    }
}

TEST_F(CornerFeet, GiveWayAsTheAreaThatFlatFacesShare) {
    const Block floor = add(geometry::cube(1), {});
    const NormalContact contact = meet(add(geometry::cube(1), {{0.25, 0, 0.999}, {}}), floor);
    // K = 1/0.5 + 1/0.5; across n what the patch gains in area: K d^2/2 a metre of its edge
    expect_near(contact.force, {0.5 * 4 * 1e-6, 0, 4 * 0.75 * 1e-3}, 1e-14, "force");
    expect_near(contact.point, {0.125, 0, 0.4995}, 1e-9, "point");
    EXPECT_NEAR(contact.energy, 4 * 0.75 * 0.5e-6, 1e-16);
    EXPECT_NEAR(contact.area, 0.75, 1e-9);
    EXPECT_NEAR(contact.stiffness, 4 * 0.75, 1e-9);
    EXPECT_NEAR(contact.depth, 1e-3, 1e-12);
}

TEST_F(CornerFeet, PushEvenlyAboutTheCentroidOfWhateverTheyShare) {
    const Block floor = add(geometry::box({1.3, 1.1, 0.6}), {{0, 0, -0.3}, {}});
    for (int i = 0; i < 200; ++i) {
        const Block column =
            add(geometry::prism(3 + i % 4, 0.5, 0.4).value(),
                {{uniform(-0.7, 0.7), uniform(-0.6, 0.6), 0.2 - 1e-4}, from_rotation_vector({0, 0, uniform(-3, 3)})});
        const NormalContact contact = meet(column, floor);
        if (share < 1) {
            continue;
        }
        // The point is the centre of even pressure: no couple is left across n but of order depth.
        const Vec3 couple{contact.moment.x, contact.moment.y, 0};
        EXPECT_LT(norm(couple), 1e-3 * norm(contact.force) * std::sqrt(contact.area)) << i;
    }
}

TEST_F(CornerFeet, LetTheResultantStandAtTheVeryEdgeOfAnyFoot) {
    const Block floor = add(geometry::box({4, 4, 1}), {{0, 0, -0.5}, {}});
    for (const int sides : {3, 4, 5, 6}) {
        const double radius = 0.5, inner = radius * std::cos(M_PI / sides);
        Block column = add(geometry::prism(sides, radius, 1).value(), {});
        for (const double tilt : {0.001, 0.01, 0.2}) {
            for (const double way : {0.1, 1.3, 2.9, 4.2}) {
                const Quat turn = from_rotation_vector({tilt * std::cos(way), tilt * std::sin(way), 0});
                const geometry::ConvexView view = pairs.shapes.view(column.shape);
                double low = 0;
                Vec3 corner{};
                for (int v = 0; v < view.vertex_count; ++v) {
                    const Vec3 x = rotate(turn, view.vertex(v));
                    corner = x.z < low ? x : corner;
                    low = std::min(low, x.z);
                }
                column.pose = {{0, 0, -low - 1e-6}, turn};
                const NormalContact contact = meet(column, floor);
                const Vec3 moment = moment_about(contact, column.pose.position + corner);
                EXPECT_LT(norm(moment), 1e-5 * inner * norm(contact.force)) << sides << ' ' << tilt << ' ' << way;
            }
        }
    }
}

TEST_F(CornerFeet, KnowNothingOfCornersInTheMiddleOfAnEdge) {
    // Equal squares on each other: as one turns through the posture of the other, corners come and go on all edges.
    const Block floor = add(geometry::cube(1), {{0, 0, -0.5}, {}});
    Block cube = add(geometry::cube(1), {});
    const auto energy = [&](double twist, double shift) {
        const Quat tilt = from_rotation_vector({0.02, -0.03, 0});
        cube.pose = {{shift, 0, 0.49}, tilt * from_rotation_vector({0, 0, twist})};
        return meet(cube, floor).energy;
    };
    const double straight = energy(0, 0);
    for (const double twist : {-1e-6, -1e-8, -1e-10, 1e-10, 1e-8, 1e-6}) {
        for (const double shift : {0.0, 1e-9, 1e-7, -1e-7}) {
            EXPECT_NEAR(energy(twist, shift), straight, 20 * (std::abs(twist) + std::abs(shift) + 1e-9) * straight)
                << twist << ' ' << shift;
        }
    }
}

TEST_F(CornerFeet, CarryABlockEvenlyOverTheSeamOfTwoBlocks) {
    const Block left = add(geometry::cube(1), {{-0.5, 0, -0.5}, {}}),
                right = add(geometry::cube(1), {{0.5, 0, -0.5}, {}});
    Block slider = add(geometry::box({0.4, 0.4, 0.4}), {});
    const double depth = 1e-4, weight = (1 / 0.5 + 1 / 0.2) * 0.16 * depth;
    for (int k = 0; k <= 2000; ++k) {
        slider.pose.position = {-0.25 + 2.5e-4 * k, 0, 0.2 - depth};
        const double force = meet(slider, left).force.z + meet(slider, right).force.z;
        EXPECT_NEAR(force, weight, 0.002 * weight) << k;
    }
}

TEST_F(CornerFeet, CarryAllUpToAQuarterAndNothingFromHalfOfTheAngleToAnotherFace) {
    const Block floor = add(geometry::box({4, 4, 1}), {{0, 0, -0.5}, {}});
    const auto share_of = [&](const geometry::Polyhedron& shape, double half_height, double reach, double degrees) {
        const double tilt = degrees * M_PI / 180;
        meet(add(shape, {{0, 0, half_height * std::cos(tilt) + reach * std::sin(tilt) - 1e-4},
                         from_rotation_vector({0, tilt, 0})}),
             floor);
        return share;
    };
    EXPECT_EQ(share_of(geometry::cube(1), 0.5, 0.5, 22.4), 1);
    EXPECT_LT(share_of(geometry::cube(1), 0.5, 0.5, 23), 1);
    EXPECT_GT(share_of(geometry::cube(1), 0.5, 0.5, 44.5), 0);
    EXPECT_LT(share_of(geometry::cube(1), 0.5, 0.5, 44.99), 1e-6);          // then another face is nearer
    const geometry::Polyhedron wheel = geometry::prism(8, 0.5, 1).value();  // its rim: 45 degrees
    for (const auto& [turn, most, least] : {std::tuple{11.2, 1.0, 1.0}, {11.4, 0.9999, 0.5}, {22.3, 0.1, 1e-9}}) {
        const double tilt = turn * M_PI / 180;
        Block rim = add(wheel, {{0, 0, 0.5 * std::cos(M_PI / 8 - tilt) - 1e-4},
                                from_rotation_vector({0, tilt, 0}) * from_rotation_vector({M_PI / 2, 0, 0}) *
                                    from_rotation_vector({0, 0, M_PI / 8})});
        meet(rim, floor);
        EXPECT_LE(share, most) << turn;
        EXPECT_GE(share, least) << turn;
    }
}

TEST_F(CornerFeet, CarryAllUpToADepthOfHalfOfTheirWidthAndNothingFromTheWholeOfIt) {
    const Block floor = add(geometry::box({4, 4, 1}), {{0, 0, -0.5}, {}});
    const auto share_at = [&](double ratio) {  // a cube that lies on 0.1 of its width: 2 (0.1)/2.2 is the patch's
        meet(add(geometry::cube(1), {{2.4, 0, 0.5 - ratio / 11}, {}}), floor);
        return share;
    };
    EXPECT_EQ(share_at(0.49), 1);
    EXPECT_LT(share_at(0.55), 1);
    EXPECT_GT(share_at(0.95), 0);
    EXPECT_LT(share_at(0.999), 1e-4);
    // Beside stiff corners h = 2 - 3 q^2 + 2 q^3, q = 0.0909/0.5: whole up to 1/(2 h^2) = 0.1367, none from 1/h =
    // 0.5228.
    corners = Corners::stiff;
    EXPECT_EQ(share_at(0.1355), 1);
    EXPECT_LT(share_at(0.1385), 1);
    EXPECT_GT(share_at(0.51), 0);
    EXPECT_LT(share_at(0.522), 1e-4);
    EXPECT_EQ(share_at(0.5235), 0);
    // All of a face is as before.
    meet(add(geometry::cube(1), {{0, 0, 0.5 - 0.245}, {}}), floor);
    EXPECT_EQ(share, 1);
}

/// Sums d |r| over the cells of a grid on a rectangle with sides along x and y, r from the centre of the pressure.
/// @param depth  d at x, y
template <class Depth>
double mean_arm(double length, double width, const Depth& depth) {
    constexpr int cells = 800;
    const auto sum = [&](const auto& of) {
        double total = 0;
        for (int i = 0; i < cells; ++i) {
            for (int j = 0; j < cells; ++j) {
                const double x = length * ((i + 0.5) / cells - 0.5), y = width * ((j + 0.5) / cells - 0.5);
                total += std::max(0.0, depth(x, y)) * of(x, y);
            }
        }
        return total;
    };
    const double all = sum([](double, double) { return 1.0; });
    const double cx = sum([](double x, double) { return x; }) / all, cy = sum([](double, double y) { return y; }) / all;
    return sum([&](double x, double y) { return std::hypot(x - cx, y - cy); }) / all;
}

TEST_F(CornerFeet, AreNoneWhereTheNextFacesOfADiscAreAsDeep) {
    // A facet of a disc was a foot down to half of its width, ten times as deep as where the next ones begin to carry:
    // the disc lay in a trough of its own on a slope of 10 degrees, its resultant farther off than its radius.
    const double radius = 0.3, half = radius * std::sin(std::numbers::pi / 64);
    const Block floor = add(geometry::box({4, 1.5, 1}), {{0, 0, -0.5}, {}}, 0.7);
    const Block disc = add(geometry::prism(64, radius, 1).value(), {}, 1.1);
    const Quat upright = from_rotation_vector({0.5 * std::numbers::pi, 0, 0});
    for (const double depth : {0.0005, 0.001, 0.002, 0.003, 0.0176}) {
        double least = 1e300, most = 0;
        for (int i = 0; i < 24; ++i) {
            const Quat turn = upright * from_rotation_vector({0, 0, 0.1 + 0.0045 * i});
            const Block rolled{disc.shape, {{0.1, 0, radius - depth}, turn}, disc.stiffness};
            expect_gradient(rolled, floor, 1e-6);
            const NormalContact contact = meet(rolled, floor);
            const double push = contact.force.z;
            EXPECT_LT(std::abs(moment_about(contact, rolled.pose.position).y), 1.02 * half * push) << depth << " " << i;
            least = std::min(least, push);
            most = std::max(most, push);
        }
        // As the square root of the depth times it, which the sagitta of a facet takes part in.
        const double sagitta = radius - std::sqrt(radius * radius - half * half);
        EXPECT_LT(most, std::pow(1 + sagitta / depth, 1.5) * least) << depth;
    }
}

TEST_F(CornerFeet, ResistSpinAsEvenPressureOnTheFaceThatTheyShare) {
    const Block floor = add(geometry::box({8, 8, 1}), {{0, 0, -0.5}, {}});
    const auto arm_of = [&](const geometry::Polyhedron& shape, double height, double turn) {
        const Block block = add(shape, {{0.3, -0.2, 0.5 * height - 1e-5}, from_rotation_vector({0, 0, turn})});
        const NormalContact contact = meet(block, floor);
        return contact.spin_moment / norm(contact.force);
    };
    for (const double turn : {0.0, 0.6, 2.0}) {
        EXPECT_NEAR(arm_of(geometry::box({0.4, 0.4, 0.4}), 0.4, turn), 0.4 * (std::sqrt(2) + std::asinh(1)) / 6, 1e-9);
        // a rectangle: twice the triangles on both sides, over its area
        const double l = 0.8, w = 0.2, d = std::hypot(l, w);
        const double brick = d / 6 + w * w / (12 * l) * std::asinh(l / w) + l * l / (12 * w) * std::asinh(w / l);
        EXPECT_NEAR(arm_of(geometry::box({l, w, 0.1}), 0.1, turn), brick, 1e-9);
        // regular polygons: of the triangle from the centre to a side, h/3 [sec p + cot p asinh tan p], p = pi/n
        for (const int sides : {3, 5, 6, 12}) {
            const double p = M_PI / sides, h = 0.5 * std::cos(p);
            const double polygon = h / 3 * (1 / std::cos(p) + std::asinh(std::tan(p)) / std::tan(p));
            EXPECT_NEAR(arm_of(geometry::prism(sides, 0.5, 0.6).value(), 0.6, turn), polygon, 1e-9) << sides;
        }
    }
}

TEST_F(CornerFeet, ResistSpinAsThePressureThatGrowsOverTheirFace) {
    const Block floor = add(geometry::box({8, 8, 1}), {{0, 0, -0.5}, {}});
    const double length = 0.8, width = 0.3, height = 0.2;
    for (const Vec3& tilt : {Vec3{0, 1e-4, 0}, Vec3{1e-4, 0, 0}, Vec3{8e-5, 2e-4, 0}, Vec3{-5e-4, 3e-4, 0}}) {
        for (const double sunk : {1e-5, 2e-4}) {  // below and above what a tilt lifts
            const Quat turn = from_rotation_vector(tilt);
            const Block brick = add(geometry::box({length, width, height}), {{0, 0, 0.5 * height - sunk}, turn});
            const NormalContact contact = meet(brick, floor);
            const double arm = mean_arm(length, width, [&](double x, double y) {
                return sunk - rotate(turn, {x, y, -0.5 * height}).z - 0.5 * height;
            });
            EXPECT_NEAR(contact.spin_moment / norm(contact.force), arm, 2e-3 * arm) << tilt.x << ' ' << sunk;
        }
    }
}

TEST_F(CornerFeet, ResistSpinWithinTheReachOfTheirFaceDownToRoundOff) {
    const geometry::Polyhedron shape = geometry::cube(0.1);
    const Block lower = add(shape, {{0.25, 0, 0.4}, {}});
    Block upper = add(shape, {});
    const double reach = std::hypot(0.1, 0.1);
    const auto tiny = [&] { return uniform(0, 1) < 0.3 ? 0 : std::pow(10.0, uniform(-19, -4)) * uniform(-1, 1); };
    int closed = 0;
    for (int i = 0; i < 20000; ++i) {
        // Equal faces on each other, or by half, with tilts, shifts and depths of round-off and of everything above.
        const Vec3 tilt{tiny(), tiny(), tiny()};
        const double lift = 0.05 * (std::abs(tilt.x) + std::abs(tilt.y)) * uniform(-1, 1);
        upper.pose = {{0.25 + tiny() + 0.05 * (i % 3 == 0), tiny(), 0.5 + lift + tiny()}, from_rotation_vector(tilt)};
        const NormalContact contact = i % 2 == 0 ? meet(upper, lower) : meet(lower, upper);
        ASSERT_TRUE(std::isfinite(contact.spin_moment)) << i;
        ASSERT_GE(contact.spin_moment, 0) << i;
        ASSERT_LE(contact.spin_moment, reach * norm(contact.force)) << i;
        closed += contact.energy > 0 ? 1 : 0;
    }
    EXPECT_GT(closed, 5000);
}

}  // namespace
}  // namespace riprap::contact
