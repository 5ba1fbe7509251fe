// SPDX-License-Identifier: Apache-2.0
#pragma once

// Tangential spring of a contact between spheres, with history and Coulomb's limit. Templates on the number type:
// `double`, or Wide<double, 8> for eight contacts at a time.

#include <cmath>
#include <cstdint>
#include <string_view>

#include "riprap/core/vec3.hpp"
#include "riprap/core/wide.hpp"

namespace riprap::contact {

// Choices number by number, for one contact and for eight.
inline double choose(bool condition, double a, double b) { return condition ? a : b; }
inline bool both(bool a, bool b) { return a && b; }
inline double larger(double a, double b) { return a > b ? a : b; }
inline double smaller(double a, double b) { return a < b ? a : b; }
template <class Int, std::size_t N>
inline Wide<double, N> choose(Wide<Int, N> condition, Wide<double, N> a, Wide<double, N> b) {
    return select(condition, a, b);
}
template <class Int, std::size_t N>
inline Wide<Int, N> both(Wide<Int, N> a, Wide<Int, N> b) {
    return a & b;
}
template <std::size_t N>
inline Wide<double, N> larger(Wide<double, N> a, Wide<double, N> b) {
    return max(a, b);
}
inline bool is_any_above(double a, double b) { return a > b; }
template <std::size_t N>
inline bool is_any_above(Wide<double, N> a, Wide<double, N> b) {
    return bits_below(b, a) != 0;
}
template <std::size_t N>
inline Wide<double, N> smaller(Wide<double, N> a, Wide<double, N> b) {
    return min(a, b);
}

/// Spring of a contact that survives from step to step.
template <class T>
struct TangentialSpring {
    Vec3T<T> force{};  ///< on A, in the tangent plane [N]
    T stiffness{};     ///< at the last step [N/m]; negative while the contact slides, 0 of a new contact
};

/// Turns a vector of the old tangent plane with the normal: by the smallest rotation that takes n_old into n,
///
///     R f = f - (f.n) (n_old + n)/(1 + n_old.n),
///
/// then about n by the angle `turn`, as a Cayley rotation. Keeps the length of f to round-off; what f has along n_old
/// is lost. A normal that turns by more than 172 degrees in a step drops f.
template <class T>
inline Vec3T<T> turn_with_normal(const Vec3T<T>& f, const Vec3T<T>& old_normal, const Vec3T<T>& normal, T turn) {
    const T cosine = dot(old_normal, normal);
    const auto is_kept = cosine > T(-0.99);
    const T share = choose(is_kept, dot(f, normal) / (T(1.0) + larger(cosine, T(-0.99))), T(0.0));
    Vec3T<T> turned = f - (old_normal + normal) * share;
    turned -= normal * dot(turned, normal);
    const T half = T(0.5) * turn, quarter = half * half, scale = choose(is_kept, T(1.0) / (T(1.0) + quarter), T(0.0));
    return turned * ((T(1.0) - quarter) * scale) + cross(normal, turned) * (turn * scale);
}

/// Friction of one pair of surfaces.
template <class T>
struct Friction {
    T at_rest;    ///< static coefficient [-]
    T in_motion;  ///< kinetic coefficient [-], not above the static one
};

/// Tangential force of one contact after a step.
template <class T>
struct TangentialResponse {
    Vec3T<T> force;   ///< on A: spring and dashpot [N]
    T friction_loss;  ///< energy that left through friction in this step [J]
    T dashpot_power;  ///< of the dashpot, as a loss [W]
    T energy;         ///< stored in the spring, f^2/(2 k) [J]
};

/// Advances a tangential spring by the sliding velocity v over dt,
///
///     f <- f min(1, k/k_old) - k v dt,   |f| <= mu |F_n|,
///
/// f already turned with the normal. A spring whose stiffness falls with the contact patch loses force in proportion,
/// else a loading cycle would create energy [Thornton2013]. The limit is static until it is passed; then the force is
/// kinetic until the trial force falls below the kinetic limit. The dashpot -c v acts while the contact sticks, within
/// the same limit.
///
/// The loss is what the spring held, plus the work of the motion, minus what the spring holds afterwards:
/// D = f_old^2/(2 k_old) - (f_old' + f_new).v dt/2 - f_new^2/(2 k), f_old' the rescaled force. It is never negative for
/// a constant k; exact to round-off.
///
/// @param stiffness     k of this step [N/m]; Mindlin's no-slip value is 8 G* sqrt(R* delta) [Mellado2021, eq. 4.75]
/// @param damping       c [N s/m]
/// @param normal_force  |F_n| >= 0 [N]
template <class T>
inline TangentialResponse<T> advance_spring(TangentialSpring<T>& spring, const Vec3T<T>& sliding, T stiffness,
                                            T damping, T normal_force, const Friction<T>& friction, T dt) {
    using std::sqrt;
    const T zero(0.0), one(1.0), half(0.5), tiny(1e-300);
    const T old_stiffness = larger(spring.stiffness, -spring.stiffness);
    const auto is_old = old_stiffness > zero;
    const auto has_spring = stiffness > zero;
    const T old_compliance = choose(is_old, one / larger(old_stiffness, tiny), zero);
    const T compliance = choose(has_spring, one / larger(stiffness, tiny), zero);
    const T relief = choose(both(is_old, old_stiffness > stiffness), stiffness * old_compliance, one);
    const T old_energy = half * old_compliance * dot(spring.force, spring.force);
    const Vec3T<T> old_force = spring.force * relief;
    const Vec3T<T> trial = old_force - sliding * (stiffness * dt);

    // Sizes are compared by their squares: where all contacts stick, nobody waits for a root and a quotient.
    const T trial_square = dot(trial, trial);
    const T limit_kinetic = friction.in_motion * normal_force;
    const T limit = choose(spring.stiffness < zero, limit_kinetic, friction.at_rest * normal_force);
    const T limit_square = limit * limit;
    const auto is_sliding = trial_square > limit_square;
    const bool slides = is_any_above(trial_square, limit_square);
    T share = choose(has_spring, one, zero);
    if (slides) {
        share = share * choose(is_sliding, limit_kinetic / larger(sqrt(trial_square), tiny), one);
    }
    spring.force = trial * share;
    spring.stiffness = choose(is_sliding, -stiffness, stiffness);

    TangentialResponse<T> response;
    response.energy = half * compliance * dot(spring.force, spring.force);
    response.friction_loss = old_energy - half * dt * dot(old_force + spring.force, sliding) - response.energy;

    const Vec3T<T> total = spring.force - sliding * choose(is_sliding, zero, damping);
    const T total_square = dot(total, total);
    response.force = total;
    if (slides || is_any_above(total_square, limit_square)) {
        const T cut = choose(total_square > limit_square, limit / larger(sqrt(total_square), tiny), one);
        response.force = total * choose(is_sliding, one, cut);
    }
    response.dashpot_power = -dot(response.force - spring.force, sliding);
    return response;
}

/// Input of a friction of spheres: one contact, or eight.
template <class T>
struct SlidingContact {
    Vec3T<T> normal, old_normal;  ///< from A to B, now and at the last step [-]
    Vec3T<T> sliding;             ///< of A against B, across the normal [m/s]
    T mean_turn;                  ///< (omega_a + omega_b).n dt/2 [rad]
    T normal_stiffness;           ///< 4/3 E* sqrt(R* delta), or that of the linear spring [N/m]
    T shear_stiffness;            ///< 8 G* sqrt(R* delta), or a share of the linear spring [N/m]
    T shear_damping;              ///< c_t/c_n at the same damping ratio, sqrt(k_t/k_n) [-]
    T damping;                    ///< c_n of this contact [N s/m]
    T weight;                     ///< by which stiffnesses count [-]
    T normal_force;               ///< >= 0 [N]
    Friction<T> friction;
    T dt;  ///< since the last step [s]
};

/// The spring above as one of contact::SphereFrictions.
struct Mindlin {
    static constexpr std::string_view word = "mindlin";
    static constexpr std::string_view help = "a spring with history";

    template <class T>
    TangentialResponse<T> respond(const SlidingContact<T>& c, TangentialSpring<T>& spring) const {
        spring.force = turn_with_normal(spring.force, c.old_normal, c.normal, c.mean_turn);
        return advance_spring<T>(spring, c.sliding, c.shear_stiffness * c.weight, c.damping * c.shear_damping,
                                 c.normal_force, c.friction, c.dt);
    }
};

}  // namespace riprap::contact
