// SPDX-License-Identifier: Apache-2.0
#pragma once

// Declares what a fluid says of itself beyond what a step needs.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "riprap/core/account.hpp"
#include "riprap/coupling/fluid_scene.hpp"
#include "riprap/fluid/gauge/gauge.hpp"
#include "riprap/fluid/shown_fluid.hpp"

namespace riprap::coupling {

/// All that the drawing of a fluid depends on.
template <class Settings>
struct ShownQuery {
    const FluidScene& scene;
    const Settings& settings;
    const fluid::ParticleState& particles;
    const typename Settings::Fields& fields;
};

/// Traits of a fluid, which its class declares as `static constexpr FluidTraits<Settings> traits{...}`. What it leaves
/// out has the default; a name that is none of these does not compile.
template <class Settings>
struct FluidTraits {
    using Fields = typename Settings::Fields;

    bool is_there{true};                    ///< there is a fluid at all
    bool leads{true};                       ///< it moves by itself: its `limit` is the step of the run
    unsigned offers{fluid::reading::none};  ///< readings of gauges (fluid/gauge/water_reader.hpp)

    bool makes_up{false};  ///< its walls make up for the way of bodies that it did not see in the last step

    /// Do the first steps after bodies were let go grow from little?
    bool (*starts_slowly)(const Settings&) = [](const Settings&) { return false; };
    /// Does its ledger close from the first step on?
    bool (*books_every_step)(const Settings&) = [](const Settings&) { return false; };
    /// Size of its particles or cells; 0: it has none [m].
    double (*spacing)(const Settings&) = [](const Settings&) { return 0.0; };
    /// Width of its narrowest cell, to which it knows its energy; 0: it has none [m].
    double (*cell_width)(const Settings&) = [](const Settings&) { return 0.0; };
    /// Height by which it may settle when it is let go [m].
    double (*grain)(const Settings&) = [](const Settings&) { return 0.0; };
    /// Mass of one particle, of a fluid of particles, which has no smaller part; else 0 [kg].
    double (*grain_mass)(const Settings&) = [](const Settings&) { return 0.0; };
    /// Box that it cannot leave; null: it is unbounded.
    const fluid::Domain* (*domain)(const Settings&) = [](const Settings&) -> const fluid::Domain* { return nullptr; };
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
    /// Returns how it is drawn; null: it is not.
    fluid::ShownFluid (*shown)(const ShownQuery<Settings>&){nullptr};
    bool shows_surface{false};  ///< as polygons, besides points
    /// Returns how it will be drawn once it has moved, where that takes more room in files: a lattice at rest is packed
    /// into much less; null: as at the start.
    fluid::ShownFluid (*shown_stirred)(const ShownQuery<Settings>&){nullptr};
};

}  // namespace riprap::coupling
