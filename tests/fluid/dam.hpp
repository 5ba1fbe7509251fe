// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "fluid/sph/water.hpp"
#include "riprap/fluid/schemes.hpp"

namespace riprap::fluid::testing {

/// A column of water beside a dry floor, stepped as the driver does it: through the interface of all schemes.
template <class Settings>
struct Dam {
    Settings settings;
    ParticleState state;
    BoundaryParticles walls;
    Vec3 gravity{0, -9.81, 0};
    std::unique_ptr<ParticleScheme> scheme;
    double time{0}, last_dt{0}, given{0};
    FluidReport report;
    Vec3 impulse{};

    explicit Dam(const Settings& chosen = {}) : settings(chosen) {
        Water water;
        water.settings = settings_2d(0.5 / 16, 20 * std::sqrt(9.81 * 0.5));
        add_tank(water, 1.0, 0.75, true);
        walls = water.walls;
        ParticleSettings& base = settings;
        base.spacing = water.settings.spacing;
        base.sound_speed = water.settings.sound_speed;
        base.particle_mass = water.settings.particle_mass;
        base.domain = water.settings.domain;
        for_lattice(base.spacing, 0.5, 0.5, [&](double x, double y) {
            state.add({x, y, 0}, {}, density_of(base, 1000 * 9.81 * (0.5 - y)),
                      static_cast<std::int32_t>(state.size()));
        });
        scheme = make_scheme(settings);
    }
    double stored() const { return report.kinetic + report.potential + report.internal; }

    void step() {
        const double dt = scheme->limit(state).limit;
        const TimeSpan span{time, dt};
        report = {};
        scheme->update_density(state, walls, gravity, 0.5 * (last_dt + dt), report);
        drift(settings, state, 0.5 * dt);
        scheme->begin_forces(state, walls, span, gravity, report);
        scheme->load_walls(state, walls, gravity);
        scheme->load_walls(state, walls, gravity);  // as light bodies make the driver do
        scheme->kick(state, walls, gravity, span, {}, report);
        drift(settings, state, 0.5 * dt);
        given += report.dissipated_viscous + report.dissipated_collisions + report.by_density.sum() +
                 report.pressure_loss + report.shifted + report.work_on_solids + report.wall_exchange +
                 report.earlier_heat + report.earlier_collisions + report.earlier_exchange - report.work_external;
        impulse += report.impulse;
        time += dt;
        last_dt = dt;
    }
    void run_until(double end) {
        while (time < end && report.problem.empty()) {
            step();
        }
    }
};

/// delta_sph by the loops of a device, which has the bits of the host here.
struct SphOnDevice : SphSettings {
    SphOnDevice() { runs_on = RunsOn::device; }
};

}  // namespace riprap::fluid::testing
