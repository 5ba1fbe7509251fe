// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/law/frictions.hpp"
#include "riprap/contact/narrowphase/distance_potential.hpp"
#include "riprap/contact/narrowphase/facing_faces.hpp"
#include "riprap/contact/pipeline.hpp"

namespace riprap::contact {

/// A placed part with its k_n [Pa].
struct PressedShape {
    PlacedShape placed;
    double stiffness;
};

/// Normal contact of two parts where they are, as DistancePotentialPhysics finds it in a step.
/// @returns false where they do not overlap; `normal` is then undefined
bool find_push(const PressedShape& a, const PressedShape& b, const DistancePotentialOptions& options,
               SeparatingCache& cache, NormalContact& normal);

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
