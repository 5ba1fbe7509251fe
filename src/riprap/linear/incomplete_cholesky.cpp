// SPDX-License-Identifier: Apache-2.0
#include "riprap/linear/incomplete_cholesky.hpp"

#include <algorithm>

#include "riprap/core/parallel.hpp"
#include "riprap/linear/small_cholesky.hpp"

namespace riprap::linear {
namespace {

template <int B>
const double* block_at(const std::vector<double>& blocks, std::int64_t entry) {
    return &blocks[static_cast<std::size_t>(entry) * BlockCsr<B>::block_numbers];
}
template <int B>
double* block_at(std::vector<double>& blocks, std::int64_t entry) {
    return &blocks[static_cast<std::size_t>(entry) * BlockCsr<B>::block_numbers];
}

/// out += sign a b^T
template <int B>
void add_outer(double sign, const double* a, const double* b, double* out) {
    for (int c = 0; c < B; ++c) {
        for (int k = 0; k < B; ++k) {
            const double factor = sign * b[k * B + c];
            for (int r = 0; r < B; ++r) {
                out[c * B + r] += factor * a[k * B + r];
            }
        }
    }
}

/// out = a b for symmetric b
template <int B>
void multiply_symmetric(const double* a, const double* b, double* out) {
    std::fill_n(out, B * B, 0.0);
    add_outer<B>(1, a, b, out);
}

}  // namespace

template <int B>
void IncompleteCholesky<B>::take_lower_part(const BlockPattern& pattern) {
    rows_ = pattern.rows();
    const auto count_of = [&](std::int64_t row) {
        const std::int64_t begin = row / range_rows_ * range_rows_;
        const auto low = pattern.column.begin() + pattern.first(row), high = pattern.column.begin() + pattern.end(row);
        const auto first = std::lower_bound(low, high, begin);
        return std::pair{first, std::lower_bound(first, high, row) - first};
    };
    lower_.start.assign(static_cast<std::size_t>(rows_) + 1, 0);
    parallel::for_each(rows_,
                       [&](std::int64_t row) { lower_.start[static_cast<std::size_t>(row)] = count_of(row).second; });
    parallel::exclusive_scan<std::int64_t>(lower_.start, lower_.start);
    lower_.column.resize(static_cast<std::size_t>(lower_.start.back()));
    parallel::for_each(rows_, [&](std::int64_t row) {
        const auto [first, count] = count_of(row);
        std::copy_n(first, count, lower_.column.begin() + lower_.first(row));
    });
}

/// Factors rows [begin, end); returns the first row whose pivot is not positive definite, or end. Row by row, with U =
/// L D and sums over the columns j < k that rows i and k share:
///
///     U_ik = A_ik - sum U_ij L_kj^T,    L_ik = U_ik D_k^-1,    D_i = A_ii - sum_k L_ik U_ik^T.
template <int B>
std::int64_t IncompleteCholesky<B>::factor_range(const BlockCsr<B>& a, std::int64_t begin, std::int64_t end,
                                                 double shift) {
    constexpr std::size_t numbers = BlockCsr<B>::block_numbers;
    for (std::int64_t i = begin; i < end; ++i) {
        const std::int64_t diagonal = a.pattern().find(i, i);
        if (diagonal < 0) {
            return i;
        }
        const std::int64_t first = lower_.first(i), last = lower_.end(i);
        // the lower entries of A's row follow each other and end before the diagonal
        const std::int64_t in_a = diagonal - (last - first);
        double pivot[numbers];
        std::copy_n(a.block(diagonal), numbers, pivot);
        for (int c = 0; c < B; ++c) {
            pivot[c * B + c] *= 1 + shift;
        }
        for (std::int64_t e = first; e < last; ++e) {
            const std::int64_t k = lower_.column_of(e);
            double* const scaled = block_at<B>(scaled_, e);
            std::copy_n(a.block(in_a + (e - first)), numbers, scaled);
            for (std::int64_t ei = first, ek = lower_.first(k); ei < e && ek < lower_.end(k);) {
                const std::int32_t ci = lower_.column_of(ei), ck = lower_.column_of(ek);
                if (ci == ck) {
                    add_outer<B>(-1, block_at<B>(scaled_, ei), block_at<B>(factor_, ek), scaled);
                }
                ei += ci <= ck ? 1 : 0;
                ek += ck <= ci ? 1 : 0;
            }
            multiply_symmetric<B>(scaled, block_at<B>(inverse_, k), block_at<B>(factor_, e));
            add_outer<B>(-1, block_at<B>(factor_, e), scaled, pivot);
        }
        if (!invert_spd<B>(pivot, block_at<B>(inverse_, i))) {
            return i;
        }
    }
    return end;
}

template <int B>
SetUp IncompleteCholesky<B>::set_up(const BlockCsr<B>& a) {
    take_lower_part(a.pattern());
    constexpr std::size_t numbers = BlockCsr<B>::block_numbers;
    factor_.resize(lower_.column.size() * numbers);
    scaled_.resize(factor_.size());
    inverse_.resize(static_cast<std::size_t>(rows_) * numbers);
    struct Result {
        std::int64_t bad_row{-1}, shifted{0};
    };
    const auto factor_one = [&](std::int64_t range) {
        const std::int64_t begin = range * range_rows_, end = std::min(rows_, begin + range_rows_);
        std::int64_t reached = factor_range(a, begin, end, 0);
        std::int64_t is_shifted = 0;
        for (double shift = 1e-3; reached < end && shift < 20; shift *= 10) {
            is_shifted = 1;
            reached = factor_range(a, begin, end, shift);
        }
        return Result{reached < end ? reached : -1, is_shifted};
    };
    const auto fold = [](Result x, Result y) {
        return Result{x.bad_row >= 0 ? x.bad_row : y.bad_row, x.shifted + y.shifted};
    };
    const Result result = parallel::reduce((rows_ + range_rows_ - 1) / range_rows_, Result{}, factor_one, fold, 1);
    shifted_ = result.shifted;
    return {result.bad_row};
}

template <int B>
void IncompleteCholesky<B>::apply(std::span<const double> r, std::span<double> z) const {
    const auto at = [&](std::int64_t row) { return &z[static_cast<std::size_t>(row) * B]; };
    const auto solve_range = [&](std::int64_t range) {
        const std::int64_t begin = range * range_rows_, end = std::min(rows_, begin + range_rows_);
        for (std::int64_t i = begin; i < end; ++i) {
            double y[B];
            std::copy_n(&r[static_cast<std::size_t>(i) * B], B, y);
            for (std::int64_t e = lower_.first(i); e < lower_.end(i); ++e) {
                add_product<B>(-1, block_at<B>(factor_, e), at(lower_.column_of(e)), y);
            }
            std::copy_n(y, B, at(i));
        }
        // backwards: row i is final before it is taken from the rows above it
        for (std::int64_t i = begin; i < end; ++i) {
            double y[B]{};
            add_product<B>(1, block_at<B>(inverse_, i), at(i), y);
            std::copy_n(y, B, at(i));
        }
        for (std::int64_t i = end; i-- > begin;) {
            for (std::int64_t e = lower_.first(i); e < lower_.end(i); ++e) {
                add_transposed_product<B>(-1, block_at<B>(factor_, e), at(i), at(lower_.column_of(e)));
            }
        }
    };
    parallel::for_each_uneven((rows_ + range_rows_ - 1) / range_rows_, 1, solve_range);
}

template class IncompleteCholesky<1>;
template class IncompleteCholesky<3>;
template class IncompleteCholesky<6>;
template class IncompleteCholesky<12>;

}  // namespace riprap::linear
