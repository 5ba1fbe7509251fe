// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/core/vec3.hpp"

// State of the blocks of both three-dimensional DDAs; see blocks.hpp and block_contacts.hpp.

namespace riprap::solid::affine {

/// Places, motion and stress of the blocks: State. Matrices are kept as three rows each.
struct BlockState {
    std::vector<Vec3> position;           ///< of the centroid [m]
    std::vector<Vec3> velocity;           ///< of the centroid [m/s]
    std::vector<Vec3> deformation;        ///< F, three rows per block [-]
    std::vector<Vec3> velocity_gradient;  ///< L, three rows per block, world axes [1/s]
    std::vector<Vec3> stress;             ///< Cauchy stress, three rows per block, tension positive [Pa]

    std::int32_t size() const { return static_cast<std::int32_t>(position.size()); }
    friend bool operator==(const BlockState&, const BlockState&) = default;

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("block.position", self.position);
        visit("block.velocity", self.velocity);
        visit("block.deformation", self.deformation);
        visit("block.velocity_gradient", self.velocity_gradient);
        visit("block.stress", self.stress);
    }
};

/// State of a contact point between the steps.
enum class ContactMode : std::uint8_t {
    open,   ///< no springs; kept between steps only where an intact bond touches
    slide,  ///< normal spring and friction
    lock    ///< normal and shear springs
};

/// Contact points that survive from step to step: State. Sorted by (pair, feature). A locked contact keeps its elastic
/// slip, which adds up the relative motion of the two bodies there and turns with the plane: it neither creeps nor
/// forgets where it was closed, and needs no fixed point on a surface that edges may slide along.
struct BlockContactHistory {
    std::vector<std::uint64_t> pair;  ///< a << 32 | b
    std::vector<std::uint64_t> feature;
    std::vector<std::uint64_t> plane;
    std::vector<Vec3> normal;             ///< at the last step, from a to b [-]
    std::vector<Vec3> slip;               ///< elastic slip t of a against b, which the shear spring holds [m]
    std::vector<std::uint8_t> mode;       ///< ContactMode
    std::vector<std::uint8_t> is_intact;  ///< bonded and not broken: cohesion and tension hold; see bonds.hpp
    std::vector<double> plastic_slip;     ///< by which an intact bond has slid at its strength so far [m]
    std::vector<double> energy;           ///< stored in its springs [J]
    std::vector<std::uint64_t> bonded;    ///< pairs with unbroken bonds, ascending; see bonds.hpp. Not of the rows

    std::size_t size() const { return pair.size(); }
    void clear();
    friend bool operator==(const BlockContactHistory&, const BlockContactHistory&) = default;

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("block_contact.pair", self.pair);
        visit("block_contact.feature", self.feature);
        visit("block_contact.plane", self.plane);
        visit("block_contact.normal", self.normal);
        visit("block_contact.slip", self.slip);
        visit("block_contact.mode", self.mode);
        visit("block_contact.is_intact", self.is_intact);
        visit("block_contact.plastic_slip", self.plastic_slip);
        visit("block_contact.energy", self.energy);
        visit("block_contact.bonded", self.bonded);
    }
};

}  // namespace riprap::solid::affine
