// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/contact_physics.hpp"
#include "riprap/contact/narrowphase/distance_potential_options.hpp"
#include "riprap/contact/narrowphase/foot_patch.hpp"
#include "riprap/core/mat3.hpp"

namespace riprap::contact {

/// Contact of two faces that lie on each other, carried by the corners of the patch that they share:
///
///     E_c = K/2 sum_c w_c max(d_c, 0)^2,    w_c = A theta_c/(2 pi) [1 + a . (q_c - s)],
///
/// K = k_A/r_A + k_B/r_B [N/m^3] as in the distance potential, A the area of the patch, theta_c the angle by which its
/// outline turns at corner c, s the mean of the corners by these angles. The vector a = M^-1 (c - s), M the second
/// moment of the corners about s, puts the centre of the weights at the centroid c of the patch, so that even faces
/// push as their area does. Weights of a rectangle are quarters, of a triangle thirds. Where edges nearly lie on each
/// other corners come and go in the middle of an edge: their angle is none, so the energy knows nothing of it.
///
/// E_c takes the place of the energy E_p of the potential by the share sigma = s t, s of the directions of the faces
/// (FacingFaces) and t of the depth D (FacingFaces::least) beside W, the lesser of the depth below any other face and
/// of the width of the patch times FacingFaces::rise, as the next faces of a disc are as deep as one of them from about
/// there on: 1 up to h^2 D = W/2, a smooth step to 0 at h D = W. Here h = 1, but between parts with stiff corners
/// (SharpPush) 2 - 3 q^2 + 2 q^3, q = min(W/r, 1), r the lesser inscribed radius: a foot is softer than a corner by
/// W/r, so where it is as narrow as deep a corner that can become one would lose its energy and throw itself there.
///
///     E = E_p + sigma (E_c - E_p)
///
/// Force and moment are the exact gradient of E (docs/theory/distance-potential.md).
class CornerFoot {
 public:
    /// @param per_area  K [N/m^3]
    CornerFoot(const PlacedShape& a, const PlacedShape& b, double per_area, Corners corners);

    double share() const { return faces_.share * fit_; }
    /// True where sigma is 1 here and nearby, so that E_p is not asked for.
    bool is_whole() const { return share() == 1; }
    /// Fills the contact of a whole foot. @returns false where no corner overlaps
    bool stand(NormalContact& contact) const;
    /// Joins the foot with the contact of the potential, its energy known.
    void join(NormalContact& potential) const;
    /// Sets the spin moment of a contact that resists spin: as the pressure on the whole foot does (spin_arm), with the
    /// disc of the potential where depths are round-off.
    void resist_spin(NormalContact& contact) const;
    /// Adds to a contact what the corners do beside the push at its point:
    ///
    /// - to the stability of both bodies the stiffness of tilting as a contact of its own: t_i + sqrt(t_i t_j), t_i the
    ///   largest eigenvalue of J_i^-1 sum_c k_c g_c g_c^T, bound by its traces [Wolkowicz1980], k_c = sigma K w_c,
    ///   g_c = (x_c - point) x n;
    /// - dashpots against tilting, of the ratio xi that the push has: k_c max(-d_c, tau v_c) at corners that overlap,
    ///   v_c = g_c . (omega_A - omega_B) closing, tau = 2 xi/sqrt(t_A + t_B). A corner never pulls.
    void add_tilting(const Candidate& pair, ContactRow& row) const;

 private:
    struct Slopes;
    /// Force on A and its moment about the origin of the pair.
    struct Wrench {
        Vec3 force{}, moment{};
        void add(const Vec3& f, const Vec3& place) {
            force += f;
            moment += cross(place, f);
        }
    };
    Wrench push(const Slopes& slopes) const;
    double stiffness() const { return per_area_ * patch_.area; }
    void weigh();
    void fit_to_width(Corners corners);
    Vec3 middle(const PatchPoint& p) const;

    const PlacedShape &a_, &b_;
    FacingFaces faces_;
    FootPatch& patch_;
    double per_area_;         ///< K [N/m^3]
    double energy_{0};        ///< E_c [J]
    PatchPoint center_{};     ///< s [m]
    PatchPoint lean_{};       ///< a [1/m]
    PatchPoint pull_{};       ///< M^-1 sum_c theta_c/(2 pi) max(d_c, 0)^2 (q_c - s) [m]
    double mean_square_{0};   ///< sum_c theta_c/(2 pi) max(d_c, 0)^2 [m^2]
    double fit_{0};           ///< t [-]
    double fit_by_least_{0};  ///< dt/dD [1/m]
    double fit_by_room_{0};   ///< dt/dW [1/m]
    double room_{0};          ///< W [m]
    bool is_narrow_{false};   ///< W is that of the width of the patch
};

}  // namespace riprap::contact
