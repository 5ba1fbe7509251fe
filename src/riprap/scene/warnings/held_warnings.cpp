// SPDX-License-Identifier: Apache-2.0
// Warns of walls that hold water at the start and lose it later: they move out of its domain, or let it through.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/geometry/polyhedra/clip.hpp"
#include "riprap/scene/case/placed_part.hpp"
#include "riprap/scene/warnings/fluid_warnings.hpp"

namespace riprap::scene {

namespace {

/// Extent of a body along the axes at a pose.
geometry::Range reach_of(const CaseBuild& build, BodyId body, const Pose& pose, int axis) {
    const body::BodySet& bodies = build.model.bodies;
    const auto b = static_cast<std::size_t>(body.value);
    geometry::Range range{1e300, -1e300};
    for (std::int32_t p = bodies.part_begin[b]; p < bodies.part_begin[b + 1]; ++p) {
        const body::Part& part = bodies.parts[static_cast<std::size_t>(p)];
        const geometry::ConvexView shape = build.model.shapes.view(part.shape);
        for (std::int32_t i = 0; i < shape.vertex_count; ++i) {
            const double x = to_world(pose, to_world(part.local, shape.vertex(i)))[axis];
            range = {std::min(range.low, x), std::max(range.high, x)};
        }
    }
    return range;
}

/// The worst of the ways by which a driven body leaves the domain.
struct Leaving {
    double farthest{0};  ///< beyond the side, more than at the start [m]
    double place{0};     ///< of its end there [m]
    double time{0};      ///< [s]
    int side{-1};        ///< twice the axis, plus 1 for the high side
};

/// Tells whether some water starts on a face of the body that looks up.
bool carries_water(const CaseBuild& build, BodyId body, double spacing, const std::vector<Vec3>& water) {
    const body::BodySet& bodies = build.model.bodies;
    const auto b = static_cast<std::size_t>(body.value);
    for (std::int32_t p = bodies.part_begin[b]; p < bodies.part_begin[b + 1]; ++p) {
        const PlacedPart part = placed(build, bodies.parts[static_cast<std::size_t>(p)]);
        const Vec3 up = rotate_back(part.pose.orientation, build.up());
        if (std::any_of(water.begin(), water.end(), [&](const Vec3& x) {
                const std::int32_t face = face_before(part, x, touching * spacing);
                return face >= 0 && dot(part.shape.normal(face), up) > 0.5;
            })) {
            return true;
        }
    }
    return false;
}

Leaving leaving_of(const CaseBuild& build, BodyId body, const coupling::ParticleFluid& fluid,
                   const std::vector<Vec3>& water) {
    const fluid::Domain& domain = fluid.settings().domain;
    const Vec3 up = build.up();
    constexpr std::int64_t most_looks = 400;
    const std::int64_t looks = std::min(most_looks, look_count(build.model.bodies, body, build.model.time.end));
    Leaving worst;
    for (int side = 0; side < 2 * domain.dimension; ++side) {
        const int axis = side / 2;
        const double sign = side % 2 == 1 ? 1 : -1, end = side % 2 == 1 ? domain.high[axis] : domain.low[axis];
        const bool is_gate = sign * up[axis] > 0.5 && !carries_water(build, body, fluid.settings().spacing, water);
        if (domain.is_periodic[static_cast<std::size_t>(axis)] || is_gate) {
            continue;  // a gate is lifted out of the water
        }
        double at_start = 0;
        for (std::int64_t k = 0; k <= looks; ++k) {
            const double time = build.model.time.end * static_cast<double>(k) / static_cast<double>(looks);
            const geometry::Range range =
                reach_of(build, body, driven_state(build.model.bodies, body, time).pose, axis);
            const double tip = side % 2 == 1 ? range.high : range.low, beyond = std::max(0.0, sign * (tip - end));
            at_start = k == 0 ? beyond : at_start;
            if (beyond - at_start > worst.farthest) {
                worst = {beyond - at_start, tip, time, side};
            }
        }
    }
    return worst;
}

bool is_paddle(const CaseBuild& build, BodyId body) {
    return std::any_of(build.paddles.begin(), build.paddles.end(),
                       [&](const WavePaddle& paddle) { return paddle.body == body; });
}

}  // namespace

void warn_of_driven_leaving(CaseBuild& build, const coupling::ParticleFluid& fluid, const std::vector<Vec3>& water) {
    const body::BodySet& bodies = build.model.bodies;
    const fluid::Domain& domain = fluid.settings().domain;
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        const auto i = static_cast<std::size_t>(b);
        const ShapeId first = bodies.parts[static_cast<std::size_t>(bodies.part_begin[i])].shape;
        const bool has_size = !build.model.shapes.is_half_space(first);
        if (bodies.drive[i] != body::Drive::driven || fluid.is_dry[i] != 0 || !has_size || is_paddle(build, {b})) {
            continue;
        }
        const Leaving leaving = leaving_of(build, {b}, fluid, water);
        if (leaving.farthest > fluid.settings().spacing) {
            const int axis = leaving.side / 2;
            warn_at(
                build, bodies.name_id[i],
                fmt::format("'{}' moves out of 'fluid.domain': it reaches {} = {:.4g} m at t = {:.4g} s, the domain "
                            "ends at {:.4g} m, and water that it takes along ends the run",
                            bodies.name({b}), "xyz"[axis], leaving.place, leaving.time,
                            leaving.side % 2 == 1 ? domain.high[axis] : domain.low[axis]));
        }
    }
}

void warn_of_dry_walls(CaseBuild& build, const coupling::ParticleFluid& fluid, const std::vector<Vec3>& water) {
    const body::BodySet& bodies = build.model.bodies;
    std::int32_t told = -1;
    for (const body::Part& part : bodies.parts) {
        const auto b = static_cast<std::size_t>(part.body.value);
        if (fluid.is_dry[b] == 0 || bodies.drive[b] == body::Drive::free || bodies.name_id[b] == told) {
            continue;
        }
        const PlacedPart here = placed(build, part);
        const bool is_touched = std::any_of(water.begin(), water.end(), [&](const Vec3& x) {
            return face_before(here, x, touching * fluid.settings().spacing) >= 0;
        });
        if (is_touched) {
            told = bodies.name_id[b];
            warn_at(build, told,
                    fmt::format("water stands at '{}', which has wet = false: nothing holds it there, and it will flow "
                                "through",
                                bodies.name(part.body)));
        }
    }
}

}  // namespace riprap::scene
