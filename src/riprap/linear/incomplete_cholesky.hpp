// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/linear/block_csr.hpp"
#include "riprap/linear/preconditioner.hpp"

namespace riprap::linear {

/// Incomplete Cholesky factors without fill, by ranges of rows [MeijerinkVorst1977]:
///
///     M = L D L^T on each range, L with unit diagonal blocks and the pattern of A below the diagonal.
///
/// Couplings between ranges are left out of M, so ranges are factored and solved side by side; where they are cut
/// depends on the number of rows alone, which keeps the bits. Rows that follow each other should be near each other.
/// Where a pivot is not positive definite, the diagonal of its range is taken 1 + s times, s = 0.001, 0.01, ...
/// [Manteuffel1980]; a symmetric M-matrix never needs it.
template <int B>
class IncompleteCholesky {
 public:
    /// @param range_rows  rows of blocks in a range; more converge in fewer iterations, fewer keep more threads busy
    explicit IncompleteCholesky(std::int64_t range_rows = 4096) : range_rows_(range_rows) {}

    /// Takes the values of A as they are now.
    SetUp set_up(const BlockCsr<B>& a);
    void apply(std::span<const double> r, std::span<double> z) const;

    std::int64_t shifted_ranges() const { return shifted_; }
    std::size_t bytes() const { return lower_.bytes() + bytes_of(factor_, scaled_, inverse_); }

 private:
    void take_lower_part(const BlockPattern& pattern);
    std::int64_t factor_range(const BlockCsr<B>& a, std::int64_t begin, std::int64_t end, double shift);

    std::int64_t range_rows_, rows_{0}, shifted_{0};
    BlockPattern lower_;           ///< of L, without the diagonal and what leaves the range
    std::vector<double> factor_;   ///< L
    std::vector<double> scaled_;   ///< L D, needed while factoring
    std::vector<double> inverse_;  ///< D^-1
};

extern template class IncompleteCholesky<1>;
extern template class IncompleteCholesky<3>;
extern template class IncompleteCholesky<6>;
extern template class IncompleteCholesky<12>;

}  // namespace riprap::linear
