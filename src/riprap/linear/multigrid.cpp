// SPDX-License-Identifier: Apache-2.0
#include "riprap/linear/multigrid.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/bytes.hpp"
#include "riprap/linear/multigrid_pieces.hpp"

namespace riprap::linear {

namespace {

/// An axis is coarsened while its mean conductance is at least this share of the largest [-].
constexpr double least_share = 0.3;

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

}  // namespace

void Multigrid::set_box(Level& level, const CellBox& box) {
    level.box = box;
    const auto size = at(box.size);
    for (int a = 0; a < 3; ++a) {
        level.face[at(a)].assign(box.has_axis(a) ? size : 0, 0.0F);
        level.weight[at(a)].assign(box.has_axis(a) ? size : 0, 0.0F);
    }
    for (auto* field : {&level.inverse, &level.x, &level.b, &level.r}) {
        field->assign(size, 0.0F);
    }
}

void Multigrid::find_inverse(Level& level) {
    for_rows(level.box, [&](std::int64_t start, std::int64_t) {
        for (std::int64_t i = start; i < start + level.box.cells[0]; ++i) {
            float sum = 0;
            for (int a = 0; a < level.box.axes; ++a) {
                sum += level.face[at(a)][at(i)] + level.face[at(a)][at(i + level.box.stride[at(a)])];
            }
            level.inverse[at(i)] = sum > 0 ? 1 / sum : 0;
        }
    });
}

std::array<bool, 3> Multigrid::axes_to_coarsen(const Level& level) {
    std::array<double, 3> mean{};
    for (int a = 0; a < level.box.axes; ++a) {
        if (level.box.cells[at(a)] < 2) {
            continue;
        }
        const auto sum_row = [&](std::int64_t start, std::int64_t) {
            double sum = 0;
            for (std::int64_t i = start; i < start + level.box.cells[0]; ++i) {
                sum += level.face[at(a)][at(i)];
            }
            return sum;
        };
        mean[at(a)] = sum_rows(level.box, sum_row);
    }
    const double largest = std::max({mean[0], mean[1], mean[2]});
    std::array<bool, 3> which{};
    for (std::size_t a = 0; a < 3; ++a) {
        which[a] = largest > 0 && mean[a] >= least_share * largest;
    }
    return which;
}

namespace {

/// Weight of the coarse neighbour in a fine cell, of conductances c: `own` leads to the other fine cell of the own
/// coarse one, `out` to the neighbour, `beyond` on to its other fine cell.
inline float weight_of(float own, float out, float beyond, bool neighbour_has_pair) {
    const float far = neighbour_has_pair ? (beyond > 0 ? 0.5F / beyond : 1e30F) : 0.0F;
    return own > 0 && out > 0 ? 1 / (1 + 2 * own * (1 / out + far)) : 0.0F;
}

/// Weights across a row's own axis: cells are the lower and the upper one of their coarse cell in turn.
void weights_along(const float* c, int n, float* weight) {
#pragma GCC ivdep
    for (int i = 0; i + 1 < n; i += 2) {
        weight[i] = weight_of(c[i + 1], c[i], c[i - 1], true);
        weight[i + 1] = weight_of(c[i + 1], c[i + 2], c[i + 3], i + 3 < n);
    }
    weight[0] = weight[n - 1] = 0;  // nothing beyond the ends, or no partner in the own coarse cell
}

/// Weights across another axis, of a row at place p of n.
void weights_beside(const float* c, std::int64_t s, int p, int n, int count, float* weight) {
    const bool is_lower = p % 2 == 0;
    const bool has_both = (is_lower ? p + 1 < n && p > 0 : p + 1 < n), has_pair = is_lower || p + 2 < n;
    const float* const own = is_lower ? c + s : c;
    const float* const out = is_lower ? c : c + s;
    const float* const beyond = is_lower ? c - s : has_pair ? c + 2 * s : c;
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const float found = weight_of(own[i], out[i], beyond[i], has_pair);
        weight[i] = has_both ? found : 0.0F;
    }
}

/// Scales the weights of cells that have more than 1 in all to a sum of 1: a cell in a corner of the air that faces
/// coarse cells of air on two sides and water in its own gets the mean of the air, not twice it less the water.
void share_weights(const CellBox& box, const std::array<bool, 3>& coarsened,
                   std::array<std::vector<float>, 3>& weight) {
    std::array<float*, 3> w{};
    std::size_t used = 0;
    for (std::size_t a = 0; a < 3; ++a) {
        if (coarsened[a]) {
            w[used++] = weight[a].data();
        }
    }
    if (used < 2) {
        return;
    }
    for_rows(box, [&](std::int64_t start, std::int64_t) {
        float *const x = w[0] + start, *const y = w[1] + start;
        if (used == 2) {
#pragma GCC ivdep
            for (int i = 0; i < box.cells[0]; ++i) {
                const float scale = 1 / std::max(1.0F, x[i] + y[i]);
                x[i] *= scale;
                y[i] *= scale;
            }
            return;
        }
        float* const z = w[2] + start;
#pragma GCC ivdep
        for (int i = 0; i < box.cells[0]; ++i) {
            const float scale = 1 / std::max(1.0F, x[i] + y[i] + z[i]);
            x[i] *= scale;
            y[i] *= scale;
            z[i] *= scale;
        }
    });
}

/// Adds the conductances of a row of fine faces to the coarse faces that they lie on.
void add_row(const float* fine, int n, bool along, bool is_coarsened, int faces, float* coarse) {
    if (!is_coarsened) {
        for (int i = 0; i < faces; ++i) {
            coarse[i] += fine[i];
        }
    } else if (along) {
        for (int i = 0; i + 1 < faces; ++i) {
            coarse[i] += fine[2 * i];
        }
        coarse[faces - 1] += fine[n];
    } else {
        for (int i = 0; i < n / 2; ++i) {
            coarse[i] += fine[2 * i] + fine[2 * i + 1];
        }
        if (n % 2 == 1) {
            coarse[n / 2] += fine[n - 1];
        }
    }
}

}  // namespace

void Multigrid::find_weights(Level& fine) {
    for (int a = 0; a < fine.box.axes; ++a) {
        if (!fine.coarsened[at(a)]) {
            continue;
        }
        const std::int64_t s = fine.box.stride[at(a)];
        const int n = fine.box.cells[at(a)], count = fine.box.cells[0];
        for_rows(fine.box, [&](std::int64_t start, std::int64_t row) {
            const float* const c = fine.face[at(a)].data() + start;
            float* const weight = fine.weight[at(a)].data() + start;
            if (a == 0) {
                weights_along(c, n, weight);
            } else {
                const auto p = static_cast<int>(a == 1 ? row % fine.box.cells[1] : row / fine.box.cells[1]);
                weights_beside(c, s, p, n, count, weight);
            }
        });
    }
    share_weights(fine.box, fine.coarsened, fine.weight);
}

void Multigrid::coarsen(const Level& fine, Level& coarse) {
    const CellBox &box = coarse.box, &below = fine.box;
    for (int a = 0; a < box.axes; ++a) {
        std::array<int, 3> faces = box.cells;
        faces[at(a)] += 1;
        const auto find_row = [&](std::int64_t row) {
            const std::array<int, 3> place{0, static_cast<int>(row % faces[1]), static_cast<int>(row / faces[1])};
            float* const to = coarse.face[at(a)].data() + box.index(0, place[1], place[2]);
            std::fill_n(to, faces[0], 0.0F);
            std::array<int, 3> first{}, last{};  // fine rows beside each other on the coarse faces
            for (std::size_t t = 1; t < 3; ++t) {
                const bool is_wide = t != at(a) && fine.coarsened[t];
                first[t] = fine.coarsened[t] ? std::min(2 * place[t], below.cells[t]) : place[t];
                last[t] = is_wide ? std::min(first[t] + 1, below.cells[t] - 1) : first[t];
            }
            for (int k = first[2]; k <= last[2]; ++k) {
                for (int j = first[1]; j <= last[1]; ++j) {
                    add_row(fine.face[at(a)].data() + below.index(0, j, k), below.cells[0], a == 0, fine.coarsened[0],
                            faces[0], to);
                }
            }
            if (!fine.coarsened[at(a)]) {
                return;
            }
            const int n = below.cells[at(a)];
            const float across = a == 0 ? 2.0F : distance_across(first[at(a)], n);
            for (int i = 0; i < faces[0]; ++i) {
                to[i] *= 1 / across;
            }
            if (a == 0) {
                for (int i = std::max(0, faces[0] - 2); i < faces[0]; ++i) {
                    to[i] *= 2 / distance_across(std::min(2 * i, n), n);
                }
            }
        };
        parallel::for_ranges(static_cast<std::int64_t>(faces[1]) * faces[2], box.row_grain(),
                             [&](std::int64_t begin, std::int64_t end) {
                                 for (std::int64_t row = begin; row < end; ++row) {
                                     find_row(row);
                                 }
                             });
    }
}

void Multigrid::build(const FaceConductance& fine) {
    if (levels_.empty()) {
        levels_.emplace_back();
    }
    if (levels_[0].box.size != fine.box.size || levels_[0].box.cells != fine.box.cells) {
        set_box(levels_[0], fine.box);
    }
    double largest = 0;  // single precision reaches far, but units are the caller's
    for (const auto& face : fine.face) {
        for (const double c : face) {
            largest = std::max(largest, c);
        }
    }
    scale_ = largest > 0 ? 1 / largest : 1;
    for (int a = 0; a < fine.box.axes; ++a) {
        auto& to = levels_[0].face[at(a)];
        const auto& from = fine.face[at(a)];
        parallel::for_each(fine.box.size,
                           [&](std::int64_t i) { to[at(i)] = static_cast<float>(scale_ * from[at(i)]); });
    }
    level_count_ = 1;
    for (;;) {
        Level& level = levels_[level_count_ - 1];
        find_inverse(level);
        level.coarsened = axes_to_coarsen(level);
        const bool any = level.coarsened[0] || level.coarsened[1] || level.coarsened[2];
        if (!any || level.box.cell_count() <= coarsest_cells) {
            level.coarsened = {};
            if (level.box.cell_count() <= coarsest_cells) {
                factorise_level(level.box, level.face, level.r);  // which has no residual to hold
            }
            return;
        }
        find_weights(level);
        std::array<int, 3> cells = level.box.cells;
        for (std::size_t a = 0; a < 3; ++a) {
            cells[a] = level.coarsened[a] ? (cells[a] + 1) / 2 : cells[a];
        }
        const CellBox box(cells, 1, level.box.axes);
        if (levels_.size() == level_count_) {
            levels_.emplace_back();
        }
        Level& next = levels_[level_count_];
        if (next.box.cells != box.cells || next.box.size != box.size) {
            set_box(next, box);
        }
        const Level& fine_level = levels_[level_count_ - 1];  // the list may have moved
        coarsen(fine_level, next);
        part_pieces(fine_level.box, fine_level.face, fine_level.inverse, fine_level.coarsened, next.box, next.face);
        ++level_count_;
    }
}

std::size_t Multigrid::bytes() const {
    std::size_t sum = 0;
    for (const Level& level : levels_) {
        sum += bytes_of(level.inverse, level.x, level.b, level.r);
        for (std::size_t a = 0; a < 3; ++a) {
            sum += bytes_of(level.face[a], level.weight[a]);
        }
    }
    return sum;
}

std::size_t PoissonSolver::bytes() const { return multigrid_.bytes() + bytes_of(work_.r, work_.d, work_.q); }

}  // namespace riprap::linear
