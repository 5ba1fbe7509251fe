// SPDX-License-Identifier: Apache-2.0
#include "case_fixture.hpp"

namespace riprap::scene {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(SolidMethods, planar_dda_refuses_a_scene_in_space_at_its_word) {
    EXPECT_THAT(problems_of(minimal_case + "[solid]\nmethod = \"planar_dda\"\n"),
                ElementsAre("case.toml:11:10: planar DDA moves polygons in the x-y plane, and this scene has three "
                            "dimensions; dimension = 2"));
}

TEST(SolidMethods, three_dimensional_dda_refuses_bodies_of_several_parts_at_their_name) {
    const std::string two =
        "{ union = [{ shape = { cube = 1.0 } }, { shape = { cube = 1.0 }, position = [1, 0, 0] }] }";
    const std::string text = with(minimal_case, "{ box = [1.0, 1.0, 0.5] }", two);
    EXPECT_THAT(problems_of(text), IsEmpty());
    for (const std::string method : {"explicit_dda", "implicit_dda"}) {
        EXPECT_THAT(problems_of(text, {"solid.method=" + method}),
                    ElementsAre(HasSubstr("case.toml:7:8: 'block' has several parts")));
    }
}

}  // namespace
}  // namespace riprap::scene
