// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "riprap/body/may_move.hpp"
#include "riprap/coupling/joints/joint_pairs.hpp"
#include "riprap/scene/assemble/build_case.hpp"

namespace riprap::scene {

void build_joints(CaseBuild& build, const Value& table, coupling::ParticleFluid& fluid) {
    const body::BodySet& bodies = build.model.bodies;
    bool has_loose = false, has_driven = false;
    for (std::size_t b = 0; b < bodies.drive.size(); ++b) {
        const bool is_loose = may_move(bodies, b);
        has_loose = has_loose || is_loose;
        has_driven = has_driven || (bodies.drive[b] == body::Drive::driven && !is_loose);
    }
    // The forces of joints and those of the water have to come from one kernel.
    fluid.has_joint_pressure = fluid.has_joint_pressure && has_loose &&
                               fluid.wall == coupling::WallTreatment::boundary_particles && takes_joints(fluid.scheme);
    if (!fluid.has_joint_pressure) {
        return;
    }
    const double least = 2 * coupling::JointPairs::reach(fluid.settings(), has_driven);
    const fluid::Domain& domain = fluid.settings().domain;
    for (int axis = 0; axis < domain.dimension; ++axis) {
        const double period = domain.high[axis] - domain.low[axis];
        if (domain.is_periodic[static_cast<std::size_t>(axis)] && period < least) {
            build.problem(
                get(table, "domain").place,
                fmt::format("a period of {:.4g} m: a loose block would meet the water in its own joints twice", period),
                fmt::format("at least {:.4g} m ({:.3g} spacings), or joint_pressure = false", least,
                            least / fluid.settings().spacing));
        }
    }
}

}  // namespace riprap::scene
