// SPDX-License-Identifier: Apache-2.0
#pragma once

// Contacts of the solid method of a case, and the fields that it shows of its bodies beyond poses and velocities
// (core/shown.hpp).

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "riprap/contact/shown_contact.hpp"
#include "riprap/core/shown.hpp"
#include "riprap/fluid/shown_water.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::sim {

/// Returns the fields that the solid method of a case shows.
std::span<const ShownField> shown_fields(const Model& model);

/// Returns the fields of every registered solid method, each name once.
const std::vector<ShownField>& all_shown_fields();

/// Returns the value of a field of shown_fields for every body.
std::vector<double> shown_values(const Model& model, const State& state, std::size_t field);

/// Returns the value of the field called `name` for one body; NaN where the method of the case does not show it.
double shown_value(const Model& model, const State& state, std::string_view name, BodyId body);

/// Returns the contacts of the last step, for output: of one that was told to measure everything (Measure::energy).
/// None before the first step.
std::vector<contact::ShownContact> shown_contacts(const Model& model, const State& state, const Scratch& scratch);

/// Tells whether the fluid is a field that is drawn.
bool draws_fluid(const Model& model);

/// Returns the fluid as it is drawn, where it is a field; else nothing.
std::optional<fluid::ShownWater> shown_fluid(const Model& model, const State& state);

}  // namespace riprap::sim
