// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "riprap/fluid/sph/continuity.hpp"
#include "riprap/fluid/sph/sph_forces.hpp"
#include "riprap/fluid/sph/transposed_stress.hpp"
#include "riprap/fluid/sph/water_in_place.hpp"

namespace riprap::fluid {

/// delta_sph: continuity with density diffusion [Antuono2010], [Fourtakas2019]; pressure, viscosity, walls by
/// extrapolated pressure [Adami2012], shifting. Written once for host and device, see SphForces.
template <class Site>
class DeltaSph : public SphForces<WendlandC2, Site> {
    using Base = SphForces<WendlandC2, Site>;

 public:
    using typename Base::Where;

    explicit DeltaSph(const SphSettings& settings)
        : Base(settings, WendlandC2(settings.smoothing_length(), settings.domain.dimension)) {}

    void update_density(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt,
                        ParticleReport& report) override;
    void begin_forces(ParticleState& state, const BoundaryParticles& walls, const TimeSpan& span, const Vec3& gravity,
                      ParticleReport& report) override;
    void load_walls(const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity) override;
    void kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
              const SparseVectors& extra_force, ParticleReport& report) override;

 protected:
    using Base::at_walls_, Base::corrections_, Base::forces_, Base::kernel_, Base::make_room, Base::settings_,
        Base::site_, Base::stage_, Base::walls_, Base::water_;

    /// Tells whether the viscosity of the case goes by the roughness of the flow.
    bool has_roughness() const {
        return settings_.viscosity.visit([](const auto& law) { return law.follows_roughness(); });
    }
    /// Finds the sums of Continuity and ContinuityAtWalls, and roughness. @returns those that are lent
    DensitySums sum_continuity(const ParticleColumns& fluid, const WallColumns& walls, const Vec3& gravity);
    /// Finds the fields that the sums of forces read, from densities and the sums of Continuity.
    void prepare_forces(const ParticleColumns& fluid);
    void shift(const parallel::Blocks& blocks, const ParticleColumns& fluid, const Vec3& gravity, double dt,
               ParticleReport& report);

    // The transposed half of the viscous stress, of viscosities that have it (transposed_forces.hpp).

    /// Tells whether the viscosity of the case is more than a sum over pairs.
    bool has_stress() const;
    /// tau of every particle, for sweeps.
    std::array<FieldView, tensor_numbers> stress() const;
    /// Finds grad u of every particle from velocities at hand; after sum_at_walls.
    void sum_velocity_gradient(const ParticleColumns& fluid, const WallColumns& walls);
    /// Adds what particles do to each other, walls to particles, and particles to walls, as SphForces does.
    void add_stress_of_fluid(const ParticleColumns& fluid);
    void add_stress_from_walls(const ParticleColumns& fluid, const WallColumns& walls);
    void add_stress_on_walls(const ParticleColumns& fluid, const WallColumns& walls);

    NumbersView<tensor_numbers> velocity_gradient_;  ///< lent, where there is stress [1/s]
    Numbers<3, Where> stress_at_walls_;              ///< of TransposedOnWalls
    FlowWork flow_;                                  ///< of the update of density in this step
    double damping_{0};                              ///< DensityUpdate::damping of this step [W]
    double density_time_{0};                         ///< dt of its update of density [s]
};

template <class Site>
DensitySums DeltaSph<Site>::sum_continuity(const ParticleColumns& fluid, const WallColumns& walls,
                                           const Vec3& gravity) {
    const auto count = static_cast<std::size_t>(fluid.count);
    const DensitySums sums = lend_density_sums(stage_);
    make_room(count, water_.strain, water_.concentration_gradient);
    const Vec3 weight = settings_.rest_density * gravity;
    const double h = settings_.smoothing_length();
    add_pair_sums_within(
        settings_, Continuity{kernel_, {weight.x, weight.y, weight.z}, 1e-4 * h * h},
        side(fluid.positions(), fluid.velocities(), water_.pressure, water_.volume),
        fresh(sinks(sums.diffusion, water_.strain, sums.moments, sums.rates, water_.concentration_gradient)),
        site_.lists().fluid_fluid);
    Where::for_each(fluid.count,
                    LookAround{settings_.domain.dimension, h, water_.concentration_gradient.columns(), sums});
    add_pair_sums(settings_, ContinuityAtWalls{kernel_}, side(fluid.positions(), fluid.velocities()),
                  side(walls.positions(), walls.velocities(), walls.volumes()),
                  sinks(sums.moments, sums.rates, water_.concentration_gradient), site_.lists().fluid_walls);
    if (has_roughness()) {
        make_room(count, water_.dynamic_viscosity);
        Where::for_each(fluid.count, FindRoughness{settings_.domain.dimension, sums, water_.strain.columns(),
                                                   water_.dynamic_viscosity.columns()});
    }
    return sums;
}

template <class Site>
void DeltaSph<Site>::update_density(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
                                    double dt, ParticleReport& report) {
    const double resistance = resistance_of_damping(settings_);
    state.damping.resize(resistance > 0 ? state.position.size() : 0);
    site_.take(reach_of(settings_), state, walls);
    const ParticleColumns fluid = site_.water(state);
    this->find_pressure(fluid);
    const auto count = static_cast<std::size_t>(fluid.count);
    make_room(count, water_.bareness);
    stage_.resize(count, settings_.is_plain, SphPlaces::count + (has_stress() ? tensor_numbers : 0));
    corrections_ = lend_corrections(stage_);
    const DensitySums sums = sum_continuity(fluid, site_.walls(walls), in_plane(gravity, settings_.domain));
    const double diffusivity = 2 * settings_.density_diffusion * settings_.smoothing_length() /
                               (settings_.sound_speed * settings_.rest_density);
    const AdvanceDensity advance_one{settings_.domain.dimension,
                                     settings_.gradient_correction,
                                     dt,
                                     diffusivity,
                                     escape_in_step(settings_.sound_speed * dt / settings_.spacing),
                                     settings_.rest_density,
                                     settings_.particle_mass,
                                     PressureLaw(settings_),
                                     fluid.density,
                                     fluid.dilution,
                                     fluid.damping,
                                     resistance,
                                     sums,
                                     corrections_,
                                     water_.bareness.columns()};
    const DensityUpdate update = Where::sum(state.blocks(), advance_one);
    report.by_density = update.losses;
    report.shifted = update.shifting;
    report.volume = update.volume;
    flow_ = update.flow;
    damping_ = update.damping;
    density_time_ = dt;
    site_.give_density(state);
}

template <class Site>
void DeltaSph<Site>::prepare_forces(const ParticleColumns& fluid) {
    const auto count = static_cast<std::size_t>(fluid.count);
    forces_ = lend_force_sums(stage_);
    velocity_gradient_ = stage_.template lend<tensor_numbers>(SphPlaces::velocity_gradient);
    make_room(count, water_.pressure, water_.volume);
    settings_.viscosity.visit([&]<class Law>(const Law& law) {
        if (Law::follows_strain) {
            make_room(count, water_.dynamic_viscosity);
        } else if (!law.follows_roughness()) {
            water_.dynamic_viscosity.fill(1, settings_.is_plain,
                                          {settings_.rest_density * law.kinematic(settings_, 0)});
        }
        Where::for_each(
            fluid.count,
            PrepareForces<Law>{settings_, law, PressureLaw(settings_), resistance_of_damping(settings_), fluid.density,
                               water_.strain.columns(), corrections_, water_.dynamic_viscosity.columns(),
                               water_.volume.columns(), water_.pressure.columns(), forces_.wall_heat});
    });
}

template <class Site>
void DeltaSph<Site>::begin_forces(ParticleState& state, const BoundaryParticles& walls, const TimeSpan& span,
                                  const Vec3& /*gravity*/, ParticleReport& report) {
    find_lost_particle(settings_, state, span.time, report);
    if (!report.problem.empty()) {
        return;
    }
    site_.take_for_forces(reach_of(settings_), state, walls);
    const ParticleColumns fluid = site_.water(state);
    const WallColumns solid = site_.walls(walls);
    prepare_forces(fluid);
    this->sum_at_walls(fluid, solid);
    this->sum_fluid_forces(fluid);
    if (has_stress()) {
        sum_velocity_gradient(fluid, solid);
        add_stress_of_fluid(fluid);
    }
}

template <class Site>
void DeltaSph<Site>::load_walls(const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity) {
    site_.take_motion(walls);
    const ParticleColumns fluid = site_.water(state);
    const WallColumns solid = site_.walls_to_load(walls);
    this->load(fluid, solid, in_plane(gravity, settings_.domain));
    if (has_stress()) {
        add_stress_on_walls(fluid, solid);
    }
    site_.give_loads(walls);
}

template <class Site>
void DeltaSph<Site>::kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
                          const TimeSpan& span, const SparseVectors& extra_force, ParticleReport& report) {
    const Vec3 pull = in_plane(gravity, settings_.domain);
    const ParticleColumns fluid = site_.water(state);
    const WallColumns solid = site_.walls(walls);
    this->add_forces_from_walls(fluid, solid);
    if (has_stress()) {
        add_stress_from_walls(fluid, solid);
    }
    shift(state.blocks(), fluid, pull, span.dt, report);
    report.by_density.diffusion += flow_.beyond(density_time_, span.dt);
    report.earlier_heat += (density_time_ - 0.5 * span.dt) * damping_;
    this->finish_kick(state, walls, pull, span, extra_force, report);
}

template <class Site>
void DeltaSph<Site>::shift(const parallel::Blocks& blocks, const ParticleColumns& fluid, const Vec3& gravity, double dt,
                           ParticleReport& report) {
    if (settings_.shifting == 0) {
        return;
    }
    const ShiftParticle shift_one{settings_.domain.dimension,
                                  settings_.shifting,
                                  settings_.smoothing_length(),
                                  dt,
                                  settings_.particle_mass,
                                  without_periodic(gravity, settings_.domain),
                                  fluid.position,
                                  fluid.dilution,
                                  water_.concentration_gradient.columns(),
                                  water_.strain.columns(),
                                  water_.bareness.columns(),
                                  corrections_.share,
                                  forces_.to_surface};
    const Shifted shifted = Where::sum(blocks, shift_one);
    report.shifted += shifted.potential;
    report.max_shift = std::sqrt(shifted.longest_squared);
}

}  // namespace riprap::fluid

#include "riprap/fluid/sph/transposed_forces.hpp"  // the rest of it

namespace riprap::fluid {

extern template class DeltaSph<WaterInPlace>;  // delta_sph.cpp

}  // namespace riprap::fluid
