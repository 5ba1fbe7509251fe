// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "riprap/geometry/planar_vector.hpp"

// Gives the answers of a mesh of elements of constant strain: bonded blocks of the same shapes are those elements, tied
// at their corners. Computed here by other means than DDA, with nodes as unknowns.

namespace riprap::validation::dda {

/// A plate in plane stress, one metre thick, meshed into triangles of constant strain.
class TriangleMesh {
 public:
    TriangleMesh(double youngs_modulus, double poisson_ratio, double density);
    void add(const std::array<geometry::Vec2, 3>& corners);
    /// Holds the node at this place.
    void hold(const geometry::Vec2& place);
    /// A force at a node [N].
    void load(const geometry::Vec2& place, const geometry::Vec2& force);
    /// Displacements under the loads, two numbers a node [m].
    std::vector<double> deflect() const;
    /// The lowest frequency of free vibration with the consistent mass matrix [rad/s].
    double first_frequency() const;
    std::int32_t node_at(const geometry::Vec2& place) const;

 private:
    std::int32_t find_or_add(const geometry::Vec2& place);
    void assemble(std::vector<double>& stiffness, std::vector<double>& mass) const;
    std::size_t size() const { return 2 * nodes_.size(); }

    double youngs_modulus_, poisson_ratio_, density_;
    std::vector<geometry::Vec2> nodes_;
    std::vector<std::array<std::int32_t, 3>> triangles_;
    std::vector<std::uint8_t> is_held_;
    std::vector<double> force_;
};

/// A bar of equal elements of constant strain that flies at a wall.
struct FlyingBar {
    int elements{50};
    double length{1}, area{0.02}, youngs_modulus{1e9}, density{2500}, speed{1};
    double wall_stiffness{2e11};  ///< of the spring that its end meets [N/m]
};
/// Mean speed away from the wall after `time`, over the speed before: consistent masses, central differences with a
/// step far below the stable one.
double rebound_of(const FlyingBar& bar, double time);

}  // namespace riprap::validation::dda
