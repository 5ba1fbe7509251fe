// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/solid_scene.hpp"
#include "riprap/solid/sphere_dem/sphere_dem_settings.hpp"

namespace riprap::solid::sphere_dem {

inline constexpr double least_modulus = 1e7;    ///< that a case without a modulus has at least [Pa]
inline constexpr double least_stiffness = 1e5;  ///< and of linear springs [N/m]
/// Overlap at rest over the size D of the smallest body, at most [-]. A cube that stands on one edge leans by this
/// share, and stands by sharp_share/6 D inside of that edge (convex_samples.hpp): its slope of tipping has a tangent
/// that is sharp_share/3 + static_share = 0.0018 too small, 0.05 degrees at 45 where nothing else is lost.
inline constexpr double static_share = 1e-4;
/// Overlap in an impact over the size D of the body, at most [-]: the upper end of the 0.1 to 1 % of a particle's
/// diameter that discrete elements are run with. The particle is the body, not its sample.
inline constexpr double impact_share = 1e-2;

/// Modulus that the settings give, or the least [Pa].
inline double modulus_of(const SphereDemSettings& settings) {
    return settings.youngs_modulus > 0 ? settings.youngs_modulus : least_modulus;
}
/// Spring that the settings give, or the least [N/m].
inline double spring_of(const SphereDemSettings& settings) {
    return settings.spring_stiffness > 0 ? settings.spring_stiffness : least_stiffness;
}

/// Holds what the contacts of a scene have to carry.
struct ContactDuty {
    double load{0};    ///< at rest, on a sample whose portion is one [N]
    double speed{0};   ///< of the hardest impact [m/s]
    double size{0};    ///< twice the least inscribed radius of what moves [m]
    double radius{0};  ///< least R of the spheres [m]
    double impact{0};  ///< largest m v^2/(p sqrt(R) (0.01 D)^(5/2)) of a body of size D [Pa]
    double spring{0};  ///< largest m v^2/(p (0.01 D)^2) [N/m]; p the portion of its corners, see SphereSet
};

/// Works out what contacts have to carry: at rest g min(M, m (1 + H/D)), with M the mass of all bodies that may move, m
/// that of the heaviest, H their extent along gravity and D the size of the smallest: so much lies on the lowest of a
/// pile. All of it lies on one edge before a body tips: in the plane on a corner, whose sample counts by a half, in
/// space on samples that count by D/(4 R) together.
/// @param speed  of the hardest impact to come [m/s]
ContactDuty contact_duty(const SolidScene& scene, const SphereDemSettings& settings, const body::BodyState& state,
                         double speed);

/// Overlap at rest by Hertz, (3 F/(4 E* sqrt R))^(2/3), or F/k of a linear spring [m]; of equal surfaces E* = E/(2 (1 -
/// nu^2)).
double static_overlap(const ContactDuty& duty, const SphereDemSettings& settings);

/// Settings with a modulus and a spring in place of those that the case leaves open: so stiff that at rest bodies sink
/// in by a ten-thousandth of the smallest one and in the hardest impact by a hundredth of themselves,
///
///     E* = max(3 F/(4 sqrt(R) (1e-4 D)^(3/2)), 15 m v^2/(16 sqrt(R) (0.01 D)^(5/2))),   k = max(F/(1e-4 D), m
///     v^2/(0.01 D)^2),
///
/// by Hertz and by a linear spring, each on one contact, and no softer than 1e7 Pa and 1e5 N/m.
SphereDemSettings completed(const SolidScene& scene, const SphereDemSettings& settings, const body::BodyState& state,
                            double speed);

}  // namespace riprap::solid::sphere_dem
