// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/assemble/choose_contact.hpp"

#include <fmt/format.h>

#include <cmath>

#include "riprap/scene/assemble/build_case.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/solid/affine/default_scales.hpp"

namespace riprap::scene {

namespace {

/// Takes `chosen` where the case left the number to its blocks.
void fill(double& value, double chosen, const char* key, const char* unit, const std::string& why, CaseBuild& build) {
    if (std::isnan(value)) {
        value = chosen;
        build.notes.push_back(fmt::format("solid.{} = {:.3g} {}, {}", key, chosen, unit, why));
    }
}

}  // namespace

void choose_contact(CaseBuild& build) {
    sim::Model& model = build.model;
    const bool has_water = build.root.find("fluid") != nullptr;
    solid::affine::Elasticity* const elasticity = sim::elasticity_of(model.solid);
    if (elasticity == nullptr) {
        return;
    }
    const solid::affine::DefaultScales scales =
        solid::affine::default_scales(sim::solid_scene(model), build.state.bodies, has_water);
    if (!elasticity->stiffness_per_area) {
        fill(elasticity->contact_stiffness, scales.stiffness, "contact_stiffness", "N/m", scales.of_stiffness, build);
    } else {
        elasticity->contact_stiffness = scales.stiffness;  // of no contact
    }
    fill(elasticity->youngs_modulus, scales.modulus, "youngs_modulus", "Pa", scales.of_modulus, build);
    if (double* const step = sim::step_of(model.solid)) {
        fill(*step, scales.step, "step", "s", scales.of_step, build);
    }
}

}  // namespace riprap::scene
