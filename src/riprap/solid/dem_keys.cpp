// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/chosen_keys.hpp"
#include "riprap/core/key.hpp"
#include "riprap/solid/dem_settings.hpp"

namespace riprap::solid {

using namespace key;

namespace {

KeyList<contact::DistancePotentialOptions> contact_keys() {
    using contact::Corners, contact::DistancePotentialOptions, contact::Potential, contact::Sides;
    return {
        choice(&DistancePotentialOptions::potential, "potential",
               {{"distance", Potential::distance}, {"fdem", Potential::fdem}},
               "Field of a block: normalised distance to its surface, or the FDEM potential (for comparison)."),
        choice(&DistancePotentialOptions::sides, "sides", {{"both", Sides::both}, {"contactor", Sides::contactor}},
               "Integrate the field of both blocks of a pair, or of one (for comparison)."),
        choice(&DistancePotentialOptions::corners, "corners", {{"stiff", Corners::stiff}, {"field", Corners::field}},
               "Corners and edges push as a punch of their size does, or by the field alone (as published). Only with "
               "the distance potential of both sides.")};
}

}  // namespace

MethodKeys<DemSettings> DemSettings::keys() {
    using S = DemSettings;
    const KeyList<S> keys{
        choice(&S::pair_contact, "contact",
               {{"distance_potential", PairContact::distance_potential},
                {"common_plane_soft", PairContact::common_plane_soft},
                {"common_plane_penalty", PairContact::common_plane_penalty}},
               "One contact a pair from the overlap of fields; or springs at the points where faces meet across the "
               "common "
               "plane, as stiff as the area that they stand for or all alike."),
        number(&S::local_damping, "local_damping", dimension::plain, below(0, 1),
               "Cundall's damping for quasi-static runs: a fraction of each force component, opposing the velocity."),
        number(&S::mass_damping, "mass_damping", dimension::frequency, non_negative(),
               "Damping force per mass and velocity."),
        number(&S::grid_factor, "grid_factor", dimension::plain, above(1, 16),
               "Ratio of circumradii between size classes of the contact search; speed only."),
        number(&S::skin, "skin", dimension::plain, above(0, 2),
               "Margin of the pair cache over the median circumradius; speed only."),
        number(&S::max_potential, "max_potential", dimension::plain, above(0, 1),
               "An overlap deeper than this fraction of the inscribed radius ends the run."),
        number(&S::max_speed, "max_speed", dimension::velocity, positive(), "A faster block ends the run.")};
    return {.help = "explicit discrete elements, polyhedra with a distance potential",
            .keys = within(&S::contact, contact_keys()).read_with("contact", {"distance_potential"}) +
                    chosen(&S::friction, "tangential_law", "Tangential law of a contact") + keys};
}

}  // namespace riprap::solid
