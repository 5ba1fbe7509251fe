// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/block_cholesky.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "riprap/core/index.hpp"

namespace riprap::solid::planar_dda {

namespace {

using Rows = std::vector<std::int32_t>;

/// Order of elimination, and the rows that each eliminated row is coupled to then.
struct Elimination {
    Rows order;
    std::vector<Rows> coupled;  ///< per row of the caller
};

/// Makes the neighbours of `row`, which is eliminated, neighbours of each other.
void connect_neighbors(std::int32_t row, std::vector<Rows>& neighbors, Rows& merged) {
    const Rows& fan = neighbors[at(row)];
    for (const std::int32_t i : fan) {
        merged.clear();
        std::set_union(neighbors[at(i)].begin(), neighbors[at(i)].end(), fan.begin(), fan.end(),
                       std::back_inserter(merged));
        std::erase_if(merged, [i, row](std::int32_t j) { return j == i || j == row; });
        neighbors[at(i)] = merged;
    }
}

/// Eliminates a row with the fewest neighbours at a time; of several, the first.
Elimination eliminate_by_degree(std::int32_t count, std::span<const BlockCholesky::Coupling> couplings) {
    Elimination result;
    result.coupled.resize(at(count));
    for (const auto& [a, b] : couplings) {
        result.coupled[at(a)].push_back(b);
        result.coupled[at(b)].push_back(a);
    }
    std::set<std::pair<std::size_t, std::int32_t>> waiting;
    for (std::int32_t i = 0; i < count; ++i) {
        std::sort(result.coupled[at(i)].begin(), result.coupled[at(i)].end());
        waiting.emplace(result.coupled[at(i)].size(), i);
    }
    Rows merged;
    while (!waiting.empty()) {
        const std::int32_t row = waiting.begin()->second;
        waiting.erase(waiting.begin());
        result.order.push_back(row);
        const Rows& fan = result.coupled[at(row)];
        for (const std::int32_t i : fan) {
            waiting.erase({result.coupled[at(i)].size(), i});
        }
        connect_neighbors(row, result.coupled, merged);
        for (const std::int32_t i : fan) {
            waiting.emplace(result.coupled[at(i)].size(), i);
        }
    }
    return result;
}

/// C -= A B^T.
inline void subtract_product(Block6& c, const Block6& a, const Block6& b) {
    for (std::size_t k = 0; k < 6; ++k) {
        for (std::size_t s = 0; s < 6; ++s) {
            const double factor = b[6 * k + s];
            for (std::size_t r = 0; r < 6; ++r) {
                c[6 * s + r] -= factor * a[6 * k + r];
            }
        }
    }
}

/// Replaces the lower triangle of a diagonal block by its Cholesky factor.
bool factorize_diagonal(Block6& d) {
    const Block6 before = d;
    for (std::size_t j = 0; j < 6; ++j) {
        double pivot = d[6 * j + j];
        for (std::size_t k = 0; k < j; ++k) {
            pivot -= d[6 * k + j] * d[6 * k + j];
        }
        if (!(pivot > 1e-14 * std::abs(before[6 * j + j]))) {
            return false;
        }
        d[6 * j + j] = std::sqrt(pivot);
        for (std::size_t i = j + 1; i < 6; ++i) {
            double sum = d[6 * j + i];
            for (std::size_t k = 0; k < j; ++k) {
                sum -= d[6 * k + i] * d[6 * k + j];
            }
            d[6 * j + i] = sum / d[6 * j + j];
        }
    }
    return true;
}

/// A <- A L^-T with the factor of a diagonal block.
void divide_by_factor(Block6& a, const Block6& factor) {
    for (std::size_t c = 0; c < 6; ++c) {
        for (std::size_t k = 0; k < c; ++k) {
            const double l = factor[6 * k + c];
            for (std::size_t r = 0; r < 6; ++r) {
                a[6 * c + r] -= l * a[6 * k + r];
            }
        }
        const double inverse = 1 / factor[6 * c + c];
        for (std::size_t r = 0; r < 6; ++r) {
            a[6 * c + r] *= inverse;
        }
    }
}

/// x <- L^-1 x.
void solve_lower(const Block6& l, Unknowns& x) {
    for (std::size_t c = 0; c < 6; ++c) {
        x[c] /= l[6 * c + c];
        for (std::size_t r = c + 1; r < 6; ++r) {
            x[r] -= l[6 * c + r] * x[c];
        }
    }
}

/// x <- L^-T x.
void solve_upper(const Block6& l, Unknowns& x) {
    for (std::size_t c = 6; c-- > 0;) {
        for (std::size_t r = c + 1; r < 6; ++r) {
            x[c] -= l[6 * c + r] * x[r];
        }
        x[c] /= l[6 * c + c];
    }
}

}  // namespace

Block6& BlockCholesky::block(std::int32_t i, std::int32_t j) {
    const auto begin = below_.begin() + begin_[at(j)], end = below_.begin() + begin_[at(j + 1)];
    return blocks_[at(std::lower_bound(begin, end, i) - below_.begin())];
}

void BlockCholesky::set_pattern(std::int32_t count, std::span<const Coupling> couplings) {
    std::vector<Coupling> sorted;
    sorted.reserve(couplings.size());
    for (const auto& [a, b] : couplings) {
        if (a != b) {
            sorted.emplace_back(std::minmax(a, b));
        }
    }
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (row_.size() == at(count) && sorted == couplings_) {
        return;
    }
    couplings_ = std::move(sorted);
    Elimination elimination = eliminate_by_degree(count, couplings_);
    row_ = std::move(elimination.order);
    place_.resize(at(count));
    for (std::int32_t p = 0; p < count; ++p) {
        place_[at(row_[at(p)])] = p;
    }
    begin_.assign(1, 0);
    below_.clear();
    for (std::int32_t p = 0; p < count; ++p) {
        below_.push_back(p);
        const auto first = static_cast<std::ptrdiff_t>(below_.size());
        for (const std::int32_t i : elimination.coupled[at(row_[at(p)])]) {
            below_.push_back(place_[at(i)]);
        }
        std::sort(below_.begin() + first, below_.end());
        begin_.push_back(static_cast<std::int64_t>(below_.size()));
    }
    blocks_.resize(below_.size());
}

void BlockCholesky::set_zero() { std::fill(blocks_.begin(), blocks_.end(), Block6{}); }

void BlockCholesky::add_diagonal(std::int32_t row, const Block6& added) {
    Block6& d = blocks_[at(begin_[at(place_[at(row)])])];
    for (std::size_t k = 0; k < 36; ++k) {
        d[k] += added[k];  // symmetric
    }
}

void BlockCholesky::add_outer(std::int32_t row_u, std::int32_t row_v, double s, const Unknowns& u, const Unknowns& v) {
    const std::int32_t i = place_[at(row_u)], j = place_[at(row_v)];
    const Unknowns& row = i >= j ? u : v;
    const Unknowns& column = i >= j ? v : u;
    Block6& target = block(std::max(i, j), std::min(i, j));
    for (std::size_t c = 0; c < 6; ++c) {
        for (std::size_t r = 0; r < 6; ++r) {
            target[6 * c + r] += s * row[r] * column[c];
        }
    }
}

void BlockCholesky::add_block(std::int32_t row, std::int32_t column, const double* added) {
    const std::int32_t i = place_[at(row)], j = place_[at(column)];
    if (i >= j) {
        Block6& target = block(i, j);
        for (std::size_t k = 0; k < 36; ++k) {
            target[k] += added[k];
        }
    }
}

/// Takes what the finished column p contributes from all later ones: L_ip L_jp^T from the block (i, j).
void BlockCholesky::subtract_column(std::int32_t p) {
    for (std::int64_t b = begin_[at(p)] + 1; b < begin_[at(p + 1)]; ++b) {
        std::int64_t target = begin_[at(below_[at(b)])];
        for (std::int64_t a = b; a < begin_[at(p + 1)]; ++a) {
            while (below_[at(target)] != below_[at(a)]) {
                ++target;
            }
            subtract_product(blocks_[at(target)], blocks_[at(a)], blocks_[at(b)]);
        }
    }
}

std::int32_t BlockCholesky::factorize() {
    for (std::int32_t p = 0; p < static_cast<std::int32_t>(row_.size()); ++p) {
        Block6& diagonal = blocks_[at(begin_[at(p)])];
        if (!factorize_diagonal(diagonal)) {
            return row_[at(p)];
        }
        for (std::int64_t e = begin_[at(p)] + 1; e < begin_[at(p + 1)]; ++e) {
            divide_by_factor(blocks_[at(e)], diagonal);
        }
        subtract_column(p);
    }
    return -1;
}

void BlockCholesky::solve(std::span<const Unknowns> b, std::span<Unknowns> x) const {
    const auto count = static_cast<std::int32_t>(row_.size());
    std::vector<Unknowns> y(at(count));
    for (std::int32_t p = 0; p < count; ++p) {
        y[at(p)] = b[at(row_[at(p)])];
    }
    for (std::int32_t p = 0; p < count; ++p) {
        Unknowns& z = y[at(p)];
        solve_lower(blocks_[at(begin_[at(p)])], z);
        for (std::int64_t e = begin_[at(p)] + 1; e < begin_[at(p + 1)]; ++e) {
            Unknowns& target = y[at(below_[at(e)])];
            for (std::size_t c = 0; c < 6; ++c) {
                for (std::size_t r = 0; r < 6; ++r) {
                    target[r] -= blocks_[at(e)][6 * c + r] * z[c];
                }
            }
        }
    }
    for (std::int32_t p = count - 1; p >= 0; --p) {
        Unknowns& z = y[at(p)];
        for (std::int64_t e = begin_[at(p)] + 1; e < begin_[at(p + 1)]; ++e) {
            const Unknowns& known = y[at(below_[at(e)])];
            for (std::size_t c = 0; c < 6; ++c) {
                for (std::size_t r = 0; r < 6; ++r) {
                    z[c] -= blocks_[at(e)][6 * c + r] * known[r];
                }
            }
        }
        solve_upper(blocks_[at(begin_[at(p)])], z);
        x[at(row_[at(p)])] = z;
    }
}

}  // namespace riprap::solid::planar_dda
