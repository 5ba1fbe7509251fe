// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/hydrostatic/held_faces.hpp"

#include <utility>

#include "riprap/core/index.hpp"
#include "riprap/coupling/hydrostatic/basins.hpp"

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

}  // namespace

std::vector<WetPiece> wet_pieces(const FluidScene& scene, const HydrostaticSettings& settings,
                                 const body::Motion& motion, const std::vector<Vec3>& face, double slack) {
    std::vector<WetPiece> found;
    std::vector<Polygon> left;
    if (Polygon out = out_of_half_spaces(scene, settings, motion, face, slack); !out.empty()) {
        left.push_back(std::move(out));
    }
    for (const HydrostaticSettings::Basin& basin : settings.basins) {
        for (const std::vector<HydrostaticSettings::Side>& sides : sides_of(settings, basin, slack)) {
            std::vector<Polygon> beyond;
            for (Polygon& piece : left) {
                for (const HydrostaticSettings::Side& side : sides) {
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
    }
    return found;
}

}  // namespace riprap::coupling
