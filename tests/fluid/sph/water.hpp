// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "riprap/fluid/particle/state_equation.hpp"
#include "riprap/fluid/sph/delta_sph.hpp"

namespace riprap::fluid::testing {

/// delta_sph with its buffers open.
struct OpenDeltaSph : DeltaSph<WaterInPlace> {
    using DeltaSph::corrections_;
    using DeltaSph::DeltaSph;
    using DeltaSph::water_;
};

/// A body of water with its walls and what its ledger added up.
struct Water {
    SphSettings settings;
    ParticleState state;
    BoundaryParticles walls;
    Vec3 gravity{};
    std::unique_ptr<ParticleScheme> scheme;  ///< of the settings as its first use finds them

    double time{0}, last_dt{0};
    ParticleReport report;  ///< of the last step
    double dissipated_viscous{0}, dissipated_diffusion{0}, shifted{0}, work_on_solids{0}, wall_exchange{0},
        work_external{0};
    Vec3 impulse{};
    int renewals{0};             ///< of the geometry
    bool are_walls_still{true};  ///< what a scheme with two clocks is told

    /// Moves walls to a time: fills position, velocity, acceleration.
    std::function<void(BoundaryParticles&, double)> move_walls;

    double stored() const { return report.kinetic + report.potential + report.internal; }
    /// constant where every change of energy is booked [J]
    double closure() const {
        return stored() + dissipated_viscous + dissipated_diffusion + shifted + work_on_solids + wall_exchange -
               work_external;
    }

    ParticleScheme& verbs() {
        if (scheme == nullptr) {
            const bool is_open = settings.scheme != SphScheme::muller && settings.sound_steps == 1;
            scheme = is_open ? std::make_unique<OpenDeltaSph>(settings) : make_scheme(settings);
        }
        return *scheme;
    }
    /// What delta_sph found last.
    const OpenDeltaSph& inside() const { return dynamic_cast<const OpenDeltaSph&>(*scheme); }
    FluidTimeStep limit() const { return make_scheme(settings)->limit(state); }
    void update_density(const Vec3& pull, double dt) { verbs().update_density(state, walls, pull, dt, report); }
    /// Finds forces and kicks, with walls that move as they do.
    void accelerate(const Vec3& pull, double dt) {
        const TimeSpan span{time, dt};
        verbs().begin_forces(state, walls, span, pull, report);
        if (report.problem.empty()) {
            verbs().load_walls(state, walls, pull);
            verbs().kick(state, walls, pull, span, {}, report);
        }
    }

    void step(double dt_most = 1e9) {
        const double dt = std::min(verbs().limit(state).limit, dt_most);
        report = {};
        if (move_walls) {
            move_walls(walls, time);
        }
        double since = 0.5 * (last_dt + dt);
        const bool is_still = !move_walls && are_walls_still;
        renewals += verbs().renew(state, walls, gravity, {time, dt}, is_still, since, report) > 0 ? 1 : 0;
        update_density(gravity, since);
        drift(settings, state, 0.5 * dt);
        if (move_walls) {
            move_walls(walls, time + 0.5 * dt);
        }
        accelerate(gravity, dt);
        drift(settings, state, 0.5 * dt);
        dissipated_viscous += report.dissipated_viscous + report.earlier_heat;
        dissipated_diffusion += report.by_density.sum();
        shifted += report.shifted;
        work_on_solids += report.work_on_solids;
        wall_exchange += report.wall_exchange + report.earlier_exchange;
        work_external += report.work_external;
        impulse += report.impulse;
        time += dt;
        last_dt = dt;
    }
    void run_until(double end) {
        while (time < end && report.problem.empty()) {
            step(end - time);
        }
    }

    void add_particle(const Vec3& x, const Vec3& v = {}, double pressure = 0) {
        state.add(x, v, density_of(settings, pressure), static_cast<std::int32_t>(state.size()));
    }
    void add_wall_particle(const Vec3& x, bool is_slippery, const Vec3& v = {}) {
        walls.position.push_back(x);
        walls.velocity.push_back(v);
        walls.acceleration.push_back({});
        walls.volume.push_back(std::pow(settings.spacing, settings.domain.dimension));
        walls.is_slippery.push_back(is_slippery ? 1 : 0);
    }
};

inline SphSettings settings_2d(double spacing, double sound_speed) {
    SphSettings settings;
    settings.spacing = spacing;
    settings.sound_speed = sound_speed;
    settings.particle_mass = settings.rest_density * spacing * spacing;
    settings.domain = {{-100, -100, 0}, {100, 100, 0}, {}, 2};
    return settings;
}

/// f(x, y) at the centres of the cells of a box [0, width] x [0, height]
inline void for_lattice(double spacing, double width, double height, const std::function<void(double, double)>& f) {
    const auto columns = std::lround(width / spacing), rows = std::lround(height / spacing);
    for (long row = 0; row < rows; ++row) {
        for (long column = 0; column < columns; ++column) {
            f((static_cast<double>(column) + 0.5) * spacing, (static_cast<double>(row) + 0.5) * spacing);
        }
    }
}

/// Layers of wall particles behind the sides and the bottom of an open tank [0, width] x [0, height]
inline void add_tank(Water& water, double width, double height, bool is_slippery) {
    const double dp = water.settings.spacing;
    const auto layers = static_cast<long>(std::ceil(water.settings.support_radius() / dp));
    const auto columns = std::lround(width / dp), rows = std::lround(height / dp);
    for (long row = -layers; row < rows; ++row) {
        for (long column = -layers; column < columns + layers; ++column) {
            if (row < 0 || column < 0 || column >= columns) {
                water.add_wall_particle(
                    {(static_cast<double>(column) + 0.5) * dp, (static_cast<double>(row) + 0.5) * dp, 0}, is_slippery);
            }
        }
    }
}

/// Water of a depth in hydrostatic balance between x = 0 and x = width
inline void add_still_water(Water& water, double width, double depth) {
    const double weight = -water.gravity.y * water.settings.rest_density;
    for_lattice(water.settings.spacing, width, depth, [&](double x, double y) {
        water.add_particle({x, y, 0}, {}, weight * (depth - y));
    });
}

}  // namespace riprap::fluid::testing
