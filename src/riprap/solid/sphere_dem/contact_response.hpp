// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <type_traits>

#include "riprap/contact/law/hertz.hpp"
#include "riprap/contact/law/linear_spring.hpp"
#include "riprap/contact/law/mindlin.hpp"
#include "riprap/contact/law/rolling.hpp"
#include "riprap/contact/law/tanh_friction.hpp"
#include "riprap/solid/sphere_dem/sphere_model.hpp"

namespace riprap::solid::sphere_dem {

/// Constants of the pair of surfaces, one contact or eight; as contact::ContactPair.
template <class T>
struct SurfacePair {
    T modulus, shear_modulus, ratio, static_friction, kinetic_friction, rolling_friction, normal_stiffness, shear_ratio;
    T shear_damping;  ///< c_t/c_n of dashpots of one ratio, sqrt(k_t/k_n) [-]
};

inline SurfacePair<double> surface_pair(const contact::ContactPair& p, contact::NormalLaw law) {
    const bool is_hertz = law == contact::NormalLaw::hertz;
    return {
        p.modulus,          p.shear_modulus,    p.ratio,
        p.static_friction,  p.kinetic_friction, p.rolling_friction,
        p.normal_stiffness, p.shear_ratio,      std::sqrt(is_hertz ? 4 * p.shear_modulus / p.modulus : p.shear_ratio)};
}

/// Geometry and motion of one contact or of eight.
template <class T>
struct ContactMotion {
    Vec3T<T> normal, old_normal;  ///< from A to B, now and at the last step [-]
    Vec3T<T> velocity;            ///< of A against B at the contact [m/s]
    Vec3T<T> spin;                ///< omega_a - omega_b [rad/s]
    T mean_turn;                  ///< (omega_a + omega_b).n dt/2 [rad]
    T overlap;                    ///< >= 0 [m]
    T radius, mass;               ///< R*, m* [m], [kg]
    T inverse_mass;               ///< 1/m* [1/kg]
    T weight;                     ///< by which its springs count among those of its pair of bodies [-]
    T damping_weight;             ///< the same of its dashpots [-]
    T count;                      ///< of equal contacts of the pair of bodies [-]
    T dt;                         ///< since the last step [s]
    T cohesion{};                 ///< strength that is there without a normal force [N]; see Laws::has_cohesion
};

/// Force on A and books of one contact or of eight.
template <class T>
struct ContactResponse {
    Vec3T<T> force;                          ///< [N]
    Vec3T<T> couple;                         ///< of rolling resistance [N m]
    Vec3T<T> dashpot;                        ///< part of the force that dashpots have [N]
    T dashpot_power;                         ///< that they take at the velocity before the kick [W]
    T elastic, friction_loss, rolling_loss;  ///< [J]
};

/// Laws of a contact besides friction, as the settings choose them.
struct ChosenLaws {
    const SphereSettings& settings;
    static constexpr bool has_cohesion = false;
    bool is_hertz() const { return settings.normal == contact::NormalLaw::hertz; }
    contact::RollingLaw rolling() const { return settings.rolling; }
};
/// The same of surfaces that cohere.
struct CohesiveLaws : ChosenLaws {
    static constexpr bool has_cohesion = true;
};
/// The defaults, known to the compiler: Hertz without resistance to rolling.
struct DefaultLaws {
    const SphereSettings& settings;
    static constexpr bool has_cohesion = false;
    static constexpr bool is_hertz() { return true; }
    static constexpr contact::RollingLaw rolling() { return contact::RollingLaw::none; }
};

/// Normal force, tangential force and rolling couple by the laws of `laws`; springs are advanced. Stiffnesses count
/// by `weight`, dashpots by `damping_weight`.
/// @param friction  the law that settings.tangential chooses
template <class T, class Laws, class Law>
[[gnu::always_inline]] inline ContactResponse<T> respond_to(const Laws& laws, const Law& friction,
                                                            const SurfacePair<T>& pair, const ContactMotion<T>& motion,
                                                            contact::TangentialSpring<T>& spring,
                                                            Vec3T<T>& rolling_couple) {
    const bool is_hertz = laws.is_hertz();
    const contact::NormalResponse<T> normal =
        is_hertz ? contact::hertz<T>({pair.modulus, motion.radius, motion.mass, pair.ratio}, motion.overlap)
                 : contact::linear_spring<T>(pair.normal_stiffness, motion.mass, pair.ratio, motion.overlap);
    const T closing = dot(motion.velocity, motion.normal);
    const Vec3T<T> sliding = motion.velocity - motion.normal * closing;
    const T zero(0.0);
    const T elastic = normal.elastic * motion.weight, damping = normal.damping * motion.damping_weight;
    // The dashpot acts on the speed that it leaves in the middle of the kick, v - F_d dt/(2 m*), F_d of all contacts of
    // the pair of bodies. Elastic forces are left out: at rest others balance them.
    const T half = T(0.5) * motion.dt * motion.count * motion.inverse_mass;
    const T middle = closing / (T(1.0) + half * damping);
    T total = elastic + damping * middle;
    if (!laws.settings.allows_pull) {
        total = contact::larger(total, zero);
    }
    const T dashpot = total - elastic, pressing = contact::larger(total, zero);
    const T shear_stiffness =
        is_hertz ? T(8.0) * pair.shear_modulus * normal.width : pair.shear_ratio * pair.normal_stiffness;
    const T old_shear_stiffness = contact::larger(spring.stiffness, -spring.stiffness);

    contact::Friction<T> limits{pair.static_friction, pair.kinetic_friction};
    if constexpr (Laws::has_cohesion) {  // mu F_n + c A
        const auto is_pressed = pressing > zero;
        const T added = contact::choose(is_pressed, motion.cohesion / contact::larger(pressing, T(1e-300)), zero);
        limits = {limits.at_rest + added, limits.in_motion + added};
    }
    const contact::TangentialResponse<T> shear = friction.template respond<T>(
        {.normal = motion.normal,
         .old_normal = motion.old_normal,
         .sliding = sliding,
         .mean_turn = motion.mean_turn,
         .normal_stiffness = is_hertz ? T(4.0 / 3.0) * pair.modulus * normal.width : pair.normal_stiffness,
         .shear_stiffness = shear_stiffness,
         .shear_damping = pair.shear_damping,
         .damping = damping,
         .weight = motion.weight,
         .normal_force = pressing,
         .friction = limits,
         .dt = motion.dt},
        spring);
    ContactResponse<T> out;
    out.force = shear.force - motion.normal * total;
    out.couple = {};
    out.elastic = normal.energy * motion.weight + shear.energy;
    out.friction_loss = shear.friction_loss;
    out.dashpot = -(motion.normal * dashpot);
    if constexpr (!std::is_same_v<Law, contact::TanhFriction>) {  // whose force is all friction
        out.dashpot += shear.force - spring.force;
    }
    out.dashpot_power = -dot(out.dashpot, motion.velocity);
    out.rolling_loss = zero;
    if (laws.rolling() != contact::RollingLaw::none) {
        const Vec3T<T> rolling = motion.spin - motion.normal * dot(motion.spin, motion.normal);
        contact::RollingResponse<T> roll;
        if (laws.rolling() == contact::RollingLaw::constant) {
            roll = contact::rolling_constant<T>(rolling, pair.rolling_friction, motion.radius, pressing, motion.dt);
        } else {
            // k_n/k_t is the same at any overlap: the tangential spring remembers the normal one.
            const T ratio = is_hertz ? pair.modulus / (T(6.0) * pair.shear_modulus) : T(1.0) / pair.shear_ratio;
            const T secant = ratio * shear_stiffness * motion.weight;
            if constexpr (std::is_same_v<Law, contact::TanhFriction>) {  // which keeps no spring
                spring.stiffness = shear_stiffness * motion.weight;
            }
            const Vec3T<T> turned =
                contact::turn_with_normal(rolling_couple, motion.old_normal, motion.normal, motion.mean_turn);
            roll = contact::rolling_spring<T>(turned, rolling, pair.rolling_friction, motion.radius, pressing, secant,
                                              ratio * old_shear_stiffness, motion.dt);
            rolling_couple = roll.couple;
        }
        out.couple = roll.couple;
        out.elastic = out.elastic + roll.energy;
        out.rolling_loss = roll.loss;
    }
    return out;
}

}  // namespace riprap::solid::sphere_dem
