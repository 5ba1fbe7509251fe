// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/law/mindlin.hpp"

namespace riprap::contact {

/// Rolling couple of a contact at the end of a step.
template <class T>
struct RollingResponse {
    Vec3T<T> couple;  ///< on A [N m]; B gets the opposite
    T loss;           ///< energy that left in this step [J]
    T energy;         ///< stored in the rolling spring [J]
};

/// Couple of constant size against rolling (model A of [Ai2011]): -mu_r R* |F_n| w/|w|, w the part of omega_a - omega_b
/// across the normal. Oscillates around rest; use it for flowing grains only.
template <class T>
inline RollingResponse<T> rolling_constant(const Vec3T<T>& rolling, T rolling_friction, T radius, T normal_force,
                                           T dt) {
    using std::sqrt;
    const T rate = sqrt(dot(rolling, rolling));
    const T size = rolling_friction * radius * normal_force;
    return {rolling * (-size / larger(rate, T(1e-300))), size * rate * dt, T(0.0)};
}

/// Elastic-plastic rolling spring (model C of [Ai2011] without its dashpot):
///
///     M <- M min(1, k_n/k_n_old) - k_r w dt,   |M| <= mu_r R* |F_n|,   k_r = 2.25 k_n (mu_r R*)^2,
///
/// k_n the secant stiffness F/delta of the contact. `couple` is that of the last step, turned with the normal; where
/// the contact has softened it is less in proportion, else loading and unloading would create energy, as that of
/// advance_spring. Holds a sphere still on slopes up to tan(beta) = mu_r.
/// @param normal_stiffness  k_n [N/m]
/// @param old_stiffness     the same at the last step, 0 of a new contact [N/m]
template <class T>
inline RollingResponse<T> rolling_spring(const Vec3T<T>& couple, const Vec3T<T>& rolling, T rolling_friction, T radius,
                                         T normal_force, T normal_stiffness, T old_stiffness, T dt) {
    using std::sqrt;
    const T arm = rolling_friction * radius, tiny(1e-300), zero(0.0), one(1.0);
    const T lever = T(2.25) * arm * arm, stiffness = lever * normal_stiffness, old = lever * old_stiffness;
    const T old_compliance = choose(old > zero, T(0.5) / larger(old, tiny), zero);
    const T relief = choose(both(old > zero, old > stiffness), stiffness / larger(old, tiny), one);
    const Vec3T<T> before = couple * relief;
    const Vec3T<T> trial = before - rolling * (stiffness * dt);
    const T size = sqrt(dot(trial, trial)), limit = arm * normal_force;
    const T share = choose(size > limit, limit / larger(size, tiny), T(1.0));
    const Vec3T<T> kept = trial * share;
    const T compliance = choose(stiffness > T(0.0), T(0.5) / larger(stiffness, tiny), T(0.0));
    // energy held before, plus the work on the couple, minus the energy held after: see advance_spring.
    const T loss =
        dot(couple, couple) * old_compliance - T(0.5) * dt * dot(before + kept, rolling) - dot(kept, kept) * compliance;
    return {kept, loss, dot(kept, kept) * compliance};
}

}  // namespace riprap::contact
