// SPDX-License-Identifier: Apache-2.0
#include "riprap/linear/multigrid.hpp"

#include <cmath>

namespace riprap::linear {

namespace {

/// An axis is coarsened while its mean conductance is at least this share of the largest [-].
constexpr double least_share = 0.3;
/// A level of so many cells is not coarsened further.
constexpr std::int64_t coarsest_cells = 16;

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
        mean[at(a)] = reduce_rows(level.box, 0.0, sum_row, [](double x, double y) { return x + y; });
    }
    const double largest = std::max({mean[0], mean[1], mean[2]});
    std::array<bool, 3> which{};
    for (std::size_t a = 0; a < 3; ++a) {
        which[a] = largest > 0 && mean[a] >= least_share * largest;
    }
    return which;
}

void Multigrid::find_weights(Level& fine) {
    for (int a = 0; a < fine.box.axes; ++a) {
        if (!fine.coarsened[at(a)]) {
            continue;
        }
        const std::int64_t s = fine.box.stride[at(a)];
        const int n = fine.box.cells[at(a)];
        const auto& c = fine.face[at(a)];
        for_rows(fine.box, [&](std::int64_t start, std::int64_t row) {
            const std::array<int, 3> place{0, static_cast<int>(row % fine.box.cells[1]),
                                           static_cast<int>(row / fine.box.cells[1])};
            for (int x = 0; x < fine.box.cells[0]; ++x) {
                const int p = a == 0 ? x : place[at(a)];
                const std::int64_t i = start + x;
                const bool is_lower = p % 2 == 0;
                const bool has_partner = !is_lower || p + 1 < n;
                const float own = c[at(is_lower ? i + s : i)], out = c[at(is_lower ? i : i + s)];
                const bool has_neighbour = is_lower ? p > 0 : p + 1 < n;
                // the neighbour's own interior face, beyond the shared one
                const bool neighbour_has_pair = is_lower || p + 2 < n;
                const float beyond = c[at(is_lower ? i - s : i + 2 * s)];
                float weight = 0;
                if (has_partner && has_neighbour && out > 0 && own > 0) {
                    const float far = neighbour_has_pair ? (beyond > 0 ? 0.5F / beyond : 1e30F) : 0.0F;
                    const float to_neighbour = 1 / (1 / out + far), to_own = 2 * own;
                    weight = to_neighbour / (to_own + to_neighbour);
                }
                fine.weight[at(a)][at(i)] = weight;
            }
        });
    }
}

double Multigrid::coarse_conductance(const Level& fine, int axis, const std::array<int, 3>& place) {
    const CellBox& box = fine.box;
    const auto& c = fine.face[at(axis)];
    std::array<int, 3> first{}, last{};  // fine faces beside each other on the coarse face
    for (std::size_t t = 0; t < 3; ++t) {
        const bool is_wide = t != at(axis) && fine.coarsened[t];
        first[t] = fine.coarsened[t] ? std::min(2 * place[t], box.cells[t]) : place[t];
        last[t] = t == at(axis) ? first[t] : std::min(first[t] + (is_wide ? 1 : 0), box.cells[t] - 1);
    }
    double sum = 0;
    for (int k = first[2]; k <= last[2]; ++k) {
        for (int j = first[1]; j <= last[1]; ++j) {
            for (int i = first[0]; i <= last[0]; ++i) {
                sum += c[at(box.index(i, j, k))];
            }
        }
    }
    if (!fine.coarsened[at(axis)]) {
        return sum;
    }
    // distance between centres over that of the fine cells: 2, less beside a last cell without a partner
    const int p = first[at(axis)], n = box.cells[at(axis)];
    const double distance = p == n ? (n % 2 == 0 ? 2 : 1) : p + 1 == n && p > 0 ? 1.5 : 2;
    return sum / distance;
}

void Multigrid::coarsen(const Level& fine, Level& coarse) {
    const CellBox& box = coarse.box;
    for (int a = 0; a < box.axes; ++a) {
        std::array<int, 3> faces = box.cells;
        faces[at(a)] += 1;
        parallel::for_ranges(static_cast<std::int64_t>(faces[1]) * faces[2], box.row_grain(),
                             [&](std::int64_t begin, std::int64_t end) {
                                 for (std::int64_t row = begin; row < end; ++row) {
                                     const int j = static_cast<int>(row % faces[1]);
                                     const int k = static_cast<int>(row / faces[1]);
                                     for (int i = 0; i < faces[0]; ++i) {
                                         coarse.face[at(a)][at(box.index(i, j, k))] =
                                             static_cast<float>(coarse_conductance(fine, a, {i, j, k}));
                                     }
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
        coarsen(levels_[level_count_ - 1], next);
        ++level_count_;
    }
}

}  // namespace riprap::linear
