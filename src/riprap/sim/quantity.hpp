// SPDX-License-Identifier: Apache-2.0
#pragma once

// Quantities of a run: the one table behind probes, [[expect]], bodies.csv and the manual.
// A quantity of one body is written "name.quantity", one of the scene by its name alone; a component of a vector
// adds ".x", ".y" or ".z": "block.displacement.x", "wall[2].contact_force.z", "solid.kinetic".

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/sim/advance.hpp"

namespace riprap::sim {

/// One line of the table.
struct QuantityInfo {
    std::string_view name;
    std::string_view unit;  ///< as printed in brackets: "m/s", "-"
    int components;         ///< 1, or 3 for a vector in world axes
    bool is_of_body;        ///< false: of the whole scene
    std::string_view help;
};

/// The whole table, body quantities first.
std::span<const QuantityInfo> quantities();

/// Looks a quantity up by name among those of bodies or those of the scene; nullptr when there is none.
const QuantityInfo* find_quantity(std::string_view name, bool of_body);

/// Tells whether the methods of a case have a quantity of the table: accounts and shown fields are named
/// by methods.
bool has_quantity(const Model& model, const QuantityInfo& quantity);

/// The scene at one moment, as quantities read it.
struct Moment {
    const Model& model;
    const State& initial;  ///< State at time 0: what displacement and rotation count from
    const State& state;
    const Scratch* scratch;    ///< contacts of the last step; nullptr before the first step
    const StepReport* report;  ///< of the last step; nullptr before the first step
};

/// One number of a run with its heading.
struct Column {
    std::string name;  ///< "block.displacement.x"
    std::string unit;  ///< "m"
    BodyId body;       ///< invalid: of the scene
    const QuantityInfo* quantity{nullptr};
    int component{0};             ///< 0 to components - 1
    std::optional<Vec3> point{};  ///< see Probe
    std::int32_t gauge{-1};       ///< index into the gauges of the model, which then says it all; -1 = none
    std::int32_t damage{-1};      ///< index into the groups whose damage is recorded, likewise; -1 = none
};

/// Tells whether a quantity can be asked of any point of a body: its place and how it moves.
bool is_of_points(const QuantityInfo& quantity);

/// The value of a column [its unit]; NaN where it does not exist yet (contact forces before the first step).
double evaluate(const Column& column, const Moment& moment);

/// A unit as it is in a scene: of what grows with the amount of matter ("N", "J", "kg", "m^3/s"), that per metre of
/// width in a planar one ("N/m").
std::string unit_in(std::string_view unit, bool is_planar);

/// The columns of one probe, named after it: one for a scalar, three for a vector.
std::vector<Column> columns_of(const Probe& probe, bool is_planar);

/// The columns of probes.csv: probes, then gauges, then damage, in the order of the case.
std::vector<Column> record_columns(const Model& model);

/// Finds what an [[expect]] names: a column of a probe or gauge ("gauge" or "gauge.x"), a quantity of the scene
/// ("solid.kinetic", "momentum.z") or of a body ("block[3].position.z"). A vector without a component, an unknown
/// body or an unknown quantity gives nothing.
std::optional<Column> find_column(const Model& model, std::string_view text);

/// The body called `name` ("block" or "block[17]"); invalid when there is none.
BodyId find_body(const body::BodySet& bodies, std::string_view name);

}  // namespace riprap::sim
