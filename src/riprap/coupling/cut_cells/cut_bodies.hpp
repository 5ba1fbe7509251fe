// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "riprap/core/sym3.hpp"
#include "riprap/fluid/grid/mesh.hpp"
#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::coupling {

/// A body in the grid: convex parts that do not overlap, and spheres, in world axes. It moves with
/// v = v_c + omega x r + D r.
struct GridBody {
    struct Sphere {
        Vec3 centre;       ///< [m]
        double radius{0};  ///< [m]
    };
    std::vector<geometry::Polyhedron> parts;
    std::vector<Sphere> spheres;
    Vec3 centre{};            ///< of mass [m]
    Vec3 velocity{};          ///< of the centre [m/s]
    Vec3 angular_velocity{};  ///< [rad/s]
    Sym3 stretch_rate{};      ///< D, world axes [1/s]

    Vec3 velocity_at(const Vec3& x) const {
        return velocity + cross(angular_velocity, x - centre) + stretch_rate * (x - centre);
    }
};

/// A triangle of a body's surface: inside one cell, or on a side of it, in the cell on the outer side of the surface.
struct CutFacet {
    std::int32_t body;
    std::int64_t cell;
    Vec3 area;                   ///< vector area, out of the body [m^2]
    std::array<Vec3, 3> middle;  ///< of its edges: means over them are exact for squares [m]
    std::int32_t joint{-1};      ///< number of the closed cell among CutBodies::joints; -1: the cell is open

    Vec3 place() const { return (middle[0] + middle[1] + middle[2]) * (1.0 / 3); }
};

/// A face of the mesh.
struct MeshFace {
    int axis;
    std::int64_t index;  ///< flat, of the cell above
    std::array<int, 3> place;
};

/// A closed cell whose facets need the state of the water: the mean of its sources.
struct JointCell {
    std::int64_t cell;
    std::vector<std::int64_t> sources;  ///< open cells, or -1 - number of earlier entries
};

/// Shares that bodies leave open, and the surfaces they do it with.
struct CutBodies {
    fluid::grid::OpenShares open;
    std::vector<CutFacet> facets;                      ///< body by body, in the order of cells
    std::array<std::vector<std::int32_t>, 3> nearest;  ///< body at each face, -1 far from any
    std::vector<MeshFace> near_faces;                  ///< those that have one
    std::vector<JointCell> joints;  ///< closed cells with facets and their neighbours, nearest to water first
};

/// Cuts bodies out of the cells of a mesh. Volumes and areas are those of the clipped polyhedra, exact; a sphere is cut
/// by the plane that touches it nearest to the cell's centre (error of order h/R of a facet). The closed areas of a
/// cell's faces and its facets add up to nothing, so a fluid that moves along with a body is not disturbed, and
///
///     d(theta V)/dt = - sum over facets of u_body . area
///
/// is exact for rigid motion. A plane flow takes bodies as deep as the mesh. Shares below 1e-9 of a face are closed,
/// and so are gaps between two bodies that leave less than a twentieth of a cell: joints, whose facets lie in closed
/// cells. Facets on a side of a cell belong to the cell beyond.
CutBodies cut_bodies(const fluid::grid::Mesh& mesh, const std::vector<GridBody>& bodies);

class Cutter;

/// Cuts bodies of which some never move: these are cut once.
class BodyCutter {
 public:
    /// @param is_still  per body
    BodyCutter(const fluid::grid::Mesh& mesh, const std::vector<GridBody>& bodies, std::vector<std::uint8_t> is_still);
    ~BodyCutter();
    BodyCutter(BodyCutter&&) noexcept;
    BodyCutter& operator=(BodyCutter&&) noexcept;
    CutBodies cut(const std::vector<GridBody>& bodies) const;
    bool moves() const;

 private:
    std::vector<std::uint8_t> is_still_;
    std::unique_ptr<const Cutter> still_;
};

/// Sets d(theta V)/dt of every cell from the velocities of bodies now [m^3/s].
void find_displacement(const std::vector<CutFacet>& facets, const std::vector<GridBody>& bodies,
                       fluid::grid::OpenShares& open);

}  // namespace riprap::coupling
