// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "riprap/body/body_kinematics.hpp"
#include "riprap/core/bytes.hpp"
#include "riprap/coupling/sample_set.hpp"
#include "riprap/fluid/particle/boundary_particles.hpp"

namespace riprap::coupling {

/// How every body moves at one moment, world axes.
struct BodyMotion {
    std::vector<Pose> pose;                                ///< of the centre of mass
    std::vector<Vec3> velocity, angular_velocity;          ///< [m/s], [rad/s]
    std::vector<Vec3> acceleration, angular_acceleration;  ///< [m/s^2], [rad/s^2]
    std::size_t bytes() const { return bytes_of(pose, velocity, angular_velocity, acceleration, angular_acceleration); }
};

/// What the fluid does to every body, pressure and viscosity apart; moments about the centre of mass.
struct FluidLoads {
    std::vector<Vec3> pressure_force, viscous_force;    ///< [N]; in 2D per metre of width
    std::vector<Vec3> pressure_torque, viscous_torque;  ///< [N m]
    std::size_t bytes() const { return bytes_of(pressure_force, viscous_force, pressure_torque, viscous_torque); }
};

/// Moves the samples with rigid bodies, r = R X being a sample's place relative to the centre of mass:
///
///     x = x_c + r,   v = v_c + omega x r,   a = a_c + alpha x r + omega x (omega x r),
///
/// and copies volumes and slip. Two dimensions: the same with all z = 0.
/// @param is_still  per body: never moves, so its particles are left as they are once they have been placed; empty: all
///                  bodies may move
void place_samples(const SampleView& samples, const BodyMotion& motion, fluid::BoundaryParticles& particles,
                   std::span<const std::uint8_t> is_still = {});

/// Gathers forces at samples into force and torque by the transpose of that map, F = sum f, T = sum r x f, so that
/// sum f . v = F . v_c + T . omega: power is conserved. Per body in the order of the samples.
/// @param place  of the samples [m]; it and `sample_force` may be longer than the samples
void gather(const SampleView& samples, const BodyMotion& motion, std::span<const Vec3> place,
            std::span<const Vec3> sample_force, std::vector<Vec3>& force, std::vector<Vec3>& torque);

/// That of pressure and viscosity.
void gather_loads(const SampleView& samples, const BodyMotion& motion, const fluid::BoundaryParticles& particles,
                  FluidLoads& loads);

}  // namespace riprap::coupling
