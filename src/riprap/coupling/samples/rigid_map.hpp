// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "riprap/body/loads.hpp"
#include "riprap/body/motion.hpp"
#include "riprap/coupling/fluid_loads.hpp"
#include "riprap/coupling/samples/sample_set.hpp"
#include "riprap/fluid/particle/boundary_particles.hpp"

namespace riprap::coupling {

/// Moves the samples with their bodies, r = R U X being a sample's place relative to the centre of mass:
///
///     x = x_c + r,   v = v_c + omega x r + D r,   a = a_c + alpha x r + omega x (omega x r),
///
/// and copies volumes and slip. Where some stick, v is found for the foot of each on its face too, X + depth n. U = 1
/// and D = 0 for rigid bodies. Two dimensions: the same with all z = 0.
/// @param is_still  per body: never moves, so its particles are left as they are once they have been placed; empty: all
///                  bodies may move
void place_samples(const SampleView& samples, const body::Motion& motion, fluid::BoundaryParticles& particles,
                   std::span<const std::uint8_t> is_still = {});

/// Gathers forces at samples by the transpose of that map, F = sum f, T = sum r x f, P = sum sym(f r^T), so that
/// sum f . v = F . v_c + T . omega + P : D: power is conserved. Per body in the order of the samples, in pieces of 4096
/// sample numbers and the pieces in order, so that a sum does not depend on which samples are left out.
/// @param place  of the samples [m]; it and `sample_force` may be longer than the samples
void gather(const SampleView& samples, const body::Motion& motion, std::span<const Vec3> place,
            std::span<const Vec3> sample_force, body::Loads& loads);

/// Gathers the loads of pressure and viscosity per body, that of viscosity at the feet.
void gather_loads(const SampleView& samples, const body::Motion& motion, const fluid::BoundaryParticles& particles,
                  FluidLoads& loads);

}  // namespace riprap::coupling
