// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "riprap/body/supports.hpp"
#include "riprap/contact/narrowphase/hull.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/solid/affine/block_state.hpp"
#include "riprap/solid/affine/surface.hpp"

// Simply deformable blocks, as both three-dimensional DDAs move them: every block is an affine image of its shape,
//
//     x = x_c + F X,   X about the centroid of the shape,   v(x) = v_c + L (x - x_c),
//
// twelve degrees of freedom. An affine map keeps convex polyhedra convex, and all integrals over a block follow from
// those of its shape: volume det F V0, second moments F E0 F^T.

namespace riprap::solid::affine {

struct Ground;

/// A convex shape with its integrals, about its centroid; or a half-space, or ground, which have none.
struct Shape {
    contact::HullTopology topology;
    std::vector<Vec3> vertices;            ///< [m]; of convex polyhedra alone
    double volume{0};                      ///< V0 [m^3]
    Mat3 second_moment;                    ///< integral of X X^T dV [m^5]
    double circumradius{0};                ///< [m]
    double round_radius{0};                ///< of the ball or disc that it stands for; 0 = none [m]
    double size{0};                        ///< cube root of the volume [m]
    Vec3 plane_normal{};                   ///< of a half-space { x : normal . x <= offset }
    double plane_offset{0};                ///< [m]
    std::shared_ptr<const Ground> ground;  ///< of ground
    bool is_convex() const { return !vertices.empty(); }
    bool is_ground() const { return ground != nullptr; }
    bool is_half_space() const { return !is_convex() && !is_ground(); }
    std::int32_t face_count() const { return is_convex() ? topology.face_count() : is_half_space() ? 1 : 0; }
};

/// Blocks, their shapes and surfaces as make_blocks.hpp makes them of a scene: Model. Arrays have one entry per block
/// unless said.
struct BlockSystem {
    std::vector<Shape> shapes;  ///< one of every block
    Elasticity elasticity;      ///< of all blocks
    Surfaces surfaces;
    std::vector<body::FixedPoint> fixed_points;  ///< each with a stiffness
    std::vector<std::int32_t> material;
    std::vector<std::uint8_t> is_fixed;  ///< loads do not move it: it rests, or goes on with the velocity it has
    std::vector<double> mass;            ///< [kg]
    std::vector<Mat3> inertia;           ///< E0 = rho integral of X X^T dV (Euler's tensor) [kg m^2]
    std::vector<std::int32_t> vertex_begin{0}, face_begin{0};  ///< size() + 1 entries: places in PlacedBlocks
    Vec3 gravity{};                                            ///< [m/s^2]
    bool is_planar{false};  ///< blocks are prisms that stay in the x-y plane; see plane.hpp

    std::int32_t size() const { return static_cast<std::int32_t>(mass.size()); }
    const Shape& shape_of(std::int32_t block) const { return shapes[index(block)]; }
    const Surface& surface_of(std::int32_t a, std::int32_t b) const {
        return surfaces.of(material[index(a)], material[index(b)]);
    }
    static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
};

inline Mat3 rows_at(const std::vector<Vec3>& rows, std::size_t block) {
    return {{rows[3 * block], rows[3 * block + 1], rows[3 * block + 2]}};
}
inline void set_rows(std::vector<Vec3>& rows, std::size_t block, const Mat3& m) {
    for (std::size_t i = 0; i < 3; ++i) {
        rows[3 * block + i] = m.row[i];
    }
}

/// Loads besides gravity and contact, held over a step; empty = none. `pull` strains the block:
/// pull = sum of sym(f r^T) [N m], r from the centroid; torque = sum of r x f.
struct BlockLoads {
    std::span<const Vec3> force;   ///< [N]
    std::span<const Vec3> torque;  ///< about the centroid [N m]
    std::span<const Mat3> pull;    ///< [N m]
};

/// Dipole sum of f r^T of given loads: pull + [torque]x/2, from (r x f) x v = f (r.v) - r (f.v).
Mat3 dipole(const BlockLoads& loads, std::size_t block);

/// The matrix [w]x: [w]x v = w x v.
constexpr Mat3 cross_matrix(const Vec3& w) { return {{{0, -w.z, w.y}, {w.z, 0, -w.x}, {-w.y, w.x, 0}}}; }
/// Half the turn in a matrix: w of its antisymmetric part [w]x.
constexpr Vec3 spin_of(const Mat3& m) { return 0.5 * Vec3{m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)}; }
constexpr Mat3 symmetric_part(const Mat3& m) { return 0.5 * (m + transpose(m)); }
/// Stress of an isotropic solid, lambda tr(e) I + 2 mu e [Pa].
Mat3 elastic_stress(const Elasticity& material, const Mat3& strain);
/// 1/2 stress : strain, its density of energy [J/m^3].
double elastic_energy(const Elasticity& material, const Mat3& strain);

/// Angular momentum about the centroid, sum of m r x L r, of a block with second moments S = F E0 F^T [kg m^2/s].
Vec3 angular_momentum(const Mat3& inertia, const Mat3& velocity_gradient);

/// Corners and face normals of all blocks in world axes: Scratch.
struct PlacedBlocks {
    std::vector<Vec3> vertices, normals;
    contact::PlacedHull hull(const BlockSystem& system, const BlockState& state, std::int32_t block) const;
};
void place_blocks(const BlockSystem& system, const BlockState& state, PlacedBlocks& placed);

/// Kinetic and potential energy, momentum: of all free blocks, in index order.
struct BlockSums {
    double mass{0}, kinetic{0}, potential{0};
    Vec3 momentum{}, angular_momentum{};  ///< the second about the origin

    template <class By>
    static void join(BlockSums& a, const BlockSums& b, const By& by) {
        by.add(a.mass, b.mass);
        by.add(a.kinetic, b.kinetic);
        by.add(a.potential, b.potential);
        by.add(a.momentum, b.momentum);
        by.add(a.angular_momentum, b.angular_momentum);
    }
};
BlockSums measure(const BlockSystem& system, const BlockState& state);

}  // namespace riprap::solid::affine
