// SPDX-License-Identifier: Apache-2.0
// Tries the contacts that a run shows, by every solid method: they carry the contact force of every body.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/shown.hpp"

namespace riprap::run {
namespace {

/// Two blocks slide on a floor, and a third with one of them.
/// @param shape  of the blocks; empty: cubes
std::string sliding_blocks(const std::string& solid, bool is_planar, const std::string& shape) {
    const auto place = [is_planar](double x, double up) {
        return is_planar ? fmt::format("[{}, {}]", x, up) : fmt::format("[{}, {}, 0.0]", x, up);
    };
    const std::string cube = is_planar ? "{ box = [1.0, 1.0] }" : "{ cube = 1.0 }";
    const std::string floor = is_planar ? "[9, 1]" : "[9, 1, 3]";
    std::string text = fmt::format(R"({}gravity = {}
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1e7
friction_coefficient = 0.5
damping_ratio = 0.1
[[body]]
name = "floor"
fixed = true
material = "rock"
shape = {{ box = {} }}
position = {}
)",
                                   is_planar ? "dimension = 2\n" : "", place(0, -9.81), floor, place(0, -0.5));
    for (const auto& [name, x, up] :
         {std::tuple("left", -1.0, 0.499), std::tuple("right", 1.0, 0.499), std::tuple("top", 1.0, 1.497)}) {
        text += fmt::format("[[body]]\nname = \"{}\"\nmaterial = \"rock\"\nshape = {}\nposition = {}\nvelocity = {}\n",
                            name, shape.empty() ? cube : shape, place(x, up), place(0.3, -0.1));
    }
    return text + "[solid]\n" + solid;
}

TEST(ShownContacts, CarryTheContactForceOfEveryBody) {
    const std::string ball = "{ sphere = 0.5 }";
    for (const auto& [solid, shape] : std::vector<std::pair<std::string, std::string>>{
             {"method = \"distance_potential_dem\"\n", ""},
             {"contact = \"common_plane_soft\"\n", ""},
             {"method = \"explicit_dda\"\n", ""},
             {"method = \"implicit_dda\"\n", ""},
             {"method = \"planar_dda\"\n", ""},
             {"method = \"sphere_dem\"\n", ""},
             {"method = \"sphere_dem\"\n", ball},
             {"method = \"sphere_dem\"\ntangential_law = \"tanh\"\nnormal_law = \"linear\"\n", ball},
             {"method = \"sphere_dem\"\nspheres = \"balls\"\n", ""}}) {
        SCOPED_TRACE(solid + shape);
        const bool is_planar = solid.find("planar") != std::string::npos;
        // Spheres that sample two faces need not touch.
        const bool is_sampled = solid == "method = \"sphere_dem\"\n" && shape.empty();
        Simulation simulation(
            scene::read_case_text(sliding_blocks(solid, is_planar, shape), "case.toml", "/nonexistent", {}));
        for (int k = 0; k < 3; ++k) {
            ASSERT_TRUE(simulation.step(k < 2 ? sim::Measure::flow : sim::Measure::energy).is_accepted());
        }
        const auto contacts = shown_contacts(simulation.model(), simulation.state(), simulation.scratch());
        const std::vector<Vec3>& expected = simulation.scratch().contact_force();
        std::vector<Vec3> force(expected.size());
        std::set<std::pair<std::int32_t, std::int32_t>> pairs;
        double largest = 0;
        for (const contact::ShownContact& contact : contacts) {
            force[static_cast<std::size_t>(contact.a.value)] += contact.force;
            force[static_cast<std::size_t>(contact.b.value)] -= contact.force;
            pairs.insert(std::minmax(contact.a.value, contact.b.value));
            largest = std::max(largest, norm(contact.force));
            EXPECT_GE(contact.normal_force, 0);
            EXPECT_NEAR(norm_squared(contact.force),
                        contact.normal_force * contact.normal_force + contact.shear_force * contact.shear_force,
                        1e-6 * norm_squared(contact.force));
            EXPECT_LT(contact.overlap, 0.01);
            EXPECT_NEAR(contact.point.y, contact.b.value == 3 || contact.a.value == 3 ? 1.0 : 0.0, 0.01);
        }
        EXPECT_THAT(pairs, testing::IsSupersetOf({testing::Pair(0, 1), testing::Pair(0, 2)}));
        EXPECT_TRUE(is_sampled || pairs.contains({2, 3}));
        for (std::size_t b = 0; b < force.size(); ++b) {
            EXPECT_LT(norm(force[b] - expected[b]), 1e-9 * largest) << "body " << b;
        }
    }
}

TEST(ShownContacts, AreNoneBeforeTheFirstStep) {
    Simulation simulation(scene::read_case_text(sliding_blocks("method = \"explicit_dda\"\n", false, ""), "case.toml",
                                                "/nonexistent", {}));
    EXPECT_THAT(shown_contacts(simulation.model(), simulation.state(), simulation.scratch()), testing::IsEmpty());
}

}  // namespace
}  // namespace riprap::run
