// SPDX-License-Identifier: Apache-2.0
#pragma once

// The verbs of delta_sph (schemes.hpp), written once for host and device: `Data` is SphScratchData, or the same numbers
// with lists of another kind (device_sph.hpp). Columns are in the memory of Data::Where.

#include <cmath>

#include "riprap/fluid/sph/continuity.hpp"
#include "riprap/fluid/sph/forces.hpp"
#include "riprap/fluid/sph/kick.hpp"
#include "riprap/fluid/sph/pair_sums.hpp"
#include "riprap/fluid/sph/sph_scratch.hpp"
#include "riprap/fluid/sph/transposed_forces.hpp"
#include "riprap/fluid/sph/wall_pressure.hpp"

namespace riprap::fluid::delta_sph {

inline WendlandC2 kernel_of(const SphSettings& s) { return WendlandC2(s.smoothing_length(), s.domain.dimension); }

/// Calls work(pair) with the viscosity of the case between pairs of particles.
template <class Work>
void with_viscosity(const SphSettings& settings, const Work& work) {
    settings.viscosity.visit([&](const auto& law) { work(law.pair(settings, kernel_of(settings))); });
}
/// Calls work() where the viscosity is more than a sum over pairs.
template <class Work>
void with_stress(const SphSettings& settings, const Work& work) {
    settings.viscosity.visit([&]<class Law>(const Law&) {
        if constexpr (requires { Law::has_transposed_stress; }) {
            work();
        }
    });
}

/// Finds the sums of Continuity and ContinuityAtWalls.
template <class Data>
void sum_continuity(const SphSettings& settings, const ParticleColumns& fluid, const WallColumns& walls,
                    const Vec3& gravity, Data& s) {
    using Where = typename Data::Where;
    const auto count = static_cast<std::size_t>(fluid.count);
    ContinuitySumsIn<Where>& sums = s.continuity;
    WaterFieldsIn<Where>& water = s.water;
    sums.diffusion.resize(count, settings.is_plain);
    sums.strain.resize(count, settings.is_plain);
    sums.rates.resize(count, settings.is_plain);
    sums.concentration_gradient.resize(count, settings.is_plain);
    const WendlandC2 kernel = kernel_of(settings);
    const Vec3 weight = settings.rest_density * gravity;
    const double h = settings.smoothing_length();
    const int dimension = settings.domain.dimension;
    const auto v = [&](int axis) { return component(fluid.velocities(), axis); };
    const auto m = [&](std::size_t k) { return water.correction.sink(k); };
    const auto g = [&](std::size_t k) { return sums.rates.sink(k); };
    const auto c = [&](std::size_t axis) { return sums.concentration_gradient.sink(axis); };
    add_pair_sums_within(settings, Continuity{kernel, {weight.x, weight.y, weight.z}, 1e-4 * h * h},
                         {fluid.positions(), {v(0), v(1), v(2), water.pressure.view(), water.volume.view()}},
                         fresh<17>({sums.diffusion.sink(), sums.strain.sink(), m(0), m(1), m(2), m(3), m(4), m(5), g(0),
                                    g(1), g(2), g(3), g(4), g(5), c(0), c(1), c(2)}),
                         s.lists.fluid_fluid);
    Where::for_each(fluid.count,
                    LookAround{dimension, h, sums.concentration_gradient.columns(), water.correction.columns(),
                               water.correction_share.columns(), water.damped_share.columns()});
    add_pair_sums(settings, ContinuityAtWalls{kernel}, {fluid.positions(), {v(0), v(1), v(2)}},
                  {walls.positions(),
                   {component(walls.velocities(), 0), component(walls.velocities(), 1),
                    component(walls.velocities(), 2), field(walls.volumes())}},
                  {m(0), m(1), m(2), m(3), m(4), m(5), g(0), g(1), g(2), g(3), g(4), g(5), c(0), c(1), c(2)},
                  s.lists.fluid_walls);
}

template <class Data>
void make_room_for_density(const SphSettings& settings, std::int64_t particles, Data& s) {
    const auto count = static_cast<std::size_t>(particles);
    auto& water = s.water;
    water.correction.resize(count, settings.is_plain);
    for (auto* numbers : {&water.bareness, &water.correction_share, &water.damped_share, &water.compression_rate}) {
        numbers->resize(count, settings.is_plain);
    }
}

/// Carries the density over a step; the lists know where the particles are.
template <class Data>
void update_density(const SphSettings& settings, const ParticleColumns& fluid, const WallColumns& walls,
                    const Vec3& gravity, double dt, Data& s, FluidReport& report) {
    using Where = typename Data::Where;
    WaterFieldsIn<Where>& water = s.water;
    if (s.continuity.rates.size() == 0) {
        s.exchange_memory_of_rate();
        s.exchange_memory();
    }
    find_pressure(settings, fluid, water);
    make_room_for_density(settings, fluid.count, s);
    sum_continuity(settings, fluid, walls, gravity, s);
    const double diffusivity =
        2 * settings.density_diffusion * settings.smoothing_length() / (settings.sound_speed * settings.rest_density);
    const AdvanceDensity advance_one{settings.domain.dimension,
                                     settings.gradient_correction,
                                     dt,
                                     diffusivity,
                                     escape_in_step(settings.sound_speed * dt / settings.spacing),
                                     settings.rest_density,
                                     settings.particle_mass,
                                     PressureLaw(settings),
                                     fluid.density,
                                     fluid.dilution,
                                     s.continuity.diffusion.columns(),
                                     s.continuity.rates.columns(),
                                     water.correction.columns(),
                                     water.correction_share.columns(),
                                     water.damped_share.columns(),
                                     water.bareness.columns(),
                                     water.compression_rate.columns()};
    const Losses losses = Where::reduce(fluid.count, Losses{}, advance_one, AddLosses{});
    report.dissipated_diffusion = losses.diffusion;
    report.shifted = losses.shifting;
}

/// Finds the fields that the sums of forces read, from densities and the sums of Continuity.
template <class Data>
void prepare_forces(const SphSettings& settings, const ParticleColumns& fluid, Data& s) {
    using Where = typename Data::Where;
    const auto count = static_cast<std::size_t>(fluid.count);
    WaterFieldsIn<Where>& water = s.water;
    water.pressure.resize(count, settings.is_plain);
    water.volume.resize(count, settings.is_plain);
    s.forces.wall_heat.resize(count, settings.is_plain);
    settings.viscosity.visit([&]<class Law>(const Law& law) {
        if (Law::follows_strain) {
            water.dynamic_viscosity.resize(count, settings.is_plain);
        } else {
            water.dynamic_viscosity.fill(1, settings.is_plain, {settings.rest_density * law.kinematic(settings, 0)});
        }
        Where::for_each(
            fluid.count,
            PrepareForces<Law>{settings, law, PressureLaw(settings), resistance_of_damping(settings), fluid.density,
                               s.continuity.strain.columns(), water.damped_share.columns(),
                               water.compression_rate.columns(), water.dynamic_viscosity.columns(),
                               water.volume.columns(), water.pressure.columns(), s.forces.wall_heat.columns()});
    });
}

/// Finds all forces that how walls move does not change; the lists know where the particles are.
template <class Data>
void begin_forces(const SphSettings& settings, const ParticleColumns& fluid, const WallColumns& walls, Data& s) {
    s.exchange_memory();
    prepare_forces(settings, fluid, s);
    s.exchange_memory_of_rate();
    make_room_for_forces(settings, fluid.count, s.forces);
    sum_at_walls(settings, kernel_of(settings), fluid, walls, s);
    with_viscosity(settings, [&](const auto& law) { add_fluid_forces(settings, kernel_of(settings), fluid, law, s); });
    with_stress(settings, [&] {
        find_transposed_stress(settings, fluid, walls, s);
        add_transposed_forces(settings, fluid, s);
    });
}

template <class Data>
void load_walls(const SphSettings& settings, const ParticleColumns& fluid, const WallColumns& walls,
                const Vec3& gravity, Data& s) {
    extrapolate_to_walls(settings, s.at_walls, gravity, walls, s.walls);
    with_viscosity(settings,
                   [&](const auto& law) { find_forces_on_walls(settings, kernel_of(settings), fluid, walls, law, s); });
    with_stress(settings, [&] { add_transposed_forces_on_walls(settings, fluid, walls, s); });
}

/// Adds what walls do to the fluid, and shifts particles.
template <class Data>
void finish_forces(const SphSettings& settings, const ParticleColumns& fluid, const WallColumns& walls,
                   const Vec3& gravity, double dt, Data& s, FluidReport& report) {
    with_viscosity(
        settings, [&](const auto& law) { add_forces_from_walls(settings, kernel_of(settings), fluid, walls, law, s); });
    with_stress(settings, [&] { add_transposed_forces_from_walls(settings, fluid, walls, s); });
    if (settings.shifting == 0) {
        return;
    }
    const ShiftParticle shift_one{settings.domain.dimension,
                                  settings.shifting,
                                  settings.smoothing_length(),
                                  dt,
                                  settings.particle_mass,
                                  without_periodic(gravity, settings.domain),
                                  fluid.position,
                                  fluid.dilution,
                                  s.continuity.concentration_gradient.columns(),
                                  s.continuity.strain.columns(),
                                  s.water.bareness.columns(),
                                  s.water.correction_share.columns(),
                                  s.forces.pushes.columns()};
    const Shifted shifted = Data::Where::reduce(fluid.count, Shifted{}, shift_one, AddShifted{});
    report.shifted += shifted.potential;
    report.max_shift = std::sqrt(shifted.longest_squared);
}

}  // namespace riprap::fluid::delta_sph
