// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/open/open_boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/selection.hpp"
#include "riprap/fluid/open/layers.hpp"
#include "riprap/fluid/open/leaving.hpp"
#include "riprap/fluid/particle/state_equation.hpp"

namespace riprap::fluid {

namespace {

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// Distance of the first layer of an inflow from its start at one spacing before the plane, at `time` [m].
double phase_of(const Inflow& inflow, std::int64_t layers, double spacing, double time) {
    return inflow.distance_at(time) + 0.5 * spacing - static_cast<double>(layers) * spacing;
}

double hydrostatic(const Outflow& outflow, const ParticleSettings& settings, const Vec3& x) {
    return std::max(0.0, settings.rest_density * outflow.gravity * (outflow.level - dot(outflow.up, x)));
}

void append(BoundaryParticles& walls, const Vec3& x, const Vec3& v, const Vec3& a, double volume, double pressure) {
    walls.position.push_back(x);
    walls.velocity.push_back(v);
    if (!walls.foot_velocity.empty()) {
        walls.foot_velocity.push_back(v);
    }
    walls.acceleration.push_back(a);
    walls.volume.push_back(volume);
    walls.is_slippery.push_back(1);
    walls.given_pressure.push_back(pressure);
}

/// Water that has passed a plane, or -1: outflows come first, then inflows that it passes backwards.
std::int64_t opening_passed(const OpenBoundaries& open, const ParticleSettings& settings, const Vec3& x) {
    const double reach = static_cast<double>(layer_count(settings)) * settings.spacing;
    const int dimension = settings.domain.dimension;
    for (std::size_t k = 0; k < open.outflows.size(); ++k) {
        const Opening& opening = open.outflows[k].opening;
        const double past = opening.past(x);
        if (past > 0 && past <= reach && opening.is_across(x, dimension)) {
            return static_cast<std::int64_t>(k);
        }
    }
    for (std::size_t k = 0; k < open.inflows.size(); ++k) {
        const Opening& opening = open.inflows[k].opening;
        const double before = -opening.past(x);  // pressed half a spacing between its layers
        if (before > 0.5 * settings.spacing && before <= reach && opening.is_across(x, dimension)) {
            return static_cast<std::int64_t>(open.outflows.size() + k);
        }
    }
    return -1;
}

/// A particle at x with the velocity v of water becomes one of the layers of outflow number k.
void enter_layers(const Outflow& outflow, std::int32_t k, const Vec3& x, const Vec3& v, OpenState& state) {
    const Vec3 n = outflow.opening.direction();
    const double speed = outflow.kind == OutflowKind::speed ? outflow.speed : std::max(0.0, dot(n, v));
    state.position.push_back(x);
    state.velocity.push_back(speed * n);
    state.outflow.push_back(k);
}

void pass_out(const OpenBoundaries& open, const ParticleSettings& settings, const Vec3& gravity, OpenState& state,
              ParticleState& water, Passage& passage) {
    const std::vector<std::size_t> gone = parallel::select(
        water.size(), [&](std::size_t i) { return opening_passed(open, settings, water.position[i]) >= 0; });
    for (const std::size_t i : gone) {
        const std::int64_t passed = opening_passed(open, settings, water.position[i]);
        book_particle(settings, water, i, gravity, -1, passage);
        passage.left += 1;
        state.left[at(passed)] += 1;
        if (passed < static_cast<std::int64_t>(open.outflows.size())) {
            const Outflow& outflow = open.outflows[at(passed)];
            if (outflow.kind != OutflowKind::free) {
                enter_layers(outflow, static_cast<std::int32_t>(passed), water.position[i], water.velocity[i], state);
            }
        }
    }
    if (!gone.empty()) {
        leave_out(gone, water);
    }
}

/// Layers of outflows of a level go with the water in front of them, never back, so that they neither stay behind still
/// water that begins to move nor pass each other. Where there is none they keep their speed.
void follow_water(const OpenBoundaries& open, const ParticleSettings& settings, const ParticleState& water,
                  OpenState& state) {
    for (std::size_t k = 0; k < open.outflows.size(); ++k) {
        const Opening& opening = open.outflows[k].opening;
        if (open.outflows[k].kind != OutflowKind::level) {
            continue;
        }
        double sum = 0;
        const std::vector<std::size_t> near = parallel::select(water.size(), [&](std::size_t i) {
            const double before = -opening.past(water.position[i]);
            return before >= 0 && before <= settings.support_radius() &&
                   opening.is_across(water.position[i], settings.domain.dimension);
        });
        for (const std::size_t i : near) {
            sum += dot(opening.direction(), water.velocity[i]);
        }
        for (std::size_t i = 0; !near.empty() && i < state.position.size(); ++i) {
            if (state.outflow[i] == static_cast<std::int32_t>(k)) {
                state.velocity[i] = std::max(0.0, sum / static_cast<double>(near.size())) * opening.direction();
            }
        }
    }
}

/// Layers of outflows go on by `dt`; what is beyond the last one is dropped: as water it is long gone.
void move_layers(const OpenBoundaries& open, const ParticleSettings& settings, double dt, OpenState& state) {
    const double reach = static_cast<double>(layer_count(settings)) * settings.spacing;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < state.position.size(); ++i) {
        const Vec3 x = state.position[i] + dt * state.velocity[i];
        if (open.outflows[at(state.outflow[i])].opening.past(x) <= reach) {
            state.position[kept] = x;
            state.velocity[kept] = state.velocity[i];
            state.outflow[kept] = state.outflow[i];
            ++kept;
        }
    }
    state.position.resize(kept);
    state.velocity.resize(kept);
    state.outflow.resize(kept);
}

void pass_in(const OpenBoundaries& open, const ParticleSettings& settings, const BoundaryParticles& walls,
             std::size_t first, const Vec3& gravity, double time, OpenState& state, ParticleState& water,
             Passage& passage) {
    std::size_t entry = first;  // of the first layer of this inflow
    for (std::size_t k = 0; k < open.inflows.size(); ++k) {
        const Inflow& inflow = open.inflows[k];
        const double phase = phase_of(inflow, state.layers[k], settings.spacing, time);
        if (phase >= settings.spacing) {
            for (std::size_t row = 0; row < inflow.rows.size(); ++row) {
                const Vec3 n = inflow.opening.direction();
                water.add(inflow.rows[row] + (phase - settings.spacing) * n, inflow.speed_at(time) * n,
                          density_of(settings, walls.pressure[entry + row]), static_cast<std::int32_t>(state.next_id));
                state.next_id += 1;
                book_particle(settings, water, water.position.size() - 1, gravity, 1, passage);
            }
            state.layers[k] += 1;
            state.entered[k] += static_cast<std::int64_t>(inflow.rows.size());
            passage.entered += static_cast<std::int64_t>(inflow.rows.size());
        }
        entry += inflow.rows.size() * at(layer_count(settings));
    }
}

}  // namespace

void start_openings(const OpenBoundaries& open, const ParticleSettings& settings, const ParticleState& water,
                    OpenState& state) {
    const double reach = static_cast<double>(layer_count(settings)) * settings.spacing;
    state.layers.assign(open.inflows.size(), 0);
    state.entered.assign(open.inflows.size(), 0);
    state.left.assign(open.outflows.size() + open.inflows.size(), 0);
    state.next_id = water.size();
    state.position.clear();
    state.velocity.clear();
    state.outflow.clear();
    for (std::size_t k = 0; k < open.outflows.size(); ++k) {
        const Outflow& outflow = open.outflows[k];
        const Opening& opening = outflow.opening;
        for (std::size_t i = 0; outflow.kind != OutflowKind::free && i < water.position.size(); ++i) {
            const double before = -opening.past(water.position[i]);
            if (before >= 0 && before <= reach && opening.is_across(water.position[i], settings.domain.dimension)) {
                enter_layers(outflow, static_cast<std::int32_t>(k),
                             water.position[i] + 2 * before * opening.direction(), water.velocity[i], state);
            }
        }
    }
}

void place_openings(const OpenBoundaries& open, const OpenState& state, const ParticleSettings& settings, double time,
                    double ahead, BoundaryParticles& walls) {
    constexpr double not_given = -1;  // pressure comes from the water
    const double volume = std::pow(settings.spacing, settings.domain.dimension);
    walls.given_pressure.assign(walls.position.size(), not_given);
    for (std::size_t k = 0; k < open.inflows.size(); ++k) {
        const Inflow& inflow = open.inflows[k];
        const double phase = phase_of(inflow, state.layers[k], settings.spacing, time);
        const Vec3 n = inflow.opening.direction();
        for (std::int64_t layer = 0; layer < layer_count(settings); ++layer) {
            const double past = phase - static_cast<double>(layer + 1) * settings.spacing;
            for (const Vec3& row : inflow.rows) {
                append(walls, row + past * n, inflow.speed_at(time) * n, inflow.acceleration_at(time) * n, volume,
                       not_given);
            }
        }
    }
    for (std::size_t i = 0; i < state.position.size(); ++i) {
        const Outflow& outflow = open.outflows[at(state.outflow[i])];
        const Vec3 x = state.position[i] + ahead * state.velocity[i];
        append(walls, x, state.velocity[i], {}, volume,
               outflow.kind == OutflowKind::level ? hydrostatic(outflow, settings, x) : not_given);
    }
}

Passage pass_openings(const OpenBoundaries& open, const ParticleSettings& settings, const BoundaryParticles& walls,
                      std::size_t first, const Vec3& gravity, double time, double dt, OpenState& state,
                      ParticleState& water) {
    Passage passage;
    move_layers(open, settings, dt, state);
    follow_water(open, settings, water, state);
    pass_out(open, settings, gravity, state, water, passage);
    pass_in(open, settings, walls, first, gravity, time, state, water, passage);
    if (water.size() > open.most_particles) {
        passage.problem = fmt::format("inflows have made {} particles of water at t = {:.6g} s; allowed: {}",
                                      water.size(), time, open.most_particles);
    } else if (state.next_id > std::numeric_limits<std::int32_t>::max()) {
        passage.problem = fmt::format("more particles have come in by t = {:.6g} s than can be counted", time);
    }
    return passage;
}

double power_on_openings(const BoundaryParticles& walls, std::size_t first) {
    double power = 0;
    for (std::size_t w = first; w < walls.position.size(); ++w) {
        power += dot(walls.pressure_force[w] + walls.viscous_force[w], walls.velocity[w]);
    }
    return power;
}

}  // namespace riprap::fluid
