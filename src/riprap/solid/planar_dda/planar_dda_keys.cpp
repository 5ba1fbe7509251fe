// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/key.hpp"
#include "riprap/solid/affine/dda_keys.hpp"
#include "riprap/solid/planar_dda/planar_dda.hpp"

namespace riprap::solid {

using namespace key;

MethodKeys<PlanarDdaSettings> PlanarDdaSettings::keys() {
    using S = PlanarDdaSettings;
    using Engine = planar_dda::Settings;
    using planar_dda::PlaneState;
    const KeyList<Engine> engine_keys{
        choice(&Engine::has_multipliers, "normal_contact", {{"penalty", false}, {"augmented_lagrange", true}},
               "Contact forces by springs alone, or with multipliers that leave no overlap."),
        integer(&Engine::max_iterations, "open_close", 1, 100,
                "Rounds of the open-close iteration in which a contact may go back to what it was before the step is "
                "cut."),
        number(&Engine::dynamic_factor, "dynamic_factor", dimension::plain, between(0, 1),
               "Share of the velocity that the next step begins with: 1 = dynamic, 0 = static.")};
    return {
        .help = "implicit discontinuous deformation analysis in the plane, deformable polygons",
        .keys = within(&S::elasticity, affine::elastic_keys()) +
                KeyList<S>{choice(&S::plane, "plane", {{"stress", PlaneState::stress}, {"strain", PlaneState::strain}},
                                  "Plane stress or plane strain."),
                           affine::wanted_step<S>(),
                           number(&S::max_displacement, "displacement_limit", dimension::plain, above(0, 1),
                                  "Displacement of a corner in a step, over the side of the smallest block, for which "
                                  "contacts are sought; three times as much cuts the step.")} +
                within(&S::engine, engine_keys + affine::joint_keys<Engine>())};
}

std::vector<material::PropertyUse> PlanarDda::reads(const Settings& /*settings*/) { return affine::contact_uses(true); }

}  // namespace riprap::solid
