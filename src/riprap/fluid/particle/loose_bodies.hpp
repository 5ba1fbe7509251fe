// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/sym3.hpp"

namespace riprap::fluid {

/// Acceleration of a rigid body.
struct Twist {
    Vec3 linear{};   ///< of the centre of mass [m/s^2]
    Vec3 angular{};  ///< [rad/s^2]
};

/// Rigid bodies whose accelerations follow from the loads of the water, as a fluid that solves for both at once sees
/// them: a boundary particle at the arm r accelerates by a + alpha x r, and its force f acts by f and r x f.
struct LooseBodies {
    std::vector<std::int32_t> of_wall;  ///< per boundary particle: its body, counted among these; -1: another one
    std::vector<Vec3> arm;              ///< per boundary particle, from the centre of mass of its body [m]
    std::vector<Vec3> lightness;        ///< 1/m along each axis of the world, 0 where the body is locked [1/kg]
    std::vector<Sym3> inverse_inertia;  ///< world axes [1/(kg m^2)]

    std::size_t size() const { return lightness.size(); }
};

/// A scheme that can solve for its pressure and the accelerations of bodies at once.
class SolvesForBodies {
 public:
    SolvesForBodies() = default;
    SolvesForBodies(const SolvesForBodies&) = delete;
    SolvesForBodies& operator=(const SolvesForBodies&) = delete;
    virtual ~SolvesForBodies() = default;

    /// Tells by how much the accelerations of bodies have to change for the loads of the water to be those that cause
    /// them: a step of Newton's method.
    /// @param residual  what the loads last found accelerate the bodies by, less what they were taken to
    /// @returns false where no step was found; `change` then means nothing
    virtual bool correct(const LooseBodies& bodies, std::span<const Twist> residual, std::span<Twist> change) = 0;
};

}  // namespace riprap::fluid
