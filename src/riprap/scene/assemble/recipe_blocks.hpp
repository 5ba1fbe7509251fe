// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/geometry/polyhedra/outcome.hpp"
#include "riprap/scene/case/case_build.hpp"

namespace riprap::scene {

// Many blocks from one table, shared by packs, rock masses and sections.

/// The seed of the table, or one from that of the case and `name`.
std::uint64_t seed_for(const CaseBuild& build, const Value& table, const std::string& name);

/// Returns a block with all that the blocks of one table have in common: name, material, whether they are fixed.
body::NewBody common_block(CaseBuild& build, const Value& table);

/// Adds a block as NAME[index].
BodyId add_recipe_block(CaseBuild& build, body::NewBody block, std::int64_t index);

/// Tells whether there is room for `count` more bodies; a problem at `place` where there is none.
bool has_room(CaseBuild& build, const SourcePlace& place, const std::string& name, std::size_t count);

/// Places armour units on a slope, as the table `slope` of a pack says.
void build_slope(CaseBuild& build, const Value& slope, const body::NewBody& common);

/// Tells whether geometry has an answer; its problems at `place` where it has none.
template <class T>
bool accept(CaseBuild& build, const geometry::Outcome<T>& outcome, const SourcePlace& place) {
    for (const geometry::GeometryProblem& problem : outcome.problems()) {
        build.problem(place, problem.message, problem.allowed);
    }
    return outcome.has_value();
}

}  // namespace riprap::scene
