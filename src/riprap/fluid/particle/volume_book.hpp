// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/config.hpp"

namespace riprap::fluid {

/// Change of the volume m/rho of particles in a step by what changed their density [m^3]:
///
///     flow + diffusion + tearing + walls + escape + shifting + returned = sum m/rho after - before.
///
/// Each cause has -m d_rho/(rho rho') of its part d_rho, rho before and rho' after, and flow what is left. Pressure
/// holds m/rho near m/rho_0, so what a cause takes or gives is given or taken by flow, and flow is how far water has
/// spread: water that tears stands higher than its volume. `refused` is no part of the sum.
struct VolumeBook {
    double flow{0};       ///< continuity
    double diffusion{0};  ///< of density
    double tearing{0};    ///< of surfaces
    double walls{0};      ///< water that leaves a wall
    double escape{0};     ///< sound that leaves water caught between walls
    double shifting{0};   ///< the share of density that goes with a shift
    double returned{0};   ///< return of the density to that of the places
    double refused{0};    ///< what shifting left alone, as it would be tension

    template <class By>
    RIPRAP_HD static void join(VolumeBook& a, const VolumeBook& b, const By& by) {
        by.add(a.flow, b.flow);
        by.add(a.diffusion, b.diffusion);
        by.add(a.tearing, b.tearing);
        by.add(a.walls, b.walls);
        by.add(a.escape, b.escape);
        by.add(a.shifting, b.shifting);
        by.add(a.returned, b.returned);
        by.add(a.refused, b.refused);
    }
    RIPRAP_HD double sum() const { return flow + diffusion + tearing + walls + escape + shifting + returned; }
};

/// Energy that leaves the compression as density is updated, by cause [J].
struct DensityLosses {
    double diffusion{0}, tearing{0}, escape{0}, returned{0};

    template <class By>
    RIPRAP_HD static void join(DensityLosses& a, const DensityLosses& b, const By& by) {
        by.add(a.diffusion, b.diffusion);
        by.add(a.tearing, b.tearing);
        by.add(a.escape, b.escape);
        by.add(a.returned, b.returned);
    }
    RIPRAP_HD double sum() const { return diffusion + tearing + escape + returned; }
};

}  // namespace riprap::fluid
