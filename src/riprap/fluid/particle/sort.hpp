// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/fluid/particle/particle_state.hpp"
#include "riprap/fluid/particle/sweep/domain.hpp"

namespace riprap::fluid {

/// Indices of points in order of place, along a curve that keeps neighbours together. Sweeps over particles in such an
/// order are fast: groups of four in a row should lie within about two spacings. Points that share a place on the curve
/// keep their order.
std::vector<std::uint32_t> order_by_place(std::span<const Vec3> points, const Domain& domain, double spacing);

/// Reorders all particles by place.
void sort_by_place(ParticleState& state, const Domain& domain, double spacing);

}  // namespace riprap::fluid
