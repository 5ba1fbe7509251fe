// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/warnings/paddle_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

#include "riprap/core/error.hpp"
#include "riprap/scene/case/placed_part.hpp"

namespace riprap::scene {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The columns of water that touch the face of a paddle.
struct WaterBefore {
    double surface{-infinity};                      ///< height of the level of their region [m]
    double nearest{infinity}, farthest{-infinity};  ///< of them along the waves [m]
    Vec3 place;                                     ///< of the highest of the nearest [m]
};

/// Returns nothing where regions of different levels touch the face, and an empty one where no water does.
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
        const double along = dot(paddle.direction, water[i]);
        found.surface = level;
        found.nearest = std::min(found.nearest, along);
        found.farthest = std::max(found.farthest, along);
    }
    return found;
}

void warn_of_dry_paddle(CaseBuild& build, const WavePaddle& paddle, double spacing) {
    build.warnings.push_back(to_string(
        Diagnostic{paddle.place,
                   fmt::format("no water touches the face of the wave maker '{}' at the start, nearer than {:.3g} m",
                               paddle.wave.paddle, touching * spacing),
                   "water up to its face: it makes no waves before it meets water"}));
}

/// Depth of that water [m]; a paddle may hang above the bed.
double depth_of(const CaseBuild& build, const WavePaddle& paddle, double spacing, const WaterBefore& before,
                const std::vector<Vec3>& water) {
    double lowest = infinity, highest = -infinity;
    for (const Vec3& x : water) {
        const double along = dot(paddle.direction, x), height = dot(build.up(), x);
        if (along >= before.nearest && along <= before.farthest) {
            lowest = std::min(lowest, height);
            highest = std::max(highest, height);
        }
    }
    // A level between two rows is known better than by its particles, one above the domain or in a solid is not there.
    return std::min(before.surface, highest + spacing) - (lowest - 0.5 * spacing);
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
    if (paddle.wave.height > 0 && paddle.wave.height < (least - 1e-6) * spacing) {
        warn(build, paddle,
             fmt::format("the wave of '{}' is {:.2g} spacings high, and surfaces are good to about half a spacing",
                         paddle.wave.paddle, paddle.wave.height / spacing),
             fmt::format("fluid.spacing = {:.3g} makes it ten", 0.1 * paddle.wave.height));
    }
}

/// Returns the reach of the paddle towards its waves at the start [m]; nothing for a plane that does not face that way.
std::optional<double> face_of(const CaseBuild& build, const WavePaddle& paddle) {
    double face = -infinity;
    for (const body::Part& part : build.model.bodies.parts) {
        if (part.body != paddle.body) {
            continue;
        }
        const PlacedPart here = placed(build, part);
        if (build.model.shapes.is_half_space(part.shape)) {
            const Vec3 normal = rotate(here.pose.orientation, here.shape.normal(0));
            if (dot(normal, paddle.direction) < 1 - 1e-9) {
                return std::nullopt;
            }
            face = std::max(face, dot(paddle.direction, here.pose.position) + here.shape.offset[0]);
        }
        for (int i = 0; i < here.shape.vertex_count; ++i) {
            face = std::max(face, dot(paddle.direction, to_world(here.pose, here.shape.vertex(i))));
        }
    }
    return face;
}

/// Returns how far a point of the paddle draws back, against its waves, corrections by absorption aside [m].
double farthest_back(const CaseBuild& build, const WavePaddle& paddle, const Vec3& point) {
    const body::BodySet& bodies = build.model.bodies;
    const Vec3 local = to_body(driven_state(bodies, paddle.body, 0).pose, point);
    const std::int64_t looks = look_count(bodies, paddle.body, build.model.time.end);
    double back = infinity;
    for (std::int64_t k = 0; k <= looks; ++k) {
        const double time = build.model.time.end * static_cast<double>(k) / static_cast<double>(looks);
        const Pose pose = driven_state(bodies, paddle.body, time).pose;
        back = std::min(back, dot(paddle.direction, to_world(pose, local)));
    }
    return back;
}

/// A point of the face at still water: the stroke of a flap is that of this line.
Vec3 point_of_face(const CaseBuild& build, const WavePaddle& paddle, double face) {
    const body::BodySet& bodies = build.model.bodies;
    const std::int32_t motion =
        bodies.driven_bodies[static_cast<std::size_t>(bodies.driven[static_cast<std::size_t>(paddle.body.value)])]
            .motion;
    const auto* law = std::get_if<body::HarmonicMotion>(&bodies.motions[static_cast<std::size_t>(motion)].law);
    const Vec3 still = law != nullptr && law->arm > 0 ? law->center + law->arm * build.up() : Vec3{};
    return still + (face - dot(paddle.direction, still)) * paddle.direction;
}

void warn_of_leaving(CaseBuild& build, const WavePaddle& paddle, const fluid::ParticleSettings& sph) {
    const fluid::Domain& domain = sph.domain;
    const std::optional<double> face = face_of(build, paddle);
    for (int axis = 0; face && axis < domain.dimension; ++axis) {
        const double way = paddle.direction[axis];
        if (std::abs(way) < 1 - 1e-9 || domain.is_periodic[static_cast<std::size_t>(axis)]) {
            continue;  // where the domain ends along other ways depends on where along the paddle one looks
        }
        const double back = farthest_back(build, paddle, point_of_face(build, paddle, *face));
        const double end = way > 0 ? domain.low[axis] : -domain.high[axis];
        if (back < end - 1e-6 * sph.spacing) {
            warn(build, paddle,
                 fmt::format("the face of '{}' draws back to {} = {:.4g} m, out of 'fluid.domain', which ends at "
                             "{:.4g} m",
                             paddle.wave.paddle, "xyz"[axis], way * back, way * end),
                 "a domain that reaches behind it: water that leaves the domain ends the run");
        }
    }
}

}  // namespace

void warn_of_paddles(CaseBuild& build, const coupling::ParticleFluid& fluid, const coupling::Filling& filling) {
    for (const WavePaddle& paddle : build.paddles) {
        warn_of_height(build, paddle, fluid.settings().spacing);
        warn_of_leaving(build, paddle, fluid.settings());
    }
    warn_of_water_at_paddles(build, fluid.settings().spacing, filling);
}

void warn_of_water_at_paddles(CaseBuild& build, double spacing, const coupling::Filling& filling) {
    for (const WavePaddle& paddle : build.paddles) {
        if (const auto before = water_before(build, paddle, spacing, filling)) {
            if (!std::isfinite(before->surface)) {
                warn_of_dry_paddle(build, paddle, spacing);
                continue;
            }
            warn_of_depth(build, paddle, spacing,
                          depth_of(build, paddle, spacing, *before, filling.particles.position));
        }
    }
}

}  // namespace riprap::scene
