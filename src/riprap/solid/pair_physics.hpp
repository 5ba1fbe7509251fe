// SPDX-License-Identifier: Apache-2.0
#pragma once

// Several physics of contact in one scene, chosen by the kinds of the two bodies that meet.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "riprap/material/property.hpp"
#include "riprap/solid/solid_scene.hpp"

namespace riprap::solid {

/// Stand-in by which a body meets others.
enum class BodyKind : std::uint8_t {
    faces,    ///< its shape: convex parts, half-spaces, ground
    spheres,  ///< spheres that a case lists or that a method lets stand for it
};
inline constexpr std::array<std::string_view, 2> kind_names{"faces", "spheres"};

/// Two kinds of bodies, in either order.
struct PairOfKinds {
    BodyKind a, b;
    constexpr bool is(BodyKind x, BodyKind y) const { return (a == x && b == y) || (a == y && b == x); }
};

/// Tells whether a list has a pair of kinds.
constexpr bool answers(std::span<const PairOfKinds> pairs, BodyKind a, BodyKind b) {
    for (const PairOfKinds& pair : pairs) {
        if (pair.is(a, b)) {
            return true;
        }
    }
    return false;
}

/// The physics of contact of a solid method: one line registers a physics. Each is a struct that says between which
/// `kinds` of bodies it acts and which properties of materials it `reads`, and has the verbs that the step of the
/// method calls for all of them. A method that meets faces with faces by itself lists OwnFaces.
template <class... Physics>
struct PairPhysics {
    static constexpr std::array<PairOfKinds, sizeof...(Physics)> kinds{Physics::kinds...};

    /// Calls work.template operator()<P>() for every physics, in the order of the list.
    template <class Work>
    static void for_each(const Work& work) {
        (work.template operator()<Physics>(), ...);
    }

 private:
    static constexpr bool is_once_each() {
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            if (answers(std::span(kinds).first(i), kinds[i].a, kinds[i].b)) {
                return false;
            }
        }
        return true;
    }
    static_assert(is_once_each(), "two physics for one pair of kinds");
};

/// The physics of a method that meets faces with faces by itself, and has `reads` itself.
template <class Method>
struct OwnFaces {
    static constexpr PairOfKinds kinds{BodyKind::faces, BodyKind::faces};
    template <class Settings>
    static std::vector<material::PropertyUse> reads(const Settings& settings) {
        return Method::reads(settings);
    }
};

/// Returns the pairs of kinds for which a solid method has a physics.
template <class Solid>
constexpr std::span<const PairOfKinds> pairs_of() {
    return Solid::Physics::kinds;
}

/// Properties of materials that the physics of a pair of kinds reads.
struct PhysicsReads {
    PairOfKinds kinds;
    std::vector<material::PropertyUse> uses;
};

/// Returns what a solid method reads of materials: `reads(settings)` of each of its physics.
template <class Solid>
std::vector<PhysicsReads> reads_of(const typename Solid::Settings& settings) {
    std::vector<PhysicsReads> all;
    Solid::Physics::for_each([&]<class Physics>() { all.push_back({Physics::kinds, Physics::reads(settings)}); });
    return all;
}

/// Returns the uses of all physics, one entry per property.
std::vector<material::PropertyUse> joined(std::span<const PhysicsReads> physics);

/// A property that a material does not give, though a physics of the scene needs it for a body of that material.
struct LackingProperty {
    BodyId body;  ///< first of its material
    material::Property property;
};
std::vector<LackingProperty> lacking_properties(const SolidScene& scene, std::span<const BodyKind> kinds,
                                                std::span<const PhysicsReads> physics);

/// Does a physics of the scene read a property? One whose kinds of bodies are there, one of them able to move.
/// @returns nothing where no physics is asked for
std::optional<bool> is_read_in_scene(const SolidScene& scene, std::span<const BodyKind> kinds,
                                     std::span<const PhysicsReads> physics, material::Property property);

/// Returns the kind of every body: spheres where the case lists them, else faces.
std::vector<BodyKind> kinds_by_lists(const SolidScene& scene);

/// A body whose kind meets another in the scene, one of them able to move, without a physics for that pair.
struct UnansweredBody {
    BodyId body;  ///< first of its kind
    BodyKind kind;
    std::vector<BodyKind> others;
};
std::vector<UnansweredBody> unanswered_bodies(const body::BodySet& bodies, std::span<const BodyKind> kinds,
                                              std::span<const PairOfKinds> pairs);

}  // namespace riprap::solid
