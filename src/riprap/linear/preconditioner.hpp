// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <span>

#include "riprap/core/parallel.hpp"

namespace riprap::linear {

/// A symmetric positive definite matrix that can be applied: y = A x. The same input gives the same bits at any thread
/// count.
template <class A>
concept LinearOperator = requires(const A& a, std::span<const double> x, std::span<double> y) {
    { a.size() } -> std::convertible_to<std::size_t>;
    a.multiply(x, y);
};

/// z = M^-1 r, M symmetric positive definite and near A: fixed for as long as one solve lasts, and the same bits at any
/// thread count. A multigrid cycle plugs in here when it smooths symmetrically. Applying may use buffers of its own,
/// hence no const.
template <class M>
concept Preconditioner = requires(M& m, std::span<const double> r, std::span<double> z) {
    m.apply(r, z);
};

/// M = I
struct NoPreconditioner {
    void apply(std::span<const double> r, std::span<double> z) const {
        parallel::for_each(static_cast<std::int64_t>(r.size()),
                           [&](std::int64_t i) { z[static_cast<std::size_t>(i)] = r[static_cast<std::size_t>(i)]; });
    }
};

/// Outcome of making a preconditioner from the values of a matrix.
struct SetUp {
    std::int64_t bad_row{-1};  ///< first row of blocks whose diagonal block is not positive definite
    bool is_ready() const { return bad_row < 0; }
};

}  // namespace riprap::linear
