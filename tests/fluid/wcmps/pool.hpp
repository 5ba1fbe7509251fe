// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "riprap/fluid/particle/sort.hpp"
#include "riprap/fluid/wcmps/wcmps.hpp"

namespace riprap::fluid::testing {

/// Weakly compressible MPS with its buffers and collisions open.
struct OpenWcmps : Wcmps {
    using Wcmps::collisions_;
    using Wcmps::continuity_;
    using Wcmps::find_collisions;
    using Wcmps::lists_;
    using Wcmps::surface_;
    using Wcmps::Wcmps;
};

/// Water by weakly compressible MPS with its walls and what its ledger added up.
struct Pool {
    WcmpsSettings settings;
    ParticleState state;
    BoundaryParticles walls;
    Vec3 gravity{};
    std::unique_ptr<OpenWcmps> scheme;  ///< of the settings as its first use finds them

    double time{0}, last_dt{0};
    std::int64_t step_count{0};
    ParticleReport report;  ///< of the last step
    double viscous{0}, diffusion{0}, collisions{0}, shifted{0}, work_on_solids{0}, wall_exchange{0}, work_external{0};
    Vec3 impulse{};

    /// Moves walls to a time: fills position, velocity, acceleration.
    std::function<void(double)> move_walls;

    double stored() const { return report.kinetic + report.potential + report.internal; }
    /// Constant where every change of energy is booked [J]
    double closure() const {
        return stored() + viscous + diffusion + collisions + shifted + work_on_solids + wall_exchange - work_external;
    }

    OpenWcmps& verbs() {
        if (scheme == nullptr) {
            scheme = std::make_unique<OpenWcmps>(settings);
        }
        return *scheme;
    }
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
        if (step_count++ % settings.sort_interval == 0) {
            sort_by_place(state, settings.domain, settings.spacing);
        }
        const double dt = std::min(verbs().limit(state).limit, dt_most);
        report = {};
        if (move_walls) {
            move_walls(time);
        }
        update_density(gravity, 0.5 * (last_dt + dt));
        drift(settings, state, 0.5 * dt);
        if (move_walls) {
            move_walls(time + 0.5 * dt);
        }
        accelerate(gravity, dt);
        drift(settings, state, 0.5 * dt);
        viscous += report.dissipated_viscous + report.earlier_heat;
        diffusion += report.by_density.sum();
        collisions += report.dissipated_collisions + report.earlier_collisions;
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
        state.add(x, v, settings.rest_density * concentration_of(settings, pressure),
                  static_cast<std::int32_t>(state.size()));
    }
    void add_wall_particle(const Vec3& x, bool is_slippery) {
        walls.position.push_back(x);
        walls.velocity.push_back({});
        walls.acceleration.push_back({});
        walls.volume.push_back(std::pow(settings.spacing, settings.domain.dimension));
        walls.is_slippery.push_back(is_slippery ? 1 : 0);
    }
};

inline WcmpsSettings wcmps_settings(int dimension, double spacing, double sound_speed) {
    WcmpsSettings settings;
    settings.spacing = spacing;
    settings.sound_speed = sound_speed;
    settings.particle_mass = settings.rest_density * std::pow(spacing, dimension);
    settings.domain = {{-10, -10, -10}, {10, 10, 10}, {}, dimension};
    return settings;
}

/// An open tank of columns x rows cells (in three dimensions columns deep, too) with the lowest cells full of still
/// water, which fill(i, j) tells; y points up.
inline void add_tank(Pool& pool, long columns, long rows, bool is_slippery,
                     const std::function<double(const Vec3&)>& pressure, const std::function<bool(long, long)>& fill) {
    const double dp = pool.settings.spacing;
    const bool is_solid = pool.settings.domain.dimension == 3;
    const auto layers = static_cast<long>(std::ceil(pool.settings.support_ratio()));
    for (long k = is_solid ? -layers : 0; k < (is_solid ? columns + layers : 1); ++k) {
        for (long j = -layers; j < rows; ++j) {
            for (long i = -layers; i < columns + layers; ++i) {
                const Vec3 x{(static_cast<double>(i) + 0.5) * dp, (static_cast<double>(j) + 0.5) * dp,
                             is_solid ? (static_cast<double>(k) + 0.5) * dp : 0};
                if (j < 0 || i < 0 || i >= columns || (is_solid && (k < 0 || k >= columns))) {
                    pool.add_wall_particle(x, is_slippery);
                } else if (fill(i, j)) {
                    pool.add_particle(x, {}, pressure(x));
                }
            }
        }
    }
}

}  // namespace riprap::fluid::testing
