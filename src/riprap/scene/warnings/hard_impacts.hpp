// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::scene {

/// A first meeting that is harder than the contact can carry.
struct HardImpact {
    BodyId body, other;
    double speed;             ///< at which they meet, 0 where one lies on the other [m/s]
    double energy;            ///< to be taken up: of motion, and of the weight over the depth [J]
    double capacity;          ///< that the contact takes up, at most [J]
    double needed_stiffness;  ///< normal_stiffness of the body's material that would carry it [Pa]
    bool goes_round{
        false};  ///< it takes up no more since it comes to push another way, as of a step that it lifts over
};

/// Predicts what free bodies meet first, along their velocity and along gravity, and how hard. By the distance
/// potential the energy of the contacts is followed along the way (StraightPush). By common planes a contact over the
/// projected area P of the body is a spring K = P (k_a/r_a + k_b/r_b), which stores K d^2/2 at d = 0.75 min(r_a, r_b),
/// all that it may (solid::most_overlap), the impact brings m v^2/2 + m g d, and bodies in the way are met where the
/// line from the body's centre enters them. What happens after a first contact is not predicted. Looks at no more than
/// 20 million pairs of bodies and parts.
std::vector<HardImpact> find_hard_impacts(const sim::Model& model, const sim::State& state);

/// First obstacle on the way of a body.
struct Meeting {
    BodyId other;                                              ///< invalid where there is nothing
    std::int32_t part{-1};                                     ///< of `other`
    double distance{std::numeric_limits<double>::infinity()};  ///< from the body's centre of mass [m]
};

/// The first part of another body that a line from a body's centre of mass enters.
/// @param direction  unit
Meeting first_met(const sim::Model& model, const sim::State& state, BodyId body, const Vec3& direction);

/// In words, with the stiffness that would do.
std::string text_of(const HardImpact& impact, const sim::Model& model);

}  // namespace riprap::scene
