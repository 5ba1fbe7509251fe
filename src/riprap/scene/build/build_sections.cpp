// SPDX-License-Identifier: Apache-2.0
// Planar sections: rock cut into blocks along lines.
#include <fmt/format.h>

#include <algorithm>

#include "riprap/core/index.hpp"
#include "riprap/geometry/convex_pieces.hpp"
#include "riprap/geometry/shapes.hpp"
#include "riprap/scene/build/recipe_blocks.hpp"
#include "riprap/scene/build/section_files.hpp"
#include "riprap/scene/build/shape_library.hpp"

namespace riprap::scene {

using geometry::PlanarJoint;
using geometry::Polygon;
using geometry::Vec2;

namespace {

Vec2 to_point(const Value& pair) { return {pair.items[0].as_number(), pair.items[1].as_number()}; }

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

/// One block as it stands.
struct Block {
    Polygon corners;
    std::vector<Polygon> pieces;
    /// A point well inside.
    Vec2 middle() const { return geometry::moments_of(pieces.front()).centroid; }
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

/// The block that a point lies in; -1 = none.
std::int64_t block_at(const std::vector<Block>& blocks, const Vec2& x) {
    const auto found =
        std::find_if(blocks.begin(), blocks.end(), [&x](const Block& block) { return is_inside(block.corners, x); });
    return found == blocks.end() ? -1 : found - blocks.begin();
}

/// Tells whether a point of the line lies in the block.
bool is_held(const Block& block, const PlanarJoint& line) {
    constexpr int samples = 64;  // a line crosses a block or does not; short cuts of a corner do not hold it
    for (int i = 0; i <= samples; ++i) {
        if (is_inside(block.corners, line.begin + (static_cast<double>(i) / samples) * (line.end - line.begin))) {
            return true;
        }
    }
    return false;
}

/// Cuts the section and leaves out what lies outside and in holes.
std::optional<std::vector<Block>> cut(CaseBuild& build, const Value& table, const Section& section) {
    const auto made =
        geometry::cut_by_lines(section.lines, {.snap = section.snap, .sliver = get_number(table, "sliver")});
    if (!accept(build, made, table.place)) {
        return std::nullopt;
    }
    std::vector<Block> blocks;
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
    std::erase_if(blocks, [&](const Block& block) { return !outline.empty() && !is_inside(outline, block.middle()); });
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
    build.notes.push_back(
        fmt::format("section '{}': {} blocks of {} lines with {} crossings; {} ends that cut nothing, {} loops that "
                    "nothing ties to the outline, {} blocks left out",
                    get_text(table, "name"), blocks.size(), section.lines.size(), made.value().crossings,
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
std::optional<std::vector<body::Part>> parts_of(CaseBuild& build, const Value& table, const Block& block,
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
void note_measured(CaseBuild& build, const std::string& name, const std::vector<Block>& blocks,
                   const std::vector<Vec2>& points) {
    for (const Vec2& x : points) {
        const std::int64_t i = block_at(blocks, x);
        build.notes.push_back(
            i < 0 ? fmt::format("the measured point ({:.6g}, {:.6g}) lies in no block", x.x, x.y)
                  : fmt::format("the measured point ({:.6g}, {:.6g}) lies in '{}[{}]'", x.x, x.y, name, i));
    }
}

/// Forces of the analysis file at the load points, in their order.
void add_section_loads(CaseBuild& build, const Value& table, const std::vector<Block>& blocks, const Section& section,
                       std::int32_t first) {
    for (std::size_t k = 0; k < section.loads.size(); ++k) {
        const auto& records = section.loads[k].records;
        const auto is_as_first = [&](const auto& r) { return r[1] == records[0][1] && r[2] == records[0][2]; };
        const bool is_constant = std::all_of(records.begin(), records.end(), is_as_first);
        const std::int64_t i = k < section.loaded.size() ? block_at(blocks, section.loaded[k]) : -1;
        if (!is_constant || i < 0) {
            build.problem(get(table, "analysis").place,
                          fmt::format("load {} {}", k, i < 0 ? "has no load point in a block" : "varies with time"),
                          "loads that stay, at load points of the geometry file that lie in a block");
            continue;
        }
        const BodyId id{first + static_cast<std::int32_t>(i)};
        body::PointLoad load{.body = id, .force = {records[0][1], records[0][2], 0}};
        load.point = Vec3{section.loaded[k].x, section.loaded[k].y, 0} - build.state.bodies.position[at(id.value)];
        load.start = records.front()[0];
        build.model.loads.push_back(load);
    }
}

void build_section(CaseBuild& build, const Value& table) {
    const body::NewBody common = common_block(build, table);
    if (!common.material.is_valid()) {
        return;
    }
    const auto section = read_section(build, table, common.material);
    const auto blocks = section ? cut(build, table, *section) : std::nullopt;
    if (!blocks || !has_room(build, table.place, common.name, blocks->size())) {
        return;
    }
    const std::int32_t first = build.model.bodies.size();
    const double fixed_below = get_number_or(table, "fixed_below", -1e300);
    for (std::size_t i = 0; i < blocks->size(); ++i) {
        const Block& one = (*blocks)[i];
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
    add_section_loads(build, table, *blocks, *section, first);
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
