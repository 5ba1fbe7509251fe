// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/body/motion.hpp"

namespace riprap::coupling {

/// Finds the accelerations a of bodies for which the loads that water gives at a are those that cause it, a = G(a),
/// where G follows from a force pass of the fluid. A light body feeds back strongly: G'(a) is about -kappa, kappa its
/// added mass over its mass as far as the wall treatment sees it, and plain repetition diverges for kappa > 1.
/// Fixed-point iteration with Aitken's relaxation, each body by itself, with r = G(a) - a:
///
///     a <- a + w r,   w <- -w (r_old . (r - r_old)) / |r - r_old|^2,   w_0 = 1/(1 + kappa),
///
/// with m a . b + I alpha . beta as the product [KuettlerWall2008].
///
/// Bodies that feel each other through the water, or one whose added mass differs much with direction, settle slowly by
/// that. After `plain` passes all of them are taken together: the combination of all passes so far with the least
/// residual, and from there a step of relaxation 1/(1 + kappa). Where G is linear, as in a pressure solve, this is
/// GMRES [WalkerNi2011]. Where water does not pull, G has kinks: a body that leaves the water may not settle. The last
/// pass then takes the best guess again, for loads of a far one would kick body and water apart.
class AddedMassIteration {
 public:
    /// @param mass, inertia  of every body [kg], [kg m^2]
    /// @param kappa          estimate of every body; bodies below `iterates_above` take G(a) as it is
    AddedMassIteration(std::span<const double> mass, std::span<const double> inertia, std::span<const double> kappa);

    static constexpr double iterates_above = 0.1;  ///< lagged feedback then still decays tenfold a step
    static constexpr double tolerance = 1e-2;      ///< of |r| over |a| + |g|
    static constexpr int most = 40;                ///< force passes in one step
    static constexpr int plain = 4;                ///< of them by Aitken's relaxation

    /// Puts the next guess into `guess`, given what came out of it. True when nothing needs to change: the loads of
    /// this pass are those to use.
    /// @param scale  of accelerations in the scene: that of gravity [m/s^2]
    bool accept(std::vector<body::Acceleration>& guess, std::span<const body::Acceleration> found, double scale);

    int passes() const { return passes_; }
    /// False where the last pass was taken for want of more, not because nothing needed to change.
    bool is_settled() const { return !(residual_ > tolerance); }
    double residual() const { return residual_; }  ///< largest |r| over |a| + |g| of the last pass [-]

 private:
    using Accelerations = std::vector<body::Acceleration>;

    /// Returns the guess that follows from all passes so far.
    Accelerations combine() const;
    double product(const Accelerations& x, const Accelerations& y) const;

    std::span<const double> mass_, inertia_, kappa_;
    std::vector<body::Acceleration> last_;
    std::vector<double> relaxation_;
    std::vector<Accelerations> guesses_, residuals_;  ///< of all passes
    std::size_t best_{0};                             ///< of these
    double least_{0};                                 ///< its residual
    int passes_{0};
    double residual_{0};
};

}  // namespace riprap::coupling
