// SPDX-License-Identifier: Apache-2.0
// A bonded base in the three methods of discontinuous deformation analysis, against limit equilibrium.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "riprap/solid/affine/bonds.hpp"
#include "riprap/solid/planar_dda/bond_faces.hpp"
#include "sliding_blocks.hpp"

namespace riprap::solid {
namespace {

constexpr double weight_of_one = 2500 * 9.81;  // N per m^2 of section

/// A block on a fixed floor, its base bonded; one metre thick.
struct BondedBlock {
    double width{1}, height{1};     ///< [m]
    double friction{0};             ///< [-]
    double cohesion{0};             ///< [Pa]
    double stiffness{1e8};          ///< of both springs of a contact point [N/m]
    double pressed{0.1}, end{0.5};  ///< settles, without inertia or damped; runs on [s]
    double speed{0};                ///< along the floor, when it has settled [m/s]
    double pebble{0};               ///< side of a square elsewhere on the floor; 0 = none [m]
    std::function<geometry::Vec2(double)> gravity{[](double) { return geometry::Vec2{0, -9.81}; }};
};

struct Answer {
    double way{0};  ///< along the floor since it had settled [m]
    bool is_bonded{false};
};

Answer run_in_the_plane(const BondedBlock& scene) {
    planar_dda::Blocks blocks({.normal_stiffness = scene.stiffness,
                               .shear_stiffness = scene.stiffness,
                               .friction = scene.friction,
                               .cohesion = scene.cohesion},
                              {2500, 5e9, 0.25});
    blocks.add_box({-5, -1}, {10, 1}, true);
    blocks.add_box({0, 0}, {scene.width, scene.height});
    if (scene.pebble > 0) {
        blocks.add_box({-3, 0}, {scene.pebble, scene.pebble});
    }
    blocks.settings.displacement_limit = 0.05;
    blocks.settings.close_tolerance = blocks.settings.open_tolerance = 1e-11;
    blocks.settings.bond_share = affine::bond_tolerance;
    bond_faces(blocks.model, blocks.settings, blocks.state);
    const double dt = 2e-4;
    const auto run = [&](double from, double length) {
        for (double t = from; t < from + length; t += dt) {
            EXPECT_TRUE(blocks.step(dt, scene.gravity(t)).ok());
        }
    };
    blocks.settings.dynamic_factor = 0.9;
    run(-scene.pressed, scene.pressed);
    blocks.settings.dynamic_factor = 1;
    const double start = blocks.state.x[1];
    blocks.state.rates[6] = scene.speed;
    run(0, scene.end);
    const auto& bonded = blocks.state.contact_is_bonded;
    return {blocks.state.x[1] - start, std::count(bonded.begin(), bonded.end(), 1) > 0};
}

Answer run_in_space(const BondedBlock& scene, bool is_explicit) {
    affine::BlockScene system;
    affine::BlockState blocks;
    set_material(system, {2500, 5e9, 0.25},
                 {scene.stiffness, scene.stiffness, false, scene.friction, scene.cohesion, 0, 0.1});
    add_box(system, blocks, {10, 1, 3}, {.position = {0, -0.5, 0}, .is_fixed = true});
    add_box(system, blocks, {scene.width, scene.height, 1}, {.position = {0, 0.5 * scene.height, 0}});
    if (scene.pebble > 0) {
        add_box(system, blocks, {scene.pebble, scene.pebble, 1}, {.position = {-3, 0.5 * scene.pebble, 0}});
    }
    affine::BlockContactHistory contacts;
    contacts.bonded = bonded_pairs(system, blocks);
    const auto turn_gravity = [&](double t) { system.gravity = {scene.gravity(t).x, scene.gravity(t).y, 0}; };
    explicit_dda::State fast{blocks, contacts, 0};
    implicit_dda::State slow{blocks, contacts};
    explicit_dda::Scratch scratch;
    implicit_dda::Scratch equations;
    explicit_dda::Settings damped;
    implicit_dda::Settings settings;
    const double dt = is_explicit ? 0.5 * explicit_dda::stable_step(system, blocks) : 2e-4;
    const auto run = [&](double from, double length) {
        for (double t = from; t < from + length; t += dt) {
            turn_gravity(t);
            const Outcome outcome = in_pieces(dt, [&](double piece) {
                explicit_dda::StepReport report;
                implicit_dda::StepReport other;
                return is_explicit ? advance(system, damped, piece, {}, fast, scratch, report)
                                   : advance(system, settings, piece, {}, slow, equations, other);
            });
            EXPECT_EQ(outcome.problem, "");
        }
    };
    affine::BlockState& state = is_explicit ? fast.blocks : slow.blocks;
    damped.mass_damping = 300;
    settings.dynamic = 0.9;
    run(-scene.pressed, scene.pressed);
    damped.mass_damping = 0;
    settings.dynamic = 1;
    const double start = state.position[1].x;
    state.velocity[1].x = scene.speed;
    run(0, scene.end);
    return {state.position[1].x - start, has_intact(is_explicit ? fast.contacts : slow.contacts)};
}

Answer run(Dda method, const BondedBlock& scene) {
    return method == Dda::planar ? run_in_the_plane(scene) : run_in_space(scene, method == Dda::explicit_);
}

class DdaBonds : public ::testing::TestWithParam<Dda> {};

/// Gravity of a slope that is raised from nothing to its angle within `raised` seconds, in the axes of the slope.
std::function<geometry::Vec2(double)> raised_slope(double angle, double raised) {
    return [angle, raised](double t) {
        const double now = angle * std::clamp(t / raised, 0.0, 1.0);
        return geometry::Vec2{9.81 * std::sin(now), -9.81 * std::cos(now)};
    };
}

TEST_P(DdaBonds, a_base_that_is_loaded_unevenly_slides_where_limit_equilibrium_says) {
    // Friction shares the shear by weight, and the corner below bears most of that of a tall block: W sin a = W cos a
    // tan phi + c b. The corner above is the first at its strength, at some per cent less.
    const double friction = 0.3, angle = 0.4, width = 0.5, height = 0.8, weight = weight_of_one * width * height;
    const double bond = weight * (std::sin(angle) - friction * std::cos(angle)) / width;
    for (const double share : {0.985, 1.015}) {
        const Answer answer = run(GetParam(), {.width = width,
                                               .height = height,
                                               .friction = friction,
                                               .cohesion = bond + (share - 1) * weight * std::sin(angle) / width,
                                               .gravity = raised_slope(angle, 0.3)});
        EXPECT_EQ(answer.is_bonded, share > 1) << share;
        EXPECT_EQ(answer.way<1e-4, share> 1) << share << ": " << answer.way;
    }
}

TEST_P(DdaBonds, a_load_that_comes_at_once_does_not_break_a_bond_that_is_stronger) {
    // Springs overshoot by up to the load itself; the bond bears 1.4 times the load.
    const double driving = weight_of_one * 0.5 * 0.8 * std::sin(0.2);
    const Answer answer = run(
        GetParam(), {.width = 0.5, .height = 0.8, .cohesion = 1.4 * driving / 0.5, .gravity = raised_slope(0.2, 1e-9)});
    EXPECT_TRUE(answer.is_bonded);
    EXPECT_LT(std::abs(answer.way), 1e-4);
}

TEST_P(DdaBonds, a_bond_is_gone_when_it_has_slid_by_a_ten_thousandth_of_the_block) {
    // A push with the speed v slides to m v^2/2 = F (s + d/2), with the strength F = c A and the elastic slip d = F/k.
    const double strength = 2000, mass = 2500, length = affine::bond_tolerance;
    for (const double share : {0.75, 1.35}) {
        const double elastic = strength / ((GetParam() == Dda::planar ? 2 : 4) * 1e8);
        const double speed = std::sqrt(2 * strength * (share * length + 0.5 * elastic) / mass);
        const Answer answer = run(GetParam(), {.cohesion = strength, .end = 0.1, .speed = speed});
        EXPECT_EQ(answer.is_bonded, share < 1) << share;
        // Nothing else holds the block: where the bond is gone it goes on.
        EXPECT_EQ(answer.way < length, share < 1) << share << ": " << answer.way;
    }
}

// Story: the smallest block of the scene gave the length of all bonds, and a pebble weakened a dam.
TEST_P(DdaBonds, a_pebble_elsewhere_does_not_shorten_the_bond_of_a_block) {
    const double strength = 2000, mass = 2500, length = affine::bond_tolerance;
    const double elastic = strength / ((GetParam() == Dda::planar ? 2 : 4) * 1e8);
    const double speed = std::sqrt(2 * strength * (0.75 * length + 0.5 * elastic) / mass);
    const Answer answer = run(GetParam(), {.cohesion = strength, .end = 0.05, .speed = speed, .pebble = 0.05});
    EXPECT_LT(answer.way, length);
    EXPECT_GT(answer.way, 0.5 * length);
}

TEST_P(DdaBonds, a_base_that_lifts_by_less_than_that_is_still_bonded) {
    // Weightless for 2 ms, the base springs off its floor with some micrometres; then it is loaded along it.
    const auto shaken = [](double lifted) {
        return [lifted](double t) {
            return t < 0 ? geometry::Vec2{0, -9.81} : t < lifted ? geometry::Vec2{0, 9.81} : geometry::Vec2{1, -9.81};
        };
    };
    for (const double lifted : {0.002, 0.02}) {
        const Answer answer = run(GetParam(), {.cohesion = 1e4, .gravity = shaken(lifted)});
        EXPECT_EQ(answer.is_bonded, lifted < 0.01) << lifted;
        EXPECT_EQ(answer.way < 1e-4, lifted < 0.01) << lifted << ": " << answer.way;
    }
}

TEST_P(DdaBonds, what_a_base_slides_while_it_is_lifted_counts_as_slip) {
    // It springs off by some hundredths of a millimetre; an acceleration of 200 m/s^2 for 2 ms moves it by 0.4 mm.
    const auto shaken = [](double along) {
        return [along](double t) {
            return t < 0        ? geometry::Vec2{0, -9.81}
                   : t < 0.0005 ? geometry::Vec2{0, 9.81}
                   : t < 0.0025 ? geometry::Vec2{along, 0}
                                : geometry::Vec2{0, -9.81};
        };
    };
    for (const double along : {0.0, 200.0}) {
        const Answer answer =
            run(GetParam(), {.cohesion = 1e3, .stiffness = 4e9, .end = 0.05, .gravity = shaken(along)});
        EXPECT_EQ(answer.is_bonded, along == 0) << along;
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, DdaBonds, ::testing::Values(Dda::planar, Dda::implicit, Dda::explicit_), name_of);

}  // namespace
}  // namespace riprap::solid
