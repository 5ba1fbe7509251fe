// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/body/body_kinematics.hpp"
#include "riprap/contact/broadphase/pair_cache.hpp"
#include "riprap/contact/frame.hpp"
#include "riprap/contact/pipeline.hpp"
#include "riprap/core/sum.hpp"
#include "riprap/solid/solid_times.hpp"
#include "riprap/solid/sphere_dem/sphere_state.hpp"

namespace riprap::solid::sphere_dem {

/// One sphere as the contact loop reads it: 96 bytes, three quarters of two cache lines.
struct alignas(32) SphereRecord {
    double x, y, z, radius;           ///< centre [m]
    double vx, vy, vz, inverse_mass;  ///< velocity of the centre [m/s]; of the body [1/kg]
    double wx, wy, wz, material;      ///< spin [rad/s]; number of the material
};

/// Sum of loads of contacts on one sphere: one cache line.
struct alignas(64) LoadRow {
    Vec3 force;   ///< [N]
    Vec3 torque;  ///< about the centre of the sphere [N m]
    double unused[2];
};

/// Energies and extremes of one evaluation of contacts.
struct ContactSums {
    double elastic{0};        ///< stored in normal, tangential and rolling springs [J]
    double friction_loss{0};  ///< in this step [J]
    double dashpot_power{0};  ///< that dashpots take at the velocities before the kick [W]
    double rolling_loss{0};   ///< in this step [J]
    double deepest{0};        ///< largest overlap over the smaller radius [-]

    template <class By>
    static void join(ContactSums& a, const ContactSums& b, const By& by) {
        by.add(a.elastic, b.elastic);
        by.add(a.friction_loss, b.friction_loss);
        by.add(a.dashpot_power, b.dashpot_power);
        by.add(a.rolling_loss, b.rolling_loss);
        by.largest(a.deepest, b.deepest);
    }
    ContactSums& operator+=(const ContactSums& b) {
        join(*this, b, parallel::JoinBy<parallel::AddRounded>{});
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

/// Rows in which the two ends of a contact are added up.
struct ContactEnds {
    std::uint32_t a, b;
};

/// Candidate pairs of spheres in slots, sorted by (a, b); slots come in groups of eight, the last one filled up with
/// copies of the last pair.
struct Slots {
    std::vector<std::int32_t> a, b;
    std::vector<std::uint8_t> touching;  ///< one bit per slot of a group, as the springs of State stand
    std::vector<std::uint8_t> found;     ///< likewise, at the poses now
    std::vector<ContactEnds> ends;       ///< per slot
    std::int64_t count{0};
    bool is_fresh{false};  ///< filled since the springs were carried last
    std::int64_t group_count() const { return (count + 7) / 8; }
};

/// Where loads on spheres are added up. The contacts whose sphere A is one of a block of 512 numbers are one thread's
/// work: they have rows of their own, one per sphere of the block and one per sphere elsewhere that is B of one of
/// them. So sums have the same bits for any number of threads, for any list of candidates, and where only some of the
/// blocks are kept.
struct LoadRows {
    static constexpr std::int32_t block_spheres = 512;
    std::vector<std::int32_t> first_sphere;  ///< per block; block count + 1 entries
    std::vector<std::uint32_t> own_row;      ///< of each sphere in its own block
    std::vector<LoadRow> rows;
    std::vector<std::uint32_t> first_row;  ///< per block; block count + 1 entries
    /// A row of a sphere elsewhere that goes to the one in its own block.
    struct Merge {
        std::uint32_t from, to;
    };
    std::vector<Merge> merges;               ///< by sphere, then in the order of the blocks that they come from
    std::vector<std::uint32_t> merge_begin;  ///< per block of the spheres, into `merges`; block count + 1 entries
    std::int64_t block_count() const { return static_cast<std::int64_t>(first_row.size()) - 1; }
};

/// One contact of a sphere with a part or triangle.
struct WallContact {
    std::int32_t sphere, wall;
    Vec3 normal;        ///< from the sphere into the wall [-]
    Vec3 point;         ///< of the wall's surface that is nearest to the centre [m]
    double overlap;     ///< [m]
    double weight;      ///< share of the contact in those of its pair of bodies [-]
    double room;        ///< that max_overlap is a share of: R, less in a thin part that an edge may pass through [m]
    double portion{1};  ///< of the sample, see SphereSet [-]
};

/// Loads of one contact with a wall, about the centres of mass.
struct WallLoad {
    Vec3 force, torque;  ///< on the body of the sphere [N], [N m]
    Vec3 wall_torque;    ///< [N m]
    Vec3 dashpot;        ///< part of the force that dashpots have [N]
};

/// Buffers of the method: Scratch. Dropping it changes no result.
struct SphereScratch {
    Placed placed;
    contact::PairCache pairs;
    Slots slots;
    LoadRows load_rows;
    std::vector<contact::PartPair> wall_pairs;            ///< candidates (sphere, wall)
    std::vector<ContactEnds> ends, old_ends;              ///< per contact of State; before it changed
    std::vector<std::uint32_t> first_row, old_first_row;  ///< first contact per chunk of groups
    std::vector<std::uint32_t> count;                     ///< contacts found per chunk, and a 0
    std::vector<std::uint8_t> has_changed;                ///< per chunk
    std::vector<std::vector<double>> dropped;             ///< energies of the springs that a chunk lost [J]
    std::vector<double> weight;                           ///< per contact; empty where all are 1
    bool keeps_forces{false};                             ///< output wants the forces of contacts
    std::vector<Vec3> forces;                             ///< then: per contact, on its sphere A [N]; else empty
    std::vector<Vec3> dashpots;                           ///< per contact, what dashpots do to its sphere A [N]
    std::vector<Vec3> spin_after;                         ///< of bodies after the kick [rad/s]
    Springs old;                                          ///< buffers of the springs that are replaced
    std::vector<WallContact> walls;
    std::vector<std::vector<WallContact>> wall_chunks;
    std::vector<WallLoad> wall_loads;
    std::vector<std::uint64_t> group_key, group_key_scratch;
    std::vector<std::uint32_t> group_contact, group_contact_scratch;
    std::vector<double> overlap;
    body::BodyKinematics kinematics;
    body::Loads loads;
    std::int64_t evaluations{-1};  ///< of State that the buffers belong to
    bool is_simple{false};         ///< every body that can move freely is one sphere about its centre of mass
    bool is_prepared{false};
    SolidTimes times;
};

}  // namespace riprap::solid::sphere_dem
