// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "riprap/sim/quantity.hpp"

namespace riprap::sim {
namespace {

/// Two bodies with a known pose and motion; body 0 is "block", 1 and 2 are "wall[0]" and "wall[1]".
struct Scene {
    Model model;
    State initial, state;

    Scene() {
        body::BodySet& bodies = model.bodies;
        bodies.names = {"block", "wall"};
        bodies.name_id = {0, 1, 1};
        bodies.name_index = {-1, 0, 1};
        bodies.mass = {2, 3, 4};
        bodies.principal_moments = {{1, 2, 3}, {1, 1, 1}, {1, 1, 1}};
        bodies.principal_axes.resize(3);
        bodies.driven.assign(3, -1);
        initial.bodies.position = {{1, 2, 3}, {}, {}};
        initial.bodies.orientation.resize(3);
        initial.bodies.velocity.resize(3);
        initial.bodies.angular_momentum.resize(3);
        state = initial;
        state.time = 0.5;
        state.step = 7;
        state.bodies.position[0] = {4, 6, 3};
        state.bodies.velocity[0] = {0, 3, 4};
        state.bodies.orientation[0] = from_rotation_vector({0, 0, 0.3});
        state.bodies.angular_momentum[0] = {0, 0, 6};  // about the third principal axis: omega = 2
        model.output.probes = {{"gauge", BodyId{0}, "displacement"}, {"energy", BodyId{}, "solid.kinetic"}};
    }
    double value(const char* text, const StepReport* report = nullptr) const {
        const std::optional<Column> column = find_column(model, text);
        EXPECT_TRUE(column.has_value()) << text;
        return evaluate(*column, {model, initial, state, nullptr, report});
    }
};

TEST(Quantity, BodiesAreAskedByNameQuantityAndComponent) {
    const Scene scene;
    EXPECT_EQ(scene.value("block.position.y"), 6);
    EXPECT_EQ(scene.value("block.displacement.x"), 3);
    EXPECT_EQ(scene.value("block.distance"), 5);
    EXPECT_EQ(scene.value("block.speed"), 5);
    EXPECT_NEAR(scene.value("block.rotation"), 0.3, 1e-15);
    EXPECT_NEAR(scene.value("block.rotation_vector.z"), 0.3, 1e-15);
    EXPECT_NEAR(scene.value("block.angular_velocity.z"), 2, 1e-14);
    EXPECT_NEAR(scene.value("block.kinetic_energy"), 0.5 * 2 * 25 + 0.5 * 3 * 4, 1e-13);
    EXPECT_EQ(scene.value("wall[1].position.x"), 0);
}

TEST(Quantity, ProbesAreAskedByTheirOwnName) {
    const Scene scene;
    EXPECT_EQ(scene.value("gauge.y"), 4);
    StepReport report;
    report.ledger.kinetic = 12;
    EXPECT_EQ(scene.value("energy", &report), 12);
}

TEST(Quantity, TheSceneIsAskedByQuantityAlone) {
    const Scene scene;
    StepReport report;
    report.max_speed = 3;
    report.contact_count = 9;
    report.ledger.momentum = {1, 2, 3};
    EXPECT_EQ(scene.value("time"), 0.5);
    EXPECT_EQ(scene.value("step"), 7);
    EXPECT_EQ(scene.value("max_speed", &report), 3);
    EXPECT_EQ(scene.value("contact_count", &report), 9);
    EXPECT_EQ(scene.value("momentum.z", &report), 3);
}

TEST(Quantity, WhatDoesNotExistYetIsMissing) {
    const Scene scene;
    EXPECT_TRUE(std::isnan(scene.value("block.contact_force.x")));
    EXPECT_TRUE(std::isnan(scene.value("max_overlap")));
}

TEST(Quantity, WhatDoesNotExistIsNotFound) {
    const Scene scene;
    for (const char* text : {"", "block", "block.position", "block.speed.x", "block.colour", "stone.speed",
                             "wall.speed", "momentum", "solid.kinetic.x", "gauge", "gauge.w", ".speed", "block..x"}) {
        EXPECT_FALSE(find_column(scene.model, text).has_value()) << text;
    }
}

TEST(Quantity, EveryLineOfTheTableHasAUnitAHelpAndAName) {
    std::set<std::pair<bool, std::string_view>> names;
    for (const QuantityInfo& info : quantities()) {
        EXPECT_TRUE(names.insert({info.is_of_body, info.name}).second) << info.name << " twice";
        EXPECT_FALSE(info.unit.empty() || info.help.empty()) << info.name;
        EXPECT_EQ(find_quantity(info.name, info.is_of_body), &info);
    }
}

TEST(Quantity, OfMatterIsPerMetreOfWidthInAPlanarScene) {
    for (const QuantityInfo& info : quantities()) {
        const bool is_of_matter = info.unit.find_first_of("NJW") != std::string_view::npos ||
                                  info.unit.starts_with("kg") || info.unit == "m^3";
        EXPECT_EQ(unit_in(info.unit, true), std::string(info.unit) + (is_of_matter ? "/m" : "")) << info.name;
        EXPECT_EQ(unit_in(info.unit, false), info.unit) << info.name;
    }
    EXPECT_EQ(unit_in("m^3/s", true), "m^3/s/m");  // as overtopping is told
    EXPECT_EQ(unit_in("Pa", true), "Pa");
    Scene scene;
    scene.model.bodies.is_planar = true;
    EXPECT_EQ(find_column(scene.model, "solid.kinetic")->unit, "J/m");
    EXPECT_EQ(find_column(scene.model, "block.contact_force.x")->unit, "N/m");
    EXPECT_EQ(find_column(scene.model, "block.speed")->unit, "m/s");
}

}  // namespace
}  // namespace riprap::sim
