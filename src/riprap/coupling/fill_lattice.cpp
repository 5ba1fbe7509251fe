// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/fill_lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/error.hpp"
#include "riprap/geometry/polyhedra/clip.hpp"

namespace riprap::coupling {

using geometry::Plane;
using geometry::Polyhedron;

namespace {

constexpr double least_layer = 1e-3;  ///< share of a cell below the level from which on it counts
constexpr double aligned = 1 - 1e-9;  ///< cosine from which on two directions are one

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

Polyhedron slab_of(const fluid::Domain& domain) {
    Polyhedron box;
    const bool is_flat = domain.dimension == 2;
    const double low = is_flat ? -0.5 : domain.low.z, high = is_flat ? 0.5 : domain.high.z;
    for (const double z : {low, high}) {
        for (const auto& [x, y] : {std::pair{domain.low.x, domain.low.y}, std::pair{domain.high.x, domain.low.y},
                                   std::pair{domain.high.x, domain.high.y}, std::pair{domain.low.x, domain.high.y}}) {
            box.vertices.push_back({x, y, z});
        }
    }
    box.faces = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    return box;
}

/// The pieces of a region: the whole domain where it names none.
std::vector<Polyhedron> pieces_of(const FillRegion& region, const fluid::Domain& domain) {
    return region.pieces.empty() ? std::vector<Polyhedron>{slab_of(domain)} : region.pieces;
}

[[noreturn]] void refuse(std::string message, std::string allowed) {
    throw CaseError(Diagnostic{{}, std::move(message), std::move(allowed)});
}

/// A number in [0, 1) for every column of the lattice, spread evenly over neighbouring ones (Kronecker's sequence of
/// the plastic number).
double turn_of(std::int64_t i, std::int64_t j) {
    constexpr double first = 0.7548776662466927, second = 0.5698402909980532;
    const double sum = first * static_cast<double>(i) + second * static_cast<double>(j);
    return sum - std::floor(sum);
}

}  // namespace

RegionPlanes planes_of(const FillRegion& region, const fluid::ParticleSettings& settings, const Vec3& up,
                       FillReport& report) {
    RegionPlanes result{{}, {{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}}, -1e300};
    for (const Polyhedron& whole : pieces_of(region, settings.domain)) {
        const Polyhedron piece = std::isfinite(region.level) ? geometry::clip_convex(whole, {up, region.level}) : whole;
        if (piece.faces.empty()) {
            continue;
        }
        const bool is_planar = settings.domain.dimension == 2;
        const geometry::Range z = geometry::range_along(piece, {0, 0, 1});
        report.region_volume += geometry::mass_properties(piece).volume / (is_planar ? z.high - z.low : 1);
        result.surface = std::max(result.surface, geometry::range_along(piece, up).high);
        std::vector<Plane> planes;
        for (const auto& face : piece.faces) {
            const Plane plane = geometry::face_plane(piece.vertices, face);
            if (!(is_planar && std::abs(plane.normal.z) > 0.5)) {
                planes.push_back(plane);
            }
        }
        result.pieces.push_back(std::move(planes));
        for (const Vec3& x : piece.vertices) {
            result.bounds.low = min(result.bounds.low, x);
            result.bounds.high = max(result.bounds.high, x);
        }
    }
    report.surface = result.surface;
    return result;
}

void raise_surface(RegionPlanes& region, const Vec3& up, double height, double spacing) {
    for (auto& planes : region.pieces) {
        for (Plane& plane : planes) {
            if (dot(plane.normal, up) > aligned && plane.offset > region.surface - lattice_slack * spacing) {
                plane.offset += height;
            }
        }
    }
    region.surface += height;
    region.bounds.low += min(Vec3{}, height * min(Vec3{}, up));
    region.bounds.high += max(Vec3{}, height * max(Vec3{}, up));
}

Vec3 lattice_corner(std::span<const RegionPlanes> regions, const fluid::Domain& domain) {
    const auto has_extent = [](const RegionPlanes& region) { return !region.pieces.empty(); };
    const auto first = std::find_if(regions.begin(), regions.end(), has_extent);
    return first != regions.end() ? first->bounds.low : domain.low;
}

Lattice lattice_over(std::span<const RegionPlanes> regions, const fluid::ParticleSettings& settings, const Vec3& corner,
                     const Vec3& up) {
    const double dp = settings.spacing;
    Lattice lattice{{}, {1, 1, 1}, dp};
    Bounds all{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
    for (const RegionPlanes& region : regions) {
        all = {min(all.low, region.bounds.low), max(all.high, region.bounds.high)};
    }
    for (int axis = 0; axis < settings.domain.dimension; ++axis) {
        const double period = settings.domain.high[axis] - settings.domain.low[axis];
        if (settings.domain.is_periodic[at(axis)] && std::abs(period / dp - std::round(period / dp)) > lattice_slack) {
            refuse(fmt::format("the domain repeats every {:.9g} m along {}, which is {:.9g} spacings", period,
                               "xyz"[axis], period / dp),
                   "a whole number of spacings");
        }
        const double anchor = corner[axis] + 0.5 * dp;
        const double low = std::max(all.low[axis] - 0.5 * dp * std::max(0.0, -up[axis]), settings.domain.low[axis]);
        // The last layer along `up` may lie half a spacing above the level (region_of).
        const double high = std::min(all.high[axis] + 0.5 * dp * std::max(0.0, up[axis]), settings.domain.high[axis]);
        const double before = std::ceil((low - anchor) / dp - lattice_slack);
        lattice.first[axis] = anchor + before * dp;
        const double steps = std::floor((high - lattice.first[axis]) / dp + lattice_slack);
        constexpr double most = 1e9;  // beyond any limit of particles, and far from the end of the integers
        if (!(steps < most)) {
            refuse(fmt::format("water spans {:.3g} spacings of {:.3g} m along {}", (high - low) / dp, dp, "xyz"[axis]),
                   fmt::format("a spacing of which at most {:.0g} fit into the water", most));
        }
        lattice.counts[at(axis)] = static_cast<std::int64_t>(std::max(-1.0, steps)) + 1;
    }
    return lattice;
}

namespace {

/// The share of cell (i, j, k) below the surface; 0 where `place`, or what is beneath it in a last layer, is outside.
double share_with(const RegionPlanes& region, const Lattice& lattice, const Vec3& up, const Vec3& middle,
                  const Vec3& place) {
    const double slack = lattice_slack * lattice.spacing;
    const double below = (region.surface - dot(up, middle)) / lattice.spacing + 0.5;
    const bool is_last = below < 1 - lattice_slack;
    const bool is_along_axis = std::max({std::abs(up.x), std::abs(up.y), std::abs(up.z)}) > aligned;
    if (is_last && !(is_along_axis && below > least_layer)) {
        return 0;
    }
    // A last layer alone would be a film; it lies on a whole one.
    const Vec3 beneath = is_last ? place - lattice.spacing * up : place;
    for (const auto& planes : region.pieces) {
        const bool is_inside = std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) {
            const bool is_level = is_last && dot(plane.normal, up) > aligned;
            return is_level || (dot(plane.normal, place) <= plane.offset - slack &&
                                dot(plane.normal, beneath) <= plane.offset - slack);
        });
        if (is_inside) {
            return is_last ? below : 1;
        }
    }
    return 0;
}

/// The first region of whose share a cell has its turn; -1 = none.
template <class Share>
int region_by(std::span<const RegionPlanes> regions, const Vec3& up, std::int64_t i, std::int64_t j, std::int64_t k,
              const Share& share) {
    const double turn = std::abs(up.x) > 0.5 ? turn_of(j, k) : std::abs(up.y) > 0.5 ? turn_of(i, k) : turn_of(i, j);
    for (std::size_t r = 0; r < regions.size(); ++r) {
        if (turn < share(regions[r])) {
            return static_cast<int>(r);
        }
    }
    return -1;
}

}  // namespace

double share_of(const RegionPlanes& region, const Lattice& lattice, const Vec3& up, std::int64_t i, std::int64_t j,
                std::int64_t k) {
    const Vec3 x = lattice.place(i, j, k);
    return share_with(region, lattice, up, x, x);
}

int region_of(std::span<const RegionPlanes> regions, const Lattice& lattice, const Vec3& up, std::int64_t i,
              std::int64_t j, std::int64_t k) {
    return region_by(regions, up, i, j, k,
                     [&](const RegionPlanes& region) { return share_of(region, lattice, up, i, j, k); });
}

int region_beside(std::span<const RegionPlanes> regions, const Lattice& lattice, const Vec3& up, std::int64_t i,
                  std::int64_t j, std::int64_t k, const Vec3& place) {
    return region_by(regions, up, i, j, k, [&](const RegionPlanes& region) {
        return share_with(region, lattice, up, lattice.place(i, j, k), place);
    });
}

double top_of(const FillRegion& region, const fluid::Domain& domain, const Vec3& up) {
    double top = -std::numeric_limits<double>::infinity();
    for (const Polyhedron& piece : pieces_of(region, domain)) {
        top = std::max(top, geometry::range_along(piece, up).high);
    }
    return top;
}

}  // namespace riprap::coupling
