// SPDX-License-Identifier: Apache-2.0
// Bodies from surface files and unions of convex parts.
#include "case_fixture.hpp"

namespace riprap::scene {
namespace {

using namespace test;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::string with_shape(const std::string& shape) { return with(minimal_case, "{ box = [1.0, 1.0, 0.5] }", shape); }

/// Corners of a cube of edge 1 in an OBJ file with the faces of `loops`.
std::string cube_obj(const std::string& loops) {
    return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n" + loops;
}
const std::string all_faces = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n";

TEST(Surfaces, a_cube_from_a_file_is_the_cube_in_its_units) {
    const TemporaryFolder folder;
    folder.write("cube.obj", cube_obj(all_faces));
    const LoadedCase loaded =
        read(with_shape("{ obj = { file = \"cube.obj\", units = \"cm\", scale = 50 } }"), {}, folder.path());
    EXPECT_NEAR(loaded.model.bodies.mass[0], 2500 * 0.125, 1e-9);
    EXPECT_NEAR(loaded.state.bodies.position[0].x, 0.25, 1e-12);
    ASSERT_EQ(loaded.inputs.size(), 1U);
    const LoadedCase centred =
        read(with_shape("{ obj = { file = \"cube.obj\", units = \"m\", center = true } }"), {}, folder.path());
    EXPECT_NEAR(norm(centred.state.bodies.position[0]), 0, 1e-12);
}

TEST(Surfaces, the_hash_of_a_case_covers_the_files_it_reads) {
    const TemporaryFolder folder;
    const std::string text = with_shape("{ obj = { file = \"cube.obj\", units = \"m\" } }");
    folder.write("cube.obj", cube_obj(all_faces));
    const std::uint64_t before = read(text, {}, folder.path()).model.case_hash;
    folder.write("cube.obj", cube_obj(all_faces) + "# another remark\n");
    EXPECT_NE(read(text, {}, folder.path()).model.case_hash, before);
}

TEST(Surfaces, an_open_surface_is_refused_with_its_place) {
    const TemporaryFolder folder;
    folder.write("open.obj", cube_obj("f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\n"));
    EXPECT_THAT(problems_of(with_shape("{ obj = { file = \"open.obj\", units = \"m\" } }"), {}, folder.path()),
                Contains(AllOf(StartsWith("open.obj:"), HasSubstr("open edge"))));
}

TEST(Surfaces, inverted_faces_are_refused_and_turned_only_on_request) {
    const TemporaryFolder folder;
    folder.write("inverted.obj", cube_obj("f 1 2 3 4\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n"));
    EXPECT_THAT(problems_of(with_shape("{ obj = { file = \"inverted.obj\", units = \"m\" } }"), {}, folder.path()),
                Contains(AllOf(StartsWith("inverted.obj:9"), HasSubstr("wrong way round"))));
    const LoadedCase loaded =
        read(with_shape("{ obj = { file = \"inverted.obj\", units = \"m\", repair = true } }"), {}, folder.path());
    EXPECT_NEAR(loaded.model.bodies.mass[0], 2500, 1e-8);
    EXPECT_FALSE(loaded.warnings.empty());
}

TEST(Surfaces, a_face_without_area_is_refused) {
    const TemporaryFolder folder;
    folder.write("flat.obj", cube_obj(all_faces) + "v 0.5 0 0\nf 1 9 2\n");
    EXPECT_THAT(problems_of(with_shape("{ obj = { file = \"flat.obj\", units = \"m\" } }"), {}, folder.path()),
                Contains(AllOf(StartsWith("flat.obj:16"), HasSubstr("area"))));
}

TEST(Surfaces, a_file_that_is_no_surface_is_refused) {
    const TemporaryFolder folder;
    folder.write("poem.stl", "Shall I compare thee\n");
    EXPECT_THAT(problems_of(with_shape("{ stl = { file = \"poem.stl\", units = \"m\" } }"), {}, folder.path()),
                ElementsAre(StartsWith("poem.stl: 21 bytes that are no ASCII STL")));
    EXPECT_THAT(problems_of(with_shape("{ stl = { file = \"poem.stl\" } }"), {}, folder.path()),
                ElementsAre(HasSubstr("lacks 'units'")));
}

TEST(Unions, touching_parts_make_one_body_whose_inner_faces_carry_no_field) {
    const LoadedCase loaded =
        read(with_shape("{ union = [ { shape = { cube = 1 } }, { shape = { cube = 1 }, position = [1, 0, 0] } ] }"));
    ASSERT_EQ(loaded.model.bodies.size(), 1);
    EXPECT_DOUBLE_EQ(loaded.model.bodies.mass[0], 5000);
    EXPECT_NEAR(loaded.state.bodies.position[0].x, 0.5, 1e-12);
    ASSERT_EQ(loaded.model.bodies.part_count(), 2);
    for (const body::Part& part : loaded.model.bodies.parts) {
        const geometry::ConvexView view = loaded.model.shapes.view(part.shape);
        int internal = 0;
        for (int face = 0; face < view.face_count; ++face) {
            internal += view.is_internal[face];
        }
        EXPECT_EQ(internal, 1);
    }
}

TEST(Unions, parts_that_overlap_are_refused_at_their_line) {
    EXPECT_THAT(problems_of(with_shape(
                    "{ union = [ { shape = { cube = 1 } }, { shape = { cube = 1 }, position = [0.5, 0, 0] } ] }")),
                Contains(AllOf(StartsWith("case.toml:9"), HasSubstr("part 1 and part 2 overlap"))));
}

TEST(Unions, a_union_of_unions_nests_and_a_planar_union_stays_planar) {
    EXPECT_THAT(problems_of(with_shape(
                    "{ union = [ { shape = { union = [ { shape = { cube = 1 } } ] } }, { shape = { cube = 1 }, "
                    "position = [0, 1, 0] } ] }")),
                IsEmpty());
    const LoadedCase planar = read(
        with(with(with_shape("{ union = [ { shape = { cube = 1 } }, { shape = { cube = 1 }, position = [1, 0] } ] }"),
                  "gravity", "dimension = 2\ngravity"),
             "[0.0, 0.0, -9.81]", "[0.0, -9.81]"));
    EXPECT_DOUBLE_EQ(planar.model.bodies.mass[0], 5000);
    for (const body::Part& part : planar.model.bodies.parts) {
        const geometry::ConvexView view = planar.model.shapes.view(part.shape);
        EXPECT_EQ(std::count(view.is_internal, view.is_internal + view.face_count, 1), 3);  // both ends, and the joint
    }
}

TEST(Unions, parts_that_meet_within_round_off_give_no_warning) {
    const LoadedCase tank =
        read(with_shape("{ union = [ { shape = { box = [0.7, 1, 1] }, position = [0.1, 0, 0] }, { shape = { box = "
                        "[0.1, 1, 1] }, position = "
                        "[0.5, 0, 0] } ] }"));
    EXPECT_THAT(tank.warnings, IsEmpty());
}

}  // namespace
}  // namespace riprap::scene
