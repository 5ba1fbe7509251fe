// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "riprap/contact/law/frictions.hpp"
#include "riprap/contact/narrowphase/distance_potential_options.hpp"

namespace riprap {
template <class S>
struct MethodKeys;  // core/key.hpp
struct NoFields;    // core/fields.hpp
}  // namespace riprap

namespace riprap::solid {

class PolyhedralDem;

/// Physics of a pair of polyhedra.
enum class PairContact : std::uint8_t {
    distance_potential,    ///< contact::DistancePotentialPhysics
    common_plane_soft,     ///< contact::CommonPlanePhysics, springs by area
    common_plane_penalty,  ///< contact::CommonPlanePhysics, equal springs
};

/// Explicit DEM of polyhedra, with the distance potential or across the common plane.
struct DemSettings {
    using Method = PolyhedralDem;
    using Fields = NoFields;
    static constexpr std::string_view method_name = "distance_potential_dem";
    static MethodKeys<DemSettings> keys();

    PairContact pair_contact{PairContact::distance_potential};
    contact::DistancePotentialOptions contact;
    contact::Frictions friction;
    double local_damping{0};  ///< Cundall's alpha: F <- F - alpha |F| sign(v), per component [-]
    double mass_damping{0};   ///< F <- F - mass_damping * m * v [1/s]
    double grid_factor{2};    ///< gamma: ratio of circumradius between size classes [-]
    double skin{0.1};         ///< of the pair cache, as a fraction of the median circumradius [-]
    double max_potential{1};  ///< an overlap deeper than this share of the inscribed radius ends the run [-]
    double max_speed{1e5};    ///< a faster body, spin included (sqrt(2 K/m)), ends the run [m/s]
};

}  // namespace riprap::solid
