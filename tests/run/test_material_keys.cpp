// SPDX-License-Identifier: Apache-2.0
// A solid method says which properties of materials it reads. Each key of a property changes the result of the methods
// that say so, and of no other: a key that nothing reads, or that a method reads without saying so, fails here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "riprap/material/property_keys.hpp"
#include "riprap/sim/method_traits.hpp"
#include "run/case_result.hpp"

namespace riprap::run {
namespace {

using material::Property;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A block of ice slides and spins on a floor of rock; one beside it touches the floor just so and is torn off, and one
/// is dragged along it.
std::string blocks(bool is_planar, const std::string& method) {
    const auto place = [is_planar](double x, double up) {
        return is_planar ? fmt::format("[{}, {}]", x, up) : fmt::format("[{}, 0, {}]", x, up);
    };
    const auto box = [is_planar](double side, double up) {
        return is_planar ? fmt::format("{{ box = [{}, {}] }}", side, up)
                         : fmt::format("{{ box = [{}, {}, {}] }}", side, side, up);
    };
    return fmt::format(R"({}gravity = {}
end = 1.0
[contact]
friction_mixing = "mean"
cohesion_mixing = "mean"
restitution_mixing = "mean"
rolling_mixing = "mean"
[material.rock]
density = 2500.0
normal_stiffness = "20 MPa"
friction_coefficient = 0.5
torsion = true
[material.ice]
density = 900.0
normal_stiffness = "20 MPa"
friction_coefficient = 0.5
[[body]]
name = "floor"
shape = {}
position = {}
material = "rock"
fixed = true
[[body]]
name = "low"
shape = {}
position = {}
velocity = {}
angular_velocity = [0, 0, {}]
material = "ice"
[[body]]
name = "torn"
shape = {}
position = {}
velocity = {}
material = "ice"
[[body]]
name = "dragged"
shape = {}
position = {}
velocity = {}
material = "ice"
[solid]
method = "{}"
)",
                       is_planar ? "dimension = 2\n" : "", is_planar ? "[0, -9.81]" : "[0, 0, -9.81]", box(5, 0.5),
                       place(0, -0.25), box(1.0, 0.5), place(-1, 0.249), place(20, -0.1), is_planar ? 0.0 : 2.0,
                       box(1.0, 0.5), place(1, 0.25), place(0.1, 0.05), box(0.4, 0.5), place(2, 0.25), place(0.1, 0),
                       method);
}

/// For a method of spheres, a ball of ice beside the blocks, which then meet by their faces.
std::string scene_of(std::string_view method) {
    std::string text = blocks(method == "planar_dda", std::string(method));
    if (method == "sphere_dem") {
        text += R"(spheres = "balls"
youngs_modulus = "10 MPa"
[[body]]
name = "ball"
shape = { sphere = 0.2 }
position = [0, 1.5, 0.199]
velocity = [5, 0, -0.1]
material = "ice"
)";
    }
    return text;
}

/// Values of the ice, each in place of the default or of what the scene gives.
const std::map<std::string_view, std::string>& tried() {
    static const std::map<std::string_view, std::string> values{
        {"normal_stiffness", "3e7"}, {"shear_ratio", "0.3"},       {"shear_stiffness", "1e6"},
        {"friction_angle", "0.2"},   {"cohesion", "1e7"},          {"tensile_strength", "1e7"},
        {"damping_ratio", "0.3"},    {"torsion", "true"},          {"youngs_modulus", "3e7"},
        {"poisson_ratio", "0.1"},    {"restitution", "0.8"},       {"friction_coefficient", "0.2"},
        {"kinetic_share", "0.5"},    {"contact_ratio", "0.9"},     {"rolling_friction", "0.3"},
        {"spring_stiffness", "3e4"}, {"spring_shear_ratio", "0.9"}};
    return values;
}

/// Settings with which a method that reads a property has a law that does.
std::vector<std::string> law_of(Property property, bool is_read) {
    if (!is_read) {
        return {};
    }
    switch (property) {
        case Property::rolling_friction:
            return {"solid.rolling=\"constant\""};
        case Property::spring_stiffness:
        case Property::spring_shear_ratio:
            return {"solid.normal_law=\"linear\""};
        case Property::restitution:  // DDA reads that of two materials that both have one
            return {"material.rock.restitution=0.5"};
        default:
            return {};
    }
}

template <class Work>
void for_each_solid(const Work& work) {
    for (const std::string_view method : sim::solid_words()) {
        work(method, sim::property_uses(method));
    }
}

TEST(MaterialKeys, change_the_result_of_the_methods_that_say_so_and_of_no_other) {
    for_each_solid([](std::string_view method, const std::vector<material::PropertyUse>& uses) {
        const std::string text = scene_of(method);
        for (const auto& [property, key] : material::material_keys()) {
            SCOPED_TRACE(fmt::format("{}, {}", method, key.row.name));
            const bool is_read = std::ranges::find(uses, property, &material::PropertyUse::property) != uses.end();
            std::vector<std::string> change = law_of(property, is_read);
            const std::string plain = result_of(text, change, 4);
            std::string changed = text;
            const std::string given = "friction_coefficient = 0.5\n[[body]]";
            if (property == Property::friction) {  // one key of the two
                changed.replace(changed.find(given), given.size(), "[[body]]");
            }
            change.push_back(fmt::format("material.ice.{}={}", key.row.name, tried().at(key.row.name)));
            EXPECT_EQ(result_of(changed, change, 4) != plain, is_read) << (is_read ? "nothing reads it" : "it is read");
        }
    });
}

TEST(MaterialKeys, of_a_pair_replace_those_of_its_materials) {
    for_each_solid([](std::string_view method, const std::vector<material::PropertyUse>& uses) {
        const std::string text = scene_of(method) + "[[contact.pair]]\nmaterials = [\"rock\", \"ice\"]\n";
        for (const auto& [property, key] : material::pair_keys()) {
            SCOPED_TRACE(fmt::format("{}, {}", method, key.row.name));
            const bool is_read = std::ranges::find(uses, property, &material::PropertyUse::property) != uses.end();
            const std::vector<std::string> law = law_of(property, is_read);
            const std::string given = text + fmt::format("{} = {}\n", key.row.name, tried().at(key.row.name));
            EXPECT_EQ(result_of(given, law, 4) != result_of(text, law, 4), is_read)
                << (is_read ? "nothing reads it" : "it is read");
        }
    });
}

/// Warnings of values that nothing reads.
std::vector<std::string> unread(const std::string& text, const std::vector<std::string>& overrides) {
    std::vector<std::string> found;
    for (const std::string& warning : scene::read_case_text(text, "case.toml", "/nonexistent", overrides).warnings) {
        if (warning.find("does nothing here") != std::string::npos) {
            found.push_back(warning);
        }
    }
    return found;
}

TEST(MaterialKeys, that_the_method_does_not_read_are_told_with_the_methods_that_do) {
    EXPECT_THAT(
        unread(blocks(false, "explicit_dda"), {"material.rock.torsion=false"}),
        ElementsAre(HasSubstr("case.toml:10:20: 'normal_stiffness' of material 'rock' and 1 other does nothing here: "
                              "solid.method \"explicit_dda\" does not read it; leave it out, or solid.method = "
                              "\"distance_potential_dem\", \"sphere_dem\"; its contacts have "
                              "solid.contact_stiffness, of a contact point, in N/m")));
    EXPECT_THAT(unread(blocks(false, "distance_potential_dem"), {"material.ice.restitution=0.5"}),
                ElementsAre(HasSubstr("'restitution' of material 'ice' does nothing here")));
    EXPECT_THAT(unread(blocks(false, "distance_potential_dem"),
                       {"solid.tangential_law=\"tanh\"", "material.ice.cohesion=5.0", "material.rock.torsion=false"}),
                ElementsAre(HasSubstr("'cohesion_mixing' of [contact] does nothing here"),
                            HasSubstr("'cohesion' of material 'ice' does nothing here: solid.method "
                                      "\"distance_potential_dem\" does not read it with these settings")));
    EXPECT_THAT(unread(blocks(false, "distance_potential_dem"), {}), IsEmpty());
    // A value that is the default says nothing that could be lost.
    EXPECT_THAT(unread(blocks(false, "distance_potential_dem"), {"material.ice.tensile_strength=0.0"}), IsEmpty());
}

std::string refusal(const std::string& text, const std::vector<std::string>& overrides = {}) {
    try {
        scene::read_case_text(text, "case.toml", "/nonexistent", overrides);
    } catch (const CaseError& error) {
        std::string all;
        for (const Diagnostic& problem : error.problems()) {
            all += to_string(problem) + "\n";
        }
        return all;
    }
    return "";
}

std::string without_stiffness(std::string text) {
    const std::string key = "normal_stiffness = \"20 MPa\"\n";
    for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key)) {
        text.erase(at, key.size());
    }
    return text;
}

TEST(MaterialKeys, are_asked_for_where_a_physics_of_the_scene_needs_them) {
    EXPECT_THAT(refusal(without_stiffness(blocks(false, "distance_potential_dem"))),
                HasSubstr("material 'ice' lacks 'normal_stiffness', which solid.method = \"distance_potential_dem\" "
                          "needs of 'low'"));
    for (const std::string method : {"explicit_dda", "implicit_dda"}) {
        EXPECT_EQ(refusal(without_stiffness(blocks(false, method))), "") << method;
    }
    EXPECT_EQ(refusal(without_stiffness(blocks(true, "planar_dda"))), "");
    // Bodies of spheres need none; those that meet by their faces do.
    EXPECT_EQ(refusal(without_stiffness(blocks(false, "sphere_dem"))), "");
    EXPECT_THAT(refusal(without_stiffness(blocks(false, "sphere_dem")), {"solid.spheres=\"balls\""}),
                HasSubstr("material 'ice' lacks 'normal_stiffness'"));
    // Where nothing moves, nothing meets.
    EXPECT_EQ(refusal(without_stiffness(blocks(false, "distance_potential_dem")),
                      {"body.low.fixed=true", "body.low.velocity=[0,0,0]", "body.low.angular_velocity=[0,0,0]",
                       "body.torn.fixed=true", "body.torn.velocity=[0,0,0]", "body.dragged.fixed=true",
                       "body.dragged.velocity=[0,0,0]"}),
              "");
}

TEST(MaterialKeys, do_not_ask_for_the_mixing_of_what_the_method_does_not_read) {
    std::string text = blocks(false, "distance_potential_dem");
    const std::string rule = "restitution_mixing = \"mean\"\n";
    text.erase(text.find(rule), rule.size());
    EXPECT_EQ(refusal(text, {"material.ice.restitution=0.5"}), "");
    EXPECT_THAT(refusal(text, {"material.ice.restitution=0.5", "solid.method=\"sphere_dem\""}),
                HasSubstr("lacks 'restitution_mixing'"));
}

std::string without(std::string text, const std::string& line) { return text.erase(text.find(line), line.size()); }

TEST(MaterialKeys, of_mixing_that_the_method_does_not_read_are_told) {
    const std::vector<std::string> harmonic{"contact.restitution_mixing=\"harmonic\""};
    EXPECT_THAT(unread(blocks(false, "distance_potential_dem"), harmonic),
                ElementsAre(HasSubstr("'restitution_mixing' of [contact] does nothing here: solid.method "
                                      "\"distance_potential_dem\" does not read it; leave it out, or solid.method = "
                                      "\"sphere_dem\"")));
    EXPECT_THAT(unread(blocks(false, "sphere_dem"), {"contact.rolling_mixing=\"maximum\""}),
                ElementsAre(HasSubstr("'rolling_mixing' of [contact] does nothing here: solid.method \"sphere_dem\" "
                                      "does not read it with these settings; leave it out")));
    EXPECT_THAT(
        unread(blocks(false, "sphere_dem"), {"contact.rolling_mixing=\"maximum\"", "solid.rolling=\"constant\""}),
        IsEmpty());
}

TEST(MaterialKeys, of_rolling_and_kinetic_friction_are_not_mixed_by_a_rule_that_nobody_gave) {
    const std::string no_rolling = without(blocks(false, "sphere_dem"), "rolling_mixing = \"mean\"\n"),
                      no_friction = without(blocks(false, "sphere_dem"), "friction_mixing = \"mean\"\n");
    const std::string rolls = "material.ice.rolling_friction=0.1", share = "material.ice.kinetic_share=0.5";
    EXPECT_THAT(refusal(no_rolling, {rolls, "solid.rolling=\"constant\""}),
                HasSubstr("case.toml:3:1: materials 'rock' and 'ice' differ, and [contact] lacks 'rolling_mixing'"));
    EXPECT_EQ(refusal(no_rolling, {rolls}), "");  // without a law that reads it
    EXPECT_THAT(refusal(no_friction, {share}), HasSubstr("case.toml:3:1: materials 'rock' and 'ice' differ, and "
                                                         "[contact] lacks 'friction_mixing'"));
    EXPECT_EQ(refusal(no_friction, {share, "solid.method=\"distance_potential_dem\""}), "");
}

TEST(MaterialKeys, of_a_pair_that_the_chosen_law_does_not_read_are_told) {
    const std::string pair = blocks(false, "sphere_dem") + "[[contact.pair]]\nmaterials = [\"rock\", \"ice\"]\n";
    EXPECT_THAT(unread(pair + "spring_stiffness = 1e4\n", {"solid.spheres=\"balls\""}),
                ElementsAre(HasSubstr("'spring_stiffness' of [[contact.pair]] does nothing here: solid.method "
                                      "\"sphere_dem\" does not read it with these settings; leave it out")));
    EXPECT_THAT(unread(pair + "rolling_friction = 0.1\n", {"solid.spheres=\"balls\""}), testing::SizeIs(1));
    EXPECT_THAT(unread(pair + "contact_ratio = 0.1\n", {"solid.spheres=\"balls\""}), IsEmpty());
    EXPECT_THAT(refusal(pair + "contact_ratio = -0.1\n"),
                HasSubstr("case.toml:46:17: contact_ratio of [[contact.pair]]"));
}

// Story: with sphere_dem a damping ratio did nothing for a ball on a box, and nothing said so: faces among themselves
// read it, spheres the restitution.
TEST(MaterialKeys, AKeyThatNoPairOfTheSceneReadsIsWarnedOf) {
    const auto warnings_of = [](const std::string& shape, const std::string& more) {
        return scene::read_case_text(
                   fmt::format("gravity = [0, 0, -9.81]\nend = 0.1\n[material.rock]\ndensity = 2500.0\n"
                               "normal_stiffness = 1e7\ndamping_ratio = 0.3\n[solid]\nmethod = 'sphere_dem'\n{}\n"
                               "[[body]]\nname = 'floor'\nshape = {{ box = [2, 2, 1] }}\nmaterial = 'rock'\n"
                               "fixed = true\nposition = [0, 0, -0.5]\n[[body]]\nname = 'it'\nshape = {{ {} }}\n"
                               "material = 'rock'\nposition = [0, 0, 0.5]\n",
                               more, shape),
                   "case.toml", ".")
            .warnings;
    };
    for (const char* const shape : {"sphere = 0.1", "cube = 0.2"}) {
        EXPECT_THAT(warnings_of(shape, ""),
                    testing::Contains(HasSubstr("case.toml:6:17: 'damping_ratio' of material 'rock' does nothing here: "
                                                "solid.method \"sphere_dem\" reads it of bodies that meet by their "
                                                "faces, and these meet by spheres; leave it out, or 'restitution'")));
    }
    EXPECT_THAT(warnings_of("cube = 0.2", "spheres = 'balls'"), Not(testing::Contains(HasSubstr("does nothing"))));
    EXPECT_THAT(warnings_of("sphere = 0.1", "spheres = 'balls'"), testing::Contains(HasSubstr("'damping_ratio'")));
}

}  // namespace
}  // namespace riprap::run
