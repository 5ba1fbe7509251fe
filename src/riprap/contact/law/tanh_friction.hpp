// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "riprap/contact/contact_kinematics.hpp"
#include "riprap/contact/contact_set.hpp"
#include "riprap/contact/law/mindlin.hpp"
#include "riprap/contact/stability.hpp"
#include "riprap/core/wide.hpp"
#include "riprap/material/material_set.hpp"
#include "riprap/material/property.hpp"

namespace riprap {
template <class S>
class KeyList;  // core/key.hpp
}

namespace riprap::contact {

/// Hyperbolic tangent of x >= 0, one value or eight. Within 1e-15 of the library's.
inline double tanh_of(double x) { return std::tanh(x); }
template <std::size_t N>
inline Wide<double, N> tanh_of(Wide<double, N> x) {
    for (std::int64_t lane = 0; lane < static_cast<std::int64_t>(N); ++lane) {
        x.set(lane, std::tanh(x[lane]));
    }
    return x;
}

/// Regularised friction without history [Mellado2021, eqs 4.15 to 4.22]: the smaller of
///
///     k_t |v| dt + c_t |v|   and   mu |F_n| tanh(|v|/v_0),
///
/// against the sliding velocity v. v_0 = 1/8 m/s in the source, which leaves the unit out. There is no friction at
/// rest: a block on a slope of angle beta creeps at v_0 atanh(tan(beta)/mu).
///
/// @param stiffness  k_t = 2/7 of 4/3 E* sqrt(R* delta) [N/m]; the source prints 8/21 E* sqrt(R*), short of a
/// length^(1/2)
/// @param damping    c_t = 2/7 of the normal dashpot [N s/m]
/// @param speed      v_0 [m/s]
template <class T>
inline TangentialResponse<T> tanh_friction(const Vec3T<T>& sliding, T stiffness, T damping, T normal_force, T friction,
                                           T speed, T dt) {
    using std::sqrt;
    const T v = sqrt(dot(sliding, sliding));
    const T spring = (stiffness * dt + damping) * v;
    const T coulomb = friction * normal_force * tanh_of(v / speed);
    const T size = smaller(spring, coulomb);
    const Vec3T<T> force = sliding * (-size / larger(v, T(1e-300)));
    return {force, size * v * dt, T(0.0), T(0.0)};
}

/// The law above as one of contact::SphereFrictions and of contact::Frictions.
struct TanhFriction {
    static constexpr std::string_view word = "tanh";
    static constexpr std::string_view help = "regularised by a speed, without history";
    static constexpr std::array reads{material::Property::friction};
    static KeyList<TanhFriction> keys();

    double speed{0.125};  ///< v_0 [m/s]

    template <class T>
    TangentialResponse<T> respond(const SlidingContact<T>& c, TangentialSpring<T>& /*spring*/) const {
        const T share(2.0 / 7);
        return tanh_friction<T>(c.sliding, share * c.normal_stiffness * c.weight, share * c.damping, c.normal_force,
                                c.friction.in_motion, T(speed), c.dt);
    }

    /// For polyhedra mu |F_n| tanh(|v|/v_0), and never more than the force that takes half of the sliding speed in a
    /// step; unlike k_t |v| dt this limit does not depend on the stiffness. Nothing is stored: the ledger counts the
    /// force as a dashpot.
    LinearContact respond(const NormalContact& normal, const material::PairProperties& pair,
                          const ContactKinematics& kinematics, const ShearState* before, ShearState& after,
                          ContactRow& row) const;
};

}  // namespace riprap::contact
