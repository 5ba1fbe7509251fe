// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/body/body_set.hpp"
#include "riprap/geometry/ground/triangle_field.hpp"

namespace riprap::body {

/// Tells whether a body is ground: it does not follow forces, and each of its parts has one face that carries a field,
/// as the cells under a surface have (geometry/ground/ground_cells.hpp). Its surface is then the union of these faces.
bool is_ground(const BodySet& bodies, const geometry::ShapeSet& shapes, BodyId body);

/// The surface of ground, in the frame of the body.
geometry::TriangleMesh ground_mesh(const BodySet& bodies, const geometry::ShapeSet& shapes, BodyId body);

/// The surface of ground as a field of nearest triangles, in the frame of the body.
geometry::TriangleField ground_field(const BodySet& bodies, const geometry::ShapeSet& shapes, BodyId body);

/// The ground of a scene.
struct Ground {
    BodyId body;
    geometry::TriangleField field;
};
std::vector<Ground> find_grounds(const BodySet& bodies, const geometry::ShapeSet& shapes);

}  // namespace riprap::body
