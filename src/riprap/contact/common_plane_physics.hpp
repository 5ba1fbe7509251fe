// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/contact/law/frictions.hpp"
#include "riprap/contact/narrowphase/hull.hpp"
#include "riprap/contact/pipeline.hpp"

namespace riprap::contact {

/// Stiffness of a contact point of the common plane, k the sum of k_n/r of both bodies [Pa/m].
enum class PlaneLaw : std::uint8_t {
    penalty,  ///< k r^2, the same for every point, r the smaller inscribed radius
    soft      ///< k (A_c + r^2/100), A_c the area that the point stands for
};

/// Topology of every shape of a set; empty for half-spaces.
std::vector<HullTopology> hull_topologies(const geometry::ShapeSet& shapes);

/// Rigid polyhedra that meet across the common plane [Cundall1988]: several contact points a pair, each with a linear
/// spring and friction of its own. A flat contact of area S is as stiff as with the distance potential,
/// S (k_a/r_a + k_b/r_b), when the law is soft.
struct CommonPlanePhysics {
    const std::vector<HullTopology>& topologies;  ///< by shape
    const body::BodySet& bodies;
    const Frictions& friction;
    PlaneLaw law{PlaneLaw::soft};

    void meet(const Candidate& pair, SeparatingCache& cache, FoundContacts& found) const;
};

extern template double ContactPipeline::find_contacts(const CommonPlanePhysics& physics, const ContactScene& scene,
                                                      const body::BodyState& state,
                                                      const body::BodyKinematics& kinematics, double sliding_time,
                                                      ContactHistory& history);

}  // namespace riprap::contact
