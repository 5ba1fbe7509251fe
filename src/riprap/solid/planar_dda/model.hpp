// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "riprap/geometry/outcome.hpp"
#include "riprap/geometry/planar_polygon.hpp"
#include "riprap/solid/planar_dda/settings.hpp"
#include "riprap/solid/planar_dda/unknowns.hpp"

namespace riprap::solid::planar_dda {

/// An isotropic elastic material.
struct Material {
    double density{2500};         ///< [kg/m^3]
    double youngs_modulus{5e10};  ///< E [Pa]
    double poisson_ratio{0.25};   ///< nu [-]
};

/// Springs and strength of a contact of two materials. Stiffnesses belong to one contact point.
struct Joint {
    double normal_stiffness{1e9};  ///< p [N/m]
    double shear_stiffness{4e8};   ///< p_s [N/m]; Shi's choice is p/2.5
    double friction{0};            ///< tan(phi) [-]
    double cohesion{0};            ///< c of a bonded contact [Pa]
    double tension{0};             ///< tensile strength of a bonded contact [Pa]
    double damping_ratio{0};       ///< share of critical damping of the normal spring [-]
};

/// Material point of a block, held at `anchor` by a spring in both directions.
struct FixedPoint {
    std::int32_t block{-1};
    Vec2 local{};         ///< offset from the centroid in the reference shape [m]
    Vec2 anchor{};        ///< where it is held [m]
    double stiffness{0};  ///< p_f [N/m]
};

/// A straight spring between material points of two blocks.
struct Bolt {
    std::int32_t first{-1}, second{-1};
    Vec2 first_local{}, second_local{};  ///< [m]
    double stiffness{0};                 ///< [N/m]
    double rest_length{0};               ///< [m]; shorter than the distance at the start = prestressed
};

/// A material point whose motion is reported.
struct MeasuredPoint {
    std::int32_t block{-1};
    Vec2 local{};  ///< [m]
};

/// A constant force at a material point, in world axes.
struct PointLoad {
    std::int32_t block{-1};
    Vec2 local{};  ///< [m]
    Vec2 force{};  ///< [N]
};

/// Blocks and what holds them; constant during a run. Corners of all blocks lie in one list; corner k and edge k (from
/// corner k to the next one of its block) bear the same number, which names them in contacts.
struct Model {
    std::vector<Material> materials;
    std::vector<Joint> joints;  ///< of materials a and b: joints[a * materials.size() + b]
    PlaneState plane{PlaneState::stress};
    double thickness{1};  ///< across the plane [m]

    std::vector<std::int32_t> corner_begin{0};  ///< per block, and the end
    std::vector<Vec2> corner;                   ///< offset from the centroid, reference shape [m]
    std::vector<std::int32_t> corner_block, corner_next, corner_before;
    std::vector<std::uint8_t> is_convex;                  ///< per corner
    std::vector<std::int32_t> material;                   ///< per block
    std::vector<std::uint8_t> is_fixed;                   ///< per block: moves as told, not by forces
    std::vector<double> mass;                             ///< [kg]
    std::vector<double> area;                             ///< of the reference shape [m^2]
    std::vector<double> moment_xx, moment_yy, moment_xy;  ///< second moments over the area, reference shape [m^2]
    std::vector<double> width;  ///< twice the area over the perimeter: half the side of a square, about the thickness
                                ///< of a slab [m]

    std::vector<std::string> names;  ///< of blocks, for messages; empty = their numbers

    std::vector<FixedPoint> fixed_points;
    std::vector<Bolt> bolts;
    std::vector<MeasuredPoint> measured_points;
    std::vector<PointLoad> point_loads;

    std::int32_t block_count() const { return static_cast<std::int32_t>(material.size()); }
    const Joint& joint(std::int32_t block_a, std::int32_t block_b) const {
        return joints[static_cast<std::size_t>(material[static_cast<std::size_t>(block_a)]) * materials.size() +
                      static_cast<std::size_t>(material[static_cast<std::size_t>(block_b)])];
    }
    /// Returns "block 3", or the name that the block was given.
    std::string name_of(std::int32_t block) const;
    /// Sets the joint of two materials in both orders.
    void set_joint(std::int32_t material_a, std::int32_t material_b, const Joint& joint);
};

/// A point of a block.
struct Pose2 {
    Vec2 position{};
    double angle{0};
};

struct State;

/// Collects blocks into a model and the state at the start.
class Builder {
 public:
    Builder(Model& model, State& state) : model_(&model), state_(&state) {}

    /// Adds a block with its corners in place. @returns its number, or why the polygon is refused
    geometry::Outcome<std::int32_t> add_block(std::span<const Vec2> corners, std::int32_t material,
                                              bool is_fixed = false);
    /// Holds the point `at` [m] of a block where it is.
    void fix_point(std::int32_t block, const Vec2& at, double stiffness);
    void add_load(std::int32_t block, const Vec2& at, const Vec2& force);
    void add_bolt(std::int32_t first, const Vec2& first_at, std::int32_t second, const Vec2& second_at,
                  double stiffness, double pretension = 0);
    std::int32_t add_measured_point(std::int32_t block, const Vec2& at);

 private:
    Vec2 local_of(std::int32_t block, const Vec2& at) const;
    Model* model_;
    State* state_;
};

/// Numbers of the model that cannot be computed with: densities and moduli that are not positive, Poisson's ratios out
/// of range, stiffnesses that are not positive or exceed 1e6 times Young's modulus times the thickness.
std::vector<geometry::GeometryProblem> problems_of(const Model& model);

}  // namespace riprap::solid::planar_dda
