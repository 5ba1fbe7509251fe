// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/contact_set.hpp"
#include "riprap/contact/frame.hpp"
#include "riprap/contact/narrowphase/separating_cache.hpp"
#include "riprap/geometry/convex_view.hpp"

namespace riprap::contact {

/// Which field a body carries.
enum class Potential {
    distance,  ///< w_j = 1/r: normalised distance to the boundary
    fdem,      ///< w_j = 1/H_j: the potential of FDEM tetrahedra, for comparison
};

/// Which of the two one-sided integrals act (the wave speed that [Zhao, eq. 43] calibrates fits one).
enum class Sides { both, contactor };

struct DistancePotentialOptions {
    Potential potential{Potential::distance};
    Sides sides{Sides::both};
    bool with_energy{true};  ///< also find NormalContact::energy; costs time, wanted only where the ledger looks
};

/// Distance-potential contact of two convex parts (see docs/theory/distance-potential.md).
/// @param stiffness_a  k_n of A, factor of its field [Pa]; stiffness_b likewise.
/// @returns false when the parts do not overlap; `contact` is then untouched.
bool find_contact(const geometry::ConvexView& a, const Frame& frame_a, double stiffness_a,
                  const geometry::ConvexView& b, const Frame& frame_b, double stiffness_b,
                  const DistancePotentialOptions& options, SeparatingCache& cache, NormalContact& contact);

}  // namespace riprap::contact
