// SPDX-License-Identifier: Apache-2.0
// Forces on the blocks of a section.
#include "riprap/scene/assemble/section_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "riprap/core/index.hpp"
#include "riprap/scene/assemble/build_case.hpp"
#include "riprap/scene/assemble/load_tables.hpp"

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

/// Force against time of load `k` of an analysis file; null with a problem where its times do not increase.
std::shared_ptr<const body::ForceTable> forces_of(CaseBuild& build, const Value& table, std::size_t k,
                                                  std::span<const std::array<double, 3>> records) {
    auto forces = std::make_shared<body::ForceTable>();
    for (const auto& [time, x, y] : records) {
        if (!forces->time.empty() && time <= forces->time.back()) {
            build.problem(get(table, "analysis").place,
                          fmt::format("load {}: time {:g} s does not follow {:g} s", k, time, forces->time.back()),
                          "increasing times");
            return nullptr;
        }
        forces->time.push_back(time);
        forces->force.push_back({x, y, 0});
    }
    return forces;
}

}  // namespace

void add_file_loads(CaseBuild& build, const Value& table, const std::vector<SectionBlock>& blocks,
                    std::span<const geometry::Vec2> points, std::span<const geometry::DdaLoadHistory> loads,
                    std::int32_t first) {
    const bool has_own = !get(table, "load").items.empty();
    if (table.find("analysis") != nullptr && !has_own && loads.size() < points.size()) {
        build.warnings.push_back(
            to_string(Diagnostic{get(table, "analysis").place,
                                 fmt::format("{} of the {} load points of the geometry file have no load",
                                             points.size() - loads.size(), points.size()),
                                 "a load for each of them, in their order"}));
    }
    for (std::size_t k = 0; k < loads.size(); ++k) {
        const auto& records = loads[k].records;
        const std::int64_t i = k < points.size() ? block_at(blocks, points[k]) : -1;
        if (i < 0) {
            build.problem(get(table, "analysis").place, fmt::format("load {} has no load point in a block", k),
                          "loads at load points of the geometry file that lie in a block");
            continue;
        }
        const BodyId id{first + static_cast<std::int32_t>(i)};
        body::PointLoad load{.body = id};
        load.point = Vec3{points[k].x, points[k].y, 0} - build.state.bodies.position[at(id.value)];
        load.table = forces_of(build, table, k, records);
        if (load.table == nullptr) {
            continue;
        }
        build.model.loads.push_back(load);
        build.notes.push_back(fmt::format("load {} of the analysis file, {} rows from {:g} s on, acts on '{}'", k,
                                          records.size(), records.front()[0], build.model.bodies.name(id)));
    }
}

void add_loads_at(CaseBuild& build, const Value& table, const std::vector<SectionBlock>& blocks, std::int32_t first) {
    const body::BodySet& bodies = build.model.bodies;
    for (const Value& one : get(table, "load").items) {
        const Vec2 x = to_point(get(one, "at"));
        const std::int64_t i = block_at_or_under(blocks, x);
        const BodyId id{first + static_cast<std::int32_t>(i)};
        if (!check_times(build, one) || !read_force_table(build, one)) {
            continue;
        }
        if (i < 0 || !is_free(bodies, id, std::numeric_limits<double>::max())) {
            build.problem(get(one, "at").place,
                          i < 0 ? "the load acts on no block"
                                : fmt::format("the load acts on '{}', which does not follow forces", bodies.name(id)),
                          "a point in a block that moves");
            continue;
        }
        body::PointLoad load = load_on(build, id, one);
        load.point = Vec3{x.x, x.y, 0} - build.state.bodies.position[at(id.value)];
        build.model.loads.push_back(load);
        build.notes.push_back(fmt::format("the load at ({:.6g}, {:.6g}) acts on '{}'", x.x, x.y, bodies.name(id)));
    }
}

}  // namespace riprap::scene
