// SPDX-License-Identifier: Apache-2.0
#pragma once

// The transposed half of the viscous stress (transposed_stress.hpp) in a step, for host and device.

#include <array>

#include "riprap/fluid/sph/pair_sums.hpp"
#include "riprap/fluid/sph/sph_scratch.hpp"
#include "riprap/fluid/sph/transposed_stress.hpp"
#include "riprap/fluid/sph/wall_pressure.hpp"

namespace riprap::fluid {

inline WendlandC2 kernel_of_stress(const SphSettings& settings) {
    return WendlandC2(settings.smoothing_length(), settings.domain.dimension);
}

/// Finds mu (grad u)^T from grad u, in its place.
struct StressFromGradient {
    NumbersView<1> dynamic_viscosity;
    NumbersView<tensor_numbers> stress;

    RIPRAP_HD void operator()(std::int64_t entry) const {
        const auto i = static_cast<std::size_t>(entry);
        const std::array<double, tensor_numbers> gradient = stress.all(i);
        for (std::size_t a = 0; a < 3; ++a) {
            for (std::size_t b = 0; b < 3; ++b) {
                stress.set(i, 3 * a + b, dynamic_viscosity[i] * gradient[3 * b + a]);
            }
        }
    }
};

/// Adds the sums of TransposedOnWalls to the viscous force.
struct AddStressOnWall {
    WallColumns walls;
    NumbersView<3> stress;

    RIPRAP_HD void operator()(std::int64_t entry) const {
        const auto w = static_cast<std::size_t>(entry);
        walls.viscous_force[w] += walls.volume[w] * stress.vector(w);
    }
};

/// tau of every particle, from velocities and dynamic viscosities at hand; after sum_at_walls.
template <class Data>
void find_transposed_stress(const SphSettings& settings, const ParticleColumns& fluid, const WallColumns& walls,
                            Data& s) {
    const WendlandC2 kernel = kernel_of_stress(settings);
    s.water.transposed_stress.fill(static_cast<std::size_t>(fluid.count), settings.is_plain, {});
    mirror_velocity(settings, s.at_walls, walls, s.walls);  // before walls are told how they move in the end
    const auto v = [&](int axis) { return component(fluid.velocities(), axis); };
    const auto u = [&](std::size_t axis) { return s.walls.mirrored_velocity.view(axis); };
    const auto g = [&](std::size_t k) { return s.water.transposed_stress.sink(k); };
    add_pair_sums_within(settings, VelocityGradient{kernel},
                         {fluid.positions(), {v(0), v(1), v(2), s.water.volume.view()}},
                         {g(0), g(1), g(2), g(3), g(4), g(5), g(6), g(7), g(8)}, s.lists.fluid_fluid);
    add_pair_sums(settings, VelocityGradientAtWalls{kernel}, {fluid.positions(), {v(0), v(1), v(2)}},
                  {walls.positions(), {u(0), u(1), u(2), field(walls.volumes()), s.walls.grip.view()}},
                  {g(0), g(1), g(2), g(3), g(4), g(5), g(6), g(7), g(8)}, s.lists.fluid_walls);
    Data::Where::for_each(fluid.count,
                          StressFromGradient{s.water.dynamic_viscosity.columns(), s.water.transposed_stress.columns()});
}

/// Adds what particles do to each other, walls to particles, and particles to walls, as forces.hpp does.
template <class Data>
void add_transposed_forces(const SphSettings& settings, const ParticleColumns& fluid, Data& s) {
    const WendlandC2 kernel = kernel_of_stress(settings);
    const auto v = [&](int axis) { return component(fluid.velocities(), axis); };
    const auto t = [&](std::size_t k) { return s.water.transposed_stress.view(k); };
    const auto f = [&](std::size_t k) { return s.forces.pushes.sink(k); };
    add_pair_sums_within(
        settings, TransposedStress{kernel},
        {fluid.positions(),
         {v(0), v(1), v(2), s.water.volume.view(), t(0), t(1), t(2), t(3), t(4), t(5), t(6), t(7), t(8)}},
        {f(0), f(1), f(2), s.forces.heat.sink()}, s.lists.fluid_fluid);
}

template <class Data>
void add_transposed_forces_from_walls(const SphSettings& settings, const ParticleColumns& fluid,
                                      const WallColumns& walls, Data& s) {
    const WendlandC2 kernel = kernel_of_stress(settings);
    const auto v = [&](int axis) { return component(fluid.velocities(), axis); };
    const auto t = [&](std::size_t k) { return s.water.transposed_stress.view(k); };
    const auto f = [&](std::size_t k) { return s.forces.pushes.sink(k); };
    add_pair_sums(settings, TransposedFromWalls{kernel},
                  {fluid.positions(), {v(0), v(1), v(2), t(0), t(1), t(2), t(3), t(4), t(5), t(6), t(7), t(8)}},
                  {walls.positions(),
                   {component(walls.velocities(), 0), component(walls.velocities(), 1),
                    component(walls.velocities(), 2), field(walls.volumes()), s.walls.grip.view()}},
                  {f(0), f(1), f(2), s.forces.wall_heat.sink()}, s.lists.fluid_walls);
}

template <class Data>
void add_transposed_forces_on_walls(const SphSettings& settings, const ParticleColumns& fluid, const WallColumns& walls,
                                    Data& s) {
    const WendlandC2 kernel = kernel_of_stress(settings);
    const auto t = [&](std::size_t k) { return s.water.transposed_stress.view(k); };
    auto& sum = s.at_walls.stress;
    sum.resize(static_cast<std::size_t>(walls.count), settings.is_plain);
    add_pair_sums(settings, TransposedOnWalls{kernel}, {walls.positions(), {s.walls.grip.view()}},
                  {fluid.positions(), {s.water.volume.view(), t(0), t(1), t(2), t(3), t(4), t(5), t(6), t(7), t(8)}},
                  fresh<3>({sum.sink(0), sum.sink(1), sum.sink(2)}), s.lists.walls_fluid);
    Data::Where::for_each(walls.count, AddStressOnWall{walls, sum.columns()});
}

}  // namespace riprap::fluid
