// SPDX-License-Identifier: Apache-2.0
// Planar sections: rock cut into blocks along lines.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/geometry/planar/convex_pieces.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"
#include "riprap/scene/assemble/build_case.hpp"
#include "riprap/scene/assemble/recipe_blocks.hpp"
#include "riprap/scene/assemble/section_files.hpp"
#include "riprap/scene/assemble/section_loads.hpp"
#include "riprap/scene/shapes/shape_library.hpp"

namespace riprap::scene {

using geometry::PlanarJoint;
using geometry::Polygon;
using geometry::Vec2;

namespace {

/// Content of a section.
struct Section {
    Polygon outline;  ///< empty where it is among the lines
    std::vector<PlanarJoint> lines;
    double snap{0};
    std::vector<Vec2> holes;
    std::vector<PlanarJoint> fixed;  ///< points and lines of which each point holds its block
    std::vector<Vec2> measured, loaded;
    std::vector<geometry::DdaLoadHistory> loads;
};

void add_lines(const Value& table, Section& section) {
    if (const Value* lines = table.find("lines")) {
        for (const Value& line : lines->items) {
            for (std::size_t k = 0; k + 1 < line.items.size(); ++k) {
                section.lines.push_back({to_point(line.items[k]), to_point(line.items[k + 1]), 0});
            }
        }
    }
}

void add_points(const Value& table, const char* key, std::vector<Vec2>& points) {
    if (const Value* list = table.find(key)) {
        for (const Value& point : list->items) {
            points.push_back(to_point(point));
        }
    }
}

/// The corners that joint sets are drawn within.
Polygon room_of(const Section& section) {
    if (!section.outline.empty()) {
        return section.outline;
    }
    Vec2 low = section.lines.front().begin, high = low;
    for (const PlanarJoint& line : section.lines) {
        for (const Vec2& x : {line.begin, line.end}) {
            low = {std::min(low.x, x.x), std::min(low.y, x.y)};
            high = {std::max(high.x, x.x), std::max(high.y, x.y)};
        }
    }
    return {low, {high.x, low.y}, high, {low.x, high.y}};
}

void add_joint_sets(const CaseBuild& build, const Value& table, Section& section) {
    const std::uint64_t seed = seed_for(build, table, get_text(table, "name"));
    const Polygon room = room_of(section);
    std::uint64_t index = 0;
    for (const Value& set : get(table, "joint_set").items) {
        geometry::PlanarJointSet joints;
        joints.dip = get_number(set, "angle");
        joints.spacing = get_number(set, "spacing");
        joints.spacing_scatter = get_number(set, "spacing_scatter");
        joints.length = get_number_or(set, "length", 0);
        joints.bridge = get_number(set, "bridge");
        const Vec3 origin = get_vector(set, "origin");
        joints.offset = dot(Vec2{-std::sin(joints.dip), std::cos(joints.dip)}, Vec2{origin.x, origin.y});
        const auto traces = geometry::traces_of(joints, room, seed + index++);
        section.lines.insert(section.lines.end(), traces.begin(), traces.end());
    }
}

/// All that the table asks for. Nothing, with problems, when a file is refused.
std::optional<Section> read_section(CaseBuild& build, const Value& table, MaterialId material) {
    Section section;
    if (const Value* outline = table.find("outline")) {
        for (const Value& corner : outline->items) {
            section.outline.push_back(to_point(corner));
        }
        const auto polygon = geometry::make_polygon(section.outline);
        if (!accept(build, polygon, outline->place)) {
            return std::nullopt;
        }
        section.outline = polygon.value();
        section.lines = geometry::outline_of(section.outline);
    } else {
        const auto file = read_geometry_file(build, get(table, "geometry"));
        if (!file) {
            return std::nullopt;
        }
        section.lines = file->joints;
        section.snap = file->snap;
        section.holes = file->hole_points;
        section.fixed = file->fixed_lines;
        section.measured = file->measured_points;
        section.loaded = file->load_points;
    }
    if (const Value* path = table.find("analysis")) {
        const auto file = read_analysis_file(build, *path, material);
        if (!file) {
            return std::nullopt;
        }
        section.loads = file->loads;
    }
    section.snap = get_number_or(table, "snap", section.snap);
    add_lines(table, section);
    if (!section.lines.empty()) {
        add_joint_sets(build, table, section);
    }
    add_points(table, "holes", section.holes);
    std::vector<Vec2> fixed;
    add_points(table, "fixed_points", fixed);
    for (const Vec2& x : fixed) {
        section.fixed.push_back({x, x, 0});
    }
    return section;
}

/// Tells whether a point of the line lies in the block.
bool is_held(const SectionBlock& block, const PlanarJoint& line) {
    constexpr int samples = 64;  // a line crosses a block or does not; short cuts of a corner do not hold it
    for (int i = 0; i <= samples; ++i) {
        if (is_inside(block.corners, line.begin + (static_cast<double>(i) / samples) * (line.end - line.begin))) {
            return true;
        }
    }
    return false;
}

/// Cuts the section and leaves out what lies outside and in holes.
std::optional<std::vector<SectionBlock>> cut(CaseBuild& build, const Value& table, const Section& section) {
    const auto made =
        geometry::cut_by_lines(section.lines, {.snap = section.snap, .sliver = get_number(table, "sliver")});
    if (!accept(build, made, table.place)) {
        return std::nullopt;
    }
    std::vector<SectionBlock> blocks;
    for (const Polygon& corners : made.value().blocks) {
        blocks.push_back({corners, geometry::convex_pieces(corners)});
        if (blocks.back().pieces.empty()) {
            const Vec2 x = geometry::moments_of(corners).centroid;
            build.problem(table.place, fmt::format("the block about ({:.6g}, {:.6g}) cannot be divided", x.x, x.y),
                          "joints farther apart, or a larger snap");
            return std::nullopt;
        }
    }
    const auto& outline = section.outline;
    std::erase_if(blocks,
                  [&](const SectionBlock& block) { return !outline.empty() && !is_inside(outline, block.middle()); });
    const std::size_t whole = blocks.size();
    for (const Vec2& hole : section.holes) {
        const std::int64_t i = block_at(blocks, hole);
        if (i < 0) {
            build.problem(table.place, fmt::format("the hole at ({:.6g}, {:.6g}) lies in no block", hole.x, hole.y),
                          "one point in each block that is left out");
            return std::nullopt;
        }
        blocks.erase(blocks.begin() + i);
    }
    double least = HUGE_VAL, most = 0;
    for (const SectionBlock& block : blocks) {
        const double area = geometry::moments_of(block.corners).area;
        least = std::min(least, area);
        most = std::max(most, area);
    }
    build.notes.push_back(
        fmt::format("section '{}': {} blocks from {:.3g} to {:.3g} m^2 of {} lines with {} crossings; {} ends that cut "
                    "nothing, {} loops that nothing ties to the outline, {} blocks left out",
                    get_text(table, "name"), blocks.size(), least, most, section.lines.size(), made.value().crossings,
                    made.value().dead_ends, made.value().loose_loops, whole - blocks.size()));
    return blocks;
}

std::vector<geometry::Point2> corners_of(const Polygon& polygon) {
    std::vector<geometry::Point2> corners;
    for (const Vec2& x : polygon) {
        corners.push_back({x.x, x.y});
    }
    return corners;
}

/// Parts of a block in world axes, from its place `origin`. Nothing, with problems, when one is refused.
std::optional<std::vector<body::Part>> parts_of(CaseBuild& build, const Value& table, const SectionBlock& block,
                                                const Vec2& origin) {
    std::vector<body::Part> parts;
    for (Polygon piece : block.pieces) {
        for (Vec2& x : piece) {
            x = x - origin;
        }
        const auto prism = geometry::planar_prism(corners_of(piece));
        if (!accept(build, prism, table.place)) {
            return std::nullopt;
        }
        parts.push_back(build.shapes.add(prism.value()));
    }
    return parts;
}

/// Names of the blocks of measured points, for probes.
void note_measured(CaseBuild& build, const std::string& name, const std::vector<SectionBlock>& blocks,
                   const std::vector<Vec2>& points) {
    for (const Vec2& x : points) {
        const std::int64_t i = block_at(blocks, x);
        build.notes.push_back(
            i < 0 ? fmt::format("the measured point ({:.6g}, {:.6g}) lies in no block", x.x, x.y)
                  : fmt::format("the measured point ({:.6g}, {:.6g}) lies in '{}[{}]'", x.x, x.y, name, i));
    }
}

/// Refuses points that are to hold a block and lie in none.
bool check_fixed(CaseBuild& build, const Value& table, const std::vector<SectionBlock>& blocks,
                 const std::vector<PlanarJoint>& fixed) {
    bool is_good = true;
    for (const PlanarJoint& line : fixed) {
        if (std::none_of(blocks.begin(), blocks.end(), [&](const auto& block) { return is_held(block, line); })) {
            build.problem(
                table.place,
                fmt::format("the fixed point at ({:.6g}, {:.6g}) lies in no block", line.begin.x, line.begin.y),
                "one point in each block that does not move");
            is_good = false;
        }
    }
    return is_good;
}

void build_section(CaseBuild& build, const Value& table) {
    const body::NewBody common = common_block(build, table);
    if (!common.material.is_valid()) {
        return;
    }
    const auto section = read_section(build, table, common.material);
    const auto blocks = section ? cut(build, table, *section) : std::nullopt;
    if (!blocks || !has_room(build, table.place, common.name, blocks->size()) ||
        !check_fixed(build, table, *blocks, section->fixed)) {
        return;
    }
    const std::int32_t first = build.model.bodies.size();
    const double fixed_below = get_number_or(table, "fixed_below", -1e300);
    for (std::size_t i = 0; i < blocks->size(); ++i) {
        const SectionBlock& one = (*blocks)[i];
        const Vec2 origin = geometry::moments_of(one.corners).centroid;
        const auto parts = parts_of(build, table, one, origin);
        if (!parts) {
            return;
        }
        body::NewBody block = common;
        block.pose.position = {origin.x, origin.y, 0};
        block.parts = *parts;
        const auto holds = [&one](const PlanarJoint& line) { return is_held(one, line); };
        if (origin.y < fixed_below || std::any_of(section->fixed.begin(), section->fixed.end(), holds)) {
            block.drive = body::Drive::fixed;
        }
        add_recipe_block(build, std::move(block), static_cast<std::int64_t>(i));
    }
    note_measured(build, common.name, *blocks, section->measured);
    add_file_loads(build, table, *blocks, section->loaded, section->loads, first);
    add_loads_at(build, table, *blocks, first);
}

}  // namespace

void build_sections(CaseBuild& build) {
    for (const Value& table : get(build.root, "section").items) {
        build.claim_name(table);
        if (!build.is_planar) {
            build.problem(table.place, "a section in a scene of three dimensions",
                          "dimension = 2, or [[rock_mass]] for a region in space");
            continue;
        }
        build_section(build, table);
    }
}

}  // namespace riprap::scene
