// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "riprap/fluid/particle/state_equation.hpp"
#include "riprap/scene/assemble/fluid_tables.hpp"

namespace riprap::scene {

namespace {

/// Returns the farthest reach of a body from its centre; nothing for half-spaces, which do not turn [m].
double rim_of(const CaseBuild& build, std::size_t body) {
    double rim = 0;
    const body::BodySet& bodies = build.model.bodies;
    for (auto p = static_cast<std::size_t>(bodies.part_begin[body]);
         p < static_cast<std::size_t>(bodies.part_begin[body + 1]); ++p) {
        const double radius = build.model.shapes.view(bodies.parts[p].shape).circumradius;
        rim = std::isfinite(radius) ? std::max(rim, norm(bodies.parts[p].local.position) + radius) : rim;
    }
    return rim;
}

/// The fastest that the case itself makes something move [m/s].
double fastest_start(const CaseBuild& build, const Value& table, const std::vector<coupling::FillRegion>& regions,
                     const fluid::ParticleState& particles) {
    double fastest = 0;
    for (const Vec3& velocity : particles.velocity) {  // of a flow
        fastest = std::max(fastest, norm(velocity));
    }
    for (const char* openings : {"inflow", "outflow"}) {
        for (const Value& opening : get(table, openings).items) {
            fastest = std::max(fastest, get_number_or(opening, "speed", 0));
        }
    }
    for (const coupling::FillRegion& region : regions) {
        fastest = std::max(fastest, norm(region.velocity));
    }
    const body::BodySet& bodies = build.model.bodies;
    for (std::size_t b = 0; b < bodies.mass.size(); ++b) {
        const double rim = rim_of(build, b);
        const BodyId body{static_cast<std::int32_t>(b)};
        const Vec3 spin = angular_velocity(bodies, build.state.bodies, body);
        fastest = std::max(fastest, norm(build.state.bodies.velocity[b]) + rim * norm(spin));
        const std::int64_t looks = bodies.driven[b] >= 0 ? look_count(bodies, body, build.model.time.end) : -1;
        for (std::int64_t k = 0; k <= looks; ++k) {
            const double time = build.model.time.end * static_cast<double>(k) / static_cast<double>(looks);
            const auto state = driven_state(bodies, body, time);
            fastest = std::max(fastest, norm(state.velocity) + rim * norm(state.angular_velocity));
        }
    }
    return fastest;
}

}  // namespace

void choose_sound_speed(CaseBuild& build, const Value& table, const std::vector<coupling::FillRegion>& regions,
                        const fluid::ParticleState& particles, coupling::ParticleFluid& fluid) {
    // Along a periodic axis water has no depth.
    const Vec3 gravity = fluid::without_periodic(build.model.gravity.value, fluid.settings().domain);
    const double strength = norm(gravity);
    double low = 1e300, high = -1e300;
    for (const Vec3& x : particles.position) {
        const double height = strength > 0 ? -dot(gravity, x) / strength : 0;
        low = std::min(low, height);
        high = std::max(high, height);
    }
    fluid.depth = particles.size() > 0 && strength > 0 ? high - low + fluid.settings().spacing : 0;
    const Value& given = get(table, "sound_speed");
    if (!given.is_text()) {
        fluid.settings().sound_speed = given.as_number();
        fluid.sound_speed_reason = "as given";
        return;
    }
    const Value& expected = get(table, "expected_speed");
    const double tip = 2 * std::sqrt(strength * fluid.depth);
    const fluid::SoundSpeed chosen = fluid::choose_sound_speed(
        strength, fluid.depth,
        std::max(expected.is_text() ? tip : expected.as_number(), fastest_start(build, table, regions, particles)));
    fluid.settings().sound_speed = chosen.value;
    fluid.sound_speed_reason = chosen.reason;
    if (!(chosen.value > 0) && build.has_all_bodies) {
        build.problem(given.place, "nothing moves and nothing weighs: no sound speed follows from the case",
                      "a sound_speed");
    }
}

}  // namespace riprap::scene
