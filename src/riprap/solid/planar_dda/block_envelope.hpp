// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "riprap/solid/planar_dda/unknowns.hpp"

namespace riprap::solid::planar_dda {

/// A symmetric positive definite matrix of 6 x 6 blocks, factorised as L L^T inside its envelope: block row i is kept
/// from its first coupling to the diagonal. Rows are ordered by reverse Cuthill-McKee, which keeps chains, stacks and
/// slopes of blocks narrow. Direct, because static steps and stiff springs make the matrix too ill-conditioned for an
/// iteration to reach the last digits. Cost: n w^2 block products for n blocks and a mean row of w.
class BlockEnvelope {
 public:
    /// Sets the pattern: `count` rows and the pairs of rows that are coupled, in any order, repeated or not.
    void set_pattern(std::int32_t count, std::span<const std::pair<std::int32_t, std::int32_t>> couplings);
    void set_zero();
    /// Adds to the diagonal block of a row.
    void add_diagonal(std::int32_t row, const Block6& block);
    /// Adds s u v^T to the block (row_u, row_v) and its transpose to (row_v, row_u); equal rows: s u v^T once.
    void add_outer(std::int32_t row_u, std::int32_t row_v, double s, const Unknowns& u, const Unknowns& v);
    /// Adds the block (row, column), by columns, of a matrix that is given whole; those above the diagonal of the
    /// envelope are left out.
    void add_block(std::int32_t row, std::int32_t column, const double* added);
    /// Factorises in place. @returns the row whose pivot is not positive, or -1
    std::int32_t factorize();
    /// x = K^-1 b after factorize(); rows as the caller numbers them.
    void solve(std::span<const Unknowns> b, std::span<Unknowns> x) const;
    /// Blocks kept, the diagonal included.
    std::int64_t stored_blocks() const { return static_cast<std::int64_t>(blocks_.size()); }

 private:
    Block6& block(std::int32_t i, std::int32_t j);
    const Block6& block(std::int32_t i, std::int32_t j) const;

    std::vector<std::int32_t> place_;  ///< of a row of the caller
    std::vector<std::int32_t> row_;    ///< the caller's row at a place
    std::vector<std::int32_t> first_;  ///< first stored column per place
    std::vector<std::int64_t> begin_;  ///< of its blocks
    std::vector<Block6> blocks_;       ///< transposed: entry (c, r) of block (i, j) at 6 c + r
};

}  // namespace riprap::solid::planar_dda
