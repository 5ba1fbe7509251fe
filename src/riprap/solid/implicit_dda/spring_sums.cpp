// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/implicit_dda/spring_sums.hpp"

#include "riprap/solid/implicit_dda/block_terms.hpp"
#include "riprap/solid/transposed.hpp"

namespace riprap::solid::implicit_dda {

namespace {

using Native = Wide<double, transposed::width>;
constexpr std::size_t native = transposed::width;
constexpr std::size_t rows = (12 + native - 1) / native * native;  ///< twelve, and what fills the last vector

/// Brings twelve numbers in(c, i) of translation (c = 0) and displacement gradient, entry (i, c), to the unknowns. Each
/// unknown moves one of them, or two: rotations by opposite entries, shears by half of both.
template <class In, class Out>
[[gnu::always_inline]] inline void to_unknowns(const In& in, const Out& out) {
    out(0, in(0, 0));
    out(1, in(0, 1));
    out(2, in(0, 2));
    out(3, in(2, 2) - in(3, 1));
    out(4, in(3, 0) - in(1, 2));
    out(5, in(1, 1) - in(2, 0));
    out(6, in(1, 0));
    out(7, in(2, 1));
    out(8, in(3, 2));
    out(9, 0.5 * (in(2, 0) + in(1, 1)));
    out(10, 0.5 * (in(3, 1) + in(2, 2)));
    out(11, 0.5 * (in(1, 2) + in(3, 0)));
}

}  // namespace

void write_blocks(const SharedSprings& sum, double* block, double* transpose) {
    // Columns to the unknowns: number 4 i + c of column v belongs to row (c, i), so that four come as they lie in the
    // sum.
    alignas(64) double column[rows][12];
    for (std::size_t i = 0; i < 3; ++i) {
        to_unknowns(
            [&](std::size_t d, std::size_t j) { return Four::load(&sum.value[16 * stiffness_place(i, j) + 4 * d]); },
            [&](std::size_t v, const Four& numbers) { numbers.store(&column[v][4 * i]); });
    }
    // Rows to the unknowns, a vector of columns at a time.
    double beyond[4];
    for (std::size_t v = 0; v < 12; v += native) {
        Native number[3][4];
        const double* from[native];
        double* to[native];
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < native; ++k) {
                from[k] = &column[v + k < 12 ? v + k : 0][4 * i];
            }
            transposed::load_four(from, number[i][0].part[0], number[i][1].part[0], number[i][2].part[0],
                                  number[i][3].part[0]);
        }
        Native row[12];
        to_unknowns([&](std::size_t c, std::size_t i) { return number[i][c]; },
                    [&](std::size_t u, const Native& numbers) { row[u] = numbers; });
        for (std::size_t u = 0; u < 12; ++u) {
            if (v + native <= 12) {
                row[u].store(transpose + 12 * u + v);
            } else {
                double all[native];
                row[u].store(all);
                for (std::size_t k = 0; v + k < 12; ++k) {
                    transpose[12 * u + v + k] = all[k];
                }
            }
        }
        for (std::size_t u = 0; u < 12; u += 4) {
            for (std::size_t k = 0; k < native; ++k) {
                to[k] = v + k < 12 ? block + 12 * (v + k) + u : beyond;
            }
            transposed::store_four(row[u].part[0], row[u + 1].part[0], row[u + 2].part[0], row[u + 3].part[0], to);
        }
    }
}

void write_block(const OwnSprings& sum, double* block) {
    static constexpr std::array<std::size_t, 16> place{0, 1, 2, 3, 1, 4, 5, 6, 2, 5, 7, 8, 3, 6, 8, 9};
    SharedSprings whole;
    for (std::size_t k = 0; k < 6; ++k) {
        for (std::size_t cd = 0; cd < 16; ++cd) {
            whole.value[16 * k + cd] = sum.value[10 * k + place[cd]];
        }
    }
    Matrix12 transpose;
    write_blocks(whole, block, transpose.data());
}

}  // namespace riprap::solid::implicit_dda
