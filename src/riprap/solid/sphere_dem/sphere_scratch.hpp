// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/body/body_kinematics.hpp"
#include "riprap/contact/broadphase/pair_cache.hpp"
#include "riprap/contact/frame.hpp"
#include "riprap/contact/pipeline.hpp"
#include "riprap/solid/sphere_dem/sphere_state.hpp"

namespace riprap::solid::sphere_dem {

/// One sphere as the contact loop reads it: 96 bytes, three quarters of two cache lines.
struct alignas(32) SphereRecord {
    double x, y, z, radius;           ///< centre [m]
    double vx, vy, vz, inverse_mass;  ///< velocity of the centre [m/s]; of the body [1/kg]
    double wx, wy, wz, material;      ///< spin [rad/s]; number of the material
};

/// Load of one contact on sphere A: 48 bytes. B gets -force and `turn` times its own radius.
struct ContactLoad {
    Vec3 force;  ///< [N]
    Vec3 turn;   ///< torque on a sphere about its centre, over its radius [N]
};

/// Energies and extremes of one evaluation of contacts.
struct ContactSums {
    double elastic{0};        ///< stored in normal, tangential and rolling springs [J]
    double friction_loss{0};  ///< in this step [J]
    double damping_loss{0};   ///< in this step [J]
    double rolling_loss{0};   ///< in this step [J]
    double deepest{0};        ///< largest overlap over the smaller radius [-]

    ContactSums& operator+=(const ContactSums& b) {
        elastic += b.elastic;
        friction_loss += b.friction_loss;
        damping_loss += b.damping_loss;
        rolling_loss += b.rolling_loss;
        deepest = deepest > b.deepest ? deepest : b.deepest;
        return *this;
    }
};

/// Everything that spheres meet, as the search for pairs sees it: spheres, then parts, then triangles.
struct Placed {
    std::vector<SphereRecord> records;  ///< per sphere
    std::vector<Vec3> center;           ///< of bounding spheres [m]
    std::vector<double> radius;         ///< [m]
    std::vector<std::int32_t> body;
    std::vector<std::uint8_t> is_mobile;
    std::vector<contact::Frame> part_frame;  ///< per polyhedral part
    std::vector<contact::Giant> giants;
    std::vector<Vec3> corner;  ///< three per triangle, world axes [m]
    double median_radius{0};
};

/// Candidate pairs of spheres in slots, sorted by (a, b); slots come in groups of eight, the last one filled up with
/// copies of the last pair.
struct Slots {
    std::vector<std::int32_t> a, b;
    std::vector<std::uint8_t> touching;         ///< one bit per slot of a group
    std::vector<std::uint32_t> begin;           ///< first slot of each sphere as A; sphere count + 1 entries
    std::vector<std::uint32_t> incoming_begin;  ///< the same into `incoming`
    std::vector<std::uint32_t> incoming;        ///< slots in which the sphere is B, increasing
    std::vector<ContactLoad> load;              ///< per slot; zero where not touching
    std::int64_t count{0};
    std::int64_t group_count() const { return (count + 7) / 8; }
};

/// One contact of a sphere with a part or triangle.
struct WallContact {
    std::int32_t sphere, wall;
    Vec3 normal;     ///< from the sphere into the wall [-]
    Vec3 point;      ///< of the wall's surface that is nearest to the centre [m]
    double overlap;  ///< [m]
    double weight;   ///< share of the contact in those of its pair of bodies [-]
};

/// Buffers of the method: Scratch. Dropping it changes no result.
struct SphereScratch {
    Placed placed;
    contact::PairCache pairs;
    Slots slots;
    std::vector<contact::PartPair> wall_pairs;  ///< candidates (sphere, wall)
    std::vector<std::uint32_t> contact_slot;    ///< per contact of State
    std::vector<std::uint32_t> chunk_count;
    std::vector<double> weight;  ///< per contact; empty where all are 1
    std::vector<Vec3> couple;    ///< per slot: rolling couple on A [N m]; empty without rolling resistance
    std::vector<std::uint8_t> is_carried;
    Springs old;  ///< buffers of the springs that are replaced
    std::vector<WallContact> walls;
    std::vector<std::vector<WallContact>> wall_chunks;
    std::vector<std::uint64_t> group_key, group_key_scratch;
    std::vector<std::uint32_t> group_contact, group_contact_scratch;
    std::vector<double> overlap;
    body::BodyKinematics kinematics;
    body::Loads loads;
    std::int64_t evaluations{-1};  ///< of State that the buffers belong to
    bool is_simple{false};         ///< every body that can move freely is one sphere about its centre of mass
    bool is_prepared{false};
};

}  // namespace riprap::solid::sphere_dem
