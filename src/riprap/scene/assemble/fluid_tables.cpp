// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/assemble/fluid_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "riprap/geometry/polyhedra/clip.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"
#include "riprap/scene/case/orientation.hpp"
#include "riprap/scene/case/placed_part.hpp"
#include "riprap/scene/keys/bound_keys.hpp"
#include "riprap/scene/keys/methods.hpp"
#include "riprap/scene/shapes/shape_library.hpp"
#include "riprap/scene/text/limits.hpp"

namespace riprap::scene {

namespace {

/// The region of one table. Nothing with a problem.
std::optional<coupling::FillRegion> read_region(CaseBuild& build, const Value& table) {
    coupling::FillRegion region;
    region.velocity = get_vector(table, "velocity");
    region.level = get_number_or(table, "level", region.level);
    auto pieces = read_pieces(build, table);
    if (!pieces) {
        return std::nullopt;
    }
    region.pieces = std::move(*pieces);
    return region;
}

}  // namespace

std::optional<std::vector<geometry::Polyhedron>> read_pieces(CaseBuild& build, const Value& table) {
    std::vector<geometry::Polyhedron> found;
    if (const Value* box = table.find("box")) {
        Vec3 low = get_vector(*box, "low"), high = get_vector(*box, "high");
        if (build.is_planar) {
            low.z = -0.5;
            high.z = 0.5;
        }
        for (int axis = 0; axis < 3; ++axis) {
            if (!(low[axis] < high[axis])) {
                build.problem(
                    box->place,
                    fmt::format("the box reaches from {} m to {} m along {}", low[axis], high[axis], "xyz"[axis]),
                    "low below high");
                return std::nullopt;
            }
        }
        found.push_back(geometry::moved(geometry::box(high - low), {0.5 * (low + high), {}}));
    } else if (const Value* shape = table.find("shape")) {
        if (ShapeLibrary::is_half_space(*shape)) {
            build.problem(shape->place, "a region of water cannot be a half-space", "a level, or another shape");
            return std::nullopt;
        }
        const auto pieces = build.shapes.pieces(*shape);
        if (!pieces) {
            return std::nullopt;
        }
        const Pose pose{get_vector(table, "position"), orientation_of(table.find("orientation"))};
        for (const geometry::Polyhedron& piece : *pieces) {
            found.push_back(geometry::moved(piece, pose));
        }
    }
    return found;
}

std::optional<fluid::Flow> read_flow(const Value& table) {
    std::optional<fluid::Flow> flow;
    if (const Value* given = table.find("flow")) {
        fluid::FlowLaws::for_each([&]<class Law>() {
            if (const Value* said = given->find(Law::word)) {
                Law law;
                read_keys(*said, Law::keys(), law);
                flow = law;
            }
        });
    }
    return flow;
}

bool read_domain(CaseBuild& build, const Value& table, fluid::Domain& domain) {
    domain.dimension = build.is_planar ? 2 : 3;
    domain.low = get_vector(table, "low");
    domain.high = get_vector(table, "high");
    bool is_good = true;
    for (int axis = 0; axis < domain.dimension; ++axis) {
        if (!(domain.low[axis] < domain.high[axis])) {
            build.problem(table.place,
                          fmt::format("the domain reaches from {} m to {} m along {}", domain.low[axis],
                                      domain.high[axis], "xyz"[axis]),
                          "low below high");
            is_good = false;
        }
    }
    if (const Value* periodic = table.find("periodic")) {
        for (std::size_t axis = 0; axis < periodic->items.size(); ++axis) {
            domain.is_periodic[axis] = periodic->items[axis].boolean && (axis < 2 || !build.is_planar);
        }
    }
    return is_good;
}

bool read_regions(CaseBuild& build, const Value& list, std::vector<coupling::FillRegion>& regions) {
    if (static_cast<std::int64_t>(list.items.size()) > limits::fluid_regions) {
        build.problem(list.place, fmt::format("{} regions of water", list.items.size()),
                      fmt::format("at most {}", limits::fluid_regions));
        return false;
    }
    for (const Value& entry : list.items) {
        if (auto region = read_region(build, entry)) {
            regions.push_back(std::move(*region));
        }
    }
    return regions.size() == list.items.size();
}

void check_level(CaseBuild& build, const Value& table, const coupling::FillRegion& region, const fluid::Domain& domain,
                 double slack) {
    if (!std::isfinite(region.level)) {
        return;
    }
    const double top = coupling::top_of(region, domain, build.up());
    if (region.level > top + slack) {
        build.problem(
            get(table, "level").place,
            fmt::format("the level {:.6g} m lies above its region, which ends at {:.6g} m", region.level, top),
            "a level in the region, or none to fill it whole");
    }
}

bool check_region(CaseBuild& build, const Value& table, const coupling::FillRegion& region,
                  const fluid::Domain& domain) {
    const Vec3 up = build.up();
    double bottom = 0;
    for (int axis = 0; axis < domain.dimension; ++axis) {
        bottom += std::min(up[axis] * domain.low[axis], up[axis] * domain.high[axis]);
    }
    const auto meets = [&](const geometry::Polyhedron& piece) {
        for (int axis = 0; axis < domain.dimension; ++axis) {
            Vec3 along{};
            along[axis] = 1;
            const auto [low, high] = geometry::range_along(piece, along);
            if (!(low < domain.high[axis] && domain.low[axis] < high)) {
                return false;
            }
        }
        return geometry::range_along(piece, up).low < region.level;
    };
    if (bottom < region.level &&
        (region.pieces.empty() || std::any_of(region.pieces.begin(), region.pieces.end(), meets))) {
        return true;
    }
    build.problem(table.place, "no water of this region lies in the domain",
                  "a region in the domain, and a level above its bottom");
    return false;
}

void check_lengths(CaseBuild& build, const fluid::Domain& domain) {
    const body::BodySet& bodies = build.model.bodies;
    int count = 0;
    std::string first;
    SourcePlace place;
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        const auto n = static_cast<std::size_t>(b);
        const bool is_dry = n < build.is_dry.size() && build.is_dry[n] != 0;
        if (is_dry || (bodies.drive[n] != body::Drive::free && std::isinf(bodies.release_time[n]))) {
            continue;
        }
        constexpr double most = std::numeric_limits<double>::max();
        Vec3 low{most, most, most}, high = -low;
        for (std::int32_t p = bodies.part_begin[n]; p < bodies.part_begin[n + 1]; ++p) {
            const PlacedPart part = placed(build, bodies.parts[static_cast<std::size_t>(p)]);
            for (int v = 0; v < part.shape.vertex_count; ++v) {
                const Vec3 x = to_world(part.pose, part.shape.vertex(v));
                low = min(low, x);
                high = max(high, x);
            }
        }
        for (int axis = 0; axis < domain.dimension; ++axis) {
            const double room = domain.high[axis] - domain.low[axis], length = high[axis] - low[axis];
            if (length > room * (1 + 1e-9)) {
                if (++count == 1) {
                    first = fmt::format("'{}' is {:.6g} m long along {}, 'fluid.domain' {:.6g} m",
                                        bodies.name(BodyId{b}), length, "xyz"[axis], room);
                    place = build.names[bodies.names[static_cast<std::size_t>(bodies.name_id[n])]];
                }
                break;
            }
        }
    }
    if (count > 0) {
        build.problem(place, count == 1 ? first : fmt::format("{}, and {} more", first, count - 1),
                      "a larger domain, a smaller body, or fixed = true");
    }
}

}  // namespace riprap::scene
