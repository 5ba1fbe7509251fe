// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/linear/block_csr.hpp"
#include "riprap/linear/block_jacobi.hpp"
#include "riprap/linear/huge_pages.hpp"
#include "riprap/linear/incomplete_cholesky.hpp"
#include "riprap/linear/pcg.hpp"
#include "riprap/solid/implicit_dda/block_terms.hpp"
#include "riprap/solid/implicit_dda/open_close.hpp"
#include "riprap/solid/implicit_dda/settings.hpp"
#include "riprap/solid/implicit_dda/spring_sums.hpp"

namespace riprap::solid::implicit_dda {

/// A contact point as the equations see it.
struct ContactTerm {
    std::int32_t row_a, row_b;  ///< of the system; -1 = the block does not move by loads
    Vec3 arm_a, arm_b;          ///< from the centroids to the contact point on either surface [m]
    Vec3 normal;                ///< from a to b [-]
    double gap;                 ///< at the start, prescribed motion of the step included [m]
    Vec3 prescribed;            ///< motion of a against b that is not unknown [m]
    ContactSprings springs;
    ContactTrial trial;
};

/// Contact points of two blocks, which come one after the other.
struct PairTerm {
    std::int32_t row_a, row_b;        ///< of the system; -1 = the block does not move by loads
    std::int32_t first, end;          ///< contact points
    std::int32_t side_a, side_b;      ///< places in Equations::sides; -1 = none
    std::int64_t entry_ab, entry_ba;  ///< places of the off-diagonal blocks; -1 = none
};

/// Springs and loads of the closed contact points of a pair on one of its blocks.
struct alignas(64) SideSum {
    OwnSprings springs{};
    std::array<double, 12> load{};  ///< f_i (1, r) of forces at zero displacement, row by row [N, N m]
};

/// The system K D = F of one step.
struct Equations {
    linear::BlockCsr<12> matrix;
    std::vector<double> right, solution;
    std::vector<Matrix12> diagonal;  ///< inertia and elasticity of each row
    std::vector<Vector12> given;     ///< right-hand side without contacts
    std::vector<PairTerm> pairs;
    std::vector<std::int64_t> side_start;  ///< first side of each row, one more at the end
    linear::StreamVector<SideSum> sides;   ///< of every pair, in the order of rows and, within one, of pairs
    std::vector<std::uint8_t> is_stale;    ///< pairs whose contacts have changed since they were summed
    std::vector<std::int32_t> stale_pairs;
    std::vector<std::uint8_t> is_due;  ///< rows that assemble() fills: all at first, then those of stale pairs
    std::vector<std::uint8_t> is_new;  ///< rows assembled since the preconditioner took their diagonal blocks
    bool is_planar{false};             ///< the unknowns out of the plane stay nought; see affine/plane.hpp
    std::int64_t singular_row{-1};     ///< row whose diagonal block was not positive definite in the last solve()
    linear::BlockJacobi<12> jacobi;
    linear::IncompleteCholesky<12> cholesky{};
    linear::PcgScratch pcg;
};

/// Makes pairs and pattern of the contacts; keeps the pattern where it is the same. All pairs are stale then.
void link_rows(std::int64_t rows, const std::vector<ContactTerm>& contacts, Equations& equations);

/// Sums stale pairs for the present modes, normal spring and friction pair of what slides, both springs of what is
/// locked, and fills their blocks and the rows of matrix and right-hand side that they are in. Rows gather the sums of
/// their pairs, so the bits do not depend on threads.
void assemble(const std::vector<ContactTerm>& contacts, Equations& equations);

/// Solves from the guess in equations.solution.
linear::SolveReport solve(const SolveSettings& settings, Equations& equations);

/// Motion of the two blocks of a pair by the solution; none where a block has no row.
struct PairMotion {
    Vec3 move_a{}, move_b{};
    Mat3 gradient_a{}, gradient_b{};

    PairMotion(const PairTerm& pair, const std::vector<double>& solution) {
        if (pair.row_a >= 0) {
            const double* const d = &solution[static_cast<std::size_t>(pair.row_a) * 12];
            move_a = {d[0], d[1], d[2]};
            gradient_a = gradient_of(d);
        }
        if (pair.row_b >= 0) {
            const double* const d = &solution[static_cast<std::size_t>(pair.row_b) * 12];
            move_b = {d[0], d[1], d[2]};
            gradient_b = gradient_of(d);
        }
    }
    /// Of a against b at a contact.
    Vec3 at(const ContactTerm& c) const { return (move_a + gradient_a * c.arm_a) - (move_b + gradient_b * c.arm_b); }
};

/// Gap and slip of a contact from the motion of its blocks.
inline void evaluate(const PairMotion& motion, ContactTerm& c) {
    const Vec3 moved = motion.at(c);
    c.trial.gap = c.gap - riprap::dot(c.normal, moved);
    const Vec3 total = moved + c.prescribed;
    c.trial.step_slip = total - riprap::dot(c.normal, total) * c.normal;
    c.trial.slip = c.trial.slip_before + c.trial.step_slip;
}

}  // namespace riprap::solid::implicit_dda
