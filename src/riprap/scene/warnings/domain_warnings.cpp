// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/geometry/polyhedra/clip.hpp"
#include "riprap/scene/case/placed_part.hpp"
#include "riprap/scene/warnings/fluid_warnings.hpp"

namespace riprap::scene {

void warn_of_bodies_outside(CaseBuild& build, const coupling::ParticleFluid& fluid) {
    const fluid::Domain& domain = fluid.settings().domain;
    std::size_t count = 0, first = 0;
    for (std::size_t b = build.state.bodies.position.size(); b-- > 0;) {
        const Vec3& x = build.state.bodies.position[b];
        if (!domain.admits(x) && build.model.bodies.drive[b] == body::Drive::free && fluid.is_dry[b] == 0) {
            first = b;
            ++count;
        }
    }
    if (count > 0) {  // one line for all: a slide may begin far above its lake
        const Vec3& x = build.state.bodies.position[first];
        const std::string others = count > 1 ? fmt::format(" and {} more", count - 1) : "";
        warn_at(build, build.model.bodies.name_id[first],
                fmt::format("'{}' at ({:.6g}, {:.6g}, {:.6g}) m{} outside of 'fluid.domain', where no water comes",
                            build.model.bodies.name(BodyId{static_cast<std::int32_t>(first)}), x.x, x.y, x.z,
                            others.empty() ? " starts" : others + " start"));
    }
}

namespace {

/// Outward unit normal of a side of the domain.
Vec3 outward(int axis, bool is_high) {
    Vec3 n{};
    n[axis] = is_high ? 1 : -1;
    return n;
}

/// Cuts from a piece of a region the part beyond a side of the domain, below the level.
geometry::Polyhedron beyond(const geometry::Polyhedron& piece, double level, const Vec3& up, const Vec3& outward,
                            double side) {
    geometry::Polyhedron cut = std::isfinite(level) ? geometry::clip_convex(piece, {up, level}) : piece;
    return cut.faces.empty() ? cut : geometry::clip_convex(cut, {-outward, -side});
}

/// Tells whether some place in the piece is in no solid. Looks at no more than 48 places along an axis.
bool has_room(const CaseBuild& build, const geometry::Polyhedron& piece, const std::vector<std::uint8_t>& is_dry,
              int dimension, double spacing) {
    Vec3 low = piece.vertices.front(), high = low;
    for (const Vec3& x : piece.vertices) {
        low = min(low, x);
        high = max(high, x);
    }
    std::vector<geometry::Plane> planes;
    for (const auto& face : piece.faces) {
        planes.push_back(geometry::face_plane(piece.vertices, face));
    }
    const PlacedSolids solids(build, is_dry, low, high);
    std::array<std::int64_t, 3> count{1, 1, 1};
    for (int k = 0; k < dimension; ++k) {
        count[static_cast<std::size_t>(k)] =
            static_cast<std::int64_t>(std::clamp((high[k] - low[k]) / spacing, 1.0, 48.0));
    }
    for (std::int64_t i = 0; i < count[0] * count[1] * count[2]; ++i) {
        const std::array<std::int64_t, 3> cell{i % count[0], i / count[0] % count[1], i / (count[0] * count[1])};
        Vec3 x{};
        for (int k = 0; k < 3; ++k) {
            const auto n = static_cast<std::size_t>(k);
            x[k] = low[k] + (static_cast<double>(cell[n]) + 0.5) / static_cast<double>(count[n]) * (high[k] - low[k]);
        }
        const bool is_inside = std::all_of(planes.begin(), planes.end(), [&](const geometry::Plane& plane) {
            return dot(plane.normal, x) <= plane.offset;
        });
        if (is_inside && !solids.at(x, 0).is_valid()) {
            return true;
        }
    }
    return false;
}

}  // namespace

void warn_of_cut_region(CaseBuild& build, const SourcePlace& place, const coupling::FillRegion& region,
                        const coupling::ParticleFluid& fluid) {
    const fluid::Domain& domain = fluid.settings().domain;
    double most = 0;
    for (const geometry::Polyhedron& piece : region.pieces) {
        for (int side = 0; side < 2 * domain.dimension; ++side) {
            const int axis = side / 2;
            const bool is_high = side % 2 == 1;
            const Vec3 n = outward(axis, is_high);
            const double end = is_high ? domain.high[axis] : -domain.low[axis];
            if (domain.is_periodic[static_cast<std::size_t>(axis)] ||
                geometry::range_along(piece, n).high < end + (1 + 1e-6) * fluid.settings().spacing) {
                continue;
            }
            const geometry::Polyhedron cut = beyond(piece, region.level, build.up(), n, end);
            const double reach = cut.faces.empty() ? 0 : geometry::range_along(cut, n).high - end;
            if (reach > std::max(most, (1 + 1e-6) * fluid.settings().spacing) &&
                has_room(build, cut, fluid.is_dry, domain.dimension, fluid.settings().spacing)) {
                most = reach;
            }
        }
    }
    if (most > 0) {
        build.warnings.push_back(to_string(Diagnostic{
            place, fmt::format("the region reaches {:.4g} m out of 'fluid.domain', where no water is placed", most),
            ""}));
    }
}

void warn_of_open_sides(CaseBuild& build, const SourcePlace& place, const coupling::ParticleFluid& fluid,
                        const std::vector<Vec3>& water) {
    const fluid::Domain& domain = fluid.settings().domain;
    const double spacing = fluid.settings().spacing;
    std::vector<const fluid::Opening*> openings;
    for (const fluid::Inflow& inflow : fluid.open.inflows) {
        openings.push_back(&inflow.opening);
    }
    for (const fluid::Outflow& outflow : fluid.open.outflows) {
        openings.push_back(&outflow.opening);
    }
    for (int side = 0; side < 2 * domain.dimension; ++side) {
        const int axis = side / 2;
        const bool is_high = side % 2 == 1;
        const double end = is_high ? domain.high[axis] : domain.low[axis];
        const Vec3 step = spacing * outward(axis, is_high);
        Vec3 low = domain.low, high = domain.high;
        low[axis] = end - spacing;
        high[axis] = end + spacing;
        const PlacedSolids solids(build, fluid.is_dry, low, high);
        const auto is_open = [&](const Vec3& x) {
            return std::abs(end - x[axis]) < spacing && !solids.at(x + step, 0).is_valid() &&
                   std::none_of(openings.begin(), openings.end(), [&](const fluid::Opening* opening) {
                       return opening->axis == axis && opening->is_across(x, domain.dimension) &&
                              std::abs(opening->past(x)) < 2 * spacing;
                   });
        };
        if (!domain.is_periodic[static_cast<std::size_t>(axis)] && std::any_of(water.begin(), water.end(), is_open)) {
            build.warnings.push_back(to_string(Diagnostic{
                place,
                fmt::format("water stands at the side {} = {:.6g} m of the domain, where nothing holds it: a particle "
                            "that leaves ends the run",
                            "xyz"[axis], end),
                "a wall there, an [[fluid.outflow]], or a larger domain"}));
        }
    }
}

}  // namespace riprap::scene
