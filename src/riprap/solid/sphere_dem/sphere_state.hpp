// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/core/fields.hpp"

namespace riprap::solid::sphere_dem {

/// Springs of touching pairs that survive from step to step: State. Sorted by `pair`; one row per contact.
struct Springs {
    std::vector<std::uint64_t> pair;  ///< sphere << 32 | other sphere, or | wall
    std::vector<Vec3> force;          ///< of the tangential spring on the sphere [N]
    std::vector<double> stiffness;    ///< of the tangential spring [N/m]; negative while sliding
    std::vector<Vec3> rolling;        ///< rolling couple on the sphere [N m]; empty without rolling springs
    std::vector<Vec3> normal;         ///< of the last step; kept for walls only [-]

    std::size_t size() const { return pair.size(); }
    friend bool operator==(const Springs&, const Springs&) = default;
};

/// State of the method besides bodies.
struct SphereState {
    Springs contacts;             ///< of spheres with spheres
    Springs walls;                ///< of spheres with parts and triangles
    std::int64_t evaluations{0};  ///< of the contacts so far; tells Scratch when State was put back
    double friction_loss{0};      ///< [J] since the start
    double damping_loss{0};       ///< of dashpots [J]
    double rolling_loss{0};       ///< [J]

    friend bool operator==(const SphereState&, const SphereState&) = default;

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("spheres.contact.pair", self.contacts.pair);
        visit("spheres.contact.force", self.contacts.force);
        visit("spheres.contact.stiffness", self.contacts.stiffness);
        visit("spheres.contact.rolling", self.contacts.rolling);
        visit("spheres.wall.pair", self.walls.pair);
        visit("spheres.wall.force", self.walls.force);
        visit("spheres.wall.stiffness", self.walls.stiffness);
        visit("spheres.wall.rolling", self.walls.rolling);
        visit("spheres.wall.normal", self.walls.normal);
        visit("spheres.evaluations", self.evaluations);
        visit("spheres.friction_loss", self.friction_loss);
        visit("spheres.damping_loss", self.damping_loss);
        visit("spheres.rolling_loss", self.rolling_loss);
    }
};

}  // namespace riprap::solid::sphere_dem
