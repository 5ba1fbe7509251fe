// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/law/frictions.hpp"
#include "riprap/contact/narrowphase/distance_potential.hpp"
#include "riprap/contact/pipeline.hpp"

namespace riprap::contact {

/// Polyhedra that repel by the distance potential and rub by the law of the case: one contact per pair.
struct DistancePotentialPhysics {
    DistancePotentialOptions options;
    const Frictions& friction;

    void meet(const Candidate& pair, SeparatingCache& cache, FoundContacts& found) const;
};

extern template double ContactPipeline::find_contacts(const DistancePotentialPhysics& physics,
                                                      const ContactScene& scene, const body::BodyState& state,
                                                      const body::BodyKinematics& kinematics, double sliding_time,
                                                      ContactHistory& history);

}  // namespace riprap::contact
