// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/near_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "riprap/fluid/particle/sweep/periodic_images.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::coupling {
namespace {

constexpr double within = 0.02;

/// A cloud of particles in a box of 1 m, cubes all over and above it, and a floor.
struct Cloud {
    geometry::ShapeSet shapes;
    std::vector<PlacedPart> parts;
    std::vector<Vec3> particles;
    fluid::Domain domain;

    Cloud(bool is_periodic, int cubes) : domain{{0, 0, -1}, {1, 1, 9}, {is_periodic, false, false}, 3} {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> unit(0, 1), turn(-1, 1);
        const ShapeId cube = shapes.add_convex(geometry::cube(0.15));
        const ShapeId floor = shapes.add_half_space({0, 0, 1}, 0.0);
        parts.push_back({shapes.view(floor), {}, 0, shapes.view(floor).circumradius + within});
        for (int k = 0; k < cubes; ++k) {
            const Quat q{turn(random), turn(random), turn(random), turn(random)};
            const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
            const Pose pose{{unit(random), unit(random), 8 * unit(random)},
                            {q.w / length, q.x / length, q.y / length, q.z / length}};
            parts.push_back({shapes.view(cube), pose, k + 1, shapes.view(cube).circumradius + within});
        }
        for (int i = 0; i < 12; ++i) {  // in small boxes that follow each other
            for (int j = 0; j < 12 * 12; ++j) {
                particles.push_back(
                    {(i + unit(random)) / 12, (j / 12 + unit(random)) / 12, (j % 12 + unit(random)) / 12});
            }
        }
    }
    /// The least distance of any image of a particle from the faces of a part, never more than the true one.
    double distance(std::size_t part, const Vec3& particle) const {
        const fluid::PeriodicImages images(domain);
        double least = 1e9;
        for (const Vec3& shift : images.shifts()) {
            const Vec3 local = to_body(parts[part].pose, particle + shift);
            least =
                std::min(least, norm(local) > parts[part].reach ? 1e9 : -depth_below_faces(parts[part].shape, local));
        }
        return least;
    }
    std::int64_t blocks() const {
        return (static_cast<std::int64_t>(particles.size()) + NearParts::block_size - 1) / NearParts::block_size;
    }
};

TEST(NearParts, leave_out_no_part_that_a_particle_of_the_block_touches) {
    for (const bool is_periodic : {false, true}) {
        const Cloud cloud(is_periodic, 300);
        NearParts near;
        near.find(cloud.parts, cloud.particles, cloud.domain, within);
        std::size_t touching = 0;
        for (std::size_t i = 0; i < cloud.particles.size(); ++i) {
            const auto named = near.of_block(static_cast<std::int64_t>(i) / NearParts::block_size);
            ASSERT_TRUE(std::is_sorted(named.begin(), named.end()));
            for (std::size_t p = 0; p < cloud.parts.size(); ++p) {
                if (cloud.distance(p, cloud.particles[i]) < within) {
                    ++touching;
                    ASSERT_TRUE(std::binary_search(named.begin(), named.end(), static_cast<std::int32_t>(p))) << p;
                }
            }
        }
        EXPECT_GT(touching, 100U);
    }
}

TEST(NearParts, name_a_part_that_is_far_from_all_particles_nowhere) {
    Cloud cloud(false, 300);
    cloud.parts[1].pose.position = {0.5, 0.5, 1 + cloud.parts[1].reach + 1e-3};
    cloud.parts[2].pose.position = {0.5, 0.5, 0.5};
    cloud.parts[2].reach = -1;  // dry
    NearParts near;
    near.find(cloud.parts, cloud.particles, cloud.domain, within);
    for (std::int64_t b = 0; b < cloud.blocks(); ++b) {
        for (const std::int32_t part : near.of_block(b)) {
            EXPECT_GT(part == 0 ? 3 : part, 2);
        }
    }
}

TEST(NearParts, name_a_floor_only_to_particles_that_stand_on_it) {
    const Cloud cloud(true, 0);
    NearParts near;
    near.find(cloud.parts, cloud.particles, cloud.domain, within);
    for (std::int64_t b = 0; b < cloud.blocks(); ++b) {
        double lowest = 1e9;
        for (std::int64_t i = b * NearParts::block_size;
             i <
             std::min<std::int64_t>(static_cast<std::int64_t>(cloud.particles.size()), (b + 1) * NearParts::block_size);
             ++i) {
            lowest = std::min(lowest, cloud.particles[static_cast<std::size_t>(i)].z);
        }
        EXPECT_EQ(near.of_block(b).empty(), lowest > within * (1 + 1e-6)) << lowest;
    }
}

TEST(NearParts, bear_that_there_are_no_particles_and_no_parts) {
    NearParts near;
    near.find({}, {}, {}, within);
    const Cloud cloud(false, 3);
    near.find(cloud.parts, {}, cloud.domain, within);
    near.find({}, cloud.particles, cloud.domain, within);
    EXPECT_TRUE(near.of_block(0).empty());
}

}  // namespace
}  // namespace riprap::coupling
