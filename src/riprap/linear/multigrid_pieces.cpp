// SPDX-License-Identifier: Apache-2.0
#include "riprap/linear/multigrid_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace riprap::linear {

namespace {

/// Share of what the faces before and behind a face conduct, from which on it holds two cells together [-].
constexpr float least_hold = 0.1F;

constexpr std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// Fine cells of a coarse one, numbered by a bit for the place along each axis.
struct Block {
    unsigned missing{0};  ///< bits of the axes along which there is one fine cell
    std::array<std::int64_t, 8> cell{};

    Block(const CellBox& fine, const std::array<bool, 3>& coarsened, const std::array<int, 3>& place) {
        std::array<int, 3> first{};
        for (std::size_t a = 0; a < 3; ++a) {
            first[a] = coarsened[a] ? 2 * place[a] : place[a];
            missing |= coarsened[a] && first[a] + 1 < fine.cells[a] ? 0U : 1U << a;
        }
        cell[0] = fine.index(first[0], first[1], first[2]);
        for (unsigned q = 1; q < 8; ++q) {
            cell[q] =
                cell[0] + (q & 1U) * fine.stride[0] + (q >> 1U & 1U) * fine.stride[1] + (q >> 2U) * fine.stride[2];
        }
    }
    bool holds(unsigned q) const { return (q & missing) == 0; }
};

/// Most that the faces of a fine cell count, per axis, where they lead out of its coarse cell.
struct Limit {
    std::int64_t cell;
    std::array<float, 3> most;
};

/// The fine level and how it is coarsened.
struct Fine {
    const CellBox& box;
    const LevelFaces& face;
    const std::vector<float>& inverse;
    const std::array<bool, 3>& coarsened;

    /// Returns what a face conducts over the most of it and the faces before and behind it.
    float hold(int a, std::int64_t f) const {
        const float* const c = face[at(a)].data() + f;
        const std::int64_t s = box.stride[at(a)];
        return c[0] > 0 ? c[0] / std::max({c[-s], c[0], c[s]}) : 0.0F;
    }

    /// Marks the coarse cells of a row in which two fine cells are not held together.
    void mark(const CellBox& coarse, std::int64_t row, std::vector<unsigned char>& on_cells,
              unsigned char* marks) const {
        const Block start(box, coarsened,
                          {0, static_cast<int>(row % coarse.cells[1]), static_cast<int>(row / coarse.cells[1])});
        const int n = box.cells[0];
        std::fill(on_cells.begin(), on_cells.end(), static_cast<unsigned char>(0));
        for (unsigned q = 0; q < 8; q += 2) {
            if (!start.holds(q)) {
                continue;
            }
            for (int a = 0; a < box.axes; ++a) {
                const unsigned up = q | 1U << static_cast<unsigned>(a);
                if (up == q || !start.holds(up)) {
                    continue;
                }
                const std::int64_t s = box.stride[at(a)];
                const float* const c = face[at(a)].data() + start.cell[q];
                for (int i = 0; i < n; i += a == 0 ? 2 : 1) {  // along the row every second face is inside
                    on_cells[at(i)] |= static_cast<unsigned char>(c[i + s] < least_hold * std::max(c[i], c[i + 2 * s]));
                }
            }
        }
        if (!coarsened[0]) {
            std::copy_n(on_cells.data(), n, marks);
            return;
        }
        for (int i = 0; i < n / 2; ++i) {
            marks[i] = on_cells[at(2 * i)] | on_cells[at(2 * i + 1)];
        }
        if (n % 2 == 1) {
            marks[n / 2] = on_cells[at(n - 1)];
        }
    }

    /// Adds the limits of the fine cells of a coarse one that are not in its best piece.
    void add_limits(const Block& block, std::vector<Limit>& limits) const {
        std::array<unsigned, 8> piece{};
        std::iota(piece.begin(), piece.end(), 0U);
        std::array<float, 8> diagonal{};  // best of a piece, where its first cell is
        std::array<float, 3> most{};
        float weakest = 1;
        for (unsigned q = 0; q < 8; ++q) {
            if (!block.holds(q)) {
                continue;
            }
            const std::int64_t cell = block.cell[q];
            for (int a = 0; a < box.axes; ++a) {
                const std::int64_t s = box.stride[at(a)];
                most[at(a)] = std::max({most[at(a)], face[at(a)][at(cell)], face[at(a)][at(cell + s)]});
                const unsigned up = q | 1U << static_cast<unsigned>(a);
                if (up == q || !block.holds(up)) {
                    continue;
                }
                const float held = hold(a, cell + s);
                weakest = held > 0 ? std::min(weakest, held) : weakest;
                if (held >= least_hold) {
                    const auto [low, high] = std::minmax({piece[q], piece[up]});
                    std::replace(piece.begin(), piece.end(), unsigned{high}, unsigned{low});
                }
            }
        }
        for (unsigned q = 0; q < 8; ++q) {
            const float inverse_of = block.holds(q) ? inverse[at(block.cell[q])] : 0;
            diagonal[piece[q]] = std::max(diagonal[piece[q]], inverse_of > 0 ? 1 / inverse_of : 0.0F);
        }
        const auto best = static_cast<unsigned>(std::max_element(diagonal.begin(), diagonal.end()) - diagonal.begin());
        for (float& m : most) {
            m *= weakest;
        }
        for (unsigned q = 0; q < 8 && weakest < least_hold; ++q) {
            if (block.holds(q) && piece[q] != best && exceeds(block.cell[q], most)) {
                limits.push_back({block.cell[q], most});
            }
        }
    }
    bool exceeds(std::int64_t cell, const std::array<float, 3>& most) const {
        bool is_above = false;
        for (int a = 0; a < box.axes; ++a) {
            is_above =
                is_above || std::max(face[at(a)][at(cell)], face[at(a)][at(cell + box.stride[at(a)])]) > most[at(a)];
        }
        return is_above;
    }
};

}  // namespace

void part_pieces(const CellBox& fine, const LevelFaces& face, const std::vector<float>& inverse,
                 const std::array<bool, 3>& coarsened, const CellBox& coarse, LevelFaces& coarse_face) {
    const Fine level{fine, face, inverse, coarsened};
    const int n = coarse.cells[0];
    std::vector<unsigned char> marks(at(coarse.cell_count()), 0);
    parallel::for_ranges(coarse.row_count(), coarse.row_grain(), [&](std::int64_t begin, std::int64_t end) {
        std::vector<unsigned char> on_cells(at(fine.cells[0]));
        for (std::int64_t row = begin; row < end; ++row) {
            level.mark(coarse, row, on_cells, marks.data() + row * n);
        }
    });
    std::vector<Limit> limits;
    for (std::size_t m = 0; m < marks.size(); ++m) {
        if (marks[m] != 0) {
            const auto row = static_cast<std::int64_t>(m) / n;
            level.add_limits(Block(fine, coarsened,
                                   {static_cast<int>(static_cast<std::int64_t>(m) % n),
                                    static_cast<int>(row % coarse.cells[1]), static_cast<int>(row / coarse.cells[1])}),
                             limits);
        }
    }
    std::sort(limits.begin(), limits.end(), [](const Limit& x, const Limit& y) { return x.cell < y.cell; });
    const auto find = [&](std::int64_t cell) {
        const auto found = std::lower_bound(limits.begin(), limits.end(), cell,
                                            [](const Limit& limit, std::int64_t c) { return limit.cell < c; });
        return found != limits.end() && found->cell == cell ? &*found : nullptr;
    };
    for (const Limit& limit : limits) {
        std::array<int, 3> place{}, above{};
        std::int64_t rest = limit.cell;
        for (std::size_t a = 3; a-- > 0;) {
            place[a] = static_cast<int>(rest / fine.stride[a]) - fine.pad[a];
            rest %= fine.stride[a];
            above[a] = coarsened[a] ? place[a] / 2 : place[a];
        }
        for (int a = 0; a < fine.axes; ++a) {
            const int p = place[at(a)], cells = fine.cells[at(a)];
            for (const int side : {0, 1}) {
                const bool is_inside = coarsened[at(a)] && p % 2 != side && !(side == 1 && p + 1 == cells);
                const std::int64_t f = limit.cell + side * fine.stride[at(a)],
                                   beyond = side == 0 ? f - fine.stride[at(a)] : f;
                const Limit* const other = find(beyond);
                if (is_inside || (side == 1 && other != nullptr)) {
                    continue;  // the cell beyond has the face as its lower one
                }
                const float c = face[at(a)][at(f)],
                            kept = std::min({c, limit.most[at(a)], other != nullptr ? other->most[at(a)] : c});
                std::array<int, 3> to = above;
                to[at(a)] = coarsened[at(a)] ? (p + side + 1) / 2 : p + side;
                float& sum = coarse_face[at(a)][at(coarse.index(to[0], to[1], to[2]))];
                sum = std::max(0.0F, sum - (c - kept) / (coarsened[at(a)] ? distance_across(p + side, cells) : 1.0F));
            }
        }
    }
}

void factorise_level(const CellBox& box, const LevelFaces& face, std::vector<float>& factor) {
    constexpr double least_pivot = 1e-9;  // over the diagonal: below, round-off of conductances in single precision
    const auto n = at(box.cell_count());
    std::vector<double> l(n * n, 0.0);
    std::vector<std::int64_t> number(at(box.size), -1);
    std::int64_t count = 0;
    for (std::int64_t row = 0; row < box.row_count(); ++row) {
        for (std::int64_t i = box.row_start(row); i < box.row_start(row) + box.cells[0]; ++i, ++count) {
            number[at(i)] = count;
            for (int a = 0; a < box.axes; ++a) {
                const std::int64_t s = box.stride[at(a)];
                const double c = face[at(a)][at(i)];
                l[at(count) * n + at(count)] += c + face[at(a)][at(i + s)];
                if (number[at(i - s)] >= 0) {
                    l[at(count) * n + at(number[at(i - s)])] = -c;
                }
            }
        }
    }
    for (std::size_t r = 0; r < n; ++r) {
        const double diagonal = l[r * n + r];
        for (std::size_t c = 0; c <= r; ++c) {
            const double sum = l[r * n + c] - std::inner_product(&l[r * n], &l[r * n + c], &l[c * n], 0.0);
            l[r * n + c] = c < r ? sum * l[c * n + c] : sum > least_pivot * diagonal ? 1 / std::sqrt(sum) : 0;
        }
    }
    factor.resize(std::max(factor.size(), n * n));
    std::transform(l.begin(), l.end(), factor.begin(), [](double value) { return static_cast<float>(value); });
}

void solve_factorised(const CellBox& box, const std::vector<float>& factor, const std::vector<float>& b,
                      std::vector<float>& x) {
    const auto n = at(box.cell_count());
    std::array<float, at(coarsest_cells)> y{};
    const auto row_length = at(box.cells[0]);
    const auto place = [&](std::size_t r) {
        return at(box.row_start(static_cast<std::int64_t>(r / row_length))) + r % row_length;
    };
    for (std::size_t r = 0; r < n; ++r) {
        const float sum = b[place(r)] - std::inner_product(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(r),
                                                           &factor[r * n], 0.0F);
        y[r] = sum * factor[r * n + r];
    }
    for (std::size_t r = n; r-- > 0;) {
        const float value = y[r] * factor[r * n + r];
        for (std::size_t c = 0; c < r; ++c) {
            y[c] -= value * factor[r * n + c];
        }
        x[place(r)] = value;
    }
}

}  // namespace riprap::linear
