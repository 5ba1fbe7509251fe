// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "riprap/linear/multigrid.hpp"
#include "riprap/linear/multigrid_pieces.hpp"

namespace riprap::linear {

namespace {

/// Sweeps of both colours before and after each coarse correction [-].
constexpr int level_sweeps = 2;

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// Pointers to one row of a level, so that the compiler sees plain arrays.
struct Row {
    const float *cx, *cy, *cy_up, *cz, *cz_up, *inverse, *b;
    float* x;
    std::int64_t sy, sz;
};

/// x = (b + sum of c_f x_neighbour)/diagonal for every second cell of the row, beginning at `from`. Cells of one colour
/// have neighbours of the other alone, so the order within the row is free.
template <bool has_z>
void relax_row(const Row& row, int n, int from) {
    float* const x = row.x;
#pragma GCC ivdep
    for (int i = 0; i < n; ++i) {
        float sum = row.b[i] + row.cx[i] * x[i - 1] + row.cx[i + 1] * x[i + 1] + row.cy[i] * x[i - row.sy] +
                    row.cy_up[i] * x[i + row.sy];
        if constexpr (has_z) {
            sum += row.cz[i] * x[i - row.sz] + row.cz_up[i] * x[i + row.sz];
        }
        const float value = sum * row.inverse[i];
        if (((i ^ from) & 1) == 0) {
            x[i] = value;
        }
    }
}

}  // namespace

void Multigrid::smooth(Level& level, int colour) {
    const CellBox& box = level.box;
    const bool has_z = box.axes == 3;
    for_rows(box, [&](std::int64_t start, std::int64_t index) {
        const auto s = at(start), sy = at(box.stride[1]), sz = at(box.stride[2]);
        const Row row{level.face[0].data() + s,
                      level.face[1].data() + s,
                      level.face[1].data() + s + sy,
                      has_z ? level.face[2].data() + s : nullptr,
                      has_z ? level.face[2].data() + s + sz : nullptr,
                      level.inverse.data() + s,
                      level.b.data() + s,
                      level.x.data() + s,
                      box.stride[1],
                      box.stride[2]};
        const int from = static_cast<int>((index % box.cells[1] + index / box.cells[1] + colour) % 2);
        has_z ? relax_row<true>(row, box.cells[0], from) : relax_row<false>(row, box.cells[0], from);
    });
}

void Multigrid::start_smooth(Level& level) {
    // the first colour from x = 0: x = b/diagonal there, 0 elsewhere
    const CellBox& box = level.box;
    for_rows(box, [&](std::int64_t start, std::int64_t index) {
        const int from = static_cast<int>((index % box.cells[1] + index / box.cells[1]) % 2);
        for (int i = 0; i < box.cells[0]; ++i) {
            const auto p = at(start + i);
            level.x[p] = ((i ^ from) & 1) == 0 ? level.b[p] * level.inverse[p] : 0.0F;
        }
    });
    smooth(level, 1);
}

void Multigrid::find_residual(Level& level) {
    const CellBox& box = level.box;
    for_rows(box, [&](std::int64_t start, std::int64_t) {
        const float* x = level.x.data() + start;
        float* r = level.r.data() + start;
        const float *b = level.b.data() + start, *inverse = level.inverse.data() + start;
        for (int i = 0; i < box.cells[0]; ++i) {
            r[i] = b[i];
        }
        for (int a = 0; a < box.axes; ++a) {
            const std::int64_t s = box.stride[at(a)];
            const float* c = level.face[at(a)].data() + start;
#pragma GCC ivdep
            for (int i = 0; i < box.cells[0]; ++i) {
                r[i] += c[i] * (x[i - s] - x[i]) + c[i + s] * (x[i + s] - x[i]);
            }
        }
        for (int i = 0; i < box.cells[0]; ++i) {
            r[i] = inverse[i] > 0 ? r[i] : 0.0F;
        }
    });
}

namespace {

/// Sums over the fine rows of one coarse row: what stays in the own coarse cell or comes from beside the row, and what
/// cells hand over along it.
struct RowSums {
    float *own, *along;
};

}  // namespace

void Multigrid::restrict_to(const Level& fine, Level& coarse) {
    const CellBox& fb = fine.box;
    const CellBox& cb = coarse.box;
    const int n = fb.cells[0];
    const auto add_row = [&](const RowSums& sums, std::int64_t start) {
        const float* const r = fine.r.data() + start;
        std::array<const float*, 3> w{};
        for (int a = 0; a < fb.axes; ++a) {
            w[at(a)] = fine.coarsened[at(a)] ? fine.weight[at(a)].data() + start : nullptr;
        }
        for (int i = 0; i < n; ++i) {
            float share = 1;
            share -= w[0] != nullptr ? w[0][i] : 0.0F;
            share -= w[1] != nullptr ? w[1][i] : 0.0F;
            share -= w[2] != nullptr ? w[2][i] : 0.0F;
            sums.own[i] += share * r[i];
            sums.along[i] += w[0] != nullptr ? w[0][i] * r[i] : 0.0F;
        }
    };
    const auto add_beside = [&](const RowSums& sums, int a, std::int64_t start) {  // a row of the next coarse cells
        const float *r = fine.r.data() + start, *w = fine.weight[at(a)].data() + start;
        for (int i = 0; i < n; ++i) {
            sums.own[i] += w[i] * r[i];
        }
    };
    parallel::for_ranges(cb.row_count(), cb.row_grain(), [&](std::int64_t begin, std::int64_t end) {
        std::vector<float> buffer(2 * at(n) + 4);
        const RowSums sums{buffer.data() + 1, buffer.data() + n + 3};
        for (std::int64_t row = begin; row < end; ++row) {
            const std::array<int, 3> place{0, static_cast<int>(row % cb.cells[1]), static_cast<int>(row / cb.cells[1])};
            std::fill(buffer.begin(), buffer.end(), 0.0F);
            std::array<int, 3> first{}, last{};
            for (std::size_t t = 1; t < 3; ++t) {
                first[t] = fine.coarsened[t] ? 2 * place[t] : place[t];
                last[t] = fine.coarsened[t] ? std::min(first[t] + 1, fb.cells[t] - 1) : first[t];
            }
            for (int k = first[2]; k <= last[2]; ++k) {
                for (int j = first[1]; j <= last[1]; ++j) {
                    const std::int64_t start = fb.index(0, j, k);
                    add_row(sums, start);
                    for (int a = 1; a < fb.axes; ++a) {
                        if (!fine.coarsened[at(a)]) {
                            continue;
                        }
                        const int p = a == 1 ? j : k;
                        if (p == first[at(a)] && p > 0) {
                            add_beside(sums, a, start - fb.stride[at(a)]);
                        }
                        if (p == last[at(a)] && p + 1 < fb.cells[at(a)]) {
                            add_beside(sums, a, start + fb.stride[at(a)]);
                        }
                    }
                }
            }
            float* const b = coarse.b.data() + cb.row_start(row);
            if (!fine.coarsened[0]) {
                std::copy_n(sums.own, n, b);
                continue;
            }
            for (int i = 0; i < n / 2; ++i) {  // sums beyond the ends of the row are zero
                b[i] = sums.own[2 * i] + sums.own[2 * i + 1] + sums.along[2 * i - 1] + sums.along[2 * i + 2];
            }
            if (n % 2 == 1) {
                b[n / 2] = sums.own[n - 1] + sums.along[n - 2];
            }
        }
    });
}

void Multigrid::prolong(const Level& coarse, Level& fine) {
    const CellBox& fb = fine.box;
    const CellBox& cb = coarse.box;
    const int n = fb.cells[0];
    for_rows(fb, [&](std::int64_t start, std::int64_t row) {
        const std::array<int, 3> place{0, static_cast<int>(row % fb.cells[1]), static_cast<int>(row / fb.cells[1])};
        const int cj = fine.coarsened[1] ? place[1] / 2 : place[1], ck = fine.coarsened[2] ? place[2] / 2 : place[2];
        const float* const own = coarse.x.data() + cb.index(0, cj, ck);
        std::array<const float*, 3> beside{own, own, own}, w{};
        for (int a = 0; a < fb.axes; ++a) {
            if (fine.coarsened[at(a)]) {
                w[at(a)] = fine.weight[at(a)].data() + start;
                const std::int64_t s = place[at(a)] % 2 == 0 ? -cb.stride[at(a)] : cb.stride[at(a)];
                beside[at(a)] = a == 0 ? own : own + s;
            }
        }
        float* const x = fine.x.data() + start;
        const float* const inverse = fine.inverse.data() + start;
        const auto corrected = [&](int i, int c, int next) {
            float value = own[c];
            value += w[0] != nullptr ? w[0][i] * (own[next] - own[c]) : 0.0F;
            value += w[1] != nullptr ? w[1][i] * (beside[1][c] - own[c]) : 0.0F;
            value += w[2] != nullptr ? w[2][i] * (beside[2][c] - own[c]) : 0.0F;
            return x[i] + (inverse[i] > 0 ? value : 0.0F);
        };
        if (!fine.coarsened[0]) {
#pragma GCC ivdep
            for (int i = 0; i < n; ++i) {
                x[i] = corrected(i, i, i);
            }
            return;
        }
#pragma GCC ivdep
        for (int c = 0; c < n / 2; ++c) {
            x[2 * c] = corrected(2 * c, c, c - 1);
            x[2 * c + 1] = corrected(2 * c + 1, c, c + 1);
        }
        if (n % 2 == 1) {
            x[n - 1] = corrected(n - 1, n / 2, n / 2 - 1);
        }
    });
}

void Multigrid::cycle(std::size_t l) {
    Level& level = levels_[l];
    if (l + 1 == level_count_ && level.box.cell_count() <= coarsest_cells) {
        solve_factorised(level.box, level.r, level.b, level.x);
        return;
    }
    start_smooth(level);
    if (l + 1 == level_count_) {
        return;  // no face is open between any two cells: solved
    }
    Level& next = levels_[l + 1];
    for (int sweep = 1; sweep < level_sweeps; ++sweep) {
        smooth(level, 0);
        smooth(level, 1);
    }
    find_residual(level);
    restrict_to(level, next);
    cycle(l + 1);
    prolong(next, level);
    for (int sweep = 0; sweep < level_sweeps; ++sweep) {
        smooth(level, 1);
        smooth(level, 0);
    }
}

const std::vector<float>& Multigrid::apply(const std::vector<double>& r, double size, double& factor) {
    Level& finest = levels_[0];
    const double down = size > 0 ? 1 / size : 0;
    for_rows(finest.box, [&](std::int64_t start, std::int64_t) {
        for (std::int64_t i = start; i < start + finest.box.cells[0]; ++i) {
            finest.b[at(i)] = static_cast<float>(down * r[at(i)]);
        }
    });
    cycle(0);
    factor = size * scale_;
    return finest.x;
}

void Multigrid::apply(const std::vector<double>& r, std::vector<double>& z) {
    const CellBox& box = levels_[0].box;
    double factor = 0;
    const auto largest_in_row = [&](std::int64_t start, std::int64_t) {
        double largest = 0;
        for (std::int64_t i = start; i < start + box.cells[0]; ++i) {
            largest = std::max(largest, std::abs(r[at(i)]));
        }
        return largest;
    };
    const double size = reduce_rows(box, 0.0, largest_in_row, [](double a, double b) { return std::max(a, b); });
    const std::vector<float>& x = apply(r, size, factor);
    for_rows(box, [&](std::int64_t start, std::int64_t) {
        for (std::int64_t i = start; i < start + box.cells[0]; ++i) {
            z[at(i)] = factor * static_cast<double>(x[at(i)]);
        }
    });
}

}  // namespace riprap::linear
