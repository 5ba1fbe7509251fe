// SPDX-License-Identifier: Apache-2.0
// Waves, stones and sponges of the grid fluid: what is refused, with the number and what to change.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case_fixture.hpp"
#include "riprap/coupling/grid_fluid/grid_parts.hpp"

namespace riprap::scene {
namespace {

using namespace test;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string tank = R"(dimension = 2
gravity = [0.0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
[[body]]
name = "block"
material = "rock"
shape = { box = [0.5, 0.5] }
position = [5.0, 0.25]
[fluid]
method = "grid"
spacing = 0.05
domain = { low = [0.0, 0.0], high = [10.0, 2.0] }
[[fluid.region]]
level = 1.0
)";

std::string wave(const std::string& keys) { return tank + "[[fluid.wave]]\ntowards = \"x\"\ndepth = 1.0\n" + keys; }

struct Refusal {
    std::string name, text, message, allowed;
};
void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.name; }

TEST(GridWaves, a_sea_by_a_file_has_the_height_and_the_period_of_its_spectrum) {
    const TemporaryFolder folder;
    folder.write("sea.csv", "f,S\n0.2,0.0\n0.4,0.05\n0.6,0.0\n");
    const std::string by_file = wave("wave = \"irregular\"\nspectrum_file = \"sea.csv\"\n");
    const auto sea_of = [&](const std::string& text) {
        const LoadedCase loaded = read(text, {}, folder.path().string());
        return std::get<coupling::GridFluidSettings>(loaded.model.fluid).scene.waves.at(0);
    };
    // m_0 is the area of the triangle: 0.2 Hz times 0.05 m^2 s.
    EXPECT_NEAR(sea_of(by_file).height, 4 * std::sqrt(0.01), 1e-12);
    EXPECT_NEAR(sea_of(by_file).period, 2.5, 1e-12);
    EXPECT_NEAR(sea_of(by_file).ramp, 5.0, 1e-12);
    const auto scaled = sea_of(by_file + "height = 0.3\n");
    EXPECT_NEAR(scaled.height, 0.3, 1e-12);
    EXPECT_NEAR(scaled.spectrum.significant_height(), 0.3, 1e-12);
}

// A bed a cell thick over a deeper domain had water below it, and nothing said so.
TEST(GridGround, that_is_hollow_in_the_domain_is_warned_of) {
    const TemporaryFolder folder;
    folder.write("bed.asc", "ncols 3\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 1\n0.5 0.5 0.5\n0.5 0.5 0.5\n");
    const auto warnings_of = [&](double thickness) {
        return read(fmt::format(R"(gravity = [0.0, 0.0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
[[body]]
name = "bed"
material = "rock"
fixed = true
shape = {{ terrain = {{ file = "bed.asc", thickness = {} }} }}
[fluid]
method = "grid"
spacing = 0.1
domain = {{ low = [0.0, 0.0, 0.0], high = [2.0, 1.0, 1.0] }}
[[fluid.region]]
level = 0.8
)",
                                thickness),
                    {}, folder.path().string())
            .warnings;
    };
    EXPECT_THAT(warnings_of(0.3), testing::Contains(HasSubstr("'bed' is hollow in 20 % of 'fluid.domain'")));
    EXPECT_THAT(warnings_of(0.5), testing::Not(testing::Contains(HasSubstr("hollow"))));
}

class GridTables : public testing::TestWithParam<Refusal> {};

TEST_P(GridTables, are_refused_with_what_was_read_and_what_is_allowed) {
    const std::vector<std::string> problems = problems_of(GetParam().text);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_THAT(problems.front(), StartsWith("case.toml:"));
    EXPECT_THAT(problems.front(), HasSubstr(GetParam().message));
    EXPECT_THAT(problems.front(), HasSubstr(GetParam().allowed));
}

INSTANTIATE_TEST_SUITE_P(
    Refusals, GridTables,
    testing::Values(
        Refusal{"low_wave", wave("wave = \"solitary\"\nheight = 0.2\n"),
                "a wave 0.2 m high on cells of 0.05 m: 4 cells over its height",
                "at least 5 cells: a spacing of 0.04 m"},
        Refusal{"nearly_resolved_wave", wave("wave = \"solitary\"\nheight = 0.2499\n"), "4.99 cells over its height",
                "at least 5 cells"},
        Refusal{"wave_that_no_theory_has", wave("wave = \"solitary\"\nheight = 0.9\n"),
                "heights up to 0.75 of the depth", "a lower wave"},
        Refusal{"absorber_for_short_waves", wave("wave = \"regular\"\nheight = 0.3\nperiod = 2.0\nabsorb = true\n"),
                "a side cannot absorb waves of kd = ", "absorb = false and a [[fluid.sponge]]"},
        Refusal{"solitary_wave_that_breaks", wave("wave = \"boussinesq\"\nheight = 0.9\n"),
                "a wave 0.9 m high in 1 m of water breaks", "heights below 0.78 m"},
        Refusal{"sea_that_breaks", wave("wave = \"irregular\"\nheight = 0.8\nperiod = 3.0\n"),
                "a wave 0.8 m high in 1 m of water breaks", "heights below 0.78 m"},
        Refusal{"sea_of_ripples", wave("wave = \"irregular\"\nheight = 0.5\nperiod = 0.2\n"),
                "a sea 0.5 m high whose peak at 5 Hz is 0.06245 m long breaks", "0.142 L tanh kd"},
        Refusal{"sea_too_steep", wave("wave = \"irregular\"\nheight = 0.5\nperiod = 1.4\n"),
                "a sea 0.5 m high whose peak at 0.7143 Hz is 2.972 m long breaks", "less than 0.4099 m"},
        Refusal{"second_order_beyond_its_range", wave("wave = \"second_order\"\nheight = 0.5\nperiod = 4.0\n"),
                "good below 26.3", "heights up to 0.18"},
        Refusal{"wave_deeper_than_the_water",
                with(wave("wave = \"none\"\nabsorb = true\n"), "depth = 1.0", "depth = 1.5"),
                "a wave in 1.5 m of water at the low side of x, where 1 m stand", "a depth of at most 1 m"},
        Refusal{"two_waves_through_a_side",
                wave("wave = \"solitary\"\nheight = 0.3\n[[fluid.wave]]\ntowards = \"x\"\ndepth = 1.0\n"
                     "wave = \"none\"\nabsorb = true\n"),
                "two waves through the low side of x", "one [[fluid.wave]] to a side"},
        Refusal{"block_longer_than_the_domain", with(tank, "box = [0.5, 0.5]", "box = [12.0, 0.5]"),
                "'block' is 12 m long along x, 'fluid.domain' 10 m", "a larger domain"},
        Refusal{"water_beyond_the_domain", with(tank, "level = 1.0", "box = { low = [20, 0], high = [21, 1] }"),
                "no water of this region lies in the domain", "a region in the domain"},
        Refusal{"water_below_the_domain", with(tank, "level = 1.0", "level = -0.5"),
                "no water of this region lies in the domain", "a level above its bottom"},
        Refusal{"level_above_the_domain", with(tank, "level = 1.0", "level = 5.0"),
                "the level 5 m lies above its region, which ends at 2 m", "a level in the region"},
        Refusal{"idle_side", wave("wave = \"none\"\n"), "a side that neither makes nor absorbs waves", "absorb = true"},
        Refusal{"crest_of_a_sea", wave("wave = \"irregular\"\nheight = 0.3\nperiod = 3.0\ncrest_time = 2.0\n"),
                "wave = \"irregular\" has no use for 'crest_time'", "leave 'crest_time' out"},
        Refusal{"ramp_of_one_wave", wave("wave = \"solitary\"\nheight = 0.3\nramp = 2.0\n"),
                "wave = \"solitary\" has no use for 'ramp'", "leave 'ramp' out"},
        Refusal{"wave_without_height", wave("wave = \"solitary\"\n"), "a wave without 'height'", "the height"},
        Refusal{"wave_without_period", wave("wave = \"regular\"\nheight = 0.3\n"), "a regular wave without 'period'",
                "the period"},
        Refusal{"wave_against_gravity",
                tank + "[[fluid.wave]]\ntowards = \"y\"\nwave = \"solitary\"\nheight = 0.3\ndepth = 1.0\n",
                "a side beside it", "'towards' along another axis"},
        Refusal{"wave_out_of_the_plane",
                tank + "[[fluid.wave]]\ntowards = \"z\"\nwave = \"solitary\"\nheight = 0.3\ndepth = 1.0\n",
                "out of the plane", "\"x\", \"-x\""},
        Refusal{"stones_elsewhere",
                tank + "[[fluid.porous]]\nshape = { polygon = [[20, 0], [21, 0], [21, 1]] }\nporosity = 0.4\n"
                       "grain_size = 0.1\nlinear = 50.0\nquadratic = 2.0\n",
                "holds the middle of no cell", "a zone in the domain"},
        Refusal{"stones_without_a_coefficient",
                tank + "[[fluid.porous]]\nshape = { polygon = [[4, 0], [6, 0], [6, 1]] }\nporosity = 0.4\n"
                       "grain_size = 0.1\nquadratic = 2.0\n",
                "[[fluid.porous]] lacks 'linear'", "mu_1 or alpha"},
        Refusal{"sponge_inside_out", tank + "[[fluid.sponge]]\ntowards = \"x\"\nlow = [9.0, 0.0]\nhigh = [8.0, 2.0]\n",
                "the sponge reaches from 9 m to 8 m along x", "low below high"},
        Refusal{"sponge_elsewhere", tank + "[[fluid.sponge]]\ntowards = \"x\"\nlow = [11.0, 0.0]\nhigh = [12.0, 2.0]\n",
                "the sponge lies outside the domain: from 11 m to 12 m along x", "from 0 m to 10 m"},
        Refusal{"sponge_in_a_current",
                tank + "[[fluid.sponge]]\ntowards = \"x\"\nlow = [8.0, 0.0]\nhigh = [10.0, 2.0]\n"
                       "velocity = [0.1, 0.0]\n",
                "a current in a sponge of water on a grid", "leave 'velocity' out"},
        Refusal{"courant_above_its_bound", with(tank, "spacing = 0.05\n", "spacing = 0.05\ncourant = 0.6\n"), "0.6",
                "0.5"},
        Refusal{"three_cells", with(tank, "spacing = 0.05\n", "spacing = 0.6\n"), "3.33 cells of 0.6 m",
                "four cells at least"}),
    [](const testing::TestParamInfo<Refusal>& refusal) { return refusal.param.name; });

/// Number of the line in `text` that begins the n-th table of this name, from 1.
int line_of(const std::string& text, const std::string& header, int n) {
    std::size_t at = text.find(header);
    for (int i = 1; i < n; ++i) {
        at = text.find(header, at + 1);
    }
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

// Story: a wrong second table of a list was blamed on the line of the first.
TEST(GridTable, that_is_wrong_is_named_by_its_own_line) {
    const std::string good_wave = "[[fluid.wave]]\ntowards = \"x\"\ndepth = 1.0\nwave = \"solitary\"\nheight = 0.3\n";
    const std::string low_wave = "[[fluid.wave]]\ntowards = \"-x\"\ndepth = 1.0\nwave = \"solitary\"\nheight = 0.2\n";
    const std::string stones = "porosity = 0.4\ngrain_size = 0.1\nlinear = 50.0\nquadratic = 2.0\n";
    const std::string zones = "[[fluid.porous]]\nshape = { polygon = [[4, 0], [6, 0], [6, 1]] }\n" + stones +
                              "[[fluid.porous]]\nshape = { polygon = [[20, 0], [21, 0], [21, 1]] }\n" + stones;
    const std::string outflow =
        "[[fluid.outflow]]\nname = \"out\"\ntowards = \"x\"\nlow = [10.0, 0.0]\nhigh = [10.0, 2.0]\n";
    const std::string inflow =
        "[[fluid.inflow]]\nname = \"in\"\ntowards = \"x\"\nlow = [0.0, 0.0]\nhigh = [0.0, 1.0]\nspeed = 0.1\n";
    const std::string elsewhere =
        with(with(outflow, "\"out\"", "\"gap\""), "low = [10.0, 0.0]\nhigh = [10.0", "low = [7.0, 0.0]\nhigh = [7.0");
    struct Wrong {
        std::string text, header;
    };
    for (const Wrong& wrong :
         {Wrong{tank + good_wave + low_wave, "[[fluid.wave]]"}, Wrong{tank + zones, "[[fluid.porous]]"},
          Wrong{tank + inflow + outflow + elsewhere, "[[fluid.outflow]]"}}) {
        const std::vector<std::string> problems = problems_of(wrong.text);
        ASSERT_EQ(problems.size(), 1U) << wrong.header;
        EXPECT_THAT(problems.front(), StartsWith(fmt::format("case.toml:{}:", line_of(wrong.text, wrong.header, 2))));
    }
}

// Ground and walls go on beyond the water.
TEST(GridTable, takes_a_fixed_body_that_is_longer_than_the_domain) {
    EXPECT_THAT(problems_of(with(tank, "box = [0.5, 0.5]", "box = [12.0, 0.5] }\nfixed = true\n#")), IsEmpty());
}

// Story: waves for half of the water came in over all of it, as fast below their bed as at it, and nothing said so.
TEST(GridTable, warns_of_waves_for_less_water_than_stands_at_the_side) {
    const std::string shallow = with(wave("wave = \"solitary\"\nheight = 0.25\n"), "depth = 1.0", "depth = 0.5");
    const auto mark = testing::Contains(HasSubstr("case.toml:18:1: waves in 0.5 m of water at the low side of x"));
    EXPECT_THAT(read(shallow).warnings, mark);
    const std::string bed =
        "[[body]]\nname = \"bed\"\nmaterial = \"rock\"\nfixed = true\n"
        "shape = { box = [4.0, 1.0] }\nposition = [0.0, 0.0]\n";
    EXPECT_THAT(read(with(shallow, "[fluid]", bed + "[fluid]")).warnings,
                testing::Not(testing::Contains(HasSubstr("waves in 0.5 m"))));
    EXPECT_THAT(read(wave("wave = \"solitary\"\nheight = 0.25\n")).warnings,
                testing::Not(testing::Contains(HasSubstr("waves in"))));
}

TEST(GridTable, takes_a_wave_of_five_cells) {
    EXPECT_THAT(problems_of(wave("wave = \"solitary\"\nheight = 0.25\n")), IsEmpty());
}

/// A tank in space with stones in the surface of a file.
std::string stones_of(const std::string& file) {
    return minimal_case +
           "[fluid]\nmethod = \"grid\"\nspacing = 0.25\n"
           "domain = { low = [0.0, 0.0, 0.0], high = [4.0, 4.0, 4.0] }\n[[fluid.region]]\nlevel = 2.0\n"
           "[[fluid.porous]]\nshape = { obj = { file = \"" +
           file + "\", units = \"m\" } }\nposition = [0.5, 0.5, 0.5]\nporosity = 0.4\ngrain_size = 0.1\n" +
           "linear = 50.0\nquadratic = 2.0\n";
}

/// A prism of the height 1 over an L of squares of side 1, in triangles and polygons; `more` closes it.
std::string l_prism(const std::string& more) {
    return "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\n"
           "v 0 2 1\nf 4 3 2 1\nf 6 5 4 1\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n" +
           more;
}

TEST(GridTable, takes_stones_in_a_closed_surface_that_is_not_convex) {
    const TemporaryFolder folder;
    folder.write("l.obj", l_prism("f 7 8 9 10\nf 7 10 11 12\n"));
    const LoadedCase loaded = read(stones_of("l.obj"), {}, folder.path());
    const auto& grid = std::get<coupling::GridFluidSettings>(loaded.model.fluid).grid;
    ASSERT_EQ(grid.porous.size(), 1U);
    double volume = 0;
    fluid::grid::for_cells(grid.mesh.box, [&](std::int64_t, int i, int j, int k) {
        volume += grid.porous[0].holds(grid.mesh.centre(i, j, k)) ? grid.mesh.volume(i, j, k) : 0;
    });
    EXPECT_NEAR(volume, 3.0, 1e-12);
    EXPECT_FALSE(grid.porous[0].holds({1.75, 1.75, 1.0}));  // in the corner that the L leaves
}

TEST(GridTable, refuses_stones_in_a_surface_that_is_open_or_inside_out) {
    const TemporaryFolder folder;
    folder.write("open.obj", l_prism("f 7 8 9 10\n"));
    const std::vector<std::string> problems = problems_of(stones_of("open.obj"), {}, folder.path());
    ASSERT_FALSE(problems.empty());
    EXPECT_THAT(problems.front(), StartsWith("open.obj:"));
    std::string inward = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";
    folder.write("inward.obj", inward);
    const std::vector<std::string> wound = problems_of(stones_of("inward.obj"), {}, folder.path());
    ASSERT_EQ(wound.size(), 1U);
    EXPECT_THAT(wound.front(), HasSubstr("is inside out"));
}

TEST(GridTable, says_which_waves_a_side_absorbs) {
    const LoadedCase loaded = read(tank +
                                   "[[fluid.wave]]\ntowards = \"-x\"\nwave = \"none\"\ndepth = 1.0\n"
                                   "absorb = true\n");
    const auto sides = absorbed_ranges(std::get<coupling::GridFluidSettings>(loaded.model.fluid));
    ASSERT_EQ(sides.size(), 1U);
    EXPECT_EQ(
        sides.front(),
        "the high side of x absorbs waves of kd below 0.314: longer than 20 m, of periods above 6.49 s, in 1 m of "
        "water");
}

}  // namespace
}  // namespace riprap::scene
