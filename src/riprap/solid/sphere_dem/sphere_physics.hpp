// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/faces_on_faces.hpp"
#include "riprap/solid/pair_physics.hpp"
#include "riprap/solid/sphere_dem/sphere_model.hpp"
#include "riprap/solid/sphere_dem/sphere_scratch.hpp"
#include "riprap/solid/sphere_dem/sphere_state.hpp"

namespace riprap::solid {
struct SphereDemSettings;  // sphere_dem_settings.hpp
}

namespace riprap::solid::sphere_dem {

/// Data that the physics of this method read and write in one evaluation of the contacts.
struct Meeting {
    const SphereModel& model;
    const body::BodyState& bodies;
    double sliding_time;  ///< since the last evaluation [s]
    bool with_energy;     ///< of the faces' contacts; spheres know theirs anyway
    SphereState& state;
    SphereScratch& scratch;
    FacesOnFaces* faces;  ///< nullptr: no body that meets others by its faces can move
    double lost{0};       ///< by friction, of springs of spheres whose contact was lost [J]
    ContactSums sums{};   ///< of the contacts of spheres
};

// The physics of this method. For all of them, in the order of the list, `find` updates what touches; then, with the
// shares of contacts known, `respond` adds the loads.

struct SpheresOnSpheres {
    static constexpr PairOfKinds kinds{BodyKind::spheres, BodyKind::spheres};
    static std::vector<material::PropertyUse> reads(const SphereDemSettings& settings);
    static void find(Meeting& meeting);
    static void respond(Meeting& meeting);
    static std::int64_t count(const SphereModel& model, const SphereState& state);  ///< of touching pairs of bodies
};

struct SpheresOnFaces {
    static constexpr PairOfKinds kinds{BodyKind::spheres, BodyKind::faces};
    static std::vector<material::PropertyUse> reads(const SphereDemSettings& settings);
    static void find(Meeting& meeting);
    static void respond(Meeting& meeting);
    static std::int64_t count(const SphereModel& model, const SphereState& state);
};

struct FacesAmongSpheres {
    static constexpr PairOfKinds kinds{FacesOnFaces::kinds};
    static std::vector<material::PropertyUse> reads(const SphereDemSettings& /*settings*/) {
        return FacesOnFaces::reads({});
    }
    static void find(Meeting& meeting);
    static void respond(Meeting& meeting);
    /// Returns 0: FacesOnFaces::book counts.
    static std::int64_t count(const SphereModel& /*model*/, const SphereState& /*state*/) { return 0; }
};

using SpherePhysics = PairPhysics<  //
    SpheresOnSpheres,               //
    SpheresOnFaces,                 //
    FacesAmongSpheres               //
    >;

}  // namespace riprap::solid::sphere_dem
