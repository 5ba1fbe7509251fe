// SPDX-License-Identifier: Apache-2.0
// Sharp bodies that meet tip on tip. Aligned ones are symmetric: they exchange their speeds along the line of the tips
// and get nothing across it. Beside each other by more than they give way they push along the normal of their faces.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "riprap/core/quat.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

using Points = std::vector<Vec3>;

/// An isosceles triangle about its centroid, its tip on the x axis.
Points triangle(double half_degrees, double height = 0.5) {
    const double half_width = height * std::tan(half_degrees * M_PI / 180);
    return {{2 * height / 3, 0, 0}, {-height / 3, half_width, 0}, {-height / 3, -half_width, 0}};
}

/// A triangle drawn out along z, its edge across the x axis.
Points wedge(double half_degrees) {
    Points points;
    for (const double z : {-0.2, 0.2}) {
        for (const Vec3& p : triangle(half_degrees)) {
            points.push_back({p.x, p.y, z});
        }
    }
    return points;
}

/// A pyramid about its centroid on a regular polygon, its tip on the x axis, twisted about it.
Points pyramid(int sides, double half_degrees, double twist = 0, double height = 0.5) {
    Points points{{0.75 * height, 0, 0}};
    for (int k = 0; k < sides; ++k) {
        const double angle = twist + 2 * M_PI * k / sides, radius = height * std::tan(half_degrees * M_PI / 180);
        points.push_back({-0.25 * height, radius * std::cos(angle), radius * std::sin(angle)});
    }
    return points;
}

/// One body goes with 2 m/s along x, and meets another at rest, turned back to front.
struct Meeting {
    std::string method;
    Points one, other;
    double offset{0};  ///< of the other along y [m]
    double turned{0};  ///< the whole scene, about z [rad]
    double stiffness{1e8};
};

struct After {
    Vec3 one, other;            ///< velocities, in the axes of the scene before it is turned [m/s]
    Vec3 spin_one, spin_other;  ///< [rad/s]
    double mass, other_mass;    ///< [kg]
    double inertia;             ///< of one about z, of a triangle [kg m^2]
    double energy;              ///< of motion over that before [-]
};

std::string text_of(const Vec3& v, bool is_planar) {
    return is_planar ? fmt::format("[{}, {}]", v.x, v.y) : fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}

After after(const Meeting& meeting) {
    bool is_planar = true;
    double tips = 0;
    for (const Points* points : {&meeting.one, &meeting.other}) {
        double tip = 0;
        for (const Vec3& p : *points) {
            tip = std::max(tip, p.x);
            is_planar = is_planar && p.z == 0;
        }
        tips += tip;
    }
    // Beside each other they come that much farther before their faces meet.
    const double farther = std::abs(meeting.offset) * 1.5 * meeting.one[0].x / std::abs(meeting.one[1].y);
    const Quat turn = from_rotation_vector({0, 0, meeting.turned});
    const auto body = [&](const std::string& name, const Points& points, double angle, const Vec3& x, const Vec3& v) {
        std::string corners;
        for (const Vec3& p : points) {
            corners += text_of(p, is_planar) + ", ";
        }
        return fmt::format(
            "[[body]]\nname = '{}'\nmaterial = 'rock'\nshape = {{ {} [{}]{} }}\nposition = {}\nvelocity = {}\n"
            "orientation = {{ {} }}\n",
            name, is_planar ? "polygon =" : "hull = { points =", corners, is_planar ? "" : " }",
            text_of(rotate(turn, x), is_planar), text_of(rotate(turn, v), is_planar),
            is_planar ? fmt::format("angle = {}", angle + meeting.turned)
                      : fmt::format("axis_angle = {{ axis = [0, 0, 1], angle_deg = {} }}",
                                    (angle + meeting.turned) * 180 / M_PI));
    };
    const std::string text =
        fmt::format("dimension = {}\ngravity = {}\nend = {}\n", is_planar ? 2 : 3, text_of({}, is_planar),
                    is_planar ? 0.04 : 0.08) +
        "[material.rock]\ndensity = 2500\nrestitution = 1\n" +
        fmt::format("normal_stiffness = {}\n[solid]\nmethod = '{}'\n", meeting.stiffness, meeting.method) +
        (meeting.method == "sphere_dem" && meeting.stiffness > 1e8 ? "youngs_modulus = 3e11\n" : "") +
        body("one", meeting.one, 0, {}, {2, 0, 0}) +
        body("other", meeting.other, M_PI, {tips + 0.02 - farther, meeting.offset, 0}, {});
    Simulation simulation(scene::read_case_text(text, "case.toml", "."));
    while (simulation.steps_left() > 0) {
        const StepOutcome outcome = simulation.step(sim::Measure::energy);
        EXPECT_NE(outcome.kind, StepOutcome::Kind::refused) << outcome.why.text;
        if (outcome.kind == StepOutcome::Kind::refused) {
            break;
        }
    }
    const body::BodySet& set = simulation.model().bodies;
    const body::BodyState& bodies = simulation.state().bodies;
    After result{rotate_back(turn, bodies.velocity[0]),
                 rotate_back(turn, bodies.velocity[1]),
                 rotate_back(turn, angular_velocity(set, bodies, BodyId{0})),
                 rotate_back(turn, angular_velocity(set, bodies, BodyId{1})),
                 set.mass[0],
                 set.mass[1],
                 0,
                 0};
    // About the centroid of a triangle of height h and half-width w: m (h^2/18 + w^2/6).
    const double h = meeting.one[0].x * 1.5, w = meeting.one[1].y;
    result.inertia = result.mass * (h * h / 18 + w * w / 6);
    const double turning =
        result.inertia * (result.spin_one.z * result.spin_one.z + result.spin_other.z * result.spin_other.z);
    result.energy =
        (result.mass * (norm_squared(result.one) + norm_squared(result.other)) + turning) / (4 * result.mass);
    return result;
}

const std::vector<std::string>& methods(bool is_planar) {
    static const std::vector<std::string> planar{"distance_potential_dem", "sphere_dem", "explicit_dda", "implicit_dda",
                                                 "planar_dda"},
        in_space{"distance_potential_dem", "sphere_dem", "explicit_dda", "implicit_dda"};
    return is_planar ? planar : in_space;
}

/// Aligned tips: bodies go on as after a central impact, where the method gives back what an impact costs.
void expect_straight(const Meeting& meeting, const std::string& what) {
    const After got = after(meeting);
    SCOPED_TRACE(meeting.method + ", " + what);
    const double expected = 2 * (got.mass - got.other_mass) / (got.mass + got.other_mass);
    if (meeting.method == "implicit_dda") {  // whose steps damp an impact
        EXPECT_LT(got.one.x, expected + 0.4);
    } else {
        EXPECT_NEAR(got.one.x, expected, 0.02);
    }
    EXPECT_LT(std::hypot(got.one.y, got.one.z), 0.01);
    EXPECT_LT(std::hypot(got.other.y, got.other.z), 0.01);
    EXPECT_LT(std::abs(got.spin_one.z), 0.02);
}

TEST(TipOnTip, AlignedTrianglesThrowEachOtherStraightBack) {
    for (const std::string& method : methods(true)) {
        for (const double turned : {0.0, 0.6457718232}) {
            for (const double half : {20.0, 30.0, 45.0, 60.0}) {
                expect_straight({method, triangle(half), triangle(half), 0, turned},
                                fmt::format("{} degrees turned by {}", 2 * half, turned));
            }
            expect_straight({method, triangle(30), triangle(45), 0, turned}, "60 on 90 degrees");
        }
    }
}

TEST(TipOnTip, AlignedSolidsThrowEachOtherStraightBack) {
    for (const std::string& method : methods(false)) {
        // As stiff as that samples of the ends of an edge do not leave by the ends of the other.
        expect_straight({method, wedge(30), wedge(30), 0, 0, 1e9}, "edge on edge");
        expect_straight({method, pyramid(4, 45), pyramid(4, 25)}, "pyramids, blunt on sharp");
        expect_straight({method, pyramid(3, 35.2644), pyramid(3, 35.2644, M_PI)}, "tetrahedra");
        expect_straight({method, pyramid(3, 35.2644), pyramid(3, 35.2644, 0.4)}, "tetrahedra, twisted");
        expect_straight({method, pyramid(4, 40), pyramid(4, 40, 0.3), 0, 0.6457718232}, "pyramids, turned");
    }
}

TEST(TipOnTip, TrianglesBesideEachOtherPushAlongTheNormalOfTheirFaces) {
    for (const std::string& method : methods(true)) {
        for (const double half : {30.0, 45.0}) {
            for (const double offset : {0.02, -0.05}) {
                const After got = after({method, triangle(half), triangle(half), offset, 0, 1e9});
                SCOPED_TRACE(fmt::format("{}, {} degrees, beside each other by {}", method, 2 * half, offset));
                // J = m (v - 2 x) on the first, along the normal of its upper or lower face.
                const double side = offset > 0 ? 1 : -1, c = std::cos(half * M_PI / 180),
                             s = std::sin(half * M_PI / 180);
                const Vec3 push = got.mass * (got.one - Vec3{2, 0, 0});
                const double size = norm(push);
                EXPECT_NEAR(push.x / size, -s, 0.02);
                EXPECT_NEAR(push.y / size, -side * c, 0.02);
                // Its moment about the first is that of a push between both tips, or by a sample beside one of them.
                const double tip = triangle(half)[0].x;
                const double length = std::abs(offset) / c, arm = got.inertia * got.spin_one.z / size * -side;
                EXPECT_LT(arm, 1.02 * tip * c);
                EXPECT_GT(arm, tip * c - 1.02 * length - (method == "sphere_dem" ? 0.02 : 0.005));
                if (method != "implicit_dda") {
                    EXPECT_NEAR(got.energy, 1, 0.02);
                }
            }
        }
    }
}

}  // namespace
}  // namespace riprap::run
