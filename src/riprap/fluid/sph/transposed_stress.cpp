// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/transposed_stress.hpp"

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/sph/pair_sums.hpp"
#include "riprap/fluid/sph/wall_pressure.hpp"

namespace riprap::fluid {

namespace {

WendlandC2 kernel_of(const SphSettings& s) { return WendlandC2(s.smoothing_length(), s.domain.dimension); }

}  // namespace

void find_transposed_stress(const SphSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
                            SphScratchData& s) {
    s.water.transposed_stress.fill(state.position.size(), settings.is_plain, {});
    mirror_velocity(settings, s.at_walls, walls, s.walls);  // before walls are told how they move in the end
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    const auto u = [&](std::size_t axis) { return s.walls.mirrored_velocity.view(axis); };
    const auto g = [&](std::size_t k) { return s.water.transposed_stress.sink(k); };
    add_pair_sums_within(settings, VelocityGradient{kernel_of(settings)},
                         {state.position, {v(0), v(1), v(2), s.water.volume.view()}},
                         {g(0), g(1), g(2), g(3), g(4), g(5), g(6), g(7), g(8)}, s.lists.fluid_fluid);
    add_pair_sums(settings, VelocityGradientAtWalls{kernel_of(settings)}, {state.position, {v(0), v(1), v(2)}},
                  {walls.position, {u(0), u(1), u(2), field(walls.volume), s.walls.grip.view()}},
                  {g(0), g(1), g(2), g(3), g(4), g(5), g(6), g(7), g(8)}, s.lists.fluid_walls);
    parallel::for_each(state.owned(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        const std::array<double, tensor_numbers> gradient = s.water.transposed_stress.all(i);
        for (std::size_t a = 0; a < 3; ++a) {
            for (std::size_t b = 0; b < 3; ++b) {
                s.water.transposed_stress.set(i, 3 * a + b, s.water.dynamic_viscosity[i] * gradient[3 * b + a]);
            }
        }
    });
}

void add_transposed_forces(const SphSettings& settings, const ParticleState& state, SphScratchData& s) {
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    const auto t = [&](std::size_t k) { return s.water.transposed_stress.view(k); };
    const auto f = [&](std::size_t k) { return s.forces.pushes.sink(k); };
    add_pair_sums_within(
        settings, TransposedStress{kernel_of(settings)},
        {state.position,
         {v(0), v(1), v(2), s.water.volume.view(), t(0), t(1), t(2), t(3), t(4), t(5), t(6), t(7), t(8)}},
        {f(0), f(1), f(2), s.forces.heat.sink()}, s.lists.fluid_fluid);
}

void add_transposed_forces_from_walls(const SphSettings& settings, const ParticleState& state,
                                      const BoundaryParticles& walls, SphScratchData& s) {
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    const auto t = [&](std::size_t k) { return s.water.transposed_stress.view(k); };
    const auto f = [&](std::size_t k) { return s.forces.pushes.sink(k); };
    add_pair_sums(settings, TransposedFromWalls{kernel_of(settings)},
                  {state.position, {v(0), v(1), v(2), t(0), t(1), t(2), t(3), t(4), t(5), t(6), t(7), t(8)}},
                  {walls.position,
                   {component(walls.velocity, 0), component(walls.velocity, 1), component(walls.velocity, 2),
                    field(walls.volume), s.walls.grip.view()}},
                  {f(0), f(1), f(2), s.forces.wall_heat.sink()}, s.lists.fluid_walls);
}

void add_transposed_forces_on_walls(const SphSettings& settings, const ParticleState& state, BoundaryParticles& walls,
                                    SphScratchData& s) {
    const auto t = [&](std::size_t k) { return s.water.transposed_stress.view(k); };
    Numbers<3>& sum = s.at_walls.stress;
    sum.resize(walls.position.size(), settings.is_plain);
    add_pair_sums(settings, TransposedOnWalls{kernel_of(settings)}, {walls.position, {s.walls.grip.view()}},
                  {state.position, {s.water.volume.view(), t(0), t(1), t(2), t(3), t(4), t(5), t(6), t(7), t(8)}},
                  fresh<3>({sum.sink(0), sum.sink(1), sum.sink(2)}), s.lists.walls_fluid);
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        walls.viscous_force[w] += walls.volume[w] * sum.vector(w);
    });
}

}  // namespace riprap::fluid
