// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/hydrostatic/hydrostatic.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/tank_scenes.hpp"
#include "riprap/coupling/hydrostatic/basins.hpp"
#include "riprap/geometry/polyhedra/clip.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::coupling {
namespace {

constexpr double g = 9.81, rho = 1000;

/// Still water about one body, bound as a step does.
struct StillWater {
    test::Scene scene;
    body::Gravity gravity{.value = {0, 0, -g}};
    HydrostaticSettings settings;
    body::Motion motion;
    fluid::ParticleState particles;
    fluid::OpenState open;
    CouplingState coupling;

    StillWater() {
        settings.spacing = 0.1;
        settings.basins = {{{-5, -5, -5}, {5, 5, 5}, 0}};
    }
    FluidLoads loads(double time = 0) {
        FluidScene bound{scene.shapes, scene.bodies, gravity};
        NoFields fields;
        HydrostaticFluid::Scratch scratch;
        HydrostaticFluid water(bound, settings, {particles, open, coupling, scene.state}, fields, scratch);
        const auto count = static_cast<std::size_t>(scene.bodies.size());
        motion = {};
        for (std::size_t b = 0; b < count; ++b) {
            motion.pose.push_back({scene.state.position[b], scene.state.orientation[b]});
        }
        motion.velocity.assign(count, {});
        motion.angular_velocity.assign(count, {});
        FluidLoads found;
        water.load({time, 0}, motion, found);
        return found;
    }
};

TEST(Hydrostatic, a_body_under_water_loses_the_weight_of_its_volume_of_water_however_it_lies) {
    StillWater water;
    water.scene.add(geometry::box({0.3, 0.5, 0.4}), {{1, 2, -1.3}, from_rotation_vector({0.4, -0.7, 1.1})});
    const FluidLoads loads = water.loads();
    const double buoyancy = rho * g * 0.3 * 0.5 * 0.4;
    EXPECT_NEAR(loads.pressure.force[0].x, 0, 1e-11 * buoyancy);
    EXPECT_NEAR(loads.pressure.force[0].y, 0, 1e-11 * buoyancy);
    EXPECT_NEAR(loads.pressure.force[0].z, buoyancy, 1e-11 * buoyancy);
    EXPECT_NEAR(norm(loads.pressure.torque[0]), 0, 1e-11 * buoyancy);
}

TEST(Hydrostatic, half_a_box_under_water_has_half_its_buoyancy_and_a_heeled_one_is_righted) {
    StillWater water;
    water.scene.add(geometry::box({1, 1, 0.4}), {{0, 0, 0}, {}});
    EXPECT_NEAR(water.loads().pressure.force[0].z, 0.5 * rho * g * 0.4, 1e-9);
    const double heel = 1e-4;  // righting moment of a box: weight times heel times (I/V - G above B)
    water.scene.state.orientation[0] = from_rotation_vector({heel, 0, 0});
    const double metacentre = (1.0 / 12) / 0.2 - 0.1;
    EXPECT_NEAR(water.loads().pressure.torque[0].x, -rho * g * 0.2 * metacentre * heel, 1e-5 * rho * g * 0.2 * heel);
}

TEST(Hydrostatic, a_level_follows_its_table_and_stays_beyond_it) {
    HydrostaticSettings settings;
    settings.levels = {{1, 0.5}, {3, 1.5}};
    const HydrostaticSettings::Basin basin;
    EXPECT_EQ(settings.level_at(basin, 0), 0.5);
    EXPECT_EQ(settings.level_at(basin, 2), 1.0);
    EXPECT_EQ(settings.level_at(basin, 7), 1.5);
    settings.levels.clear();
    EXPECT_EQ(settings.level_at({{}, {}, 4}, 2), 4);
}

/// A block on a floor, the water on its side of x < 0 alone, 2 m deep above the base.
StillWater dam(Uplift uplift) {
    StillWater water;
    water.scene.add(geometry::box({1, 1, 2}), {{0.5, 0, -1}, {}});
    water.scene.add(geometry::box({20, 20, 1}), {{0, 0, -2.5}, {}});
    water.settings.basins = {{{-5, -5, -5}, {0, 5, 5}, 0}};
    water.settings.uplift = uplift;
    return water;
}

TEST(Hydrostatic, a_dam_on_a_watertight_joint_is_pushed_but_not_lifted) {
    const FluidLoads loads = dam(Uplift::none).loads();
    EXPECT_NEAR(loads.pressure.force[0].x, 0.5 * rho * g * 4, 1e-9 * rho * g);  // rho g H^2/2 on a metre of width
    EXPECT_NEAR(loads.pressure.force[0].z, 0, 1e-9 * rho * g);
}

// Story: the region ended at the face, and its water was there or not by the strain of the block.
TEST(Hydrostatic, a_dam_that_strains_away_from_its_region_by_less_than_a_joint_keeps_its_thrust) {
    const double thrust = dam(Uplift::none).loads().pressure.force[0].x;
    for (const double way : {-4e-3, 4e-3}) {
        StillWater water = dam(Uplift::none);
        water.scene.state.position[0].x += way;
        EXPECT_NEAR(water.loads().pressure.force[0].x, thrust, 1e-9 * thrust) << way;
    }
    StillWater water = dam(Uplift::none);
    water.scene.state.position[0].x += 6e-3;
    EXPECT_EQ(water.loads().pressure.force[0].x, 0);
}

TEST(Hydrostatic, linear_uplift_is_half_of_the_full_one_under_a_dam) {
    const double lift = dam(Uplift::linear).loads().pressure.force[0].z;
    EXPECT_NEAR(lift, 0.5 * rho * g * 2, 1e-9 * rho * g * 2);
}

// Story: fixed and driven bodies felt nothing.
TEST(Hydrostatic, a_fixed_or_driven_body_under_water_is_lifted_by_the_weight_of_its_water) {
    for (const body::Drive drive : {body::Drive::fixed, body::Drive::driven}) {
        StillWater water;
        water.scene.add(geometry::box({0.3, 0.5, 0.4}), {{1, 2, -1.3}, from_rotation_vector({0.4, -0.7, 1.1})}, drive);
        water.scene.add(geometry::box({1, 1, 0.4}), {{-2, 0, 0.1}, {}}, drive);
        const FluidLoads loads = water.loads();
        EXPECT_NEAR(norm(loads.pressure.force[0] - Vec3{0, 0, rho * g * 0.06}), 0, 1e-9 * rho * g * 0.06);
        EXPECT_NEAR(norm(loads.pressure.force[1] - Vec3{0, 0, rho * g * 0.1}), 0, 1e-9 * rho * g);
    }
}

// Story: bodies with wet = false were lifted by their whole volume.
TEST(Hydrostatic, water_passes_through_a_dry_body_and_into_the_joint_below_it) {
    for (const body::Drive drive : {body::Drive::free, body::Drive::fixed}) {
        StillWater water;
        water.settings.uplift = Uplift::none;
        water.scene.add(geometry::box({1, 1, 0.4}), {{0, 0, -1.2}, {}}, body::Drive::free);
        water.scene.add(geometry::box({1, 1, 0.4}), {{0, 0, -1.6}, {}}, drive);
        EXPECT_NEAR(water.loads().pressure.force[0].z, -rho * g * 1.0, 1e-9 * rho * g);  // a watertight joint below
        water.settings.is_dry = {0, 1};
        const FluidLoads loads = water.loads();
        EXPECT_NEAR(loads.pressure.force[0].z, rho * g * 0.4, 1e-9 * rho * g);
        EXPECT_EQ(norm(loads.pressure.force[1]) + norm(loads.pressure.torque[1]), 0);
    }
}

TEST(Hydrostatic, a_wall_through_a_floor_is_pushed_by_the_water_on_the_floor_alone) {
    for (const bool by_half_space : {false, true}) {
        StillWater water;
        water.scene.add(geometry::box({1, 1, 20}), {{0.5, 0, 0}, {}}, body::Drive::driven);
        water.settings.basins = {{{-5, -5, by_half_space ? -5.0 : -2.0}, {0, 5, 5}, 0}};
        if (by_half_space) {
            water.scene.add_half_space({0, 0, 1}, -2);
        }
        const FluidLoads loads = water.loads();
        const double slack = 5e-3;  // the foot of the water is blurred by a twentieth of a panel
        EXPECT_NEAR(loads.pressure.force[0].x, 0.5 * rho * g * 4, 1.01 * slack * rho * g * 2);
        EXPECT_NEAR(loads.pressure.force[0].z, 0, 1e-9 * rho * g);
    }
}

TEST(Hydrostatic, a_floor_that_reaches_beyond_the_water_carries_its_weight_once) {
    StillWater water;
    water.scene.add(geometry::box({20, 20, 1}), {{0, 0, -2.5}, {}}, body::Drive::fixed);
    water.settings.basins = {{{-5, -5, -2}, {0.5, 5, 5}, 0}, {{0, -5, -2}, {5, 5, 5}, 0}};  // both overlap
    const double weight = rho * g * 2 * 100;
    EXPECT_NEAR(water.loads().pressure.force[0].z, -weight, 3e-3 * weight);
}

// Story: faces beyond a periodic side were dry, and a float was blown away.
/// Water 2 m deep with a leaning side through the line x = z = 0; its box reaches farther.
HydrostaticSettings::Basin leaning_basin(const Vec3& outward) {
    const geometry::Polyhedron box = geometry::moved(geometry::box({10, 10, 2}), Pose{{0, 0, -1}, Quat{}});
    FillRegion region;
    region.pieces.push_back(geometry::clip_convex(box, {outward, 0}));
    region.level = 0;
    HydrostaticSettings::Basin basin =
        basin_of(region, fluid::Domain{.low = {-5, -5, -5}, .high = {5, 5, 5}, .dimension = 3}, {0, 0, 1});
    basin.level = 0;
    return basin;
}

// Story: a block behind a leaning wall floated in the box about the water before it, and the wall, pressed from both of
// its sides, had 876 N/m of 2403.
TEST(Hydrostatic, a_region_with_a_leaning_side_ends_there_and_not_at_its_box) {
    for (const double angle : {-0.8, -0.3, 0.3, 0.8}) {
        const Vec3 outward{std::cos(angle), 0, std::sin(angle)}, along{-std::sin(angle), 0, std::cos(angle)};
        for (const body::Drive drive : {body::Drive::free, body::Drive::fixed}) {
            StillWater water;
            water.settings.basins = {leaning_basin(outward)};
            water.scene.add(geometry::box({0.2, 0.2, 0.2}), {-0.6 * outward - 1.0 * along, {}}, drive);
            water.scene.add(geometry::box({0.2, 0.2, 0.2}), {0.6 * outward - 1.0 * along, {}}, drive);
            const FluidLoads loads = water.loads();
            EXPECT_NEAR(loads.pressure.force[0].z, rho * g * 0.008, 1e-9) << angle;
            EXPECT_NEAR(norm(loads.pressure.force[1]), 0, 1e-9) << angle;
        }
        StillWater water;
        water.settings.basins = {leaning_basin(outward)};
        water.scene.add(geometry::box({0.4, 1, 12}), {0.2 * outward, from_rotation_vector({0, -angle, 0})},
                        body::Drive::fixed);
        const Vec3 force = water.loads().pressure.force[0];
        EXPECT_NEAR(force.x / (rho * g * 2), 1, 0.01) << angle;
        EXPECT_NEAR(force.z / (rho * g * 2), std::tan(angle), 0.01) << angle;
    }
}

TEST(Hydrostatic, a_float_across_a_periodic_side_is_carried_as_one_in_the_middle) {
    for (const body::Drive drive : {body::Drive::free, body::Drive::fixed}) {
        for (const double x : {0.0, 2.0, 4.0, 9.0}) {
            StillWater water;
            FieldScene field;
            field.domain = {{0, -5, -5}, {4, 5, 5}, {true, false, false}, 3};
            field.regions.emplace_back();
            field.regions.back().level = 0;
            water.settings.basins.clear();
            water.settings.prepare(field);
            water.scene.add(geometry::box({1, 1, 0.4}), {{x, 0, 0}, {}}, drive);
            const Vec3 force = water.loads().pressure.force[0];
            EXPECT_NEAR(norm(force - Vec3{0, 0, 0.5 * rho * g * 0.4}), 0, 1e-9 * rho * g) << x;
        }
    }
}

}  // namespace
}  // namespace riprap::coupling
