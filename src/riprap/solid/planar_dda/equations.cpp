// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/equations.hpp"

#include <array>

#include "riprap/core/index.hpp"

namespace riprap::solid::planar_dda {

namespace {

constexpr linear::PcgSettings to_round_off{1e-12, 0, 200};

void add_block(double* target, const Block6& block) {
    for (std::size_t k = 0; k < 36; ++k) {
        target[k] += block[k];
    }
}

/// A += s u v^T, A by columns.
void add_product(double* a, double s, const Unknowns& u, const Unknowns& v) {
    for (std::size_t c = 0; c < 6; ++c) {
        for (std::size_t r = 0; r < 6; ++r) {
            a[6 * c + r] += s * u[r] * v[c];
        }
    }
}

linear::BlockPattern pattern_of(std::int32_t count, std::span<const std::pair<std::int32_t, std::int32_t>> couplings) {
    std::vector<std::array<std::int32_t, 2>> pairs;
    pairs.reserve(couplings.size());
    for (const auto& [a, b] : couplings) {
        if (a != b) {
            pairs.push_back({a, b});
        }
    }
    return linear::symmetric_pattern(count, pairs);
}

}  // namespace

void Equations::set_pattern(std::int32_t count, std::span<const std::pair<std::int32_t, std::int32_t>> couplings,
                            Way way) {
    way_ = way;
    if (way == Way::direct) {
        factors_.set_pattern(count, couplings);
    } else {
        couplings_.assign(couplings.begin(), couplings.end());
        rows_.set_pattern(pattern_of(count, couplings));
    }
}

void Equations::set_zero() {
    if (way_ == Way::direct) {
        factors_.set_zero();
    } else {
        rows_.set_zero();
    }
}

void Equations::add_diagonal(std::int32_t row, const Block6& block) {
    if (way_ == Way::direct) {
        factors_.add_diagonal(row, block);
    } else {
        add_block(rows_.block(rows_.pattern().find(row, row)), block);
    }
}

void Equations::add_outer(std::int32_t row_u, std::int32_t row_v, double s, const Unknowns& u, const Unknowns& v) {
    if (way_ == Way::direct) {
        factors_.add_outer(row_u, row_v, s, u, v);
        return;
    }
    add_product(rows_.block(rows_.pattern().find(row_u, row_v)), s, u, v);
    if (row_u != row_v) {
        add_product(rows_.block(rows_.pattern().find(row_v, row_u)), s, v, u);
    }
}

std::int32_t Equations::prepare() {
    if (way_ == Way::direct) {
        return factors_.factorize();
    }
    is_factorized_ = false;
    return preconditioner_.set_up(rows_).is_ready() ? -1 : factorize_rows();
}

std::int32_t Equations::solve(std::span<const Unknowns> b, std::span<Unknowns> x) {
    if (way_ == Way::iterative && !is_factorized_) {
        const auto copy = [](std::span<const Unknowns> from, std::vector<double>& to) {
            to.clear();
            for (const Unknowns& row : from) {
                to.insert(to.end(), row.begin(), row.end());
            }
        };
        copy(b, right_);
        copy(x, solution_);
        if (solve_pcg(rows_, preconditioner_, right_, solution_, to_round_off, buffers_).is_converged()) {
            for (std::size_t k = 0; k < solution_.size(); ++k) {
                x[k / 6][k % 6] = solution_[k];
            }
            return -1;
        }
        if (const std::int32_t row = factorize_rows(); row >= 0) {
            return row;
        }
    }
    factors_.solve(b, x);
    return -1;
}

std::int32_t Equations::factorize_rows() {
    factors_.set_pattern(static_cast<std::int32_t>(rows_.rows()), couplings_);
    factors_.set_zero();
    for (std::int32_t row = 0; row < static_cast<std::int32_t>(rows_.rows()); ++row) {
        for (std::int64_t e = rows_.pattern().first(row); e < rows_.pattern().end(row); ++e) {
            factors_.add_block(row, rows_.pattern().column_of(e), rows_.block(e));
        }
    }
    is_factorized_ = true;
    return factors_.factorize();
}

}  // namespace riprap::solid::planar_dda
