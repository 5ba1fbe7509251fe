// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/narrowphase/distance_potential.hpp"

#include "riprap/contact/narrowphase/distance_potential_plain.hpp"

namespace riprap::contact {

bool find_contact(const geometry::ConvexView& a, const Frame& frame_a, double stiffness_a,
                  const geometry::ConvexView& b, const Frame& frame_b, double stiffness_b,
                  const DistancePotentialOptions& options, SeparatingCache& /*cache*/, NormalContact& contact) {
    auto outcome = plain::find_contact<48>(a, frame_a, stiffness_a, b, frame_b, stiffness_b, options, contact);
    if (outcome == plain::Outcome::overflow) {
        outcome = plain::find_contact<1024>(a, frame_a, stiffness_a, b, frame_b, stiffness_b, options, contact);
    }
    return outcome == plain::Outcome::touching;
}

}  // namespace riprap::contact
