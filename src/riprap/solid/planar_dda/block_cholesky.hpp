// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "riprap/solid/planar_dda/unknowns.hpp"

namespace riprap::solid::planar_dda {

/// A sparse symmetric positive definite matrix of 6 x 6 blocks, factorised as L L^T. Rows are eliminated by minimum
/// degree [GeorgeLiu1981, chapter 5], which keeps the factors of planar assemblies sparse: n blocks need some n log n
/// blocks of L. Direct, because static steps and stiff springs make the matrix too ill-conditioned for an iteration to
/// reach the last digits. The order is kept while the couplings stay.
class BlockCholesky {
 public:
    using Coupling = std::pair<std::int32_t, std::int32_t>;

    /// Sets the pattern: `count` rows and the pairs of rows that are coupled, in any order, repeated or not.
    void set_pattern(std::int32_t count, std::span<const Coupling> couplings);
    void set_zero();
    /// Adds to the diagonal block of a row.
    void add_diagonal(std::int32_t row, const Block6& block);
    /// Adds s u v^T to the block (row_u, row_v) and its transpose to (row_v, row_u); equal rows: s u v^T once.
    void add_outer(std::int32_t row_u, std::int32_t row_v, double s, const Unknowns& u, const Unknowns& v);
    /// Adds the block (row, column), by columns, of a matrix that is given whole; those above the diagonal of the
    /// factors are left out.
    void add_block(std::int32_t row, std::int32_t column, const double* added);
    /// Factorises in place. @returns the row whose pivot is not positive, or -1
    std::int32_t factorize();
    /// x = K^-1 b after factorize(); rows as the caller numbers them.
    void solve(std::span<const Unknowns> b, std::span<Unknowns> x) const;
    /// Blocks kept, the diagonal included.
    std::int64_t stored_blocks() const { return static_cast<std::int64_t>(blocks_.size()); }

 private:
    Block6& block(std::int32_t i, std::int32_t j);
    void subtract_column(std::int32_t p);

    std::vector<Coupling> couplings_;  ///< sorted, each once: of the order that is kept
    std::vector<std::int32_t> place_;  ///< of a row of the caller
    std::vector<std::int32_t> row_;    ///< the caller's row at a place
    std::vector<std::int64_t> begin_;  ///< of the blocks of a column, its diagonal first
    std::vector<std::int32_t> below_;  ///< place of the row of a block, ascending in each column
    std::vector<Block6> blocks_;       ///< by columns: entry (r, c) at 6 c + r
};

}  // namespace riprap::solid::planar_dda
