// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/linear/block_csr.hpp"
#include "riprap/linear/block_jacobi.hpp"
#include "riprap/linear/incomplete_cholesky.hpp"
#include "riprap/linear/pcg.hpp"
#include "riprap/solid/implicit_dda/block_terms.hpp"
#include "riprap/solid/implicit_dda/open_close.hpp"

namespace riprap::solid::implicit_dda {

enum class Solver : std::uint8_t {
    pcg_jacobi,    ///< conjugate gradients, diagonal blocks as preconditioner
    pcg_cholesky,  ///< conjugate gradients, incomplete Cholesky factors
    sor,           ///< block successive over-relaxation, the source's solver [Ding2021, eq. 4.120]
    cholmod        ///< factors of CHOLMOD, in builds that have it
};

/// A contact point as the equations see it.
struct ContactTerm {
    std::int32_t row_a, row_b;        ///< of the system; -1 = the block does not move by loads
    std::int64_t entry_ab, entry_ba;  ///< places of the off-diagonal blocks; -1 = none
    Vec3 arm_a, arm_b;                ///< from the centroids to the contact point on either surface [m]
    Vec3 normal;                      ///< from a to b [-]
    double gap;                       ///< at the start, prescribed motion of the step included [m]
    Vec3 prescribed;                  ///< motion of a against b that is not unknown [m]
    ContactSprings springs;
    ContactTrial trial;
};

/// Contacts of each row, in their order.
struct RowContacts {
    std::vector<std::int32_t> start, contact;
    std::span<const std::int32_t> of(std::int64_t row) const {
        const auto r = static_cast<std::size_t>(row);
        return std::span(contact).subspan(static_cast<std::size_t>(start[r]),
                                          static_cast<std::size_t>(start[r + 1] - start[r]));
    }
};

/// The system K D = F of one step.
struct Equations {
    linear::BlockCsr<12> matrix;
    std::vector<double> right, solution;
    std::vector<Matrix12> diagonal;  ///< inertia and elasticity of each row
    std::vector<Vector12> given;     ///< right-hand side without contacts
    RowContacts incident;
    std::vector<std::uint8_t> is_stale;  ///< rows whose contacts have changed since they were assembled
    std::vector<std::uint8_t> is_new;    ///< rows assembled since the preconditioner took their diagonal blocks
    std::int64_t singular_row{-1};       ///< row whose diagonal block was not positive definite in the last solve()
    linear::BlockJacobi<12> jacobi;
    linear::IncompleteCholesky<12> cholesky{};
    linear::PcgScratch pcg;
};

/// Makes pattern and incidence of the contacts; keeps the pattern where it is the same. All rows are stale then.
void link_rows(std::int64_t rows, std::vector<ContactTerm>& contacts, Equations& equations);

/// Tells that the contact has changed its mode or its friction.
inline void mark_stale(const ContactTerm& contact, Equations& equations) {
    for (const std::int32_t row : {contact.row_a, contact.row_b}) {
        if (row >= 0) {
            equations.is_stale[static_cast<std::size_t>(row)] = 1;
        }
    }
}

/// Fills stale rows of matrix and right-hand side for the present modes: normal spring and friction pair of what
/// slides, both springs of what is locked. Rows gather, so the bits do not depend on threads.
void assemble(const std::vector<ContactTerm>& contacts, Equations& equations);

struct SolveSettings {
    Solver solver{Solver::pcg_jacobi};
    double tolerance{1e-10};  ///< |F - K D|/|F| [-]
    int max_iterations{2000};
    double relaxation{1.3};  ///< of SOR [-]
};

/// Solves from the guess in equations.solution.
linear::SolveReport solve(const SolveSettings& settings, Equations& equations);

/// Gap and slip of a contact from the solution.
void evaluate(const Equations& equations, ContactTerm& contact);

}  // namespace riprap::solid::implicit_dda
