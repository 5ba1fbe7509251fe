// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/coupling/fill_lattice.hpp"
#include "riprap/coupling/fill_solids.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"

namespace riprap::coupling {

/// A cell of the lattice that a face cuts.
struct CutCell {
    std::array<std::int64_t, 3> cell;  ///< of the lattice of the water; negative before its first place
    double share;                      ///< that lies in no solid, on the side of the particle [-]
    int region;                        ///< of water that it belongs to; -1: air
    bool is_filled;                    ///< by a particle
    Vec3 place;                        ///< of the particle [m]
};

/// Fills cells that faces cut. A particle stands for a whole cell, so of cut cells only so many are filled as the
/// shares of them that lie in no solid add up to: what one cell has too much or too little is handed on to the cut
/// cells beside it that follow in the order of the lattice, as halftones are made [FloydSteinberg1976]. The middle of a
/// cell that is filled is the place of its particle where it keeps the distance from solids, else the place next to it
/// that does. Cells without such a place and without a neighbour that water reaches stay empty.
///
/// The lattice goes on beyond regions, by so much as a particle of water feels: what stands there is air, which holds
/// water in its place while both are packed (pack.hpp).
///
/// Where no face cuts cells, the surface does where the spacing does not divide the depth: of the last layer only some
/// have a particle (region_of()), which would fall in. The layer is to be packed with those below it, under air whose
/// first layer stands half a spacing over the surface.
class CutCells {
 public:
    CutCells() = default;  ///< without any: cells are filled by their middles
    /// @param distance  that places keep from solids [m]
    CutCells(const Lattice& lattice, std::span<const RegionPlanes> regions, const FillSolids& solids,
             const fluid::ParticleSettings& settings, const Vec3& up, double distance);

    /// Returns how far cells of water reach beyond the lattice [cells].
    std::array<std::int64_t, 3> rim() const;
    /// Tells that neither a face nor the surface cuts a cell of water: the lattice fits.
    bool empty() const { return misfits_.empty(); }
    /// Tells that some face cuts a cell of water.
    bool has_faces() const { return has_faces_; }
    /// Middles of the cells of water that faces or the surface cut [m].
    std::span<const Vec3> misfits() const { return misfits_; }
    const CutCell* find(std::int64_t i, std::int64_t j, std::int64_t k) const;
    /// Places of air within `reach` of a cell of water that a face cuts [m].
    std::vector<Vec3> air(double reach) const;

 private:
    const CutCell* in_row(std::int64_t row, std::int64_t i) const;
    void find_cells();
    void fill_cells();
    void find_surface();
    double below_surface(std::int64_t i, std::int64_t j, std::int64_t k) const;
    double sunk(std::int64_t i, std::int64_t j, std::int64_t k) const;
    bool is_open(std::int64_t i, std::int64_t j, std::int64_t k) const;
    bool is_reached(std::int64_t i, std::int64_t j, std::int64_t k) const;
    bool place(CutCell& cut) const;

    Lattice lattice_{};                     ///< of the water
    Lattice wide_{};                        ///< with air around it
    std::array<std::int64_t, 3> before_{};  ///< places of air before the first of water
    std::span<const RegionPlanes> regions_;
    const FillSolids* solids_{nullptr};
    const fluid::ParticleSettings* settings_{nullptr};
    Vec3 up_{};
    double distance_{0};
    std::vector<CutCell> cells_;           ///< in the order of the wide lattice
    std::vector<std::int64_t> row_begin_;  ///< of its rows
    std::vector<Vec3> misfits_;
    bool has_faces_{false};
};

}  // namespace riprap::coupling
