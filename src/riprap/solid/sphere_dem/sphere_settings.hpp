// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/contact/law/contact_table.hpp"
#include "riprap/contact/law/frictions.hpp"

namespace riprap::solid::sphere_dem {

/// Choices of the method.
struct SphereSettings {
    contact::NormalLaw normal{contact::NormalLaw::hertz};
    contact::SphereFrictions tangential;
    contact::RollingLaw rolling{contact::RollingLaw::none};
    contact::Sharing sharing{contact::Sharing::dashpots};
    contact::SphereNormals normals{contact::SphereNormals::centres};
    bool allows_pull{true};        ///< the dashpot may pull at the end of an impact
    double local_damping{0};       ///< Cundall's alpha [-]
    double mass_damping{0};        ///< [1/s]
    double skin{0.1};              ///< of the candidate pairs, over the median radius [-]
    double grid_factor{2};         ///< ratio of radii between size classes of the search [-]
    double steps_per_contact{50};  ///< steps in the shortest impact [-]
    double max_overlap{0.5};       ///< over the smaller radius; a deeper overlap ends the run [-]
    double max_speed{1e5};         ///< [m/s]
};

}  // namespace riprap::solid::sphere_dem
