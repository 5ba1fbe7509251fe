// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/open/leaving.hpp"

#include <cmath>
#include <numeric>
#include <string_view>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/state_equation.hpp"

namespace riprap::fluid {

namespace {

struct KeepOnly {
    const std::vector<std::size_t>& kept;

    template <class T>
    void operator()(std::string_view, std::vector<T>& values) const {
        const std::size_t left = values.empty() ? 0 : kept.size();  // empty: a field that this scheme has not
        for (std::size_t k = 0; k < left; ++k) {
            values[k] = values[kept[k]];
        }
        values.resize(left);
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

void keep_only(const std::vector<std::size_t>& kept, ParticleState& water) {
    ParticleState::visit_fields(water, KeepOnly{kept});
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
    const std::int64_t count = parallel::reduce(
        water.size(), std::int64_t{0},
        [&](std::int64_t i) { return leaves(static_cast<std::size_t>(i)) ? std::int64_t{1} : std::int64_t{0}; },
        [](std::int64_t a, std::int64_t b) { return a + b; });
    if (count == 0) {
        return passage;
    }
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < water.position.size(); ++i) {
        if (leaves(i)) {
            book_particle(settings, water, i, gravity, -1, passage);
        } else {
            kept.push_back(i);
        }
    }
    passage.left = count;
    keep_only(kept, water);
    return passage;
}

std::int64_t let_go_so_far(const OpenState& open, const ParticleState& water) {
    return open.next_id - std::accumulate(open.left.begin(), open.left.end(), std::int64_t{0}) - water.size();
}

std::int64_t most_let_go(const OpenState& open) {
    return static_cast<std::int64_t>(std::ceil(share_let_go * static_cast<double>(open.next_id)));
}

}  // namespace riprap::fluid
