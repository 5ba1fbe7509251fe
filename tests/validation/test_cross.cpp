// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/temporary_folder.hpp"
#include "riprap/core/error.hpp"
#include "riprap/validation/cross/causes.hpp"
#include "riprap/validation/cross/scene.hpp"
#include "riprap/validation/cross/table.hpp"
#include "riprap/validation/validate.hpp"

namespace riprap::validation::cross {
namespace {

using testing::HasSubstr;

Cell cell(const std::string& scene, const std::string& solid, const std::string& fluid, const std::string& finding,
          double value, const std::string& variation = "") {
    Cell made;
    made.scene = scene;
    made.solid = solid;
    made.fluid = fluid;
    made.variation = variation;
    made.finding = finding;
    made.quantity = "speed";
    made.unit = "m/s";
    made.value = value;
    made.low = 2.97;
    made.high = 3.03;
    return made;
}

TEST(CrossTable, has_methods_across_and_scenes_down_and_counts_the_runs_that_are_right) {
    std::vector<Cell> cells{cell("seam", "planar_dda", "none", "right", 3.0),
                            cell("seam", "planar_dda", "none", "wrong", 1.54, "step x 4"),
                            cell("seam", "sphere_dem", "none", "right", 2.99)};
    cells.push_back(cell("fall", "planar_dda", "none", "refused", 0));
    cells.back().why = "plane only";
    const std::string text = table_of(cells);
    EXPECT_THAT(text, HasSubstr("scene  planar_dda      sphere_dem\n"));
    EXPECT_THAT(text, HasSubstr("seam   WRONG 1.54 1/2  2.99\n"));
    EXPECT_THAT(text, HasSubstr("fall   (plane only)\n"));
    EXPECT_THAT(text, HasSubstr("answers: 3 judged: 2 right, 1 wrong, of which 0 with a known cause; 1 refused"));
}

TEST(CrossTable, has_fluids_across_and_a_line_for_each_solid_where_there_is_water) {
    const std::string text =
        table_of({cell("disc", "planar_dda", "sph", "right", 3.0), cell("disc", "planar_dda", "grid", "right", 3.01),
                  cell("disc", "sphere_dem", "sph", "right", 2.98)});
    EXPECT_THAT(text, HasSubstr("scene              sph   grid\n"));
    EXPECT_THAT(text, HasSubstr("disc   planar_dda  3     3.01\n       sphere_dem  2.98\n"));
}

class KnownCauses : public ::testing::Test {
 protected:
    Causes causes(const std::string& text) {
        std::ofstream(folder_ / "causes.toml") << text;
        return Causes(folder_ / "causes.toml");
    }
    TemporaryFolder folder_;
};

TEST_F(KnownCauses, make_a_wrong_cell_close_and_a_right_one_a_failure) {
    const Causes known =
        causes("[[red]]\nscenes = [\"seam\"]\nsolids = [\"planar_dda\"]\ncause = \"sees two blocks only\"\n");
    Cell wrong = cell("seam", "planar_dda", "none", "wrong", 1.54),
         mended = cell("seam", "planar_dda", "none", "right", 3);
    Cell other = cell("seam", "sphere_dem", "none", "wrong", 1.54);
    known.note(wrong);
    known.note(mended);
    known.note(other);
    EXPECT_EQ(result_of(wrong).verdict, Verdict::close);
    EXPECT_THAT(result_of(wrong).note, HasSubstr("sees two blocks only"));
    EXPECT_EQ(result_of(mended).verdict, Verdict::not_reproduced);
    EXPECT_EQ(result_of(other).verdict, Verdict::not_reproduced);
}

TEST_F(KnownCauses, are_about_the_variations_and_the_account_that_they_name) {
    const Causes known =
        causes("[[red]]\nscenes = [\"seam\"]\nvariations = [\"step x 4\"]\nenergy = true\ncause = \"it is coarse\"\n");
    Cell answers = cell("seam", "planar_dda", "none", "wrong", 1, "step x 4"), energy = answers, fine = answers;
    energy.is_energy = fine.is_energy = true;
    fine.variation = "";
    known.note(answers);
    known.note(energy);
    known.note(fine);
    EXPECT_EQ(answers.cause, "");
    EXPECT_EQ(energy.cause, "it is coarse");
    EXPECT_EQ(fine.cause, "");
    EXPECT_THROW(causes("[[red]]\nscenes = [\"seam\"]\n"), CaseError);
    EXPECT_THROW(causes("[[red]]\nscenes = [\"seam\"]\ncause = \"it is coarse\"\nsolid = \"planar_dda\"\n"), CaseError);
}

// An excuse for a scene as it is does not excuse its variations, and no key excuses a cell that is right.
TEST_F(KnownCauses, name_the_scene_as_it_is_apart_from_its_variations) {
    const Causes known = causes(
        "[[red]]\nscenes = [\"seam\"]\nvariations = [\"as it is\"]\nfluids = [\"none\"]\ncause = \"it is coarse\"\n");
    Cell plain = cell("seam", "planar_dda", "none", "wrong", 1),
         varied = cell("seam", "planar_dda", "none", "wrong", 1, "step x 4");
    Cell wet = cell("seam", "planar_dda", "sph", "wrong", 1), right = cell("seam", "planar_dda", "none", "right", 3);
    for (Cell* one : {&plain, &varied, &wet, &right}) {
        known.note(*one);
    }
    EXPECT_EQ(plain.cause, "it is coarse");
    EXPECT_EQ(varied.cause, "");
    EXPECT_EQ(wet.cause, "");
    EXPECT_EQ(result_of(right).verdict, Verdict::not_reproduced);
    EXPECT_THROW(causes("[[red]]\nscenes = [\"seam\"]\ncause = \"it is coarse\"\nmay_be_right = true\n"), CaseError);
}

// A scene is a folder: nothing else names it.
TEST(CrossScenes, are_the_folders_of_the_suite) {
    const std::vector<ValidationCase> found = scenes();
    EXPECT_GE(found.size(), 40U);
    const auto is_there = [&](std::string_view name) {
        return std::ranges::any_of(found, [name](const ValidationCase& one) { return one.name == name; });
    };
    EXPECT_TRUE(is_there("seam_of_two"));
    EXPECT_TRUE(is_there("rising_disc"));
}

TEST(CrossScenes, are_validated_with_every_solid_method) {
    const std::vector<ValidationCase> found = scenes();
    std::ostringstream out;
    const ValidateOptions options{
        .selection = {"cross/locked_slider"}, .is_full = false, .as_json = true, .results = "", .folder = ""};
    validate(options, found, out, nullptr);
    const auto json = nlohmann::json::parse(out.str());
    EXPECT_EQ(json.at("cells").size(), 5U);
    EXPECT_EQ(json.at("results").size(), 5U);
    for (const auto& one : json.at("cells")) {
        const bool has_locks = one.at("solid").get<std::string>().ends_with("_dem");
        EXPECT_EQ(one.at("finding"), has_locks ? "right" : "refused") << one.dump();
        EXPECT_EQ(one.at("why"), has_locks ? "" : "no locks");
    }
}

/// Scenes that are judged with every change, two minutes of them; `riprap validate cross` judges all.
class QuickScene : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Dry, QuickScene,
                         ::testing::Values("seam_of_two", "corner_in_a_v", "plan_view", "locked_slider", "tumble",
                                           "seam_of_section", "seam_of_mesh", "seam_of_terrain", "gap_of_1_mm",
                                           "step_of_5_mm", "push_across_a_slope", "head_on", "keystone",
                                           "slide_on_slopes", "couple_from_nothing", "open_joint", "rod_into_blocks",
                                           "edge_on_edge", "slot", "disc_on_slot", "cube_on_slot",
                                           "seam_of_bonded_blocks", "mesh_at_map_coordinates",
                                           "terrain_at_map_coordinates", "head_on_plane"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST_P(QuickScene, is_right_with_every_pair_of_methods_but_those_listed_with_their_cause) {
    const std::vector<ValidationCase> found = scenes();
    std::ostringstream out;
    const ValidateOptions options{.selection = {std::string("cross/") + GetParam()},
                                  .is_full = false,
                                  .as_json = false,
                                  .results = "",
                                  .folder = ""};
    EXPECT_EQ(validate(options, found, out, nullptr), 0) << out.str();
}

}  // namespace
}  // namespace riprap::validation::cross
