// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "riprap/fluid/mps/mps.hpp"
#include "riprap/fluid/particle/sort.hpp"

namespace riprap::fluid::testing {

/// Water by semi-implicit MPS with its walls and what its ledger added up.
struct Basin {
    MpsSettings settings;
    ParticleState state;
    BoundaryParticles walls;
    Vec3 gravity{};
    std::unique_ptr<Mps> scheme;  ///< of the settings as its first use finds them

    double time{0}, last_dt{0};
    std::int64_t step_count{0};
    ParticleReport report;  ///< of the last step
    double viscous{0}, collisions{0}, pressure_loss{0}, work_on_solids{0}, work_external{0};
    double booked_in_step{0};  ///< of these, in the last step: half of it comes after the kick
    Vec3 impulse{};

    double stored() const { return report.kinetic + report.potential; }
    /// Constant where every change of energy is booked [J]
    double closure() const { return stored() + booked() - 0.5 * booked_in_step; }
    double booked() const { return viscous + collisions + pressure_loss + work_on_solids - work_external; }

    Mps& verbs() {
        if (scheme == nullptr) {
            scheme = std::make_unique<Mps>(settings);
        }
        return *scheme;
    }
    FluidTimeStep limit() const { return Mps(settings).limit(state); }
    void begin_forces(const Vec3& pull, double dt) {
        verbs().begin_forces(state, walls, {time, dt}, pull, report);
        EXPECT_EQ(report.problem, "");
    }
    /// Solves for the pressure and loads walls.
    void find_pressure(const Vec3& pull, double dt) {
        begin_forces(pull, dt);
        verbs().load_walls(state, walls, pull);
        EXPECT_TRUE(verbs().solved().is_converged());
    }

    void step(double dt_most = 1e9) {
        if (step_count++ % settings.sort_interval == 0) {
            sort_by_place(state, settings.domain, settings.spacing);
        }
        const double dt = std::min(verbs().limit(state).limit, dt_most), before = booked();
        report = {};
        drift(settings, state, 0.5 * dt);
        const TimeSpan span{time, dt};
        verbs().begin_forces(state, walls, span, gravity, report);
        if (report.problem.empty()) {
            verbs().load_walls(state, walls, gravity);
            verbs().kick(state, walls, gravity, span, {}, report);
        }
        drift(settings, state, 0.5 * dt);
        viscous += report.dissipated_viscous;
        collisions += report.dissipated_collisions;
        pressure_loss += report.pressure_loss;
        work_on_solids += report.work_on_solids;
        work_external += report.work_external;
        impulse += report.impulse;
        booked_in_step = booked() - before;
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
    void add_wall_particle(const Vec3& x, bool is_slippery) {
        walls.position.push_back(x);
        walls.velocity.push_back({});
        walls.acceleration.push_back({});
        walls.volume.push_back(std::pow(settings.spacing, settings.domain.dimension));
        walls.is_slippery.push_back(is_slippery ? 1 : 0);
    }
};

inline MpsSettings mps_settings(int dimension, double spacing, double expected_speed) {
    MpsSettings settings;
    settings.smoothing_ratio = 1.05;  // of the source: sums over the lattice have few terms, and can be written down
    settings.spacing = spacing;
    settings.sound_speed = 10 * expected_speed;
    settings.particle_mass = settings.rest_density * std::pow(spacing, dimension);
    settings.domain = {{-10, -10, -10}, {10, 10, 10}, {}, dimension};
    return settings;
}

/// An open tank of columns x rows cells (in three dimensions columns deep, too) with the lowest cells full of still
/// water, which fill(i, j) tells; y points up.
inline void add_tank(Basin& pool, long columns, long rows, bool is_slippery,
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
