// SPDX-License-Identifier: Apache-2.0
// Blocks on elastic feet tip where rigid ones do: a quarter of a degree before they stand, as much after they go.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "riprap/core/quat.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

constexpr double degree = M_PI / 180;

struct End {
    bool has_ended{false};
    sim::State state;
};

End end_of(const std::string& text) {
    Simulation simulation(scene::read_case_text(text, "case.toml", "."));
    while (simulation.steps_left() > 0) {
        if (simulation.step(sim::Measure::flow).kind == StepOutcome::Kind::refused) {
            return {false, simulation.state()};
        }
    }
    return {true, simulation.state()};
}

/// Bodies on a base whose gravity leans from its normal -z towards +x; all of it turned, and `size` times as large,
/// with times and moduli that keep the ratios of its forces.
struct Leaning {
    double slope;  ///< [rad]
    Quat turn{};
    double size{1};
    std::string bodies{};

    std::string vector(const Vec3& v) const {
        const Vec3 x = rotate(turn, v);
        return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", x.x, x.y, x.z);
    }
    Leaning& body(const std::string& name, const std::string& shape, const Vec3& place, const std::string& more = "") {
        bodies += fmt::format(
            "[[body]]\nname = '{}'\nmaterial = 'rock'\nshape = {{ {} }}\nposition = {}\n{}\n"
            "orientation = {{ quaternion = [{:.17g}, {:.17g}, {:.17g}, {:.17g}] }}\n",
            name, shape, vector(size * place), more, turn.w, turn.x, turn.y, turn.z);
        return *this;
    }
    Leaning& box(const std::string& name, const Vec3& sides, const Vec3& place, const std::string& more = "") {
        return body(name, fmt::format("box = [{}, {}, {}]", size * sides.x, size * sides.y, size * sides.z), place,
                    more);
    }
    /// Turn of the last body after a second, for size 1 [rad]. Gravity grows over 0.2 s, so that nothing bounces.
    double turned() const {
        const double time = std::sqrt(size);
        const End end = end_of(
            fmt::format("gravity = {{ value = {}, ramp = {} }}\nend = {}\n[material.rock]\ndensity = 2500\n"
                        "friction_coefficient = 0.9\ndamping_ratio = 0.1\nnormal_stiffness = {}\n",
                        vector({9.81 * std::sin(slope), 0, -9.81 * std::cos(slope)}), 0.2 * time, time, 1e8 * size) +
            bodies);
        EXPECT_TRUE(end.has_ended);
        return norm(to_rotation_vector(end.state.bodies.orientation.back() * conjugate(turn)));
    }
};

Leaning hexagonal_column(double slope, const Quat& turn, double size) {
    Leaning scene{slope, turn, size};
    scene.box("base", {4, 2, 0.5}, {0, 0, -0.25}, "fixed = true");
    // Corners on the x axis: it tips over a corner first, at atan(radius/half height).
    return scene.body("column",
                      fmt::format("prism = {{ sides = 6, circumradius = {}, height = {} }}", 0.2 * size, 1.2 * size),
                      {0, 0, 0.6});
}

// Over an edge of the hexagon, 30 degrees off x, it tips later in the direction of x: the corner decides.
TEST(CornerFeet, HoldAHexagonalColumnUntilItTipsOverItsCornerInAnyPostureAndSize) {
    const double limit = std::atan(0.2 / 0.6);
    const Quat turn = from_rotation_vector(37 * degree * normalized(Vec3{0.3, 1, 0.2}));
    for (const double size : {1e-3, 1.0, 1e3}) {
        EXPECT_LT(hexagonal_column(limit - 0.5 * degree, turn, size).turned(), 3e-3) << size;
        EXPECT_GT(hexagonal_column(limit + 0.5 * degree, turn, size).turned(), 0.02) << size;
    }
}

TEST(CornerFeet, HoldAStackOnASlopeUntilItTipsAsOne) {
    const double limit = std::atan(0.15 / 0.6);
    for (const double size : {1e-3, 1.0, 1e3}) {
        for (const double off : {-0.25, 0.5}) {
            Leaning scene{limit + off * degree, from_rotation_vector({0, 37 * degree, 0}), size};
            scene.box("base", {4, 2, 0.5}, {0, 0, -0.25}, "fixed = true");
            for (int k = 0; k < 3; ++k) {
                scene.box(fmt::format("slab_{}", k), {0.3, 0.5, 0.4}, {0, 0, 0.2 + 0.4 * k});
            }
            EXPECT_EQ(scene.turned() > 0.02, off > 0) << size;
        }
    }
}

TEST(CornerFeet, HoldABlockOnAHalfSpaceUntilItTips) {
    const double limit = std::atan(0.2 / 0.8);
    for (const double off : {-0.25, 0.5}) {
        Leaning scene{limit + off * degree};
        scene.body("base", "half_space = { normal = [0, 0, 1] }", {}, "fixed = true");
        scene.box("block", {0.2, 0.3, 0.8}, {0, 0, 0.4});
        EXPECT_EQ(scene.turned() > 0.02, off > 0);
    }
}

/// Share of its spin that a flat block has left on a floor when a rigid one on a face of even pressure has half of it.
/// @param arm  mean distance from the centre of the face [m]
/// @param square_of_gyration  J/m about the normal [m^2]
double spin_left(const std::string& shape, double height, double arm, double square_of_gyration) {
    const double spin = 3, friction = 0.5, gravity = 9.81;
    const std::string text = fmt::format(
        "gravity = [0, 0, -{}]\nend = {}\n[material.rock]\ndensity = 2500\nnormal_stiffness = 1e8\n"
        "friction_coefficient = {}\ndamping_ratio = 0.3\ntorsion = true\n"
        "[[body]]\nname = 'floor'\nmaterial = 'rock'\nfixed = true\nshape = {{ box = [4, 4, 0.5] }}\n"
        "position = [0, 0, -0.25]\n"
        "[[body]]\nname = 'block'\nmaterial = 'rock'\nshape = {{ {} }}\nposition = [0.3, 0.1, {}]\n"
        "angular_velocity = [0, 0, {}]\n",
        gravity, 0.5 * spin * square_of_gyration / (friction * gravity * arm), friction, shape, 0.5 * height, spin);
    const Simulation start(scene::read_case_text(text, "case.toml", "."));
    const End end = end_of(text);
    EXPECT_TRUE(end.has_ended);
    return end.state.bodies.angular_momentum.back().z / start.state().bodies.angular_momentum.back().z;
}

// With the friction of discs of their areas the brick would have 0.65 left, the square 0.51 and the triangle 0.54.
TEST(CornerFeet, LoseTheirSpinAsFacesOfEvenPressureDo) {
    const double l = 0.8, w = 0.2,
                 brick =
                     std::hypot(l, w) / 6 + w * w / (12 * l) * std::asinh(l / w) + l * l / (12 * w) * std::asinh(w / l);
    EXPECT_NEAR(spin_left("box = [0.8, 0.2, 0.1]", 0.1, brick, (l * l + w * w) / 12), 0.5, 0.01);
    const double square = 0.4 * (std::sqrt(2) + std::asinh(1)) / 6;
    EXPECT_NEAR(spin_left("box = [0.4, 0.4, 0.1]", 0.1, square, 0.4 * 0.4 / 6), 0.5, 0.01);
    const double h = 0.15, triangle = h / 3 * (2 + std::asinh(std::sqrt(3)) / std::sqrt(3));  // h: centre to side
    EXPECT_NEAR(spin_left("prism = { sides = 3, circumradius = 0.3, height = 0.1 }", 0.1, triangle, 0.3 * 0.3 / 4), 0.5,
                0.01);
}

// Columns that stand side by side touch by slivers and by depths of round-off, whose pressure has no arm to speak of.
TEST(CornerFeet, LetColumnsOfCubesThatResistSpinStandSideBySide) {
    const End end = end_of(
        "gravity = { value = [0, 0, -9.81], rotation = { axis = [0, -1, 0], rate = 0.03, start = 0.5 } }\n"
        "end = 0.001\n[material.rock]\ndensity = 2000\nnormal_stiffness = 2e9\nfriction_coefficient = 0.4877\n"
        "shear_ratio = 0.8\ncohesion = 2.14\ndamping_ratio = 0.1\ntorsion = true\n"
        "[[body]]\nname = 'floor'\nmaterial = 'rock'\nfixed = true\nshape = { half_space = { normal = [0, 0, 1] } }\n"
        "[[body]]\nname = 'cube'\nmaterial = 'rock'\nshape = { box = [0.1, 0.1, 0.1] }\n"
        "position = [0.05, 0, 0.05]\nrepeat = { counts = [5, 1, 5], pitch = [0.1, 0.1, 0.1] }\n");
    ASSERT_TRUE(end.has_ended);
    for (const Vec3& momentum : end.state.bodies.angular_momentum) {
        EXPECT_LT(norm(momentum), 1e-9);
    }
}

}  // namespace
}  // namespace riprap::run
