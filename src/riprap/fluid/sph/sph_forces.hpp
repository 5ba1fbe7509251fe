// SPDX-License-Identifier: Apache-2.0
#pragma once

// From pressures and viscosities to forces on fluid and walls, the same for every scheme of SPH.

#include "riprap/fluid/particle/unsound_particles.hpp"
#include "riprap/fluid/sph/momentum.hpp"
#include "riprap/fluid/sph/sph.hpp"
#include "riprap/fluid/sph/sph_numbers.hpp"
#include "riprap/fluid/sph/wall_loops.hpp"
#include "riprap/fluid/sph/water_loops.hpp"

namespace riprap::fluid {

/// A scheme of SPH whose forces go by a kernel: its buffers, and the sums at walls and between particles.
/// @tparam Site  where particles are and loops run: WaterInPlace, or a WaterCopy for a device, with the same code
template <class Kernel, class Site>
class SphForces : public Sph {
 public:
    using Where = typename Site::Where;

    SphForces(const SphSettings& settings, const Kernel& kernel) : Sph(settings), kernel_(kernel) {}

    void describe_walls(const Vec3& gravity, WaterAtWalls& water) const override {
        const std::size_t count = at_walls_.weight.size();
        typename Where::template Array<double> weight(count), pressure(count);
        typename Where::template Array<Vec3> slope(count);
        Where::for_each(static_cast<std::int64_t>(count),
                        DescribeWall{pressure_at_wall(), at_walls_.slope.columns(), gravity, weight.data(),
                                     pressure.data(), slope.data()});
        water.weight.resize(count);
        water.pressure.resize(count);
        water.slope.resize(count);
        Where::template download<double>(weight, water.weight);
        Where::template download<double>(pressure, water.pressure);
        Where::template download<Vec3>(slope, water.slope);
    }
    std::size_t bytes() const override {
        return water_.bytes() + stage_.bytes() + at_walls_.bytes() + walls_.bytes() + site_.bytes();
    }

 protected:
    /// Calls work(pair) with the viscosity of the case between pairs of particles.
    template <class Work>
    void with_viscosity(const Work& work) const {
        settings_.viscosity.visit([&](const auto& law) { work(law.pair(settings_, kernel_)); });
    }
    /// Finds pressure and volume of every particle from its density.
    void find_pressure(const ParticleColumns& fluid) {
        const auto count = static_cast<std::size_t>(fluid.count);
        make_room(count, water_.pressure, water_.volume);
        Where::for_each(fluid.count, FindPressure{PressureLaw(settings_), settings_.particle_mass, fluid.density,
                                                  water_.pressure.columns(), water_.volume.columns()});
    }
    /// Finds the sums of WallAverages and PressureOnWalls, for walls that may then be told to move in another way but
    /// not to another place.
    void sum_at_walls(const ParticleColumns& fluid, const WallColumns& walls) {
        WaterAtWallSumsIn<Where>& at = at_walls_;
        make_room(static_cast<std::size_t>(walls.count), at.weight, at.pressure, at.moment, at.velocity, at.slope,
                  at.push);
        const WendlandC2 mean(settings_.smoothing_length(), settings_.domain.dimension);
        add_pair_sums(settings_, WaterOnWalls<Kernel>{{mean}, {kernel_}}, side(walls.positions()),
                      side(fluid.positions(), fluid.velocities(), water_.pressure, fluid.densities(), water_.volume,
                           corrections_.tensor),
                      fresh(sinks(at.weight, at.pressure, at.moment, at.velocity, at.slope, at.push)),
                      site_.lists().walls_fluid);
    }
    /// Finds the sums of Momentum: fluid on fluid.
    void sum_fluid_forces(const ParticleColumns& fluid) {
        with_viscosity([&]<class Law>(const Law& law) {
            add_pair_sums_within(settings_, Momentum<Kernel, Law>{kernel_, law},
                                 side(fluid.positions(), fluid.velocities(), water_.volume, water_.dynamic_viscosity,
                                      water_.bareness, products(fields(corrections_.tensor), water_.pressure)),
                                 fresh(sinks(forces_.force, forces_.heat, forces_.to_surface)),
                                 site_.lists().fluid_fluid);
        });
    }
    /// Adds the sums of MomentumFromWalls: what walls do to the fluid.
    void add_forces_from_walls(const ParticleColumns& fluid, const WallColumns& walls) {
        with_viscosity([&]<class Law>(const Law& law) {
            add_pair_sums(settings_, MomentumFromWalls<Kernel, Law>{kernel_, law},
                          side(fluid.positions(), fluid.velocities(), water_.pressure, water_.dynamic_viscosity,
                               corrections_.tensor),
                          side(walls.positions(), walls_.mirrored_velocity, walls.pressures(), walls.volumes(),
                               walls_.grip, walls.velocities()),
                          joined(sinks(forces_.force, forces_.wall_heat),
                                 fresh(sinks(forces_.wall_hold, forces_.wall_hold_power))),
                          site_.lists().fluid_walls);
        });
    }
    /// Mean pressure of the water about wall particles.
    PressureAtWall pressure_at_wall() const {
        return {at_walls_.weight.columns(), at_walls_.pressure.columns(), at_walls_.moment.columns()};
    }
    /// Finds u_w (see load) and the grip of walls that move as they say now.
    void mirror_velocity(const WallColumns& walls) {
        make_room(static_cast<std::size_t>(walls.count), walls_.mirrored_velocity, walls_.grip);
        Where::for_each(walls.count, MirrorVelocity{walls, at_walls_.weight.columns(), at_walls_.velocity.columns(),
                                                    walls_.mirrored_velocity.columns(), walls_.grip.columns()});
    }
    /// Extrapolates the pressure of the fluid to wall particles and mirrors its velocity in them, from averages over
    /// fluid j [Adami2012, eqs. 22, 23, 27]:
    ///
    ///     p_w = max(0, sum (p_j + rho_j (g - a_w).(x_w - x_j)) W / sum W),     u_w = 2 v_f - sum v_j W / sum W,
    ///
    /// v_f the velocity of the solid at the foot of w on its face,
    /// and finds the forces of the fluid on walls [N]: of pressure, and of viscosity where some are not slippery.
    /// Differs from the source: walls never pull.
    void load(const ParticleColumns& fluid, const WallColumns& walls, const Vec3& gravity) {
        mirror_velocity(walls);
        Where::for_each(walls.count, ExtrapolateToWall{walls, pressure_at_wall(), gravity});
        Where::for_each(walls.count, ClearForce{walls.viscous_force});
        if (walls.may_stick) {
            const std::span<Vec3> viscous{walls.viscous_force, static_cast<std::size_t>(walls.count)};
            with_viscosity([&]<class Law>(const Law& law) {
                add_pair_sums(settings_, ViscosityOnWalls<Kernel, Law>{kernel_, law},
                              side(walls.positions(), walls_.mirrored_velocity, walls_.grip),
                              side(fluid.positions(), fluid.velocities(), water_.volume, water_.dynamic_viscosity),
                              sinks(viscous), site_.lists().walls_fluid);
            });
        }
        Where::for_each(walls.count, ForceOnWall{walls, at_walls_.slope.columns(), at_walls_.push.columns()});
    }
    /// Kicks the fluid by the forces found, and books the step.
    void finish_kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
                     const SparseVectors& extra_force, FluidReport& report) {
        const auto extra = site_.extra(extra_force, state.position.size());
        using Extra = std::remove_const_t<decltype(extra)>;
        const ParticleColumns fluid = site_.water(state);
        const KickParticle<Extra> kick_one{
            settings_.particle_mass, span.dt, gravity, gravity - without_periodic(gravity, settings_.domain), fluid,
            water_.volume.columns(), forces_, extra};
        book_kick(fluid.count, gravity, span.dt, Where::sum(state.blocks(), kick_one), report);
        site_.give_motion(state);
        book_compression(state, report);
        state.max_acceleration = report.max_acceleration;
        book_walls(walls, span.dt, report);
        find_wild_particle(settings_, state, span.time, report);
    }
    template <class... All>
    void make_room(std::size_t count, All&... numbers) const {
        (numbers.resize(count, settings_.is_plain), ...);
    }

    Kernel kernel_;
    Site site_;
    WaterFieldsIn<Where> water_;
    StageMemory<Where> stage_;
    Corrections corrections_;  ///< lent by it
    ForceSums forces_;         ///< likewise
    WaterAtWallSumsIn<Where> at_walls_;
    WallFieldsIn<Where> walls_;
};

}  // namespace riprap::fluid
