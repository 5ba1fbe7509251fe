// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "riprap/linear/block_csr.hpp"
#include "riprap/linear/pcg.hpp"

// The sparse Cholesky factors of CHOLMOD, an oracle and a way out where springs are too stiff for conjugate gradients.
// Only in builds with RIPRAP_CHOLMOD: its supernodal part is under the GPL, and so is a program linked with it.

namespace riprap::linear {

/// Tells whether this program was built with CHOLMOD.
bool has_cholmod();

/// Solves A x = b, A symmetric and positive definite: analysis, factors and solution anew in every call, as the pattern
/// of contacts changes. Without CHOLMOD the status is not_positive_definite and x stays.
template <int B>
SolveReport solve_cholmod(const BlockCsr<B>& a, std::span<const double> b, std::span<double> x);

extern template SolveReport solve_cholmod(const BlockCsr<6>&, std::span<const double>, std::span<double>);
extern template SolveReport solve_cholmod(const BlockCsr<12>&, std::span<const double>, std::span<double>);

}  // namespace riprap::linear
