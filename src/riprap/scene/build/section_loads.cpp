// SPDX-License-Identifier: Apache-2.0
// Forces on the blocks of a section.
#include "riprap/scene/build/section_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "riprap/core/index.hpp"
#include "riprap/scene/build/load_tables.hpp"

namespace riprap::scene {

using geometry::Vec2;

std::int64_t block_at(const std::vector<SectionBlock>& blocks, const Vec2& x) {
    const auto found = std::find_if(blocks.begin(), blocks.end(),
                                    [&x](const SectionBlock& block) { return is_inside(block.corners, x); });
    return found == blocks.end() ? -1 : found - blocks.begin();
}

namespace {

/// Distance of a point from the outline of a block [m].
double distance_from(const SectionBlock& block, const Vec2& x) {
    double least = 1e300;
    for (std::size_t k = 0; k < block.corners.size(); ++k) {
        const Vec2 a = block.corners[k], line = block.corners[(k + 1) % block.corners.size()] - a;
        const double share = std::clamp(dot(x - a, line) / dot(line, line), 0.0, 1.0);
        least = std::min(least, norm(x - (a + share * line)));
    }
    return least;
}

/// The block that a point lies in or, to round-off, on; -1 = none.
std::int64_t block_at_or_under(const std::vector<SectionBlock>& blocks, const Vec2& x) {
    const std::int64_t inside = block_at(blocks, x);
    const auto is_under = [&x](const SectionBlock& block) {
        const double size = norm(block.corners[1] - block.corners[0]);
        return distance_from(block, x) <= 1e-6 * size;
    };
    const auto under = inside < 0 ? std::find_if(blocks.begin(), blocks.end(), is_under) : blocks.end();
    return under == blocks.end() ? inside : under - blocks.begin();
}

}  // namespace

void add_file_loads(CaseBuild& build, const Value& table, const std::vector<SectionBlock>& blocks,
                    std::span<const geometry::Vec2> points, std::span<const geometry::DdaLoadHistory> loads,
                    std::int32_t first) {
    for (std::size_t k = 0; k < loads.size(); ++k) {
        const auto& records = loads[k].records;
        const auto is_as_first = [&](const auto& r) { return r[1] == records[0][1] && r[2] == records[0][2]; };
        const bool is_constant = std::all_of(records.begin(), records.end(), is_as_first);
        const std::int64_t i = k < points.size() ? block_at(blocks, points[k]) : -1;
        if (!is_constant || i < 0) {
            build.problem(get(table, "analysis").place,
                          fmt::format("load {} {}", k, i < 0 ? "has no load point in a block" : "varies with time"),
                          "loads that stay, at load points of the geometry file that lie in a block");
            continue;
        }
        const BodyId id{first + static_cast<std::int32_t>(i)};
        body::PointLoad load{.body = id, .force = {records[0][1], records[0][2], 0}};
        load.point = Vec3{points[k].x, points[k].y, 0} - build.state.bodies.position[at(id.value)];
        load.start = records.front()[0];
        build.model.loads.push_back(load);
    }
}

void add_loads_at(CaseBuild& build, const Value& table, const std::vector<SectionBlock>& blocks, std::int32_t first) {
    const body::BodySet& bodies = build.model.bodies;
    for (const Value& one : get(table, "load").items) {
        const Vec2 x = to_point(get(one, "at"));
        const std::int64_t i = block_at_or_under(blocks, x);
        const BodyId id{first + static_cast<std::int32_t>(i)};
        if (!check_times(build, one)) {
            continue;
        }
        if (i < 0 || !is_free(bodies, id, std::numeric_limits<double>::max())) {
            build.problem(get(one, "at").place,
                          i < 0 ? "the load acts on no block"
                                : fmt::format("the load acts on '{}', which does not follow forces", bodies.name(id)),
                          "a point in a block that moves");
            continue;
        }
        body::PointLoad load = load_on(id, one);
        load.point = Vec3{x.x, x.y, 0} - build.state.bodies.position[at(id.value)];
        build.model.loads.push_back(load);
        build.notes.push_back(fmt::format("the load at ({:.6g}, {:.6g}) acts on '{}'", x.x, x.y, bodies.name(id)));
    }
}

}  // namespace riprap::scene
