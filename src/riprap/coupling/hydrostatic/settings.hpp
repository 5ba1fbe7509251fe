// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "riprap/core/key_problem.hpp"
#include "riprap/core/vec3.hpp"
#include "riprap/coupling/field_scene.hpp"

namespace riprap {
template <class S>
struct MethodKeys;  // core/key.hpp
struct NoFields;    // core/fields.hpp
}  // namespace riprap

namespace riprap::coupling {

class HydrostaticFluid;

/// Pressure of still water between faces that lie on each other.
enum class Uplift : std::uint8_t {
    full,    ///< the pressure of the level, as if the joint were open
    linear,  ///< the pressure of the level at the wet end of the joint, falling to zero at its other end
    none,    ///< no pressure: the joint is watertight
};

/// Water that stands still, its level given: Settings of HydrostaticFluid.
struct HydrostaticSettings {
    using Method = HydrostaticFluid;
    using Fields = NoFields;
    static constexpr std::string_view method_name = "hydrostatic";
    static MethodKeys<HydrostaticSettings> keys();

    double spacing{0};          ///< size of the panels into which faces are cut to find joints [m]
    double rest_density{1000};  ///< rho [kg/m^3]
    Uplift uplift{Uplift::full};

    /// A plane with the water behind it: normal . x <= offset.
    struct Side {
        Vec3 normal;    ///< [-]
        double offset;  ///< [m]
    };
    /// Extent of the water: a region gives its sides and, where no levels are given, its level.
    struct Basin {
        Vec3 low{}, high{};  ///< corners of its box [m]
        double level{0};     ///< along `up` [m]
        /// Of each convex part, sides and bed, without the top; empty for a box along the axes.
        std::vector<std::vector<Side>> parts{};
    };
    std::vector<Basin> basins;
    std::vector<LevelAt> levels;       ///< of all basins; empty: each keeps its own
    std::vector<std::uint8_t> is_dry;  ///< per body: not there for the water; bodies beyond the end are wet
    Vec3 up{0, 0, 1};                  ///< [-]
    bool is_planar{false};

    /// Tells whether water passes through a body.
    bool passes(std::size_t body) const { return body < is_dry.size() && is_dry[body] != 0; }

    /// Takes over the regions of the case. Returns what does not fit: nothing.
    std::vector<KeyProblem> prepare(const FieldScene& scene);
    /// Returns the level of a basin at a time, linear between rows and constant beyond [m].
    double level_at(const Basin& basin, double time) const;
};

}  // namespace riprap::coupling
