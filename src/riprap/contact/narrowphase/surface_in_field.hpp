// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/contact/narrowphase/distance_potential.hpp"
#include "riprap/contact/narrowphase/lanes.hpp"
#include "riprap/contact/narrowphase/overlap_integrals.hpp"

namespace riprap::contact {

/// Sums over the surface pieces in a cell of the field, for the energy.
struct CellSum {
    double offset{0};  ///< sum of (n . x on the face, from the reference) * int phi dS
    Vec3 normal{};     ///< sum of n * int phi dS
};

/// Room for one side of a pair. Grows to the largest shapes met and stays.
struct SurfaceWorkspace {
    std::vector<Lanes> rows;            ///< per corner: `groups` vectors of w_j h_j, then (x, y, z, unused)
    std::vector<Lanes> fields;          ///< per face: infinity where it carries no field; then the least w_j h_j
    std::vector<std::int32_t> loops;    ///< corner lists of polygons being cut
    std::vector<double> gaps;           ///< of the corners of a loop from the plane that cuts it
    std::vector<std::int32_t> kept;     ///< candidate cells of a patch
    std::vector<CellSum> cells;         ///< per face of the field body
    std::vector<std::uint8_t> is_met;   ///< per face of the field body: a piece of the surface lies in its cell
    std::vector<std::uint8_t> reaches;  ///< per face of the surface body: not wholly outside the field body
};

/// One ordered pair: a surface body in the frame of a field body.
struct SurfaceInField {
    const geometry::ConvexView& surface;
    const Frame& frame;  ///< of the surface body in the frame of the field body
    const geometry::ConvexView& field;
    Potential potential;
    Vec3 reference;    ///< in the frame of the field body
    double tolerance;  ///< positions closer to a plane than this lie in it [m]
    bool with_energy;
    SurfaceWorkspace& work;
};

/// A face plane of the field body that has the surface body wholly outside; none where `face` < 0.
struct Separation {
    std::int32_t face{-1};
};

/// Exact integrals of the field over the surface, as plain::OneSide but vectorised over the faces of the field body:
/// each polygon corner carries all its w_j h_j in lanes, a cut interpolates them. Only planes that cross a polygon cut
/// it, and only cells that can hold the least w_j h_j of a patch are looked at. Fills `work` for the energy.
Separation integrate_surface(const SurfaceInField& side, SurfaceIntegrals& total);

}  // namespace riprap::contact
