// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "riprap/core/bytes.hpp"
#include "riprap/linear/bicgstab.hpp"

namespace riprap::fluid::mps {

/// Coupling of one particle with one body through the boundary particles w in its support, with d = x_i - x_w, r the
/// arm of w, b its share of a lattice volume and u(d) = (d, r x d):
///
///     flux = c rho_0 sum b W u(d)                what an acceleration (a, alpha) adds to the right-hand side of i
///     load = f sum b (M_i u(S) - W/r^2 u(d))     what a pressure of i adds to force and torque of the body
///     mass = f rho_0 sum b M_i u(S) u(B)^T       and what (a, alpha) takes from them at a given pressure
///
/// M_i = W/sum_j W being the share of i in the pressure of w, S = sum_j W/r^2 (x_w - x_j) and B = sum_j M_j (x_w -
/// x_j). Walls that mirror each particle have load = -2 f sum b W/r^2 u(d) and mass = f rho_0 sum b W/r^2 u(d) u(d)^T;
/// those of given pressure take no part. c and f as in solve_pressure and find_pressure_forces.
struct BodyEntry {
    std::int32_t particle, body;
    std::array<double, 6> flux, load;
    std::array<double, 36> mass;
};

/// Buffers of Mps::correct, which takes bodies as unknowns of the pressure equation beside those of the particles.
/// Given the pressure p solved with accelerations a, and r, what the loads that it gives accelerate the bodies by, less
/// a, the step of Newton's method to where both agree is
///
///     A dp = B da,   da = r + M^-1 (L S dp + K da)
///     =>  (A - B H L S) dp = B (1 - M^-1 K)^-1 r,   H = (1 - M^-1 K)^-1 M^-1,
///
/// A the matrix of the pressure equation, B, L and -K the sums of `flux`, `load` and `mass` over BodyEntry, and S = 1
/// where p > 0, else 0: pressures below zero are set to zero, which is all that keeps the problem from being linear.
/// A - B H L S is A and six numbers a body; it is solved by BiCGStab with the preconditioner of A.
struct BodiesInPressure {
    std::vector<BodyEntry> entries;
    std::vector<std::vector<BodyEntry>> chunks;
    std::vector<std::array<double, 36>> mobility, inverse;  ///< (1 - M^-1 K)^-1 M^-1 and (1 - M^-1 K)^-1 of every body
    std::vector<double> right, solution;
    linear::BicgstabScratch solver;
    std::size_t bytes() const { return bytes_of(entries, mobility, inverse, right, solution) + solver.bytes(); }
};

}  // namespace riprap::fluid::mps
