// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/linear/block_pattern.hpp"
#include "riprap/linear/huge_pages.hpp"

namespace riprap::linear {

/// A square matrix of B x B blocks with a fixed pattern, whose values are filled anew as often as needed:
///
///     y_i = sum_j A_ij x_j,      x_i, y_i of B numbers each.
///
/// Symmetric matrices are stored whole: rows gather, so any thread may take any row and the bits stay the same, and
/// nothing is scattered. Numbers of a block are stored by columns, so that a block times a vector is B updates of the
/// whole sum. For B = 1, 3, 6, 12.
template <int B>
class BlockCsr {
 public:
    static constexpr int block_size = B;
    static constexpr std::size_t block_numbers = static_cast<std::size_t>(B) * B;

    BlockCsr() = default;
    explicit BlockCsr(BlockPattern pattern) { set_pattern(std::move(pattern)); }

    /// Takes a pattern; all values are zero afterwards.
    void set_pattern(BlockPattern pattern);
    void set_zero();

    const BlockPattern& pattern() const { return pattern_; }
    std::int64_t rows() const { return pattern_.rows(); }                      ///< of blocks
    std::size_t size() const { return static_cast<std::size_t>(rows()) * B; }  ///< length of a vector

    /// The B x B numbers of an entry of the pattern, column by column.
    double* block(std::int64_t entry) { return &value_[static_cast<std::size_t>(entry) * block_numbers]; }
    const double* block(std::int64_t entry) const { return &value_[static_cast<std::size_t>(entry) * block_numbers]; }
    double& at(std::int64_t entry, int row, int column) { return block(entry)[column * B + row]; }
    double at(std::int64_t entry, int row, int column) const { return block(entry)[column * B + row]; }

    /// y = A x
    void multiply(std::span<const double> x, std::span<double> y) const;

    /// Bytes that multiply() moves through memory at least: values, columns and starts once, x and y once.
    double bytes_per_product() const;
    std::size_t bytes() const { return pattern_.bytes() + value_.capacity() * sizeof(double); }

 private:
    BlockPattern pattern_;
    StreamVector<double> value_;
};

extern template class BlockCsr<1>;
extern template class BlockCsr<3>;
extern template class BlockCsr<6>;
extern template class BlockCsr<12>;

}  // namespace riprap::linear
