// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/block_envelope.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"

namespace riprap::solid::planar_dda {

namespace {

struct Graph {
    std::vector<std::int32_t> begin, neighbor;
    std::int32_t degree(std::int32_t i) const { return begin[at(i + 1)] - begin[at(i)]; }
};

Graph graph_of(std::int32_t count, std::span<const std::pair<std::int32_t, std::int32_t>> couplings) {
    std::vector<std::pair<std::int32_t, std::int32_t>> both;
    both.reserve(2 * couplings.size());
    for (const auto& [a, b] : couplings) {
        if (a != b) {
            both.emplace_back(a, b);
            both.emplace_back(b, a);
        }
    }
    std::sort(both.begin(), both.end());
    both.erase(std::unique(both.begin(), both.end()), both.end());
    Graph graph;
    graph.begin.assign(at(count + 1), 0);
    for (const auto& [a, b] : both) {
        ++graph.begin[at(a + 1)];
        graph.neighbor.push_back(b);
    }
    for (std::int32_t i = 0; i < count; ++i) {
        graph.begin[at(i + 1)] += graph.begin[at(i)];
    }
    return graph;
}

/// Appends the rows reachable from `start`, breadth first, neighbours by degree; returns the last one.
std::int32_t append_levels(const Graph& graph, std::int32_t start, std::vector<std::uint8_t>& is_placed,
                           std::vector<std::int32_t>& order) {
    std::size_t next = order.size();
    order.push_back(start);
    is_placed[at(start)] = 1;
    std::vector<std::int32_t> around;
    for (; next < order.size(); ++next) {
        const std::int32_t i = order[next];
        around.clear();
        for (std::int32_t k = graph.begin[at(i)]; k < graph.begin[at(i + 1)]; ++k) {
            const std::int32_t j = graph.neighbor[at(k)];
            if (!is_placed[at(j)]) {
                is_placed[at(j)] = 1;
                around.push_back(j);
            }
        }
        std::sort(around.begin(), around.end(), [&graph](std::int32_t a, std::int32_t b) {
            return graph.degree(a) < graph.degree(b) || (graph.degree(a) == graph.degree(b) && a < b);
        });
        order.insert(order.end(), around.begin(), around.end());
    }
    return order.back();
}

/// Reverse Cuthill-McKee; every part of the graph begins at the far end of a first walk through it.
std::vector<std::int32_t> narrow_order(const Graph& graph, std::int32_t count) {
    std::vector<std::int32_t> order;
    std::vector<std::uint8_t> is_placed(at(count), 0);
    for (std::int32_t seed = 0; seed < count; ++seed) {
        if (is_placed[at(seed)]) {
            continue;
        }
        const std::size_t begin = order.size();
        const std::int32_t far_end = append_levels(graph, seed, is_placed, order);
        for (std::size_t k = begin; k < order.size(); ++k) {
            is_placed[at(order[k])] = 0;
        }
        order.resize(begin);
        append_levels(graph, far_end, is_placed, order);
    }
    std::reverse(order.begin(), order.end());
    return order;
}

/// C -= A B^T of blocks kept transposed.
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

/// Replaces the lower triangle of a diagonal block (kept transposed) by its Cholesky factor.
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

}  // namespace

Block6& BlockEnvelope::block(std::int32_t i, std::int32_t j) { return blocks_[at(begin_[at(i)] + j - first_[at(i)])]; }
const Block6& BlockEnvelope::block(std::int32_t i, std::int32_t j) const {
    return blocks_[at(begin_[at(i)] + j - first_[at(i)])];
}

void BlockEnvelope::set_pattern(std::int32_t count, std::span<const std::pair<std::int32_t, std::int32_t>> couplings) {
    row_ = narrow_order(graph_of(count, couplings), count);
    place_.resize(at(count));
    first_.resize(at(count));
    begin_.resize(at(count));
    for (std::int32_t p = 0; p < count; ++p) {
        place_[at(row_[at(p)])] = p;
        first_[at(p)] = p;
    }
    for (const auto& [a, b] : couplings) {
        const std::int32_t low = std::min(place_[at(a)], place_[at(b)]), high = std::max(place_[at(a)], place_[at(b)]);
        first_[at(high)] = std::min(first_[at(high)], low);
    }
    std::int64_t total = 0;
    for (std::int32_t p = 0; p < count; ++p) {
        begin_[at(p)] = total;
        total += p - first_[at(p)] + 1;
    }
    blocks_.resize(at(total));
}

void BlockEnvelope::set_zero() { std::fill(blocks_.begin(), blocks_.end(), Block6{}); }

void BlockEnvelope::add_diagonal(std::int32_t row, const Block6& added) {
    Block6& d = block(place_[at(row)], place_[at(row)]);
    for (std::size_t k = 0; k < 36; ++k) {
        d[k] += added[k];  // symmetric
    }
}

void BlockEnvelope::add_outer(std::int32_t row_u, std::int32_t row_v, double s, const Unknowns& u, const Unknowns& v) {
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

void BlockEnvelope::add_block(std::int32_t row, std::int32_t column, const double* added) {
    const std::int32_t i = place_[at(row)], j = place_[at(column)];
    if (i >= j) {
        Block6& target = block(i, j);
        for (std::size_t k = 0; k < 36; ++k) {
            target[k] += added[k];
        }
    }
}

std::int32_t BlockEnvelope::factorize() {
    const auto count = static_cast<std::int32_t>(row_.size());
    for (std::int32_t i = 0; i < count; ++i) {
        for (std::int32_t j = first_[at(i)]; j <= i; ++j) {
            Block6& c = block(i, j);
            for (std::int32_t k = std::max(first_[at(i)], first_[at(j)]); k < j; ++k) {
                subtract_product(c, block(i, k), block(j, k));
            }
            if (j < i) {
                divide_by_factor(c, block(j, j));
            } else if (!factorize_diagonal(c)) {
                return row_[at(i)];
            }
        }
    }
    return -1;
}

void BlockEnvelope::solve(std::span<const Unknowns> b, std::span<Unknowns> x) const {
    const auto count = static_cast<std::int32_t>(row_.size());
    std::vector<Unknowns> y(at(count));
    for (std::int32_t i = 0; i < count; ++i) {
        Unknowns sum = b[at(row_[at(i)])];
        for (std::int32_t j = first_[at(i)]; j < i; ++j) {
            const Block6& l = block(i, j);
            for (std::size_t c = 0; c < 6; ++c) {
                for (std::size_t r = 0; r < 6; ++r) {
                    sum[r] -= l[6 * c + r] * y[at(j)][c];
                }
            }
        }
        const Block6& d = block(i, i);
        for (std::size_t c = 0; c < 6; ++c) {
            sum[c] /= d[6 * c + c];
            for (std::size_t r = c + 1; r < 6; ++r) {
                sum[r] -= d[6 * c + r] * sum[c];
            }
        }
        y[at(i)] = sum;
    }
    for (std::int32_t i = count - 1; i >= 0; --i) {
        Unknowns& z = y[at(i)];
        const Block6& d = block(i, i);
        for (std::size_t c = 6; c-- > 0;) {
            for (std::size_t r = c + 1; r < 6; ++r) {
                z[c] -= d[6 * c + r] * z[r];
            }
            z[c] /= d[6 * c + c];
        }
        for (std::int32_t j = first_[at(i)]; j < i; ++j) {
            const Block6& l = block(i, j);
            for (std::size_t c = 0; c < 6; ++c) {
                for (std::size_t r = 0; r < 6; ++r) {
                    y[at(j)][c] -= l[6 * c + r] * z[r];
                }
            }
        }
        x[at(row_[at(i)])] = z;
    }
}

}  // namespace riprap::solid::planar_dda
