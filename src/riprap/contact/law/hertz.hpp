// SPDX-License-Identifier: Apache-2.0
#pragma once

// Hertz contact of two elastic spheres with a dashpot. Formulas are templates on the number type: `double`, or
// Wide<double, 8> for eight contacts at a time.

#include <cmath>

namespace riprap::contact {

/// Elastic constants of one surface.
struct Elasticity {
    double youngs_modulus{0};  ///< E [Pa]
    double poisson_ratio{0};   ///< nu [-]
};

/// E* of a pair [Pa]: 1/E* = (1 - nu_a^2)/E_a + (1 - nu_b^2)/E_b [Mellado2021, eq. 4.12].
double effective_modulus(const Elasticity& a, const Elasticity& b);
/// G* of a pair [Pa]: 1/G* = 2 (2 - nu_a)(1 + nu_a)/E_a + the same of b [Mellado2021, eq. 4.76].
double effective_shear_modulus(const Elasticity& a, const Elasticity& b);

/// Contact ratio of the dashpot that gives restitution e at every impact speed [-]:
///
///     epsilon = sqrt(10/9) |ln e| / sqrt(pi^2 + ln^2 e),
///
/// valid where the contact may pull at the end of an impact [Antypov2011]. The source calls epsilon a calibration
/// parameter [Mellado2021, eq. 4.11]; its 0.14 is e = 0.656.
/// @param restitution  0 < e <= 1 [-]
double contact_ratio(double restitution);
/// Inverse of contact_ratio: e in (0, 1] [-].
double restitution_of(double contact_ratio);
/// Contact ratio that gives restitution e where the force is cut off at zero [-]. Integrates the impact in units in
/// which it is free of parameters, x'' + sqrt(4.5) epsilon x^(1/4) x' + x^(3/2) = 0, and bisects.
double contact_ratio_without_pull(double restitution);

/// Largest overlap of an elastic impact with approach speed v [m]: (15 m* v^2/(16 sqrt(R*) E*))^(2/5).
double hertz_largest_overlap(double modulus, double radius, double mass, double speed);
/// Duration of an elastic impact [s]: 2.9432 delta_max/v = 2.87 (m*^2/(R* E*^2 v))^(1/5). Differs from the source: its
/// exponent is lost in print [Mellado2021, eq. 4.26] or 1/3 [Amaro2021, eq. A33]; the dimensions ask for 1/5.
double hertz_contact_time(double modulus, double radius, double mass, double speed);

/// Constants of one contact: the pair of surfaces and the two bodies.
template <class T>
struct HertzPair {
    T modulus;  ///< E* [Pa]
    T radius;   ///< R* = R_a R_b/(R_a + R_b) [m]; R_a against a plane
    T mass;     ///< m* = m_a m_b/(m_a + m_b) of the bodies [kg]
    T ratio;    ///< contact ratio epsilon [-]
};

/// Spring and dashpot of the normal direction at one overlap.
template <class T>
struct NormalResponse {
    T elastic;  ///< F = 4/3 E* sqrt(R* delta) delta [N]
    T damping;  ///< c = epsilon sqrt(6 m* E* sqrt(R* delta)) [N s/m]
    T width;    ///< radius of the contact patch, sqrt(R* delta) [m]
    T energy;   ///< 2/5 F delta [J]
};

/// [Mellado2021, eqs 4.7, 4.10, 4.11]; valid for delta much smaller than R*.
/// @param overlap  delta >= 0 [m]
template <class T>
inline NormalResponse<T> hertz(const HertzPair<T>& pair, T overlap) {
    using std::sqrt;
    const T width = sqrt(pair.radius * overlap);
    const T elastic = T(4.0 / 3.0) * pair.modulus * width * overlap;
    return {elastic, pair.ratio * sqrt(T(6.0) * pair.mass * pair.modulus * width), width, T(0.4) * elastic * overlap};
}

}  // namespace riprap::contact
