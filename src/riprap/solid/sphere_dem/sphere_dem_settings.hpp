// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "riprap/solid/sphere_dem/sphere_settings.hpp"

namespace riprap {
template <class S>
struct MethodKeys;  // core/key.hpp
}

namespace riprap::solid::sphere_dem {
struct SphereState;  // sphere_state.hpp
}

namespace riprap::solid {

class SphereDem;

/// Spheres that stand for a body that can move freely.
enum class SphereSampling {
    surface,  ///< its surface, flush with the faces of boxes
    one,      ///< one sphere (planar: disc) of its volume about its centre of mass
    balls,    ///< none but of balls and discs: other bodies meet by their faces, each other by the distance potential
};

/// Explicit DEM of bodies that meet by spheres.
struct SphereDemSettings {
    using Method = SphereDem;
    using Fields = sphere_dem::SphereState;
    static constexpr std::string_view method_name = "sphere_dem";
    static MethodKeys<SphereDemSettings> keys();

    sphere_dem::SphereSettings laws;
    SphereSampling sampling{SphereSampling::surface};
    std::optional<double> sphere_radius;  ///< of samples [m]; empty = a third of the least inscribed radius
    double youngs_modulus{0};             ///< of all bodies [Pa]; 0 = as the scene asks for (default_stiffness.hpp)
    double poisson_ratio{0.3};            ///< [-]
    double restitution{0.5};              ///< [-]
    double rolling_friction{0};           ///< [-]
    std::optional<double> contact_ratio;  ///< of Hertz' dashpot [-]; empty = from the restitution
    double kinetic_share{1};              ///< kinetic over static friction [-]
    double spring_stiffness{0};           ///< of the linear normal spring [N/m]; 0 likewise
    double shear_ratio{2.0 / 7};          ///< tangential over normal stiffness of linear springs [-]
};

}  // namespace riprap::solid
