// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "riprap/linear/cell_box.hpp"

namespace riprap::linear {

/// A level of so many cells is not coarsened further, and solved by a factorisation.
constexpr std::int64_t coarsest_cells = 64;

/// Conductances of the faces below cells, per axis.
using LevelFaces = std::array<std::vector<float>, 3>;

/// Returns the distance between coarse centres across face p of n fine ones, over that of the fine cells: 2, less
/// beside a last cell without a partner.
inline float distance_across(int p, int n) {
    return p >= n ? (n % 2 == 0 ? 2.0F : 1.0F) : p + 1 == n && p > 0 ? 1.5F : 2.0F;
}

/// Lets every coarse cell conduct through one piece of its fine cells alone.
///
/// Fine cells of a coarse one hang together where the face between them conducts at least a tenth of what the faces
/// before and behind it do. Where they fall into pieces, as on either side of a film of water in air, the coarse cell
/// belongs to the piece that conducts best, and faces that lead out of other pieces count for no more than the best
/// along their axis times the weakest such share inside the coarse cell: water's, where that is the best in air. Sums
/// of fine faces alone would join the air on both sides of every film thinner than a coarse cell, and an air pocket
/// would cost an iteration or two: its pressure is a mode that only coarse levels see. Pieces behind closed faces keep
/// their sums.
/// @param face, inverse  conductances of the fine level, and 1/diagonal of its cells
/// @param coarsened      axes along which the coarse level has half as many cells
/// @param coarse_face    sums of fine conductances over the growth of the distance between centres
void part_pieces(const CellBox& fine, const LevelFaces& face, const std::vector<float>& inverse,
                 const std::array<bool, 3>& coarsened, const CellBox& coarse, LevelFaces& coarse_face);

/// Factorises the operator of a level of at most coarsest_cells cells, L L^T by rows with 1/L_ii on the diagonal. Modes
/// without a pivot, of a closed box, are left out.
void factorise_level(const CellBox& box, const LevelFaces& face, std::vector<float>& factor);

/// Solves L L^T x = b on the cells of the level.
void solve_factorised(const CellBox& box, const std::vector<float>& factor, const std::vector<float>& b,
                      std::vector<float>& x);

}  // namespace riprap::linear
