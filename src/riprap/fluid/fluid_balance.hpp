// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/core/vec3.hpp"

namespace riprap::fluid {

/// Energies, momenta and work of a fluid in a step, measured at the kick like those of bodies (sim/ledger.hpp): what
/// every fluid reports. What a fluid loses in its own ways are amounts of accounts that it names (core/account.hpp).
struct FluidBalance {
    double kinetic{0};                  ///< [J]
    double potential{0};                ///< -sum m g.x; gravity along periodic axes is in work_external [J]
    Vec3 gravity{}, mass_moment{};      ///< g of this potential [m/s^2]; sum m x, of its components alone [kg m]
    double internal{0};                 ///< of compression [J]
    double work_on_solids{0};           ///< in this step [J]
    double work_external{0};            ///< in this step, by what is neither fluid nor solid [J]
    Vec3 momentum{}, impulse{};         ///< after the step [kg m/s]; of all forces on the fluid in it [N s]
    double mass{0};                     ///< [kg]
    double max_speed{0};                ///< [m/s]
    std::int64_t solver_iterations{0};  ///< of the pressure equation, all passes of the step
    double solver_residual{0};          ///< of it, over its right-hand side, last pass [-]
};

}  // namespace riprap::fluid
