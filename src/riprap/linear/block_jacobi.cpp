// SPDX-License-Identifier: Apache-2.0
#include "riprap/linear/block_jacobi.hpp"

#include <algorithm>
#include <limits>

#include "riprap/core/parallel.hpp"
#include "riprap/linear/small_cholesky.hpp"

namespace riprap::linear {

template <int B>
template <class IsDue>
SetUp BlockJacobi<B>::invert(const BlockCsr<B>& a, const IsDue& is_due) {
    constexpr std::size_t numbers = BlockCsr<B>::block_numbers;
    constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
    inverse_.resize(static_cast<std::size_t>(a.rows()) * numbers);
    const auto invert_one = [&](std::int64_t row) {
        if (!is_due(row)) {
            return none;
        }
        const std::int64_t entry = a.pattern().find(row, row);
        const bool is_good =
            entry >= 0 && invert_spd<B>(a.block(entry), &inverse_[static_cast<std::size_t>(row) * numbers]);
        return is_good ? none : row;
    };
    const std::int64_t bad = parallel::reduce(
        a.rows(), none, invert_one, [](std::int64_t x, std::int64_t y) { return std::min(x, y); }, 256);
    return {bad == none ? -1 : bad};
}

template <int B>
SetUp BlockJacobi<B>::set_up(const BlockCsr<B>& a) {
    return invert(a, [](std::int64_t) { return true; });
}

template <int B>
SetUp BlockJacobi<B>::update(const BlockCsr<B>& a, std::span<const std::uint8_t> is_changed) {
    return invert(a, [is_changed](std::int64_t row) { return is_changed[static_cast<std::size_t>(row)] != 0; });
}

template <int B>
void BlockJacobi<B>::apply(std::span<const double> r, std::span<double> z) const {
    const auto rows = static_cast<std::int64_t>(inverse_.size() / BlockCsr<B>::block_numbers);
    parallel::for_each(rows, [&](std::int64_t row) {
        double sum[B]{};
        add_product<B>(1, &inverse_[static_cast<std::size_t>(row) * BlockCsr<B>::block_numbers],
                       &r[static_cast<std::size_t>(row) * B], sum);
        std::copy_n(sum, B, &z[static_cast<std::size_t>(row) * B]);
    });
}

template class BlockJacobi<1>;
template class BlockJacobi<3>;
template class BlockJacobi<6>;
template class BlockJacobi<12>;

}  // namespace riprap::linear
