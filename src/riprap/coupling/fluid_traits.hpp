// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a fluid says of itself beyond what a step needs.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "riprap/core/account.hpp"
#include "riprap/coupling/fluid_scene.hpp"
#include "riprap/fluid/gauge/gauge.hpp"
#include "riprap/fluid/shown_water.hpp"

namespace riprap::coupling {

/// Traits of a fluid, which its class declares as `static constexpr FluidTraits<Settings> traits{...}`. What it leaves
/// out has the default; a name that is none of these does not compile.
template <class Settings>
struct FluidTraits {
    using Fields = typename Settings::Fields;

    bool is_there{true};                    ///< there is a fluid at all
    bool leads{true};                       ///< it moves by itself: its `limit` is the step of the run
    unsigned offers{fluid::reading::none};  ///< readings of gauges (fluid/gauge/water_reader.hpp)

    /// Does its ledger close from the first step on?
    bool (*books_every_step)(const Settings&) = [](const Settings&) { return false; };
    /// Size of its particles or cells; 0: it has none [m].
    double (*spacing)(const Settings&) = [](const Settings&) { return 0.0; };
    /// Width of its narrowest cell, to which it knows its energy; 0: it has none [m].
    double (*cell_width)(const Settings&) = [](const Settings&) { return 0.0; };
    /// Height by which it may settle when it is let go [m].
    double (*grain)(const Settings&) = [](const Settings&) { return 0.0; };
    /// Share of the limit of its step that the case asks for; 0: it has none [-].
    double (*courant)(const Settings&) = [](const Settings&) { return 0.0; };
    /// Bytes of what the settings hold beside themselves.
    std::size_t (*bytes)(const Settings&) = [](const Settings&) { return std::size_t{0}; };
    /// Accounts of energy that it has besides those of all fluids.
    std::span<const Account> (*accounts)() = [] { return std::span<const Account>(); };
    /// Says how much of it has left where it was let go; empty where none has.
    std::string (*let_go_text)(const Settings&, const Fields&) = [](const Settings&, const Fields&) {
        return std::string();
    };
    /// Says which waves sides absorb, a line each.
    std::vector<std::string> (*absorbed_ranges)(const Settings&) = [](const Settings&) {
        return std::vector<std::string>();
    };
    /// Says how many cells it has and how wide they are; empty: it has none.
    std::string (*cells_text)(const Settings&) = [](const Settings&) { return std::string(); };
    /// Returns how it is drawn where it is a field; null: it is not.
    fluid::ShownWater (*shown)(const FluidScene&, const Settings&, const Fields&){nullptr};
};

}  // namespace riprap::coupling
