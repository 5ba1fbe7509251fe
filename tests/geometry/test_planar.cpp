// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "riprap/geometry/dda_files/dda_files.hpp"
#include "riprap/geometry/planar/planar_cut.hpp"
#include "riprap/geometry/planar/planar_polygon.hpp"

namespace riprap::geometry {
namespace {

const Polygon unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

double total_area(const PlanarBlocks& cut) {
    return std::accumulate(cut.blocks.begin(), cut.blocks.end(), 0.0,
                           [](double sum, const Polygon& block) { return sum + moments_of(block).area; });
}

TEST(PlanarPolygon, MomentsOfAnEllAreThoseOfItsThreeSquares) {
    const Polygon ell{{10, 5}, {12, 5}, {12, 6}, {11, 6}, {11, 7}, {10, 7}};
    const PolygonMoments m = moments_of(ell);
    EXPECT_NEAR(m.area, 3, 1e-14);
    EXPECT_NEAR(m.centroid.x, 10 + 2.5 / 3, 1e-14);
    EXPECT_NEAR(m.centroid.y, 5 + 2.5 / 3, 1e-14);
    double xx = 0, xy = 0;
    for (const Vec2 c : {Vec2{10.5, 5.5}, Vec2{11.5, 5.5}, Vec2{10.5, 6.5}}) {
        xx += 1.0 / 12 + (c.x - m.centroid.x) * (c.x - m.centroid.x);
        xy += (c.x - m.centroid.x) * (c.y - m.centroid.y);
    }
    EXPECT_NEAR(m.xx, xx, 1e-13);
    EXPECT_NEAR(m.yy, xx, 1e-13);
    EXPECT_NEAR(m.xy, xy, 1e-13);
}

TEST(PlanarPolygon, MomentsDoNotDependOnWhereThePolygonIs) {
    Polygon far = unit_square;
    for (Vec2& p : far) {
        p += {1e6, -1e6};
    }
    EXPECT_NEAR(moments_of(far).xx, 1.0 / 12, 1e-9);
    EXPECT_NEAR(moments_of(far).area, 1, 1e-9);
}

TEST(PlanarPolygon, OutlinesThatCrossOrEncloseNothingAreRefused) {
    EXPECT_FALSE(make_polygon(std::vector<Vec2>{{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
    EXPECT_FALSE(make_polygon(std::vector<Vec2>{{0, 0}, {1, 1}, {1, 1}}));
    EXPECT_FALSE(make_polygon(std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1e-9}}));
    EXPECT_FALSE(make_polygon(std::vector<Vec2>{{0, 0}, {NAN, 0}, {1, 1}}));
    const auto turned = make_polygon(std::vector<Vec2>{{0, 1}, {1, 1}, {1, 0}, {0, 0}, {0, 1}});
    ASSERT_TRUE(turned);
    EXPECT_EQ(turned.value().size(), 4u);
    EXPECT_GT(moments_of(turned.value()).area, 0);
}

TEST(PlanarCut, CrossingJointsCutASquareIntoFourBlocksAndKeepTheirTypes) {
    std::vector<PlanarJoint> joints = outline_of(unit_square, 1);
    joints.push_back({{0.5, -0.2}, {0.5, 1.2}, 2});  // reaches beyond the outline
    joints.push_back({{0, 0.25}, {1, 0.25}, 3});
    const auto cut = cut_by_lines(joints);
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut.value().blocks.size(), 4u);
    EXPECT_EQ(cut.value().dead_ends, 2) << "the two tails outside";
    EXPECT_NEAR(total_area(cut.value()), 1, 1e-14);
    for (std::size_t b = 0; b < 4; ++b) {
        EXPECT_EQ(cut.value().blocks[b].size(), 4u);
        std::int32_t sum = 0;
        for (const std::int32_t type : cut.value().edge_types[b]) {
            sum += type;
        }
        EXPECT_EQ(sum, 1 + 1 + 2 + 3);
    }
}

TEST(PlanarCut, DeadEndsAndDanglingJointsCutNothing) {
    std::vector<PlanarJoint> joints = outline_of(unit_square);
    joints.push_back({{0.5, 0}, {0.5, 0.6}, 0});    // ends inside
    joints.push_back({{0.2, 0.3}, {0.8, 0.3}, 0});  // hangs on it
    const auto cut = cut_by_lines(joints);
    ASSERT_TRUE(cut);
    ASSERT_EQ(cut.value().blocks.size(), 1u);
    EXPECT_EQ(cut.value().blocks[0].size(), 4u) << "the corner where the joint began is dropped";
    EXPECT_EQ(cut.value().dead_ends, 4);
}

TEST(PlanarCut, JointsThatMeetWithinTheSnapDistanceEncloseABlock) {
    const std::vector<PlanarJoint> open{{{0, 0}, {1, 0}, 0}, {{1, 0.004}, {1, 1}, 0}, {{1.003, 1}, {0, 0}, 0}};
    EXPECT_FALSE(cut_by_lines(open));
    const auto cut = cut_by_lines(open, {.snap = 0.01});
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut.value().blocks.size(), 1u);
}

TEST(PlanarCut, JointsThatLieOnEachOtherAreOne) {
    std::vector<PlanarJoint> joints = outline_of(unit_square);
    joints.push_back({{0, 0.5}, {0.7, 0.5}, 0});
    joints.push_back({{0.3, 0.5}, {1, 0.5}, 0});
    const auto cut = cut_by_lines(joints);
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut.value().blocks.size(), 2u);
    EXPECT_NEAR(total_area(cut.value()), 1, 1e-14);
}

TEST(PlanarCut, ALoopThatNothingTiesToTheOutlineIsLeftOut) {
    std::vector<PlanarJoint> joints = outline_of(unit_square);
    const Polygon inner{{0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}};
    const std::vector<PlanarJoint> loop = outline_of(inner);
    joints.insert(joints.end(), loop.begin(), loop.end());
    const auto cut = cut_by_lines(joints);
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut.value().blocks.size(), 1u);
    EXPECT_EQ(cut.value().loose_loops, 1);
}

TEST(PlanarCut, ASliverIsRefusedWithItsPlace) {
    std::vector<PlanarJoint> joints = outline_of(unit_square);
    joints.push_back({{0, 0.5}, {1, 0.5}, 0});
    joints.push_back({{0, 0.50001}, {1, 0.50001}, 0});
    const auto cut = cut_by_lines(joints);
    ASSERT_FALSE(cut);
    EXPECT_NE(cut.problems()[0].message.find("(0.5, 0.500005)"), std::string::npos) << cut.problems()[0].message;
}

TEST(PlanarCut, JointSetsFillASlopeAndKeepItsArea) {
    const Polygon slope{{0, 0}, {30, 0}, {30, 20}, {12, 20}, {6, 5}, {0, 5}};  // concave at its toe
    std::vector<PlanarJoint> joints = outline_of(slope);
    for (const PlanarJointSet& set :
         {PlanarJointSet{.dip = 0.6, .spacing = 1.3, .spacing_scatter = 0.3},
          PlanarJointSet{.dip = 2.0, .spacing = 1.9, .length = 6, .bridge = 1, .offset = 0.3}}) {
        const auto traces = traces_of(set, slope, 7);
        EXPECT_GT(traces.size(), 10u);
        joints.insert(joints.end(), traces.begin(), traces.end());
    }
    const auto cut = cut_by_lines(joints, {.snap = 0, .sliver = 1e-12});
    ASSERT_TRUE(cut) << cut.problems()[0].message;
    EXPECT_GT(cut.value().blocks.size(), 100u);
    EXPECT_GT(cut.value().dead_ends, 0);
    EXPECT_NEAR(total_area(cut.value()), moments_of(slope).area, 1e-9);
}

constexpr const char* marked_geometry = R"(<?xml version="1.0"?>
<DDA xmlns:B="x">
<!-- a box on a bar -->
<B:Geometry>
   <Edgenodedist distance="0.01"/>
   <Jointlist>
      <Joint type="1"> 0 -0.01 0 1.01 </Joint>
      <Joint type="1"> -0.01 1 4.01 1 </Joint>
      <Joint type="2"> 4 1.01 4 -0.01</Joint>
      <Joint type="1"> 4.01 0 -0.01 0</Joint>
   </Jointlist>
   <Fixedpointlist> <Point> 1 0.5 </Point> <Line> 2 0.5 3 0.5 </Line> </Fixedpointlist>
   <Loadpointlist> <Point> 4 0.5 </Point> </Loadpointlist>
   <Whatever/>
</B:Geometry>
</DDA>
)";

TEST(DdaFiles, AMarkedUpGeometryGivesJointsThatCutItsBlocks) {
    const DdaGeometry geometry = read_dda_geometry(marked_geometry, "bar.geo");
    EXPECT_EQ(geometry.snap, 0.01);
    ASSERT_EQ(geometry.joints.size(), 4u);
    EXPECT_EQ(geometry.joints[2].type, 2);
    EXPECT_EQ(geometry.fixed_lines.size(), 2u);
    EXPECT_EQ(geometry.load_points.size(), 1u);
    ASSERT_EQ(geometry.notes.size(), 2u);
    EXPECT_NE(geometry.notes[1].find("line 14: <Whatever>"), std::string::npos) << geometry.notes[1];
    const auto cut = cut_by_lines(geometry.joints, {.snap = geometry.snap});
    ASSERT_TRUE(cut);
    ASSERT_EQ(cut.value().blocks.size(), 1u);
    EXPECT_NEAR(total_area(cut.value()), 4, 0.1);
}

TEST(DdaFiles, BareNumbersGiveTheSameJoints) {
    const DdaGeometry geometry = read_dda_geometry(
        "0.01\n4 4\n0\n0\n1\n0\n0\n0\n0 0 4 0 1\n4 0 4 1 2\n4 1 0 1 1\n0 1 0 0 1\n1 0.5 1 0.5\n", "bar.geo");
    EXPECT_EQ(geometry.joints.size(), 4u);
    EXPECT_EQ(geometry.outline_count, 4);
    EXPECT_EQ(geometry.joints[1].type, 2);
    EXPECT_EQ(geometry.fixed_lines.size(), 1u);
    const DdaAnalysis analysis = read_dda_analysis(
        "0\n20\n1\n1\n0.006\n0.01\n5 161 1000000 0.49\n0 0 0\n0 0 0\n1 2 3\n30.0 10.0 4.0\n", "bar.ana");
    EXPECT_FALSE(analysis.is_dynamic);
    ASSERT_EQ(analysis.materials.size(), 1u);
    EXPECT_EQ(analysis.materials[0].poisson_ratio, 0.49);
    EXPECT_EQ(analysis.materials[0].velocity[2], 3);
    EXPECT_NEAR(analysis.joints[0].friction_angle, std::numbers::pi / 6, 1e-15);
}

TEST(DdaFiles, AMarkedUpAnalysisIsReadWithItsMaterialsAndLoads) {
    const DdaAnalysis analysis = read_dda_analysis(R"(<DDA><Analysis>
<Analysistype type="dynamic"/> <Planestrain flag="yes"/> <Numtimesteps timesteps="500"/>
<Maxtimestep maxtimestep="0.01"/> <Maxdisplacement maxdisplacement="0.025"/>
<Autopenalty flag="no" pfactor="50.0"/>
<Blockmaterial type="1"> <Unitmass> 18 </Unitmass> <Unitweight> 176.58 </Unitweight>
 <Youngsmod> 3e6 </Youngsmod> <Poissonratio> 0.2 </Poissonratio> <Istress> 1 2 3 </Istress> </Blockmaterial>
<Jointproperties type="1"><Friction> 45 </Friction><Cohesion> 7 </Cohesion><Tensile> 8</Tensile></Jointproperties>
<Loadpointlist><Loadpoint numpoints = "2"> 0 5000 500; 5 6000 500; </Loadpoint></Loadpointlist>
</Analysis></DDA>)",
                                                   "bar.ana");
    EXPECT_TRUE(analysis.is_plane_strain);
    EXPECT_EQ(analysis.step_count, 500);
    EXPECT_EQ(analysis.materials.at(0).stress[2], 3);
    EXPECT_EQ(analysis.joints.at(0).tension, 8);
    ASSERT_EQ(analysis.loads.at(0).records.size(), 2u);
    EXPECT_EQ(analysis.loads[0].records[1][1], 6000);
}

/// The first problem of a text as "line:column message".
std::string problem_of(std::string_view text) {
    try {
        read_dda_geometry(text, "bad.geo");
    } catch (const CaseError& error) {
        return to_string(error.problems().front());
    }
    return "";
}

/// The first problem of an analysis file.
std::string analysis_problem_of(std::string_view text) {
    try {
        read_dda_analysis(text, "bad.ana");
    } catch (const CaseError& error) {
        return to_string(error.problems().front());
    }
    return "";
}

TEST(DdaFiles, MalformedTextsAreRefusedWithLineAndColumn) {
    EXPECT_NE(problem_of("0.01\n1 0 0 0 0 0 0 0\n0 0 x 0 1\n").find("bad.geo:3:5:"), std::string::npos);
    EXPECT_NE(problem_of("0.01\n1 0 0 0 0 0 0 0\n0 0 1 0\n").find("the text ends before a type"), std::string::npos);
    EXPECT_NE(problem_of("0.01\n-1 0\n").find("bad.geo:2:1:"), std::string::npos);
    EXPECT_NE(problem_of("<DDA>\n <Geometry>\n  <Jointlist> <Joint type=\"1\"> 0 0 1 </Joint> </Jointlist>\n"
                         "</Geometry></DDA>")
                  .find("bad.geo:3:15: <Joint> holds 3 numbers"),
              std::string::npos);
    EXPECT_NE(problem_of("<DDA>\n <Geometry>\n").find("bad.geo:2:2: <Geometry> is not closed"), std::string::npos);
    EXPECT_NE(problem_of("<DDA></Geometry></DDA>").find("bad.geo:1:6: </Geometry> closes nothing"), std::string::npos);
    EXPECT_NE(problem_of("<DDA/>").find("there is no <Geometry>"), std::string::npos);
}

TEST(DdaFiles, LinesWithoutLengthAreRefused) {
    // They were left out where blocks are cut.
    EXPECT_NE(problem_of("<DDA><Geometry><Jointlist>\n<Joint type=\"1\"> 0 0 1 0 </Joint>\n"
                         "<Joint type=\"1\"> 18 11.9 18 11.9 </Joint></Jointlist></Geometry></DDA>")
                  .find("bad.geo:3:18: a line from (18, 11.9) to the same point; two ends apart"),
              std::string::npos);
    EXPECT_NE(problem_of("0.01\n1 0 0 0 0 0 0 0\n2 3 2 3 1\n").find("bad.geo:3:1: a line from (2, 3)"),
              std::string::npos);
    EXPECT_EQ(problem_of("0.01\n1 0 0 0 1 0 0 0\n0 0 1 0 1\n2 3 2 3\n"), "");  // a fixed point
}

TEST(DdaFiles, WordsThatAreNoneAndSecondElementsAreRefusedAtTheirPlace) {
    // "dinamic" was read as static, of two properties of one joint type the first was taken, two geometries were
    // joined.
    const auto analysis = [](const std::string& what) { return "<DDA><Analysis>\n" + what + "</Analysis></DDA>"; };
    EXPECT_NE(
        analysis_problem_of(analysis("<Analysistype type=\"dinamic\"/>")).find("bad.ana:2:21: type is \"dinamic\""),
        std::string::npos);
    EXPECT_NE(analysis_problem_of(analysis("<Planestrain flag=\"maybe\"/>")).find("yes or no"), std::string::npos);
    EXPECT_EQ(analysis_problem_of(analysis("<Analysistype type=\"Static\"/><Planestrain flag=\"no\"/>")), "");
    const std::string joint = "<Jointproperties type=\"1\"><Friction> 1 </Friction></Jointproperties>\n";
    EXPECT_EQ(analysis_problem_of(analysis(joint)), "");
    EXPECT_NE(
        analysis_problem_of(analysis(joint + joint)).find("bad.ana:3:1: a second <Jointproperties> of type \"1\""),
        std::string::npos);
    for (const std::string twice : {"<Numtimesteps timesteps=\"5\"/>\n<Numtimesteps timesteps=\"7\"/>",
                                    "<Analysistype type=\"static\"/>\n<Analysistype type=\"dynamic\"/>"}) {
        EXPECT_NE(analysis_problem_of(analysis(twice)).find("bad.ana:3:1: a second <"), std::string::npos) << twice;
    }
    EXPECT_NE(
        analysis_problem_of(
            analysis(
                "<Jointproperties type=\"1\"><Friction> 1 </Friction>\n<Friction> 2 </Friction></Jointproperties>"))
            .find("bad.ana:3:1: a second <Friction>; the first is in line 2"),
        std::string::npos);
    EXPECT_EQ(analysis_problem_of(analysis("<Remark/><Remark/>" + joint)), "");  // is not read
    EXPECT_NE(analysis_problem_of("<DDA><Analysis/>\n<Analysis/></DDA>").find("bad.ana:2:1: a second <Analysis>"),
              std::string::npos);
    EXPECT_NE(problem_of("<DDA><Geometry/>\n<Geometry/></DDA>").find("bad.geo:2:1: a second <Geometry>"),
              std::string::npos);
    EXPECT_NE(analysis_problem_of(analysis("<Loadpointlist><L> 0 1 2; 0 1 2; </L></Loadpointlist>"))
                  .find("bad.ana:2:27: time 0 does not follow 0"),
              std::string::npos);
}

TEST(DdaFiles, AListThatPromisesAnotherNumberOfEntriesIsRefused) {
    const auto text = [](const std::string& joints, const std::string& points) {
        return "<DDA><Geometry>\n<Jointlist" + joints +
               "><Joint type=\"1\"> 0 0 1 0 </Joint><Joint type=\"1\"> 1 0 0 1 </Joint></Jointlist>\n<Fixedpointlist" +
               points + "><Line> 0 0 1 0 </Line></Fixedpointlist></Geometry></DDA>";
    };
    EXPECT_EQ(problem_of(text("", "")), "");
    EXPECT_EQ(problem_of(text(" numjoints=\"2\"", " numpoints=\"1\"")), "");
    EXPECT_NE(problem_of(text(" numjoints=\"3\"", "")).find("bad.geo:2:23: numjoints is \"3\", and 2 entries follow"),
              std::string::npos);
    EXPECT_NE(problem_of(text("", " numPoints=\"9\"")).find("bad.geo:3:28: numPoints is \"9\", and 1 entries follow"),
              std::string::npos);
    EXPECT_NE(problem_of(text("", " numpoints=\"-1\"")).find("numpoints is \"-1\""), std::string::npos);
    const std::string load = "<Loadpoint numpoints=\"1\"> 0 1 2; </Loadpoint></Loadpointlist></Analysis></DDA>";
    EXPECT_EQ(analysis_problem_of("<DDA><Analysis><Loadpointlist numpoints=\"1\">" + load), "");
    EXPECT_NE(analysis_problem_of("<DDA><Analysis><Loadpointlist numpoints=\"3\">" + load)
                  .find("bad.ana:1:42: numpoints is \"3\", and 1 entries follow"),
              std::string::npos);
}

std::string load_of(const std::string& attributes, const std::string& records) {
    return "<DDA><Analysis><Loadpointlist><Loadpoint" + attributes + ">" + records +
           "</Loadpoint></Loadpointlist></Analysis></DDA>";
}

TEST(DdaFiles, ALoadWithAMissingColumnIsRefusedAtItsRecord) {
    EXPECT_EQ(analysis_problem_of(load_of("", " 0 1 2; 3 4 5; ")), "");
    EXPECT_EQ(analysis_problem_of(load_of("", " 0 1 0 1 4 5 ")), "");
    EXPECT_EQ(analysis_problem_of(load_of(" numpoints=\"2\"", " 0 1 2 3 4 5 ")), "");
    // Records of two as well, at the times 0, 2 and 4.
    EXPECT_NE(analysis_problem_of(load_of("", " 0 1 2 3 4 5 "))
                  .find("bad.ana:1:43: 6 numbers could be 3 records of two or 2 of three"),
              std::string::npos)
        << analysis_problem_of(load_of("", " 0 1 2 3 4 5 "));
    EXPECT_NE(analysis_problem_of(load_of("", "\n0 1e6 1 1e6 2 1e6\n")).find("bad.ana:2:1:"), std::string::npos);
    // Six numbers, but three records of two.
    EXPECT_NE(analysis_problem_of(load_of("", "\n0 1\n2 3\n4 5\n")).find("bad.ana:2:1: a record of 2 numbers"),
              std::string::npos);
    EXPECT_NE(analysis_problem_of(load_of("", "0 1; 2 3; 4 5;")).find("bad.ana:1:42: a record of 2 numbers"),
              std::string::npos)
        << analysis_problem_of(load_of("", "0 1; 2 3; 4 5;"));
    EXPECT_NE(analysis_problem_of(load_of("", "\n0 1 2\n2 3 4 5\n4 5\n")).find("bad.ana:3:1: a record of 4 numbers"),
              std::string::npos);
    EXPECT_NE(analysis_problem_of(load_of(" numpoints=\"3\"", " 0 1 2; 3 4 5; "))
                  .find("numpoints is \"3\", and 2 records follow"),
              std::string::npos);
    EXPECT_NE(analysis_problem_of(load_of(" numpoints=\"-1\"", " 0 1 2 ")).find("numpoints is \"-1\""),
              std::string::npos);
    EXPECT_NE(analysis_problem_of(load_of(" numTimesteps=\"5\"", " 0 1 2; ")).find("5\", and 1 records follow"),
              std::string::npos);
}

TEST(DdaFiles, ElementsThatAreNotReadAreRefusedWhereTheyHoldNumbers) {
    const auto geometry = [](const std::string& inside) {
        return problem_of("<DDA>\n<Geometry>\n" + inside + "\n</Geometry></DDA>");
    };
    const auto analysis = [](const std::string& inside) {
        return analysis_problem_of("<DDA>\n<Analysis>\n" + inside + "\n</Analysis></DDA>");
    };
    EXPECT_NE(geometry("<Fixpointlist><Point> 1 2 </Point></Fixpointlist>")
                  .find("bad.geo:3:1: <Fixpointlist> is not read; <Fixedpointlist>?"),
              std::string::npos);
    EXPECT_NE(geometry(" <jointlist/>").find("bad.geo:3:2: <jointlist> is not read; <Jointlist>?"), std::string::npos);
    EXPECT_NE(geometry("<Boundlist><Line> 0 0 1 0 </Line></Boundlist>").find("<Boundlist> is not read"),
              std::string::npos);
    EXPECT_EQ(geometry("<Title> A slope of 1990 cut </Title><Author> N </Author>").find("Author"), std::string::npos);
    EXPECT_EQ(geometry("<Author> N. N. </Author><Matlinelist><Line> 0 0 1 0 </Line></Matlinelist>"), "");
    EXPECT_NE(analysis("<Blockmaterials><Unitmass> 2600 </Unitmass></Blockmaterials>")
                  .find("bad.ana:3:1: <Blockmaterials> is not read; <Blockmaterial>?"),
              std::string::npos);
    EXPECT_NE(analysis("<Blockmaterial><Density> 2600 </Density></Blockmaterial>").find("<Density> is not read"),
              std::string::npos);
    EXPECT_NE(analysis("<Jointproperties><Cohesian> 1e5 </Cohesian></Jointproperties>").find("<Cohesion>?"),
              std::string::npos);
    EXPECT_NE(analysis("<Loadpoints><Load> 0 1 2; </Load></Loadpoints>").find("<Loadpoints> is not read"),
              std::string::npos);
    EXPECT_EQ(analysis("<Gravity flag=\"yes\"/><Units> SI </Units>"), "");
}

TEST(DdaFiles, NumbersBehindTheLastJointMaterialAreRefused) {
    const std::string bare = "1 1000 1 1 0.005 0.001\n2600 25506 1e10 0.25 0 0 0 0 0 0 0 0 0\n25 0 0\n";
    EXPECT_EQ(analysis_problem_of(bare), "");
    EXPECT_EQ(analysis_problem_of(bare + "1.4\n"), "");  // of the over-relaxation
    EXPECT_NE(analysis_problem_of(bare + "0 0 1e6\n1 0 1e6\n").find("bad.ana:4:1: 6 numbers follow the last joint"),
              std::string::npos);
    EXPECT_NE(analysis_problem_of(bare + "25 0\n").find("bad.ana:4:1: 2 numbers follow"), std::string::npos);
}

TEST(DdaFiles, ValuesThatNoMaterialHasAreRefusedAtTheirWord) {
    const std::string bare = "0\n20\n1\n1\n0.006\n0.01\n";
    // A missing unit weight moves every number after it.
    EXPECT_NE(analysis_problem_of(bare + "5 1000000 0.49\n0 0 0\n0 0 0\n1 2 3\n30.0 10.0 4.0\n").find("bad.ana:"),
              std::string::npos);
    EXPECT_NE(analysis_problem_of(bare + "5 161 1000000 0.6\n0 0 0\n0 0 0\n1 2 3\n30.0 10.0 4.0\n")
                  .find("bad.ana:7:15: Poisson's ratio is \"0.6\""),
              std::string::npos);
    EXPECT_NE(analysis_problem_of(bare + "5 161 1000000 0.4\n0 0 0\n0 0 0\n1 2 3\n95 10.0 4.0\n")
                  .find("a friction angle is \"95\""),
              std::string::npos);
    EXPECT_NE(analysis_problem_of(
                  "<DDA><Analysis><Blockmaterial><Poissonratio> 0.6 </Poissonratio></Blockmaterial></Analysis></DDA>")
                  .find("<Poissonratio> is 0.6; a Poisson's ratio"),
              std::string::npos);
    EXPECT_NE(problem_of("<DDA><Geometry><Edgenodedist distance=\"-1\"/></Geometry></DDA>")
                  .find("bad.geo:1:40: distance is \"-1\"; a number of 0 or more"),
              std::string::npos)
        << problem_of("<DDA><Geometry><Edgenodedist distance=\"-1\"/></Geometry></DDA>");
    EXPECT_NE(problem_of("-0.01\n0 0 0 0 0 0 0 0\n").find("bad.geo:1:1: the least distance"), std::string::npos);
    EXPECT_NE(problem_of("0.01\n1 2 0 0 0 0 0 0\n0 0 1 0 1\n").find("bad.geo:2:3: 2 outline joints among 1 joints"),
              std::string::npos);
    EXPECT_NE(problem_of("0.01\n1 0 0 0 0 0 0 0\n0 0 1 0 0.5\n").find("a type is \"0.5\""), std::string::npos);
}

TEST(PlanarCut, ManyJointsAreCutInTheTimeOfTheirBlocks) {
    std::vector<PlanarJoint> joints = outline_of(std::vector<Vec2>{{0, 0}, {100, 0}, {100, 100}, {0, 100}});
    constexpr int n = 300;
    for (int k = 1; k < n; ++k) {  // each sticks out: the ends are dead
        const double x = 100.0 * k / n;
        joints.push_back({{x, -1}, {x, 101}, 0});
        joints.push_back({{-1, x}, {101, x}, 0});
    }
    const auto cut = cut_by_lines(joints);
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut.value().blocks.size(), static_cast<std::size_t>(n) * n);
    EXPECT_EQ(cut.value().dead_ends, 4 * (n - 1));
    EXPECT_EQ(cut.value().loose_loops, 0);
}

TEST(DdaFiles, ATextThatEndsEarlyIsToldOnce) {
    try {
        read_dda_geometry("0.01\n3 3 0", "short.geo");
        FAIL() << "a text without joints";
    } catch (const CaseError& error) {
        ASSERT_EQ(error.problems().size(), 1u);
        EXPECT_NE(to_string(error.problems()[0]).find("short.geo:2:6: the text ends before the number of bolts"),
                  std::string::npos)
            << to_string(error.problems()[0]);
    }
}

}  // namespace
}  // namespace riprap::geometry
