// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/wcmps/surface.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/wcmps/continuity.hpp"
#include "riprap/fluid/wcmps/pair_sums.hpp"

namespace riprap::fluid::wcmps {
namespace {

double square(double a) { return a * a; }

/// E, F or, for the time being, I.
SurfaceClass class_alone(const MpsLattice& lattice, double crowding, double neighbours, double in_front) {
    if (crowding < splash_limit) {
        return SurfaceClass::splash;
    }
    // in_front is a sum of ones
    const bool is_open = in_front < 0.5 || neighbours < neighbour_limit * lattice.neighbours;
    return crowding <= surface_limit && is_open ? SurfaceClass::surface : SurfaceClass::internal;
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

}  // namespace

void classify(const WcmpsSettings& settings, const ParticleState& state, WcmpsScratchData& s) {
    const auto count = state.position.size();
    const MpsLattice lattice = settings.lattice();
    s.surface.classes.resize(count);
    s.surface.is_surface.resize(count);
    s.surface.normal.resize(count);
    parallel::for_each(state.owned(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        s.surface.classes[i] =
            class_alone(lattice, s.continuity.crowding[i], s.continuity.neighbours[i], s.forces.in_front[i]);
        const bool is_surface = s.surface.classes[i] == SurfaceClass::surface;
        s.surface.is_surface[i] = is_surface ? 1 : 0;
        s.surface.normal[i] = is_surface ? s.continuity.normal[i] : Vec3{};
    });
    clear(s.surface.adjacent, count);
    clear(s.surface.inner_normal, count);
    const auto n = [&](int axis) { return component(s.surface.normal, axis); };
    const auto inner = [&](int axis) { return sink_component(s.surface.inner_normal, axis); };
    add_pair_sums_within(settings, MpsSurface{settings.weight(), square(2.1 * settings.spacing)},
                         {state.position, {field(s.surface.is_surface), n(0), n(1), n(2)}},
                         {sink(s.surface.adjacent), inner(0), inner(1), inner(2)}, s.lists.fluid_fluid);
    parallel::for_each(state.owned(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        if (s.surface.classes[i] == SurfaceClass::internal && s.surface.adjacent[i] > 0.5) {
            s.surface.classes[i] = SurfaceClass::near;
        }
    });
}

bool find_collisions(const WcmpsSettings& settings, const ParticleState& state, WcmpsScratchData& s) {
    const auto count = state.position.size();
    const double l = settings.spacing, contact = square(settings.collision_distance * l);
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    s.collisions.share.resize(count);
    const double size = 0.5 * (1 + settings.collision_ratio);
    parallel::for_each(state.owned(), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        const bool may = s.surface.classes[i] == SurfaceClass::surface || s.surface.classes[i] == SurfaceClass::near;
        s.collisions.share[i] = may ? size : 0;
    });
    clear(s.surface.approaching, count);
    add_pair_sums_within(settings, MpsApproach{contact},
                         {state.position, {v(0), v(1), v(2), field(s.collisions.share)}}, {sink(s.surface.approaching)},
                         s.lists.fluid_fluid);
    const double most = parallel::reduce(
        state.owned(), 0.0,
        [&](std::int64_t entry) {
            const auto i = static_cast<std::size_t>(entry);
            const double approaching = s.surface.approaching[i];
            s.collisions.share[i] = approaching > 0.5 ? s.collisions.share[i] / approaching : 0;
            return s.collisions.share[i];
        },
        [](double a, double b) { return std::max(a, b); });
    if (most == 0) {
        return false;
    }
    clear(s.collisions.change, count);
    const auto c = [&](int axis) { return sink_component(s.collisions.change, axis); };
    add_pair_sums_within(settings, MpsCollision{contact, 1e-8 * l * l},
                         {state.position, {v(0), v(1), v(2), field(s.collisions.share)}}, {c(0), c(1), c(2)},
                         s.lists.fluid_fluid);
    return true;
}

Shifting shift(const WcmpsSettings& settings, ParticleState& state, const Vec3& gravity, double dt,
               const WcmpsScratchData& s) {
    if (settings.shifting == 0) {
        return {};
    }
    const double bound = 0.5 / settings.lattice().wave_stiffness;
    state.shift.resize(state.position.size());
    const double longest = 0.1 * settings.spacing;
    const auto shift_one = [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        const double strength = std::min(settings.shifting * 2 * settings.spacing * dt * s.continuity.stir[i], bound);
        Vec3 move = along_surface(s.surface.classes[i], s.continuity.normal[i], s.surface.inner_normal[i],
                                  -strength * s.forces.crowding_gradient[i]);
        const double length = norm(move);
        move *= length > longest ? longest / length : 1;
        state.shift[i] = 0.5 * move;
        state.position[i] += state.shift[i];
        return Shifting{settings.particle_mass * dot(gravity, state.shift[i]), norm_squared(move)};
    };
    return parallel::reduce(state.owned(), Shifting{}, shift_one, [](const Shifting& a, const Shifting& b) {
        return Shifting{a.potential + b.potential, std::max(a.longest_squared, b.longest_squared)};
    });
}

}  // namespace riprap::fluid::wcmps
