// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap::contact {

/// Which field a body carries.
enum class Potential {
    distance,  ///< w_j = 1/r: normalised distance to the boundary
    fdem,      ///< w_j = 1/H_j: the potential of FDEM tetrahedra, for comparison
};

/// Which of the two one-sided integrals act (the wave speed that [Zhao, eq. 43] calibrates fits one).
enum class Sides { both, contactor };

/// Says how corners and edges push (SharpPush).
enum class Corners {
    stiff,  ///< as a punch: in proportion to the size of what overlaps
    field,  ///< by the field alone, as published: in proportion to its area
};

struct DistancePotentialOptions {
    Potential potential{Potential::distance};
    Sides sides{Sides::both};
    Corners corners{Corners::stiff};
    bool with_energy{true};  ///< also find NormalContact::energy; costs time, wanted only where the ledger looks
};

}  // namespace riprap::contact
