// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "riprap/contact/law/joint_laws.hpp"
#include "riprap/solid/affine/elasticity.hpp"

namespace riprap {
template <class S>
struct MethodKeys;  // core/key.hpp
}

namespace riprap::solid::planar_dda {

/// Which strain or stress vanishes across the plane.
enum class PlaneState : std::uint8_t { stress, strain };

/// Settings of contact search, open-close iteration and steps. Lengths follow the size of the scene.
struct Settings {
    double displacement_limit{0.01};  ///< largest displacement of a corner in one step [m]; contacts are sought 2.5
                                      ///< times as far
    double close_tolerance{1e-9};     ///< an open contact closes below -this gap [m]
    double open_tolerance{1e-9};      ///< a closed contact opens when its spring is stretched by more [m]
    double bond_share{0};             ///< slip or gap by which a bond without tensile strength is lost, over the side
                                      ///< of a square as large as the smaller block of the pair [-]
    double angle_tolerance{0.0523598775598};  ///< by which a corner may lean into an edge, 3 degrees [rad]
    int max_iterations{8};                    ///< open-close iterations of one step
    double friction_tolerance{1e-6};    ///< change of friction between iterations over the largest normal force [-]
    double dynamic_factor{1};           ///< kappa: share of the velocity that the next step begins with; 0 = static
    bool has_multipliers{false};        ///< augmented Lagrange instead of the penalty alone
    double multiplier_tolerance{1e-9};  ///< overlap left by the augmented Lagrange loop [m]
    int max_augmentations{20};          ///< of that loop
    contact::JointLaws joint_law{};
};

}  // namespace riprap::solid::planar_dda

namespace riprap::solid {

class PlanarDda;
struct PlanarDdaFields;

/// Keys of `solid.method = "planar_dda"`.
struct PlanarDdaSettings {
    using Method = PlanarDda;
    using Fields = PlanarDdaFields;
    static constexpr std::string_view method_name = "planar_dda";
    static MethodKeys<PlanarDdaSettings> keys();
    planar_dda::Settings engine;  ///< its lengths follow the smallest block
    planar_dda::PlaneState plane{planar_dda::PlaneState::stress};
    affine::Elasticity elasticity;
    double max_displacement{0.1};  ///< displacement limit over the side of the smallest block [-]
    double step{1e-3};  ///< that the method wants; shorter where the open-close iteration does not settle [s]
};

}  // namespace riprap::solid
