// SPDX-License-Identifier: Apache-2.0
#include <numeric>

#include "case_fixture.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/scene/warnings/initial_overlaps.hpp"

namespace riprap::scene {
namespace {

using namespace test;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string head = R"(gravity = [0.0, 0.0, -9.81]
end = 1.0
[material.rock]
density = 2000.0
normal_stiffness = 1.0e7
)";

double total_mass(const sim::Model& model) {
    return std::accumulate(model.bodies.mass.begin(), model.bodies.mass.end(), 0.0);
}

TEST(Packs, a_jointed_rock_mass_takes_five_lines_and_keeps_the_mass_of_its_region) {
    const LoadedCase loaded = read(head + R"([[rock_mass]]
name = "slope"
material = "rock"
region = { box = [4, 2, 3] }
position = [1, 2, 3]
fixed_below = 2.0
[[rock_mass.joint_set]]
dip_deg = 30
dip_direction_deg = 90
spacing = "0.5 m"
[[rock_mass.joint_set]]
dip_deg = 60
dip_direction_deg = 270
spacing = "0.7 m"
)");
    EXPECT_GT(loaded.model.bodies.size(), 30);
    EXPECT_NEAR(total_mass(loaded.model), 2000 * 24.0, 1e-8);
    bool has_fixed = false;
    for (std::size_t i = 0; i < loaded.model.bodies.mass.size(); ++i) {
        const bool is_fixed = loaded.model.bodies.drive[i] == body::Drive::fixed;
        EXPECT_EQ(is_fixed, loaded.state.bodies.position[i].z < 2.0);
        has_fixed = has_fixed || is_fixed;
    }
    EXPECT_TRUE(has_fixed);
    EXPECT_TRUE(find_initial_overlaps(loaded.model, loaded.state, 1e-9).empty());
}

TEST(Packs, joints_have_the_dip_direction_of_geologists) {
    // One set that dips 90 degrees towards east cuts along planes x = const, and nothing else.
    const LoadedCase loaded = read(head + R"([[rock_mass]]
name = "slabs"
material = "rock"
region = { box = [4, 1, 1] }
[[rock_mass.joint_set]]
dip_deg = 90
dip_direction_deg = 90
spacing = 1
)");
    ASSERT_EQ(loaded.model.bodies.size(), 4);
    std::vector<double> x;
    for (const Vec3& position : loaded.state.bodies.position) {
        x.push_back(position.x);
        EXPECT_NEAR(position.y, 0, 1e-12);
    }
    std::sort(x.begin(), x.end());
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(x[i], -1.5 + static_cast<double>(i), 1e-12);
    }
}

TEST(Packs, more_rock_blocks_than_the_limit_are_refused) {
    EXPECT_THAT(problems_of(head + R"([[rock_mass]]
name = "dust"
material = "rock"
region = { box = [100, 100, 100] }
[[rock_mass.joint_set]]
dip_deg = 0
dip_direction_deg = 0
spacing_mm = 1
[[rock_mass.joint_set]]
dip_deg = 90
dip_direction_deg = 0
spacing_mm = 1
)"),
                ElementsAre(StartsWith("case.toml:6:")));
}

TEST(Packs, voronoi_blocks_fill_their_region_and_depend_on_the_seed) {
    const std::string text = head + R"([[pack]]
name = "rubble"
material = "rock"
voronoi = { region = { box = [2, 1, 1] }, count = 40, lloyd = 2 }
)";
    const LoadedCase loaded = read(text);
    EXPECT_EQ(loaded.model.bodies.size(), 40);
    EXPECT_NEAR(total_mass(loaded.model), 4000, 1e-8);
    EXPECT_EQ(hash_fields(read(text).state), hash_fields(loaded.state));
    EXPECT_NE(hash_fields(read(text, {"seed=2"}).state), hash_fields(loaded.state));
    EXPECT_TRUE(find_initial_overlaps(loaded.model, loaded.state, 1e-9).empty());
    EXPECT_LT(total_mass(read(text, {"pack.rubble.voronoi.gap=1 mm"}).model), 4000 * 0.999);
}

TEST(Packs, a_mixed_lattice_has_its_kinds_in_their_shares) {
    const LoadedCase loaded = read(head + R"([[pack]]
name = "mix"
material = "rock"
[pack.lattice]
counts = [10, 10, 10]
pitch = [4, 4, 4]
total = 900
mix = [ { shape = { cube = 1 }, fraction = 3 }, { shape = { octahedron = 1 }, fraction = 1, sizes = [0.5, 1, 2] } ]
)");
    ASSERT_EQ(loaded.model.bodies.size(), 900);
    EXPECT_EQ(loaded.model.shapes.size(), 4);
    std::vector<int> count(4);
    for (const body::Part& part : loaded.model.bodies.parts) {
        count[static_cast<std::size_t>(part.shape.value)] += 1;
    }
    EXPECT_NEAR(count[0], 675, 4 * 13);
    for (std::size_t i = 1; i < 4; ++i) {
        EXPECT_NEAR(count[i], 75, 4 * 8.3);
    }
    EXPECT_NEAR(loaded.model.bodies.mass[0] > 0 ? norm(loaded.state.bodies.position[899] - Vec3{36, 36, 32}) : 1, 0,
                1e-9);
}

TEST(Packs, pieces_of_a_case_are_random_independently_of_each_other) {
    const std::string pack =
        "[[pack]]\nname = \"b\"\nmaterial = \"rock\"\nlattice = { counts = [3, 3, 3], pitch = [4, 4, 4], mix = [ { "
        "shape = { cube = 1 } } ] }\n";
    const std::string other =
        "[[body]]\nname = \"first\"\nmaterial = \"rock\"\nshape = { cube = 1 }\nposition = [-9, 0, 0]\n";
    const LoadedCase alone = read(head + pack), after = read(head + other + pack);
    for (std::size_t i = 0; i < 27; ++i) {
        EXPECT_EQ(alone.state.bodies.orientation[i], after.state.bodies.orientation[i + 1]);
    }
}

std::string two_cubes(const std::string& position) {
    return head + "[[body]]\nname = \"a\"\nmaterial = \"rock\"\nshape = { cube = 1 }\n" +
           "[[body]]\nname = \"b\"\nmaterial = \"rock\"\nshape = { cube = 1 }\nposition = " + position + "\n";
}

/// A layer of core-locs on a slope of 1:2 that is 12 m long and 8 m wide.
std::string armour(const std::string& keys) {
    return with(minimal_case, "[[body]]",
                "[[pack]]\nname = \"layer\"\nmaterial = \"rock\"\nslope = { shape = { armour = { unit = \"core_loc\", "
                "nominal_diameter = 1.0 } }, from = [10.0, 0.0, 0.0], to = [20.733126, 0.0, 5.366563], " +
                    keys + " }\n[[body]]");
}

TEST(ArmourLayer, has_the_units_of_its_packing_density_on_the_slope_and_none_starts_in_another) {
    for (const char* placement : {"regular", "random"}) {
        const LoadedCase loaded = read(
            armour("width = 8.0, layers = 1, packing_density = 0.6, placement = \"" + std::string(placement) + "\""));
        const auto count = loaded.model.bodies.size() - 1;
        EXPECT_EQ(count, 9 * 6) << placement;  // pitch 1/sqrt(0.6) = 1.291 m
        const Vec3 out = normalized(Vec3{-1, 0, 2});
        for (std::int32_t b = 0; b < loaded.model.bodies.size(); ++b) {
            if (loaded.model.bodies.name(BodyId{b}) == "block") {
                continue;
            }
            const Vec3 x = loaded.state.bodies.position[static_cast<std::size_t>(b)] - Vec3{10, 0, 0};
            EXPECT_GT(dot(x, out), 0.3) << placement;  // on the slope
            EXPECT_GE(x.y, -1e-9);
            EXPECT_LE(x.y, 8.0);
        }
    }
}

TEST(ArmourLayer, on_a_slope_that_falls_or_without_width_is_refused) {
    EXPECT_THAT(problems_of(armour("layers = 1, packing_density = 0.6")),
                testing::ElementsAre(testing::HasSubstr("a slope in space without 'width'")));
    EXPECT_THAT(problems_of(with(armour("width = 8.0, packing_density = 0.6"), "5.366563", "-5.366563")),
                testing::ElementsAre(testing::HasSubstr("a slope that does not rise")));
    EXPECT_THAT(problems_of(armour("width = 8.0, packing_density = 0.001")),
                testing::ElementsAre(testing::HasSubstr("no unit fits on the slope")));
}

TEST(InitialOverlaps, two_blocks_on_the_same_place_are_refused) {
    EXPECT_THAT(
        problems_of(two_cubes("[0, 0, 0]")),
        ElementsAre("case.toml:11:8: 'b' starts 0.5 m deep in 'a', 100 % of the smaller inscribed radius; at most "
                    "10 % (max_initial_overlap of [contact])"));
    EXPECT_THAT(problems_of(two_cubes("[1e-9, 0, 0]")), ElementsAre(HasSubstr("'b' starts 0.5 m deep in 'a'")));
    EXPECT_THAT(problems_of(two_cubes("[0.94, 0, 0]")), ElementsAre(HasSubstr("'b' starts 0.06 m deep in 'a', 12 %")));
}

TEST(InitialOverlaps, touching_and_slightly_overlapping_blocks_are_accepted) {
    EXPECT_THAT(problems_of(two_cubes("[1, 0, 0]")), IsEmpty());
    EXPECT_THAT(problems_of(two_cubes("[0.96, 0.5, 0]")), IsEmpty());
    EXPECT_THAT(problems_of(two_cubes("[0.5, 0, 0]") + "[contact]\nmax_initial_overlap = 1.1\n"), IsEmpty());
}

TEST(InitialOverlaps, a_block_swallowed_by_a_larger_one_or_by_the_ground_is_refused) {
    const std::string small =
        "[[body]]\nname = \"b\"\nmaterial = \"rock\"\nshape = { cube = 0.1 }\nposition = [0.2, 0.1, 0]\n";
    const std::string large = "[[body]]\nname = \"a\"\nmaterial = \"rock\"\nshape = { cube = 1 }\n";
    const std::string ground =
        "[[body]]\nname = \"g\"\nmaterial = \"rock\"\nfixed = true\nshape = { half_space = { normal = [0, 0, 1] } }\n";
    EXPECT_THAT(problems_of(head + large + small), ElementsAre(HasSubstr("'b' starts")));
    EXPECT_THAT(problems_of(head + small + ground), ElementsAre(HasSubstr("'g' starts")));
    EXPECT_THAT(problems_of(head + with(large, "shape", "fixed = true\nshape") + ground), IsEmpty());
}

TEST(InitialOverlaps, a_thousand_overlaps_are_counted_not_listed) {
    const auto problems = problems_of(head +
                                      "[[body]]\nname = \"a\"\nmaterial = \"rock\"\nshape = { cube = 1 }\nrepeat = { "
                                      "counts = [1000, 1, 1], pitch = [0.8, 0, 0] }\n");
    ASSERT_EQ(problems.size(), 11U);
    EXPECT_THAT(problems.back(), HasSubstr("989 more pairs"));
}

}  // namespace
}  // namespace riprap::scene
