// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/open/leaving.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

#include "riprap/core/selection.hpp"
#include "riprap/fluid/particle/state_equation.hpp"

namespace riprap::fluid {

namespace {

struct LeaveOut {
    const std::vector<std::size_t>& gone;

    template <class T>
    void operator()(std::string_view, std::vector<T>& values) const {
        if (values.empty() || gone.empty()) {  // empty: a field that this scheme has not
            return;
        }
        const auto entry = [&](std::size_t i) { return values.begin() + static_cast<std::ptrdiff_t>(i); };
        auto end = entry(gone.front());
        for (std::size_t k = 0; k < gone.size(); ++k) {
            end = std::copy(entry(gone[k] + 1), k + 1 < gone.size() ? entry(gone[k + 1]) : values.end(), end);
        }
        values.erase(end, values.end());
    }
    void operator()(std::string_view, double&) const {}
    void operator()(std::string_view, std::int64_t&) const {}
    void operator()(std::string_view, std::uint64_t&) const {}
};

}  // namespace

void book_particle(const ParticleSettings& settings, const ParticleState& water, std::size_t i, const Vec3& gravity,
                   double sign, Passage& passage) {
    const double m = settings.particle_mass;
    const Vec3& v = water.velocity[i];
    passage.momentum += sign * m * v;
    passage.energy +=
        sign * m *
        (0.5 * norm_squared(v) - dot(gravity, water.position[i]) + internal_energy_of(settings, water.density[i]));
}

void leave_out(const std::vector<std::size_t>& gone, ParticleState& water) {
    ParticleState::visit_fields(water, LeaveOut{gone});
    water.flow.forget();  // its geometry had those that are gone
}

Passage let_go(const ParticleSettings& settings, const Vec3& gravity, double dt, ParticleState& water) {
    const Domain& domain = settings.domain;
    int axis = 0;
    for (int k = 1; k < domain.dimension; ++k) {
        axis = std::abs(gravity[k]) > std::abs(gravity[axis]) ? k : axis;
    }
    Passage passage;
    if (gravity[axis] == 0 || domain.is_periodic[static_cast<std::size_t>(axis)]) {
        return passage;
    }
    const bool is_high = gravity[axis] < 0;
    const auto leaves = [&](std::size_t i) {
        const double x = water.position[i][axis], next = x + dt * water.velocity[i][axis];
        return is_high ? std::fmax(x, next) > domain.high[axis] : std::fmin(x, next) < domain.low[axis];
    };
    const std::vector<std::size_t> gone = parallel::select(water.size(), leaves);
    if (gone.empty()) {
        return passage;
    }
    for (const std::size_t i : gone) {
        book_particle(settings, water, i, gravity, -1, passage);
    }
    passage.left = static_cast<std::int64_t>(gone.size());
    leave_out(gone, water);
    return passage;
}

std::int64_t let_go_so_far(const OpenState& open, const ParticleState& water) {
    return open.next_id - std::accumulate(open.left.begin(), open.left.end(), std::int64_t{0}) - water.size();
}

std::int64_t most_let_go(const OpenState& open) {
    return static_cast<std::int64_t>(std::ceil(share_let_go * static_cast<double>(open.next_id)));
}

}  // namespace riprap::fluid
