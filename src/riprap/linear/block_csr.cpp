// SPDX-License-Identifier: Apache-2.0
#include "riprap/linear/block_csr.hpp"

#include <algorithm>

#include "riprap/core/parallel.hpp"
#include "riprap/core/wide.hpp"

namespace riprap::linear {
namespace {

/// Numbers of a block's column that are worked on side by side.
template <int B>
inline constexpr std::size_t lanes = B % 4 == 0   ? 4
                                     : B % 2 == 0 ? 2
                                                  : 1;

template <int B>
[[maybe_unused]] inline constexpr std::size_t bytes_of_block = BlockCsr<B>::block_numbers * sizeof(double);

/// sum_j A_ij x_j over one row. Processors with AVX-512 are asked for large blocks four ahead, as they fetch ahead of a
/// stream to the end of a page only; those with AVX2 alone are slower if asked.
template <int B>
void multiply_row(const double* value, const std::int32_t* column, std::int64_t count, const double* x, double* y) {
    if constexpr (lanes < B >> 1) {
        using Lanes = Wide<double, lanes<B>>;
        constexpr std::size_t parts = static_cast<std::size_t>(B) / lanes<B>;
        Lanes sum[parts]{};
        for (std::int64_t k = 0; k < count; ++k) {
            const double* const v = x + std::int64_t{column[k]} * B;
            if constexpr (B == 12 && vector_bytes == 64) {
                for (std::size_t line = 0; line < bytes_of_block<B>; line += 64) {
                    __builtin_prefetch(reinterpret_cast<const char*>(value) + 4 * bytes_of_block<B> + line);
                }
            }
            for (int c = 0; c < B; ++c, value += B) {
                for (std::size_t part = 0; part < parts; ++part) {
                    sum[part] += v[c] * Lanes::load(value + part * lanes<B>);
                }
            }
        }
        for (std::size_t part = 0; part < parts; ++part) {
            sum[part].store(y + part * lanes<B>);
        }
    } else {
        // sums side by side: one alone would wait for itself
        constexpr int chains = B == 1 ? 4 : 1;
        double sum[chains][B]{};
        std::int64_t k = 0;
        for (; k + chains <= count; k += chains) {
            for (int chain = 0; chain < chains; ++chain) {
                const double* const v = x + std::int64_t{column[k + chain]} * B;
                for (int c = 0; c < B; ++c, value += B) {
                    for (int r = 0; r < B; ++r) {
                        sum[chain][r] += value[r] * v[c];
                    }
                }
            }
        }
        for (; k < count; ++k, ++value) {  // B = 1 alone gets here
            sum[0][0] += *value * x[column[k]];
        }
        for (int r = 0; r < B; ++r) {
            y[r] =
                chains == 1 ? sum[0][r] : (sum[0][r] + sum[1 % chains][r]) + (sum[2 % chains][r] + sum[3 % chains][r]);
        }
    }
}

}  // namespace

template <int B>
void BlockCsr<B>::set_pattern(BlockPattern pattern) {
    pattern_ = std::move(pattern);
    const std::size_t size = static_cast<std::size_t>(pattern_.entries()) * block_numbers;
    make_room(size, value_);
    value_.assign(size, 0.0);
}

template <int B>
void BlockCsr<B>::set_zero() {
    parallel::for_ranges(static_cast<std::int64_t>(value_.size()), 1 << 16, [&](std::int64_t begin, std::int64_t end) {
        std::fill(value_.begin() + begin, value_.begin() + end, 0.0);
    });
}

template <int B>
void BlockCsr<B>::multiply(std::span<const double> x, std::span<double> y) const {
    const std::int64_t grain = std::max<std::int64_t>(1, 2048 / B);
    parallel::for_each_uneven(rows(), grain, [&](std::int64_t row) {
        const std::int64_t first = pattern_.first(row), count = pattern_.end(row) - first;
        multiply_row<B>(value_.data() + static_cast<std::size_t>(first) * block_numbers, pattern_.column.data() + first,
                        count, x.data(), y.data() + row * B);
    });
}

template <int B>
double BlockCsr<B>::bytes_per_product() const {
    const auto per_entry = static_cast<double>(block_numbers * sizeof(double) + sizeof(std::int32_t));
    return static_cast<double>(pattern_.entries()) * per_entry +
           static_cast<double>(rows()) * (2.0 * B * sizeof(double) + sizeof(std::int64_t));
}

template class BlockCsr<1>;
template class BlockCsr<3>;
template class BlockCsr<6>;
template class BlockCsr<12>;

}  // namespace riprap::linear
