// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/geometry/polyhedra/armour_units.hpp"
#include "riprap/geometry/polyhedra/random_bits.hpp"

namespace riprap::geometry {
namespace {

constexpr std::array units{ArmourUnit::cube, ArmourUnit::tetrapod, ArmourUnit::accropode, ArmourUnit::dolos,
                           ArmourUnit::core_loc};

double volume_of(const std::vector<Polyhedron>& parts) {
    double sum = 0;
    for (const Polyhedron& part : parts) {
        sum += mass_properties(part).volume;
    }
    return sum;
}

/// Counts the parts that hold a point.
int holders(const std::vector<Polyhedron>& parts, const Vec3& x) {
    int count = 0;
    for (const Polyhedron& part : parts) {
        bool holds = true;
        for (const auto& face : part.faces) {
            const Plane plane = face_plane(part.vertices, face);
            holds = holds && dot(plane.normal, x) <= plane.offset;
        }
        count += holds ? 1 : 0;
    }
    return count;
}

TEST(ArmourUnits, have_the_volume_of_the_cube_of_their_nominal_diameter) {
    for (const ArmourUnit unit : units) {
        EXPECT_NEAR(volume_of(armour_unit(unit, 1.7)), 1.7 * 1.7 * 1.7, 1e-12);
        EXPECT_NEAR(volume_of(planar_armour_unit(unit, 1.7)), 1.7 * 1.7, 1e-12);
    }
}

TEST(ArmourUnits, are_made_of_parts_that_do_not_overlap) {
    std::uint64_t draw = 0;
    const auto random = [&draw] { return 2 * unit_interval(mix_bits(3, ++draw)) - 1; };
    for (const ArmourUnit unit : units) {
        const auto parts = armour_unit(unit, 1), planar = planar_armour_unit(unit, 1);
        int inside = 0;
        for (int i = 0; i < 4000; ++i) {
            const Vec3 x{1.5 * random(), 1.5 * random(), 1.5 * random()};
            const int count = holders(parts, x);
            EXPECT_LE(count, 1);
            inside += count;
            EXPECT_LE(holders(planar, {x.x, x.y, 0}), 1);
        }
        EXPECT_NEAR(27.0 * inside / 4000, 1, 0.3);  // so no part lies elsewhere
    }
}

TEST(ArmourUnits, that_are_symmetric_have_their_centre_of_mass_in_the_origin) {
    for (const ArmourUnit unit : units) {
        for (const auto& parts : {armour_unit(unit, 1), planar_armour_unit(unit, 1)}) {
            Vec3 moment{};
            for (const Polyhedron& part : parts) {
                const MassProperties mass = mass_properties(part);
                moment += mass.volume * mass.centroid;
            }
            EXPECT_NEAR(norm(moment), 0, 1e-12);
        }
    }
}

}  // namespace
}  // namespace riprap::geometry
