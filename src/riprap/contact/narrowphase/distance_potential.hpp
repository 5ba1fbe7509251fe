// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/contact_set.hpp"
#include "riprap/contact/frame.hpp"
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

/// A direction that separated a pair when last looked at, in the frame of A. Scratch: it may only *reject*, and only
/// where the full computation would find no contact either, so dropping it changes no bit of any result.
struct SeparatingCache {
    float x{0}, y{0}, z{0};  ///< unit direction from A to B; zero = none
    std::int32_t spare{0};
};

/// Distance-potential contact of two convex parts (see docs/theory/distance-potential.md).
/// @param stiffness_a  k_n of A, factor of its field [Pa]; stiffness_b likewise.
/// @returns false when the parts do not overlap; `contact` is then untouched.
bool find_contact(const geometry::ConvexView& a, const Frame& frame_a, double stiffness_a,
                  const geometry::ConvexView& b, const Frame& frame_b, double stiffness_b,
                  const DistancePotentialOptions& options, SeparatingCache& cache, NormalContact& contact);

}  // namespace riprap::contact
