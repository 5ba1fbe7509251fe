// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "riprap/core/key_problem.hpp"
#include "riprap/coupling/field_scene.hpp"
#include "riprap/fluid/grid/settings.hpp"

namespace riprap {
template <class S>
struct MethodKeys;  // core/key.hpp
}

namespace riprap::coupling {

class GridFluid;
struct GridFluidFields;  // fields.hpp

/// Who moves whom.
enum class GridCoupling : std::uint8_t {
    two_way,  ///< water and bodies each other
    one_way,  ///< water the bodies, as if these stood where they started [Ding2021, eqs. 3.26 to 3.29]
};

/// Settings of GridFluid.
struct GridFluidSettings {
    using Method = GridFluid;
    using Fields = GridFluidFields;
    static constexpr std::string_view method_name = "grid";
    static MethodKeys<GridFluidSettings> keys();

    double spacing{0};               ///< width of a cell [m]
    Vec3 stretch{1, 1, 1};           ///< width of cells along each axis over `spacing` [-]
    double wall_narrowing{0};        ///< cells at both ends of the domain are narrower by this share of their mean [-]
    double growth{1};                ///< width of a cell over that of its neighbour nearer to the fine box [-]
    Vec3 fine_low{}, fine_high{};    ///< box of cells of `spacing`, where others grow [m]
    std::optional<double> coarsest;  ///< widest cell [m]
    double rest_density{1000};       ///< of water [kg/m^3]
    double kinematic_viscosity{1e-6}, air_density{1.2}, air_viscosity{1.48e-5}, surface_tension{0};
    fluid::grid::SideKind domain_walls{fluid::grid::SideKind::slip};
    bool has_open_top{true};
    fluid::grid::Turbulence turbulence{fluid::grid::Turbulence::laminar};
    fluid::grid::VofScheme vof{fluid::grid::VofScheme::plic};
    double compression{1}, courant{0.45}, tolerance{1e-5};
    int outer_corrections{1}, pressure_corrections{1};
    GridCoupling coupling{GridCoupling::two_way};
    bool is_carried{false};  ///< the velocity is that of FieldScene::flow at all times

    FieldScene scene;                ///< where the fluid is
    fluid::grid::GridSettings grid;  ///< made of all of the above by `prepare`

    /// Takes over the scene and makes the grid. Returns what does not fit.
    std::vector<KeyProblem> prepare(const FieldScene& scene);
    bool is_dry(std::size_t body) const { return body < scene.is_dry.size() && scene.is_dry[body] != 0; }
};

}  // namespace riprap::coupling
