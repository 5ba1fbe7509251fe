// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "riprap/contact/contact_set.hpp"
#include "riprap/contact/frame.hpp"

namespace riprap::contact {

/// Integrals of the field phi of one body (the *field body*) over the surface S of the other inside it, in the frame
/// of the field body. x is measured from a reference point chosen by the caller; n is the outward normal of S.
struct SurfaceIntegrals {
    Vec3 force{};          ///< integral of phi n dS [m^2]
    Vec3 moment{};         ///< integral of phi x x n dS (vector product) [m^3]
    Vec3 first{};          ///< integral of phi x dS [m^3]
    Vec3 area{};           ///< integral of n dS [m^2]
    double sum{0};         ///< integral of phi dS [m^2]
    double weighted{0};    ///< integral of |grad phi| phi dS [m]
    double volume_sum{0};  ///< integral of phi over the volume of the overlap [m^3]
    double potential{0};   ///< largest phi on S [-]
    double depth{0};       ///< largest distance of a point of S below the face whose cell it is in [m]
};

/// Contribution of one side of a pair to a contact: its integrals, factor k of the field [Pa] and the axes that turn
/// the field body's frame into the world.
struct ContactSide {
    const SurfaceIntegrals& integrals;
    double stiffness;
    const Mat3& axes;
};

/// |F| below this fraction of the sum of |pressure| x area is round-off of a force that cancels: a body embedded
/// symmetrically in another. It has no direction and so no central axis.
inline constexpr double vanishing_force = 1e-12;

/// Spin moment over force and root of area [-], (2/3)/sqrt(pi): uniform pressure on a disc of the patch's area; on a
/// square patch 1.7 % below the integral.
inline constexpr double disc_spin = 2.0 / 3.0 * 0.56418958354775628695;

/// Resultant of both sides. `on_a` belongs to the surface of A in the field of B, `on_b` to the surface of B in the
/// field of A:
///
///     F_A = -k_B int_{dA in B} n phi_B dS + k_A int_{dB in A} n phi_A dS,      M_A(O) likewise with x x n,
///
/// [Zhao, eqs. 2 and 3, signs corrected]. The wrench is given at the point of its central axis
/// O + F x M / |F|^2 + s F/|F| that lies nearest to the pressure centroid; what is left of M there is parallel to F.
/// Where the force vanishes the point is the pressure centroid itself.
/// K_n = S_c (k_A w_A + k_B w_B) with w the pressure-weighted mean gradient, 1/r for the distance potential.
/// @param area_sides  how many of the sides carry a closed patch: 2, or 1 where only one of them was integrated
RIPRAP_HD inline void assemble_contact(const ContactSide& on_a, const ContactSide& on_b, const Vec3& reference,
                                       int area_sides, NormalContact& contact) {
    const SurfaceIntegrals &a = on_a.integrals, &b = on_b.integrals;
    const double ka = on_a.stiffness, kb = on_b.stiffness;
    const Vec3 force = kb * (on_b.axes * b.force) - ka * (on_a.axes * a.force);
    const Vec3 moment = kb * (on_b.axes * b.moment) - ka * (on_a.axes * a.moment);
    const double pressure = ka * a.sum + kb * b.sum;
    const Vec3 centroid = pressure > 0 ? (ka * (on_a.axes * a.first) + kb * (on_b.axes * b.first)) / pressure : Vec3{};

    const double size2 = norm_squared(force);
    Vec3 arm = centroid;
    if (size2 > vanishing_force * vanishing_force * pressure * pressure) {
        arm = cross(force, moment) / size2;
        arm += (dot(centroid - arm, force) / size2) * force;
    }
    contact.force = force;
    contact.point = reference + arm;
    contact.moment = moment - cross(arm, force);
    contact.area = norm(on_a.axes * a.area - on_b.axes * b.area) / area_sides;
    contact.stiffness =
        contact.area * ((a.sum > 0 ? ka * a.weighted / a.sum : 0.0) + (b.sum > 0 ? kb * b.weighted / b.sum : 0.0));
    contact.energy = ka * a.volume_sum + kb * b.volume_sum;
    contact.depth = a.depth > b.depth ? a.depth : b.depth;
    contact.potential = a.potential > b.potential ? a.potential : b.potential;
    contact.spin_moment = disc_spin * std::sqrt(size2 * contact.area);
}

}  // namespace riprap::contact
