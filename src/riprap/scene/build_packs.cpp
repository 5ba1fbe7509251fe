// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/build_case.hpp"

namespace riprap::scene {

void build_packs(CaseBuild& build) {
    for (const Value& table : get(build.root, "pack").items) {
        build.problem(table.place, "[[pack]] is not implemented in this version");
    }
}

void build_rock_masses(CaseBuild& build) {
    for (const Value& table : get(build.root, "rock_mass").items) {
        build.problem(table.place, "[[rock_mass]] is not implemented in this version");
    }
}

}  // namespace riprap::scene
