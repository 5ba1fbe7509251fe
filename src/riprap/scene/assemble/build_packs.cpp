// SPDX-License-Identifier: Apache-2.0
// Blocks from recipes: mixed lattices, Voronoi packs, jointed rock masses.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "riprap/geometry/polyhedra/joint_sets.hpp"
#include "riprap/geometry/polyhedra/voronoi.hpp"
#include "riprap/scene/assemble/build_case.hpp"
#include "riprap/scene/assemble/random_stream.hpp"
#include "riprap/scene/assemble/recipe_blocks.hpp"
#include "riprap/scene/case/orientation.hpp"
#include "riprap/scene/shapes/shape_library.hpp"
#include "riprap/scene/text/limits.hpp"

namespace riprap::scene {

using geometry::Polyhedron;

namespace {

/// The one convex region that a recipe fills, in world axes. Nothing, with a problem, otherwise.
std::optional<Polyhedron> region_of(CaseBuild& build, const Value& table) {
    const Value& shape = get(table, "region");
    if (build.is_planar) {
        build.problem(shape.place, "regions are not cut in a scene with dimension = 2",
                      "use [[section]], [[body]] or a lattice");
        return std::nullopt;
    }
    const auto pieces = build.shapes.pieces(shape);
    if (!pieces) {
        return std::nullopt;
    }
    if (pieces->size() != 1) {
        build.problem(shape.place, fmt::format("the region has {} convex parts", pieces->size()), "one convex shape");
        return std::nullopt;
    }
    return geometry::moved(pieces->front(), {get_vector(table, "position"), orientation_of(table.find("orientation"))});
}

/// Adds blocks given in world coordinates, each with a shape of its own.
void add_blocks(CaseBuild& build, const Value& table, const body::NewBody& common,
                const std::vector<Polyhedron>& blocks) {
    if (!has_room(build, table.place, common.name, blocks.size())) {
        return;
    }
    const double fixed_below = get_number_or(table, "fixed_below", -1e300);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        body::NewBody block = common;
        body::Part part = build.shapes.add(blocks[i]);
        if (part.local.position.z < fixed_below) {
            block.drive = body::Drive::fixed;
        }
        block.pose.position = part.local.position;  // the body frame of a block has its origin in the centre of mass
        part.local.position = {};
        block.parts = {part};
        add_recipe_block(build, std::move(block), static_cast<std::int64_t>(i));
    }
}

void build_voronoi(CaseBuild& build, const Value& table, const Value& voronoi, const body::NewBody& common) {
    const std::optional<Polyhedron> region = region_of(build, voronoi);
    if (!region || !common.material.is_valid()) {
        return;
    }
    const auto blocks =
        geometry::voronoi_blocks(*region, {.block_count = get_integer(voronoi, "count"),
                                           .seed = seed_for(build, voronoi, common.name),
                                           .lloyd_iterations = static_cast<int>(get_integer(voronoi, "lloyd")),
                                           .gap = get_number(voronoi, "gap")});
    if (accept(build, blocks, voronoi.place)) {
        add_blocks(build, table, common, blocks.value());
    }
}

/// One kind of block of a mixed pack: its parts for each size, and the upper end of its share of [0, 1).
struct Kind {
    std::vector<std::vector<body::Part>> sizes;
    double share_end;
};

std::vector<Kind> read_mix(CaseBuild& build, const Value& mix, double density) {
    std::vector<Kind> kinds;
    double total = 0;
    for (const Value& table : mix.items) {
        const Value shape = build.shapes.sized(get(table, "shape"), density);
        if (ShapeLibrary::is_half_space(shape)) {
            build.problem(shape.place, "a half-space is no block", "a shape with a volume");
            return {};
        }
        Kind kind;
        Value unit_size = Value::array();
        unit_size.items = {Value::of(1.0)};
        const Value* sizes = table.find("sizes");
        for (const Value& size : (sizes != nullptr ? *sizes : unit_size).items) {
            auto parts = build.shapes.parts(shape, size.as_number());
            if (!parts) {
                return {};
            }
            kind.sizes.push_back(std::move(*parts));
        }
        total += get_number(table, "fraction");
        kind.share_end = total;
        kinds.push_back(std::move(kind));
    }
    for (Kind& kind : kinds) {
        kind.share_end /= total;
    }
    return kinds;
}

void build_lattice(CaseBuild& build, const Value& table, const body::NewBody& common) {
    const Lattice lattice(table);
    if (build.is_planar && !lattice.is_flat()) {
        build.problem(table.place, "a lattice along z leaves the plane of a scene with dimension = 2",
                      "counts = [nx, ny]");
        return;
    }
    const std::vector<Kind> kinds = read_mix(build, get(table, "mix"), common.density);
    if (kinds.empty() || !common.material.is_valid()) {
        return;
    }
    const Value* total = table.find("total");
    const std::int64_t count = total != nullptr ? std::min(total->integer, lattice.size()) : lattice.size();
    const Vec3 origin = get_vector(table, "origin");
    const double jitter = get_number(table, "jitter");
    const std::uint64_t seed = seed_for(build, table, common.name);
    for (std::int64_t i = 0; i < count; ++i) {
        RandomStream random(seed, common.name, static_cast<std::uint64_t>(i));
        const double share = random.uniform();
        const auto kind =
            std::find_if(kinds.begin(), kinds.end() - 1, [share](const Kind& k) { return share < k.share_end; });
        const auto size = static_cast<std::size_t>(random.uniform() * static_cast<double>(kind->sizes.size()));
        body::NewBody block = common;
        block.parts = kind->sizes[size];
        const double x = random.uniform(-jitter, jitter), y = random.uniform(-jitter, jitter);
        const double z = random.uniform(-jitter, jitter);
        block.pose.position = origin + lattice.point(i) + Vec3{x, y, build.is_planar ? 0.0 : z};
        if (get_boolean(table, "random_orientation")) {
            block.pose.orientation = random.orientation(build.is_planar);
        }
        add_recipe_block(build, std::move(block), i);
    }
}

}  // namespace

void build_packs(CaseBuild& build) {
    for (const Value& table : get(build.root, "pack").items) {
        build.claim_name(table);
        body::NewBody common = common_block(build, table);
        common.velocity = get_vector(table, "velocity");
        if (common.drive == body::Drive::fixed && norm_squared(common.velocity) > 0) {
            build.problem(table.place, fmt::format("'{}' is fixed and has a velocity", common.name), "one of the two");
        }
        if (const Value* voronoi = table.find("voronoi")) {
            build_voronoi(build, table, *voronoi, common);
        } else if (const Value* slope = table.find("slope")) {
            build_slope(build, *slope, common);
        } else {
            build_lattice(build, get(table, "lattice"), common);
        }
    }
}

void build_rock_masses(CaseBuild& build) {
    for (const Value& table : get(build.root, "rock_mass").items) {
        build.claim_name(table);
        const body::NewBody common = common_block(build, table);
        const std::optional<Polyhedron> region = region_of(build, table);
        if (!region || !common.material.is_valid()) {
            continue;
        }
        std::vector<geometry::JointSet> sets;
        for (const Value& set : get(table, "joint_set").items) {
            sets.push_back({.normal = geometry::joint_normal(get_number(set, "dip"), get_number(set, "dip_direction")),
                            .spacing = get_number(set, "spacing"),
                            .spacing_scatter = get_number(set, "spacing_scatter"),
                            .origin = get_vector(set, "origin"),
                            .persistence = get_number(set, "persistence")});
        }
        const auto rock = geometry::cut_by_joint_sets(*region, sets,
                                                      {.seed = seed_for(build, table, common.name),
                                                       .minimum_volume = get_number(table, "minimum_volume"),
                                                       .maximum_blocks = limits::rock_blocks});
        if (!accept(build, rock, table.place)) {
            continue;
        }
        if (rock.value().skipped_cuts > 0) {
            build.warnings.push_back(
                fmt::format("'{}': {} cuts left out, since they would make blocks smaller than minimum_volume",
                            common.name, rock.value().skipped_cuts));
        }
        add_blocks(build, table, common, rock.value().blocks);
    }
}

}  // namespace riprap::scene
