// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"
#include "riprap/fluid/mps_operators/collision.hpp"
#include "riprap/fluid/particle/pair_sums.hpp"
#include "riprap/fluid/particle/sweep/zeros.hpp"
#include "riprap/fluid/wcmps/surface_limits.hpp"
#include "riprap/fluid/wcmps/surface_pairs.hpp"
#include "riprap/fluid/wcmps/wcmps.hpp"

namespace riprap::fluid {

namespace {

double square(double a) { return a * a; }

/// E, F or, for the time being, I.
SurfaceClass class_alone(const MpsLattice& lattice, double crowding, double neighbours, double in_front) {
    if (crowding < wcmps::splash_limit) {
        return SurfaceClass::splash;
    }
    // in_front is a sum of ones
    const bool is_open = in_front < 0.5 || neighbours < wcmps::neighbour_limit * lattice.neighbours;
    return crowding <= wcmps::surface_limit && is_open ? SurfaceClass::surface : SurfaceClass::internal;
}

/// Returns the part of a shift that a class allows.
Vec3 along_surface(SurfaceClass surface, const Vec3& normal, const Vec3& inner_normal, const Vec3& shift) {
    if (surface == SurfaceClass::splash) {
        return {};
    }
    if (surface == SurfaceClass::internal) {
        return shift;
    }
    const double length = norm(inner_normal);
    const Vec3 n = surface == SurfaceClass::surface ? normal : length > 0 ? inner_normal / length : Vec3{};
    const double outward = dot(n, shift);
    const bool keeps_inward = surface == SurfaceClass::near && outward < 0;
    return keeps_inward ? shift : shift - outward * n;
}

/// Longest shift and energy of place that its first half took away.
struct Shifting {
    double potential{0};        ///< [J]
    double longest_squared{0};  ///< [m^2]

    template <class By>
    static void join(Shifting& a, const Shifting& b, const By& by) {
        by.add(a.potential, b.potential);
        by.largest(a.longest_squared, b.longest_squared);
    }
};

}  // namespace

void Wcmps::classify(const ParticleState& state) {
    const auto count = state.position.size();
    surface_.classes.resize(count);
    surface_.is_surface.resize(count);
    surface_.normal.resize(count);
    parallel::for_each(state.blocks(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        surface_.classes[i] =
            class_alone(lattice_, continuity_.crowding[i], continuity_.neighbours[i], forces_.in_front[i]);
        const bool is_surface = surface_.classes[i] == SurfaceClass::surface;
        surface_.is_surface[i] = is_surface ? 1 : 0;
        surface_.normal[i] = is_surface ? continuity_.normal[i] : Vec3{};
    });
    make_zeros(count, surface_.adjacent, surface_.inner_normal);
    add_pair_sums_within(settings_, wcmps::MpsSurface{weight_, square(2.1 * settings_.spacing)},
                         side(state.position, surface_.is_surface, surface_.normal),
                         sinks(surface_.adjacent, surface_.inner_normal), lists_.fluid_fluid);
    parallel::for_each(state.blocks(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        if (surface_.classes[i] == SurfaceClass::internal && surface_.adjacent[i] > 0.5) {
            surface_.classes[i] = SurfaceClass::near;
        }
    });
}

bool Wcmps::find_collisions(const ParticleState& state) {
    const auto count = state.position.size();
    const double l = settings_.spacing, contact = square(settings_.collision_distance * l);
    collisions_.share.resize(count);
    const double size = 0.5 * (1 + settings_.collision_ratio);
    parallel::for_each(state.blocks(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        const bool may = surface_.classes[i] == SurfaceClass::surface || surface_.classes[i] == SurfaceClass::near;
        collisions_.share[i] = may ? size : 0;
    });
    make_zeros(count, surface_.approaching);
    add_pair_sums_within(settings_, wcmps::MpsApproach{contact},
                         side(state.position, state.velocity, collisions_.share), sinks(surface_.approaching),
                         lists_.fluid_fluid);
    const double most = parallel::reduce(  // of ghosts too, which may meet own particles
        state.size(), 0.0,
        [&](std::int64_t entry) {
            const auto i = static_cast<std::size_t>(entry);
            const double approaching = surface_.approaching[i];
            collisions_.share[i] = approaching > 0.5 ? collisions_.share[i] / approaching : 0;
            return collisions_.share[i];
        },
        [](double a, double b) { return std::max(a, b); });
    if (most == 0) {
        return false;
    }
    make_zeros(count, collisions_.change);
    add_pair_sums_within(settings_, MpsCollision{contact, 1e-8 * l * l},
                         side(state.position, state.velocity, collisions_.share), sinks(collisions_.change),
                         lists_.fluid_fluid);
    return true;
}

void Wcmps::shift(ParticleState& state, const Vec3& gravity, double dt, ParticleReport& report) const {
    if (settings_.shifting == 0) {
        report.max_shift = 0;
        return;
    }
    const double bound = 0.5 / lattice_.wave_stiffness;
    state.shift.resize(state.position.size());
    const double longest = 0.1 * settings_.spacing, gradient = lattice_.first_order();
    const auto shift_one = [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        const double strength = std::min(settings_.shifting * 2 * settings_.spacing * dt * continuity_.stir[i], bound);
        Vec3 move = along_surface(surface_.classes[i], continuity_.normal[i], surface_.inner_normal[i],
                                  -strength * (gradient * forces_.crowding_gradient.vector(i)));
        const double length = norm(move);
        move *= length > longest ? longest / length : 1;
        state.shift[i] = 0.5 * move;
        state.position[i] += state.shift[i];
        return Shifting{settings_.particle_mass * dot(gravity, state.shift[i]), norm_squared(move)};
    };
    const Shifting all = parallel::sum(state.blocks(), shift_one);
    report.shifted += all.potential;
    report.max_shift = std::sqrt(all.longest_squared);
}

}  // namespace riprap::fluid
