// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/hydrostatic/basins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/index.hpp"

namespace riprap::coupling {

namespace {

using Basin = HydrostaticSettings::Basin;
using Side = HydrostaticSettings::Side;

constexpr double infinity = std::numeric_limits<double>::infinity();
/// A plane whose normal is farther from an axis than this lies across it [-].
constexpr double along_axis = 1e-9;

void reach_over_periods(const fluid::Domain& domain, Basin& basin) {
    for (int axis = 0; axis < domain.dimension; ++axis) {
        const double round_off = 1e-9 * (domain.high[axis] - domain.low[axis]);
        if (domain.is_periodic[at(axis)] && basin.low[axis] <= domain.low[axis] + round_off &&
            basin.high[axis] >= domain.high[axis] - round_off) {
            basin.low[axis] = -infinity;
            basin.high[axis] = infinity;
        }
    }
}

bool is_along_an_axis(const Vec3& normal) {
    return std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)}) > 1 - along_axis;
}

/// Returns the sides and the bed of a convex piece, without those where the water has no end and those across the plane
/// of a planar scene.
std::vector<Side> sides_of_piece(const geometry::Polyhedron& piece, const Basin& basin, const fluid::Domain& domain,
                                 const Vec3& up) {
    std::vector<Side> sides;
    for (const std::vector<std::int32_t>& face : piece.faces) {
        const geometry::Plane plane = geometry::face_plane(piece.vertices, face);
        bool is_end = dot(plane.normal, up) < 1 - along_axis;
        for (int axis = 0; axis < 3; ++axis) {
            const bool is_across = std::abs(plane.normal[axis]) > 1 - along_axis;
            is_end = is_end && !(is_across && (axis >= domain.dimension || std::isinf(basin.high[axis])));
        }
        if (is_end) {
            sides.push_back({plane.normal, plane.offset});
        }
    }
    return sides;
}

bool is_box(const FillRegion& region) {
    return region.pieces.size() <= 1 && std::all_of(region.pieces.begin(), region.pieces.end(), [](const auto& piece) {
               return std::all_of(piece.faces.begin(), piece.faces.end(), [&](const auto& face) {
                   return is_along_an_axis(geometry::face_plane(piece.vertices, face).normal);
               });
           });
}

double distance_from_piece(const std::vector<Side>& sides, const Vec3& up, const Vec3& x) {
    double distance = 0;
    for (const Side& side : sides) {
        const double sideways = norm(side.normal - dot(side.normal, up) * up);
        if (sideways > along_axis) {
            distance = std::max(distance, (dot(side.normal, x) - side.offset) / sideways);
        }
    }
    return distance;
}

}  // namespace

Basin basin_of(const FillRegion& region, const fluid::Domain& domain, const Vec3& up) {
    Basin basin{domain.low, domain.high, region.level, {}};
    if (!region.pieces.empty()) {
        basin.low = {infinity, infinity, infinity};
        basin.high = {-infinity, -infinity, -infinity};
        for (const geometry::Polyhedron& piece : region.pieces) {
            for (const Vec3& x : piece.vertices) {
                basin.low = min(basin.low, x);
                basin.high = max(basin.high, x);
            }
        }
    }
    reach_over_periods(domain, basin);
    if (!is_box(region)) {
        for (const geometry::Polyhedron& piece : region.pieces) {
            basin.parts.push_back(sides_of_piece(piece, basin, domain, up));
        }
    }
    return basin;
}

std::vector<std::vector<Side>> sides_of(const HydrostaticSettings& settings, const Basin& basin, double slack) {
    if (!basin.parts.empty()) {
        std::vector<std::vector<Side>> parts = basin.parts;
        for (std::vector<Side>& part : parts) {
            for (Side& side : part) {
                side.offset += slack;
            }
        }
        return parts;
    }
    std::vector<Side> sides;
    for (int axis = 0; axis < (settings.is_planar ? 2 : 3); ++axis) {
        for (const double sign : {1.0, -1.0}) {
            const double bound = sign > 0 ? basin.high[axis] : -basin.low[axis];
            if (sign * settings.up[axis] > 0.5 || !std::isfinite(bound)) {
                continue;
            }
            Side side{{}, bound + slack};
            side.normal[axis] = sign;
            sides.push_back(side);
        }
    }
    return {std::move(sides)};
}

double distance_from(const Basin& basin, const HydrostaticSettings& settings, const Vec3& x) {
    if (!basin.parts.empty()) {
        double least = infinity;
        for (const std::vector<Side>& part : basin.parts) {
            least = std::min(least, distance_from_piece(part, settings.up, x));
        }
        return least;
    }
    Vec3 out{};
    for (int axis = 0; axis < (settings.is_planar ? 2 : 3); ++axis) {
        out[axis] = std::max({0.0, basin.low[axis] - x[axis], x[axis] - basin.high[axis]});
    }
    return norm(out - dot(out, settings.up) * settings.up);
}

const Basin* nearest_basin(const HydrostaticSettings& settings, const Vec3& x) {
    const Basin* nearest = nullptr;
    double least = infinity;
    for (const Basin& basin : settings.basins) {
        if (const double distance = distance_from(basin, settings, x); distance < least) {
            least = distance;
            nearest = &basin;
        }
    }
    return nearest;
}

}  // namespace riprap::coupling
