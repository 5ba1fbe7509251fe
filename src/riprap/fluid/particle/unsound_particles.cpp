// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/unsound_particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/parallel.hpp"

namespace riprap::fluid {
namespace {

/// The lowest id among particles that are not sound, or -1
template <class IsSound>
std::int64_t first_unsound(const ParticleState& state, const IsSound& is_sound) {
    constexpr auto none = std::numeric_limits<std::int64_t>::max();
    const std::int64_t entry_none = none;
    const auto look = [&](std::int64_t i) {
        return is_sound(static_cast<std::size_t>(i)) ? entry_none
                                                     : static_cast<std::int64_t>(state.id[static_cast<std::size_t>(i)]);
    };
    const std::int64_t first = parallel::reduce(state.blocks(), entry_none, look,
                                                [](std::int64_t a, std::int64_t b) { return std::min(a, b); });
    return first == none ? -1 : first;
}

void describe(const ParticleState& state, std::int64_t id, double time, const char* what, FluidReport& report) {
    if (id < 0) {
        return;
    }
    const auto entry = static_cast<std::size_t>(std::find(state.id.begin(), state.id.end(), id) - state.id.begin());
    const Vec3 x = state.position[entry], v = state.velocity[entry];
    report.worst_particle = id;
    report.problem = fmt::format(
        "fluid particle {} {} at t = {:.6g} s: position ({:.6g}, {:.6g}, {:.6g}) m, velocity ({:.6g}, {:.6g}, {:.6g}) "
        "m/s, density {:.6g} kg/m^3",
        id, what, time, x.x, x.y, x.z, v.x, v.y, v.z, state.density[entry]);
}

}  // namespace

void find_lost_particle(const ParticleSettings& settings, const ParticleState& state, double time,
                        FluidReport& report) {
    describe(state,
             first_unsound(state,
                           [&](std::size_t i) {
                               return is_finite(state.position[i]) && std::isfinite(state.density[i]) &&
                                      state.density[i] > 0;
                           }),
             time, "has no finite place or no density", report);
    if (report.problem.empty()) {
        describe(state, first_unsound(state, [&](std::size_t i) { return settings.domain.admits(state.position[i]); }),
                 time, "has left the domain", report);
        if (!report.problem.empty()) {
            report.remedy =
                "a wall there holds the water, an [[fluid.outflow]] lets it go and counts it, and where "
                "walls move, fluid.domain has to hold all of their way";
        }
    }
}

void find_wild_particle(const ParticleSettings& settings, const ParticleState& state, double time,
                        FluidReport& report) {
    const double limit = settings.sound_speed * settings.sound_speed;
    describe(state, first_unsound(state, [&](std::size_t i) { return norm_squared(state.velocity[i]) <= limit; }), time,
             "is faster than the sound speed of the model", report);
}

}  // namespace riprap::fluid
