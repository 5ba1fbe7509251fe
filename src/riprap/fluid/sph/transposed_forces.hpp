// SPDX-License-Identifier: Apache-2.0
#pragma once

// The transposed half of the viscous stress (transposed_stress.hpp) in a step of DeltaSph.

#include "riprap/fluid/sph/delta_sph.hpp"

namespace riprap::fluid {

/// Adds the sums of TransposedOnWalls to the viscous force.
struct AddStressOnWall {
    WallColumns walls;
    NumbersView<3> stress;

    RIPRAP_HD void operator()(std::int64_t entry) const {
        const auto w = static_cast<std::size_t>(entry);
        walls.viscous_force[w] += walls.volume[w] * stress.vector(w);
    }
};

template <class Site>
bool DeltaSph<Site>::has_stress() const {
    return settings_.viscosity.visit([]<class Law>(const Law&) {
        return requires { Law::has_transposed_stress; };
    });
}

/// tau = mu (grad u)^T, by rows.
template <class Site>
std::array<FieldView, tensor_numbers> DeltaSph<Site>::stress() const {
    std::array<FieldView, tensor_numbers> transposed;
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
            transposed[3 * a + b] = velocity_gradient_.view(3 * b + a);
        }
    }
    return products(transposed, water_.dynamic_viscosity);
}

template <class Site>
void DeltaSph<Site>::sum_velocity_gradient(const ParticleColumns& fluid, const WallColumns& walls) {
    this->mirror_velocity(walls);  // before walls are told how they move in the end
    add_pair_sums_within(settings_, VelocityGradient{kernel_},
                         side(fluid.positions(), fluid.velocities(), water_.volume), fresh(sinks(velocity_gradient_)),
                         site_.lists().fluid_fluid);
    add_pair_sums(settings_, VelocityGradientAtWalls{kernel_}, side(fluid.positions(), fluid.velocities()),
                  side(walls.positions(), walls_.mirrored_velocity, walls.volumes(), walls_.grip),
                  sinks(velocity_gradient_), site_.lists().fluid_walls);
}

template <class Site>
void DeltaSph<Site>::add_stress_of_fluid(const ParticleColumns& fluid) {
    add_pair_sums_within(settings_, TransposedStress{kernel_},
                         side(fluid.positions(), fluid.velocities(), water_.volume, stress()),
                         sinks(forces_.force, forces_.heat), site_.lists().fluid_fluid);
}

template <class Site>
void DeltaSph<Site>::add_stress_from_walls(const ParticleColumns& fluid, const WallColumns& walls) {
    add_pair_sums(settings_, TransposedFromWalls{kernel_}, side(fluid.positions(), fluid.velocities(), stress()),
                  side(walls.positions(), walls.velocities(), walls.volumes(), walls_.grip),
                  sinks(forces_.force, forces_.wall_heat), site_.lists().fluid_walls);
}

template <class Site>
void DeltaSph<Site>::add_stress_on_walls(const ParticleColumns& fluid, const WallColumns& walls) {
    make_room(static_cast<std::size_t>(walls.count), stress_at_walls_);
    add_pair_sums(settings_, TransposedOnWalls{kernel_}, side(walls.positions(), walls_.grip),
                  side(fluid.positions(), water_.volume, stress()), fresh(sinks(stress_at_walls_)),
                  site_.lists().walls_fluid);
    Where::for_each(walls.count, AddStressOnWall{walls, stress_at_walls_.columns()});
}

}  // namespace riprap::fluid
