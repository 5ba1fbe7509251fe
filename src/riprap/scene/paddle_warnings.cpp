// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/paddle_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "riprap/core/error.hpp"
#include "riprap/scene/placed_part.hpp"

namespace riprap::scene {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The columns of water that touch the face of a paddle.
struct WaterBefore {
    double surface{-infinity};                      ///< height of the level of their region [m]
    double nearest{infinity}, farthest{-infinity};  ///< of them along the waves [m]
    Vec3 place;                                     ///< of the highest of the nearest [m]
};

/// Nothing where no water touches the face, or regions of different levels do.
std::optional<WaterBefore> water_before(const CaseBuild& build, const WavePaddle& paddle, double spacing,
                                        const coupling::Filling& filling) {
    std::vector<PlacedPart> parts;
    for (const body::Part& part : build.model.bodies.parts) {
        if (part.body == paddle.body) {
            parts.push_back(placed(build, part));
        }
    }
    WaterBefore found;
    const std::vector<Vec3>& water = filling.particles.position;
    for (std::size_t i = 0; i < water.size(); ++i) {
        const bool touches = std::any_of(parts.begin(), parts.end(), [&](const PlacedPart& part) {
            const std::int32_t face = face_before(part, water[i], touching * spacing);
            return face >= 0 && dot(rotate(part.pose.orientation, part.shape.normal(face)), paddle.direction) > 0.5;
        });
        if (!touches) {
            continue;
        }
        const double level = filling.regions[static_cast<std::size_t>(filling.region[i])].surface;
        if (std::isfinite(found.surface) && std::abs(level - found.surface) > 1e-6 * spacing) {
            return std::nullopt;
        }
        const double along = dot(paddle.direction, water[i]), slack = 1e-6 * spacing;
        if (along < found.nearest - slack ||
            (along < found.nearest + slack && dot(build.up(), water[i]) > dot(build.up(), found.place))) {
            found.place = water[i];
        }
        found.surface = level;
        found.nearest = std::min(found.nearest, along);
        found.farthest = std::max(found.farthest, along);
    }
    return std::isfinite(found.surface) ? std::optional(found) : std::nullopt;
}

/// Depth of that water [m]; a paddle may hang above the bed.
double depth_of(const CaseBuild& build, const WavePaddle& paddle, double spacing, const WaterBefore& before,
                const std::vector<Vec3>& water) {
    double lowest = infinity;
    for (const Vec3& x : water) {
        const double along = dot(paddle.direction, x);
        lowest = along >= before.nearest && along <= before.farthest ? std::min(lowest, dot(build.up(), x)) : lowest;
    }
    return before.surface - (lowest - 0.5 * spacing);
}

void warn(CaseBuild& build, const WavePaddle& paddle, std::string what, std::string why) {
    build.warnings.push_back(to_string(Diagnostic{paddle.place, std::move(what), std::move(why)}));
}

void warn_of_depth(CaseBuild& build, const WavePaddle& paddle, double spacing, double depth) {
    if (std::abs(depth - paddle.wave.depth) > (1 + 1e-6) * spacing) {
        warn(build, paddle,
             fmt::format("the wave maker '{}' has depth = {:.6g} m, but water stands {:.4g} m deep before it",
                         paddle.wave.paddle, paddle.wave.depth, depth),
             "its stroke, and the wave, are those of the depth it is given");
    }
}

/// A surface is known to about half a spacing.
void warn_of_height(CaseBuild& build, const WavePaddle& paddle, double spacing) {
    constexpr double least = 4;
    if (paddle.wave.kind != "none" && paddle.wave.height < (least - 1e-6) * spacing) {
        warn(build, paddle,
             fmt::format("the wave of '{}' is {:.2g} spacings high, and surfaces are good to about half a spacing",
                         paddle.wave.paddle, paddle.wave.height / spacing),
             fmt::format("fluid.spacing = {:.3g} makes it ten", 0.1 * paddle.wave.height));
    }
}

/// How far back, against its waves, a point that moves with the paddle comes [m].
double farthest_back(const CaseBuild& build, const WavePaddle& paddle, const Vec3& point) {
    const auto place_at = [&](double time) {
        const Pose pose = driven_state(build.model.bodies, paddle.body, time).pose;
        return to_world(pose, to_body(driven_state(build.model.bodies, paddle.body, 0).pose, point));
    };
    constexpr int looks = 1999;  // prime, so that no period hides between them
    double back = infinity;
    for (int k = 0; k <= looks; ++k) {
        back = std::min(back, dot(paddle.direction, place_at(build.model.time.end * k / looks)));
    }
    return back;
}

void warn_of_leaving(CaseBuild& build, const WavePaddle& paddle, const fluid::SphSettings& sph,
                     const WaterBefore& before) {
    const fluid::Domain& domain = sph.domain;
    for (int axis = 0; axis < domain.dimension; ++axis) {
        const double way = paddle.direction[axis];
        if (std::abs(way) < 1 - 1e-9 || domain.is_periodic[static_cast<std::size_t>(axis)]) {
            continue;  // where the domain ends along other ways depends on where along the paddle one looks
        }
        const double face = farthest_back(build, paddle, before.place) - 0.5 * sph.spacing;
        const double end = way > 0 ? domain.low[axis] : -domain.high[axis];
        if (face < end - 1e-6 * sph.spacing) {
            warn(build, paddle,
                 fmt::format("the face of '{}' draws back to {} = {:.4g} m, out of 'fluid.domain', which ends at "
                             "{:.4g} m",
                             paddle.wave.paddle, "xyz"[axis], way * face, way * end),
                 "a domain that reaches behind it: water that leaves the domain ends the run");
        }
    }
}

}  // namespace

void warn_of_paddles(CaseBuild& build, const sim::FluidModel& fluid, const coupling::Filling& filling) {
    const double spacing = fluid.sph.spacing;
    for (const WavePaddle& paddle : build.paddles) {
        warn_of_height(build, paddle, spacing);
        if (const auto before = water_before(build, paddle, spacing, filling)) {
            warn_of_depth(build, paddle, spacing,
                          depth_of(build, paddle, spacing, *before, filling.particles.position));
            warn_of_leaving(build, paddle, fluid.sph, *before);
        }
    }
}

}  // namespace riprap::scene
