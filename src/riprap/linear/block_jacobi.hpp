// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/linear/block_csr.hpp"
#include "riprap/linear/preconditioner.hpp"

namespace riprap::linear {

/// M = the diagonal blocks of A: z_i = A_ii^-1 r_i. Rids block systems of the units that unknowns of one block differ
/// in.
template <int B>
class BlockJacobi {
 public:
    /// Takes the values of A as they are now.
    SetUp set_up(const BlockCsr<B>& a);
    /// Takes the values of the flagged rows, the only ones that have changed since the last call.
    SetUp update(const BlockCsr<B>& a, std::span<const std::uint8_t> is_changed);
    void apply(std::span<const double> r, std::span<double> z) const;
    std::size_t bytes() const { return bytes_of(inverse_); }

 private:
    template <class IsDue>
    SetUp invert(const BlockCsr<B>& a, const IsDue& is_due);

    std::vector<double> inverse_;  ///< of the diagonal blocks
};

extern template class BlockJacobi<1>;
extern template class BlockJacobi<3>;
extern template class BlockJacobi<6>;
extern template class BlockJacobi<12>;

}  // namespace riprap::linear
