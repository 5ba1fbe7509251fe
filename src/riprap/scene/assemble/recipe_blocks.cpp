// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/assemble/recipe_blocks.hpp"

#include <fmt/format.h>

#include "riprap/scene/assemble/random_stream.hpp"
#include "riprap/scene/text/limits.hpp"

namespace riprap::scene {

std::uint64_t seed_for(const CaseBuild& build, const Value& table, const std::string& name) {
    const Value* seed = table.find("seed");
    return seed != nullptr ? static_cast<std::uint64_t>(seed->integer) : seed_of(build.model.seed, name);
}

body::NewBody common_block(CaseBuild& build, const Value& table) {
    body::NewBody block;
    block.name = get_text(table, "name");
    block.material = build.material_of(table);
    if (block.material.is_valid()) {
        block.density = build.model.materials[block.material].density;
    }
    const Value* release = table.find("release_time");
    const bool is_fixed = get_boolean(table, "fixed");
    if (release != nullptr && !is_fixed && table.find("fixed_below") == nullptr) {
        build.problem(release->place, fmt::format("the blocks of '{}' are free from the start", block.name),
                      "release_time is for fixed blocks");
    }
    block.drive = is_fixed ? body::Drive::fixed : body::Drive::free;
    block.release_time = release != nullptr ? release->as_number() : block.release_time;
    return block;
}

BodyId add_recipe_block(CaseBuild& build, body::NewBody block, std::int64_t index) {
    block.name_index = static_cast<std::int32_t>(index);
    return body::add_body(build.model.bodies, build.state.bodies, build.model.shapes, block);
}

bool has_room(CaseBuild& build, const SourcePlace& place, const std::string& name, std::size_t count) {
    if (build.model.bodies.size() + static_cast<std::int64_t>(count) <= limits::bodies) {
        return true;
    }
    build.problem(place, fmt::format("'{}' has {} blocks", name, count),
                  fmt::format("a scene has at most {} bodies", limits::bodies));
    return false;
}

}  // namespace riprap::scene
