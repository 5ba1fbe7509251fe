// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "riprap/fluid/grid/mesh.hpp"
#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/geometry/polyhedron.hpp"

namespace riprap::coupling {

/// A rigid body in the grid: convex parts that do not overlap, and spheres, in world axes.
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

    Vec3 velocity_at(const Vec3& x) const { return velocity + cross(angular_velocity, x - centre); }
};

/// A triangle of a body's surface inside one cell.
struct CutFacet {
    std::int32_t body;
    std::int64_t cell;
    Vec3 area;                   ///< vector area, out of the body [m^2]
    std::array<Vec3, 3> middle;  ///< of its edges: means over them are exact for squares [m]

    Vec3 place() const { return (middle[0] + middle[1] + middle[2]) * (1.0 / 3); }
};

/// Shares that bodies leave open, and the surfaces they do it with.
struct CutBodies {
    fluid::grid::OpenShares open;
    std::vector<CutFacet> facets;                      ///< body by body, in the order of cells
    std::array<std::vector<std::int32_t>, 3> nearest;  ///< body at each face, -1 far from any
};

/// Cuts bodies out of the cells of a mesh. Volumes and areas are those of the clipped polyhedra, exact; a sphere is cut
/// by the plane that touches it nearest to the cell's centre (error of order h/R of a facet). The closed areas of a
/// cell's faces and its facets add up to nothing, so a fluid that moves along with a body is not disturbed, and
///
///     d(theta V)/dt = - sum over facets of u_body . area
///
/// is exact for rigid motion. A plane flow takes bodies as deep as the mesh. Shares below 1e-9 of a face are closed.
CutBodies cut_bodies(const fluid::grid::Mesh& mesh, const std::vector<GridBody>& bodies);

}  // namespace riprap::coupling
