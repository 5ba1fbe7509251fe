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

    RIPRAP_HD VolumeBook operator+(const VolumeBook& b) const {
        return {flow + b.flow,     diffusion + b.diffusion, tearing + b.tearing,   walls + b.walls,
                escape + b.escape, shifting + b.shifting,   returned + b.returned, refused + b.refused};
    }
    double sum() const { return flow + diffusion + tearing + walls + escape + shifting + returned; }
};

/// Energy that leaves the compression as density is updated, by cause [J].
struct DensityLosses {
    double diffusion{0}, tearing{0}, escape{0}, returned{0};

    RIPRAP_HD DensityLosses operator+(const DensityLosses& b) const {
        return {diffusion + b.diffusion, tearing + b.tearing, escape + b.escape, returned + b.returned};
    }
    double sum() const { return diffusion + tearing + escape + returned; }
};

}  // namespace riprap::fluid
