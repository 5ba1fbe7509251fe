// SPDX-License-Identifier: Apache-2.0
// Constants of water in joints, from where rows of particles stand before a face: docs/theory/coupling.md, 6.
#include "riprap/coupling/joints/joint_water.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "riprap/coupling/joints/solid_slopes.hpp"

namespace riprap::coupling {
namespace {

constexpr double pressure = 1000;  // of the water, everywhere [Pa]

/// Layers of samples of a loose slab (body 0) below y = 0 and of a still one (body 1) above y = gap, and rows of water;
/// lengths in spacings.
struct Faces {
    SampleSet samples;
    body::Motion motion;
    fluid::ParticleSettings settings;
    std::vector<std::uint8_t> is_still{0, 1}, is_loose{1, 0};
    std::vector<Vec3> water;

    Faces() {
        settings.spacing = 1;
        settings.particle_mass = 1000;
        settings.sound_speed = 30;
        settings.domain = {{-40, -40, 0}, {40, 40, 0}, {}, 2};
        motion.pose.resize(2);
    }
    /// Four layers from x = -10 to the face that ends them at `end`, or endless there.
    void add_slab(std::int32_t body, double face, double up, double end) {
        for (int layer = 0; layer < 4; ++layer) {
            for (double x = -9.5; x < end; x += 1) {
                samples.body.push_back(BodyId{body});
                samples.anchor.push_back({x, face - up * (layer + 0.5), 0});
                samples.normal.push_back({0, up, 0});
                samples.depth.push_back(layer + 0.5);
                samples.volume.push_back(1);
                samples.is_slippery.push_back(0);
            }
        }
    }
    /// @returns of the sample of the first layer that is nearest to x
    JointWater opening_at(double x) const {
        fluid::BoundaryParticles walls;
        walls.position.assign(samples.anchor.begin(), samples.anchor.end());
        const fluid::WendlandC2 kernel(settings.smoothing_length(), 2);
        fluid::WaterAtWalls at_walls;
        at_walls.weight.assign(walls.position.size(), 1);
        at_walls.pressure.assign(walls.position.size(), pressure);
        for (const Vec3& wall : walls.position) {
            Vec3 slope{};
            for (const Vec3& drop : water) {
                const Vec3 d = wall - drop;
                slope += norm(d) < settings.support_radius() ? kernel.slope_over_r(norm(d)) * d : Vec3{};
            }
            at_walls.slope.push_back(slope);
        }
        const auto slopes = solid_slopes(samples, motion, is_still, kernel, settings.support_radius(), settings.domain);
        JointPairs pairs;
        pairs.update(samples, {is_still, is_loose}, motion, walls, settings);
        std::vector<AroundSlot<float>> around;
        std::vector<JointWater> found;
        const JointSums<float> sums(pairs, pairs.placed(), settings, {});
        std::vector<std::uint8_t> marks;
        find_joint_water(pairs, sums, samples, slopes, motion, at_walls, settings,
                         find_wet_solids(pairs, motion.pose.size(), at_walls), around, marks, found);
        JointWater nearest;
        double distance = 1e300;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const JointFour& four = pairs.fours()[i / four_size];
            const Vec3 place = four.has(i % four_size) ? samples.anchor[four.sample(i % four_size)] : Vec3{};
            if (four.solid[i % four_size] == 0 && place.y == -0.5 && std::abs(place.x - x) < distance) {
                distance = std::abs(place.x - x);
                nearest = found[i];
            }
        }
        return nearest;
    }
};

/// Rows of water over an endless face, the first `height` above it.
JointWater under_rows(double height) {
    Faces faces;
    faces.add_slab(0, 0, 1, 10);
    for (int row = 0; row < 4; ++row) {
        for (double x = -14.5; x < 15; x += 1) {
            faces.water.push_back({x, height + row, 0});
        }
    }
    return faces.opening_at(0);
}

TEST(JointWaters, a_wall_feels_crowded_water_as_crowded_down_to_where_the_guard_holds_it) {
    EXPECT_NEAR(under_rows(0.5).felt, pressure, 0.005 * pressure);
    EXPECT_NEAR(under_rows(0.4).felt, 1.083 * pressure, 0.005 * pressure);  // sums over the lattice, by hand
    EXPECT_NEAR(under_rows(0.3).felt, 1.154 * pressure, 0.005 * pressure);
    // The guard lets no particle nearer than 0.2: what is nearer still is on its way through, not crowded.
    EXPECT_NEAR(under_rows(0.2).felt, 1.2 * pressure, 0.012 * pressure);
    EXPECT_NEAR(under_rows(0.1).felt, under_rows(0.2).felt, 0.005 * pressure);
}

TEST(JointWaters, water_a_sixth_of_a_spacing_farther_off_than_at_rest_counts_in_full_and_beyond_for_less) {
    const JointWater at_rest = under_rows(0.5), off = under_rows(0.5 + 1.0 / 7), far = under_rows(0.5 + 1.0 / 4);
    EXPECT_NEAR(off.weight, at_rest.weight, 1e-9 * at_rest.weight);
    EXPECT_NEAR(far.weight, 0.767 / 0.85 * at_rest.weight, 0.01 * at_rest.weight);
    // Ragged water is no less crowded than a lattice, so its pressure is taken as it is.
    EXPECT_GT(far.felt, off.felt);
}

/// Water beside the end of two slabs whose joint is open by a gap, its first column crowded.
double felt_at_mouth(double gap) {
    Faces faces;
    faces.add_slab(0, 0, 1, 0);
    faces.add_slab(1, gap, -1, 0);
    for (int column = 0; column < 4; ++column) {
        for (double y = -6.5 + 0.5 * gap; y < 7; y += 1) {
            faces.water.push_back({0.25 + column, y, 0});
        }
    }
    return faces.opening_at(-0.5).felt / pressure;
}

TEST(JointWaters, water_before_a_joint_is_crowded_while_it_is_shut_and_on_its_way_in_once_it_is_a_quarter_open) {
    const double shut = felt_at_mouth(0) - 1;
    EXPECT_GT(shut, 0.1);
    EXPECT_NEAR(felt_at_mouth(0.125) - 1, 0.5 * shut, 0.15 * shut);
    EXPECT_NEAR(felt_at_mouth(0.25) - 1, 0, 0.15 * shut);
}

}  // namespace
}  // namespace riprap::coupling
