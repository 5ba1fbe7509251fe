// SPDX-License-Identifier: Apache-2.0
#pragma once

// The terms of one step's potential energy as blocks of the matrix K and the right side F of K D = F
// [Shi1988; Ding2021, sections 3.1 to 3.2]. Each is the second and the negative first derivative of an energy named
// with it; energies are quadratic in the unknowns D of the step, which are zero at its start.

#include "riprap/solid/planar_dda/model.hpp"
#include "riprap/solid/planar_dda/state.hpp"

namespace riprap::solid::planar_dda {

/// sigma_x = direct exx + cross eyy, sigma_y = cross exx + direct eyy, tau_xy = shear gxy [Pa].
struct Elasticity {
    double direct, cross, shear;
};
Elasticity elasticity_of(const affine::Elasticity& rock, PlaneState plane);

/// Stress in world axes, tension positive [Pa].
struct Stress {
    double x{0}, y{0}, xy{0};
};
Stress stress_of(const Elasticity& elasticity, const Unknowns& strain);
/// Density of the strain energy of a stress, 1/2 sigma . E^-1 sigma [J/m^3].
double energy_density(const Elasticity& elasticity, const Stress& stress);

/// Second moments over mass or area in world axes, as the block stands now [m^2].
struct Spread {
    double xx{0}, yy{0}, xy{0};
};
Spread spread_of(const Model& model, const State& state, std::int32_t block);
/// Volume of a block as it stands now: reference area times det U, one metre thick [m^3].
double volume_of(const Model& model, const State& state, std::int32_t block);

/// K of the strain energy 1/2 V eps . E eps.
Block6 elastic_block(const Elasticity& elasticity, double volume);
/// M, the integral of density T^T T; the inertia term is K = 2 M/dt^2 and F = 2 M rates/dt, Newmark's beta = 1/2 and
/// gamma = 1 with the displacement zero at the start of the step [Ding2021, eq. 3.12].
Block6 mass_block(double mass, const Spread& spread);
/// F of the stress energy V eps . sigma.
Unknowns stress_force(const Stress& stress, double volume);
/// K of the energy 1/2 p |T(r) D - gap|^2 of a point held at a distance `gap` from where it is; F is p T^T gap.
Block6 fixed_point_block(const Vec2& r, double stiffness);

/// A scalar that two blocks change, value + a . D_a + b . D_b: a gap, a slip or a length [m].
struct Linear {
    double value{0};
    Unknowns a{}, b{};

    double after(const Unknowns& da, const Unknowns& db) const { return value + dot(a, da) + dot(b, db); }
};

/// Corner against edge in world coordinates. The edge runs counter-clockwise about its block from `begin` to `end`, so
/// that its outside is to the right. Centers are the centroids of the corner's block and of the edge's.
struct CornerAndEdge {
    Vec2 corner{}, begin{}, end{};
    Vec2 corner_center{}, edge_center{};
};

/// Distance of the corner from the line of the edge, positive outside: d = S0/l + e . D_a + g . D_b with S0 twice the
/// area of the triangle (corner, end, begin), l the length of the edge, kept at its value of the start
/// [Shi1988; Ding2021, eq. 3.15].
Linear gap_of(const CornerAndEdge& where);

/// Slip of the corner along the edge against the lock point P0 = end + lock (begin - end), which moves with the edge:
/// s = (P1 - P0) . (begin - end)/l. The derivative takes the turn of the edge along, so that a common rigid motion
/// changes nothing and the pair of forces has no moment.
Linear slip_of(const CornerAndEdge& where, double lock);

/// Place of the corner along the edge: 0 at its end, 1 at its begin [-].
double foot_of(const CornerAndEdge& where);

/// Length of a bolt [m].
Linear length_of(const Vec2& first, const Vec2& first_center, const Vec2& second, const Vec2& second_center);

}  // namespace riprap::solid::planar_dda
