// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/hydrostatic/held_faces.hpp"

#include <cmath>
#include <utility>

#include "riprap/core/index.hpp"

namespace riprap::coupling {

namespace {

using Polygon = std::vector<Vec3>;

/// Returns the part of a convex polygon with n . x <= offset; empty without area.
Polygon behind(const Polygon& polygon, const Vec3& n, double offset) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double depth_a = offset - dot(n, a), depth_b = offset - dot(n, b);
        if (depth_a >= 0) {
            kept.push_back(a);
        }
        if ((depth_a > 0 && depth_b < 0) || (depth_a < 0 && depth_b > 0)) {
            kept.push_back(a + (depth_a / (depth_a - depth_b)) * (b - a));
        }
    }
    return kept.size() > 2 ? kept : Polygon{};
}

/// Cuts off what lies in half-spaces.
Polygon out_of_half_spaces(const FluidScene& scene, const HydrostaticSettings& settings, const body::Motion& motion,
                           Polygon polygon, double slack) {
    for (const body::Part& part : scene.bodies.parts) {
        if (!scene.shapes.is_half_space(part.shape) || settings.passes(at(part.body.value)) || polygon.empty()) {
            continue;
        }
        const Pose& body = motion.pose[at(part.body.value)];
        const Vec3 place = body.position + rotate(body.orientation, part.local.position);
        const geometry::ConvexView shape = scene.shapes.view(part.shape);
        const Vec3 n = rotate(body.orientation, rotate(part.local.orientation, shape.normal(0)));
        polygon = behind(polygon, -1.0 * n, slack - shape.offset[0] - dot(n, place));
    }
    return polygon;
}

/// A plane with the water behind it.
struct BasinSide {
    Vec3 normal;
    double offset;
};

/// Returns the sides and the bed of a basin; the level is its top. Water along an axis without end has no sides there.
std::vector<BasinSide> sides_of(const HydrostaticSettings& settings, const HydrostaticSettings::Basin& basin,
                                double slack) {
    std::vector<BasinSide> sides;
    for (int axis = 0; axis < (settings.is_planar ? 2 : 3); ++axis) {
        for (const double sign : {1.0, -1.0}) {
            const double bound = sign > 0 ? basin.high[axis] : -basin.low[axis];
            if (sign * settings.up[axis] > 0.5 || !std::isfinite(bound)) {
                continue;
            }
            BasinSide side{{}, bound + slack};
            side.normal[axis] = sign;
            sides.push_back(side);
        }
    }
    return sides;
}

}  // namespace

std::vector<WetPiece> wet_pieces(const FluidScene& scene, const HydrostaticSettings& settings,
                                 const body::Motion& motion, const std::vector<Vec3>& face, double slack) {
    std::vector<WetPiece> found;
    std::vector<Polygon> left;
    if (Polygon out = out_of_half_spaces(scene, settings, motion, face, slack); !out.empty()) {
        left.push_back(std::move(out));
    }
    for (const HydrostaticSettings::Basin& basin : settings.basins) {
        std::vector<Polygon> beyond;
        for (Polygon& piece : left) {
            for (const BasinSide& side : sides_of(settings, basin, slack)) {
                if (Polygon outside = behind(piece, -1.0 * side.normal, -side.offset); !outside.empty()) {
                    beyond.push_back(std::move(outside));
                }
                piece = behind(piece, side.normal, side.offset);
            }
            if (!piece.empty()) {
                found.push_back({std::move(piece), &basin});
            }
        }
        left = std::move(beyond);
    }
    return found;
}

}  // namespace riprap::coupling
