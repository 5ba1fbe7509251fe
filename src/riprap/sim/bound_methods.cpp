// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/bound_methods.hpp"

#include "riprap/sim/method_scratch.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::sim {

ScratchData::ScratchData() : methods(std::make_unique<MethodScratch>()) {}
ScratchData::~ScratchData() = default;

namespace {

/// Returns the parts of the Model that solids read, with the strengths of now: those of the start of the step.
solid::SolidScene scene_of_now(const Model& model, double time, material::MaterialSet& reduced) {
    if (!model.strength.is_active()) {
        return solid_scene(model);
    }
    const double divisor = model.strength.divisor(time);
    reduce_strength(model.materials, model.strength, divisor, reduced);
    return solid_scene(model, reduced, divisor);
}

}  // namespace

BoundMethods::BoundMethods(const Model& model, State& state, ScratchData& scratch)
    : solid_scene_(scene_of_now(model, state.time, scratch.materials)),
      fluid_scene_{model.shapes, model.bodies, model.gravity},
      fluid_leads_(sim::fluid_leads(model)) {
    Solids::visit(model.solid, [&]<class Method>(const typename Method::Settings& settings) {
        const solid::SolidState parts{state.bodies, state.contacts, state.previous_dt};
        solid_ = std::make_unique<Method>(solid_scene_, settings, parts,
                                          Solids::matching<Method>(model.solid, state.solid_fields),
                                          Solids::matching<Method>(model.solid, scratch.methods->solid));
    });
    Fluids::visit(model.fluid, [&]<class Method>(const typename Method::Settings& settings) {
        const coupling::FluidState parts{state.fluid, state.open, state.coupling, state.bodies};
        fluid_ = std::make_unique<Method>(fluid_scene_, settings, parts,
                                          Fluids::matching<Method>(model.fluid, state.fluid_fields),
                                          Fluids::matching<Method>(model.fluid, scratch.methods->fluid));
    });
}

const body::Loads& contact_loads(const ScratchData& scratch) {
    return Solids::visit(scratch.methods->solid,
                         []<class Method>(const typename Method::Scratch& own) -> const body::Loads& {
                             return Method::contact_loads(own);
                         });
}

const solid::SolidTimes& solid_times(const ScratchData& scratch) {
    return Solids::visit(scratch.methods->solid,
                         []<class Method>(const typename Method::Scratch& own) -> const solid::SolidTimes& {
                             return Method::times(own);
                         });
}

std::size_t method_bytes(const ScratchData& scratch) {
    const auto bytes_of_own = [](const auto& own) { return own.bytes(); };
    return std::visit(bytes_of_own, scratch.methods->solid) + std::visit(bytes_of_own, scratch.methods->fluid);
}

}  // namespace riprap::sim
