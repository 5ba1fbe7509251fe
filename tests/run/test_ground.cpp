// SPDX-License-Identifier: Apache-2.0
// Blocks and water on ground of many triangles.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "ground_case.hpp"
#include "riprap/body/ground.hpp"
#include "riprap/io/vtp.hpp"

namespace riprap::run {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Ground, lets_a_block_slide_over_its_triangles_as_over_a_plane) {
    CaseFolder folder;
    folder.write_heights(21, 13, 0.17, [](double x, double) { return -slope_tangent * x; });
    const Vec3 smooth = place_of_last(run(folder, slope(slope_plane, slope_box)));
    const Vec3 rough = place_of_last(run(folder, slope(slope_grid, slope_box)));
    const double way = norm(smooth - slope_start);
    EXPECT_NEAR(way, 0.5 * 9.81 * (0.5 - slope_tangent * 1.5 * std::tan(M_PI / 9)) * 0.25, 2e-3);
    EXPECT_LT(norm(rough - smooth), 1e-3 * way);
}

TEST(Ground, of_triangles_from_a_file_without_an_up_lets_a_block_slide_the_same_way) {
    CaseFolder folder;
    folder.write("bed.obj", slope_strip());
    const Vec3 smooth = place_of_last(run(folder, slope(slope_plane, slope_box)));
    const Vec3 rough =
        place_of_last(run(folder, slope("{ mesh = { file = 'bed.obj', units = 'm', thickness = 0.6 } }", slope_box)));
    EXPECT_LT(norm(rough - smooth), 1e-3 * norm(smooth - slope_start));
}

TEST(Ground, is_the_same_from_a_file_of_paraview_as_from_another) {
    const CaseFolder folder;
    const std::vector<Vec3> corners{
        {-1, -1, slope_tangent}, {2, -1, -2 * slope_tangent}, {2, 1, -2 * slope_tangent}, {-1, 1, slope_tangent}};
    std::string obj;
    for (const Vec3& x : corners) {
        obj += fmt::format("v {:.17g} {:.17g} {:.17g}\n", x.x, x.y, x.z);
    }
    folder.write("bed.obj", obj + "f 1 2 3\nf 1 3 4\n");
    io::PolyData faces;
    faces.points = corners;
    faces.connectivity = {0, 1, 2, 0, 2, 3};
    faces.offsets = {3, 6};
    folder.write("bed.vtp", io::encode_vtp(faces, 0));
    const auto place = [&](const std::string& file) {
        return place_of_last(
            run(folder, slope("{ mesh = { file = '" + file + "', units = 'm', thickness = 0.6 } }", slope_box)));
    };
    EXPECT_EQ(place("bed.vtp"), place("bed.obj"));
}

TEST(Ground, lets_a_ball_roll_over_its_triangles_as_over_a_plane) {
    CaseFolder folder;
    folder.write_heights(21, 13, 0.17, [](double x, double) { return -slope_tangent * x; });
    const std::string method = "[solid]\nmethod = 'sphere_dem'\nspheres = 'one'\nyoungs_modulus = 1e7\n";
    const double radius = std::cbrt(0.75 * 0.008 / M_PI);
    const std::string ball =
        fmt::format("shape = {{ cube = 0.2 }}\nposition = [{}, 0.02, {}]", 0.5 * radius, 0.8660254037844386 * radius);
    const Vec3 smooth = place_of_last(run(folder, slope(slope_plane, ball, method)));
    const Vec3 rough = place_of_last(run(folder, slope("{ terrain = { file = 'bed.asc' } }", ball, method)));
    EXPECT_GT(norm(smooth), 0.3);
    EXPECT_LT(norm(rough - smooth), 1e-3 * norm(smooth));
}

TEST(Ground, that_is_bumpy_and_frictionless_takes_no_energy_of_a_block_that_slides_over_ridges_and_valleys) {
    CaseFolder folder;
    folder.write_heights(15, 11, 0.25,
                         [](double x, double y) { return 0.05 * std::sin(4 * x) + 0.03 * std::cos(5 * y); });
    const auto end = run(folder, R"(gravity = [0.0, 0.0, -9.81]
end = 0.4
time_step_factor = 0.1
[material.ice]
density = 900.0
normal_stiffness = 1.0e6
[[body]]
name = "ground"
material = "ice"
fixed = true
shape = { terrain = { file = 'bed.asc' } }
[[body]]
name = "block"
material = "ice"
shape = { box = [0.3, 0.3, 0.1] }
position = [-0.3, 0.2, 0.2]
velocity = [2.0, 0.5, 0.0]
)");
    const body::BodySet& bodies = end->model().bodies;
    const body::BodyState& state = end->state().bodies;
    const Vec3 spin = body::angular_velocity(bodies, state, BodyId{1});
    const double kinetic =
        0.5 * bodies.mass[1] * norm_squared(state.velocity[1]) + 0.5 * dot(spin, state.angular_momentum[1]);
    const double before = bodies.mass[1] * (0.5 * 4.25 + 9.81 * 0.2);
    const double after = kinetic + bodies.mass[1] * 9.81 * state.position[1].z;
    EXPECT_GT(norm(spin), 0.3);                 // it has met bumps
    EXPECT_GT(state.position[1].z, -0.05);      // and has not sunk in
    EXPECT_NEAR(after, before, 5e-3 * before);  // but for what the springs hold now
}

/// A lake over a bumpy bed between walls.
std::string lake(const std::string& fluid, double end) {
    return fmt::format(R"(dimension = 2
gravity = [0.0, -9.81]
end = {}
[material.rock]
density = 2400.0
normal_stiffness = 1.0e7
[fluid]
{}
spacing = 0.025
domain = {{ low = [0.0, -0.3], high = [1.5, 0.8] }}
[[fluid.region]]
box = {{ low = [0.0, -0.3], high = [1.5, 0.4] }}
[[body]]
name = "left"
material = "rock"
shape = {{ half_space = {{ normal = [1, 0] }} }}
fixed = true
[[body]]
name = "right"
material = "rock"
shape = {{ half_space = {{ normal = [-1, 0], offset = -1.5 }} }}
fixed = true
[[body]]
name = "bed"
material = "rock"
fixed = true
shape = {{ terrain = {{ profile = [[-0.2, 0.0], [0.3, -0.1], [0.5, 0.08], [0.7, 0.05], [0.9, -0.17], [1.2, -0.05], [1.7, 0.1]] }} }}
)",
                       end, fluid);
}

TEST(Ground, keeps_a_still_lake_still) {
    const CaseFolder folder;
    const auto end = run(folder, lake("method = 'sph'", 2.0));
    double sum = 0;
    for (const Vec3& v : end->state().fluid.velocity) {
        sum += norm_squared(v);
    }
    const double speed = std::sqrt(sum / static_cast<double>(end->state().fluid.size()));
    EXPECT_LT(speed, 0.02 * std::sqrt(9.81 * 0.5));  // the same that walls along the lattice are allowed
}

TEST(Ground, under_a_grid_fluid_keeps_a_still_lake_still_to_round_off) {
    const CaseFolder folder;
    const auto end = run(folder, lake("method = 'grid'", 0.5));
    const auto kinetic = sim::find_column(end->model(), "fluid.kinetic");
    ASSERT_TRUE(kinetic.has_value());
    EXPECT_LT(sim::evaluate(*kinetic, end->now()), 1e-20);  // [J/m], of 1 kJ/m that it has above the bed
}

TEST(Ground, holds_the_water_of_every_particle_method) {
    const CaseFolder folder;
    for (const std::string method : {"sph", "wcmps", "mps"}) {
        const auto end = run(folder, lake("method = '" + method + "'", 0.3));
        const auto grounds = body::find_grounds(end->model().bodies, end->model().shapes);
        ASSERT_EQ(grounds.size(), 1U);
        const auto b = static_cast<std::size_t>(grounds[0].body.value);
        const Pose pose{end->state().bodies.position[b], end->state().bodies.orientation[b]};
        for (const Vec3& x : end->state().fluid.position) {
            EXPECT_FALSE(grounds[0].field.is_inside(to_body(pose, x))) << method << ' ' << x.x << ' ' << x.y;
        }
    }
}

}  // namespace
}  // namespace riprap::run
