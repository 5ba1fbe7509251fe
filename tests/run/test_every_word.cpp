// SPDX-License-Identifier: Apache-2.0
// Every word of every choice of the key table gives a result of its own: a word that falls into another one's code
// fails here. Keys of methods are tried in test_method_keys.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <map>

#include "io/temporary_folder.hpp"
#include "riprap/scene/keys/key_table.hpp"
#include "run/case_result.hpp"

namespace riprap::run {
namespace {

using Scene = std::function<std::string(const std::string& word)>;

/// `text` with every "@" replaced by the word.
std::string put(std::string text, const std::string& word) {
    for (std::size_t at = text.find('@'); at != std::string::npos; at = text.find('@')) {
        text.replace(at, 1, word);
    }
    return text;
}

/// A block of one material slides on a bed of another.
const std::string sliding = R"(gravity = [0, 0, -9.81]
end = 0.1
[material.rock]
density = 2500.0
normal_stiffness = 1e7
friction_coefficient = 0.2
cohesion = 100.0
[material.ice]
density = 900.0
normal_stiffness = 1e7
friction_coefficient = 0.6
cohesion = 900.0
[[body]]
name = "bed"
material = "rock"
shape = { box = [4, 4, 1] }
position = [0, 0, -0.5]
fixed = true
[[body]]
name = "block"
material = "ice"
shape = { cube = 1.0 }
position = [0, 0, 0.499]
velocity = [2, 0, 0]
[contact]
)";

std::string mixing(const std::string& key, const std::string& other, const std::string& word) {
    return sliding + key + " = \"" + word + "\"\n" + other + " = \"mean\"\n";
}

/// A block of some shape falls for three steps.
std::string falling(const std::string& shape) {
    return R"(gravity = [0, 0, -9.81]
end = 0.015
time_step = 0.005
force_time_step = true
[material.rock]
density = 2500.0
normal_stiffness = 1e7
[[body]]
name = "block"
material = "rock"
shape = )" +
           shape + R"(
[[output.probe]]
quantity = "solid.kinetic"
)";
}

/// The same of a body that spheres stand for.
std::string spheres(const std::string& shape, const std::string& given) {
    return falling(shape + "\nspheres = { " + given + " }") + "[solid]\nmethod = \"sphere_dem\"\n";
}

/// A flume of still water with a paddle at its end, at rest in x = 0.
std::string flume(const std::string& paddle, const std::string& wave, const std::string& more) {
    return R"(dimension = 2
gravity = [0, -9.81]
end = 1.0
[material.wood]
density = 500.0
normal_stiffness = 1e6
[[body]]
name = "bed"
material = "wood"
shape = { box = [1.4, 0.2] }
position = [0.4, -0.1]
fixed = true
[[body]]
name = "wall"
material = "wood"
shape = { box = [0.2, 0.8] }
position = [0.9, 0.4]
fixed = true
[[body]]
name = "paddle"
material = "wood"
shape = { box = [0.2, 0.8] }
position = [-0.1, 0.4]
[body.motion.wave_maker]
height = 0.08
depth = 0.3
period = 1.0
ramp = 0.1
)" + ("paddle = \"" + paddle + "\"\nwave = \"" + wave + "\"\n" + more) +
           R"(
[fluid]
spacing = 0.02
domain = { low = [-0.3, -0.3], high = [1.1, 0.8] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [0.8, 0.3] }
)";
}

/// A cube of water in the middle of a larger domain, without gravity.
const std::string cube_of_water = R"(gravity = [0, 0, 0]
end = 1.0
[material.none]
density = 1.0
normal_stiffness = 1.0
[fluid]
spacing = 0.1
sound_speed = 20.0
domain = { low = [-1, -1, -1], high = [2, 2, 2] }
[[fluid.region]]
box = { low = [0, 0, 0], high = [1, 1, 1] }
velocity = [0.3, 0.2, 0.1]
)";

/// A square of 0.6 m that faces `word`, in a side of the cube.
std::string opening(const std::string& kind, const std::string& word, bool is_inflow) {
    const int axis = word.back() - 'x';
    const double side = (word.size() == 1) == is_inflow ? 0.0 : 1.0;
    Vec3 low{0.2, 0.2, 0.2}, high{0.8, 0.8, 0.8};
    low[axis] = high[axis] = side;
    return cube_of_water + fmt::format(
                               "[[fluid.{}]]\nname = \"hole\"\nlow = [{}, {}, {}]\nhigh = [{}, {}, {}]\n"
                               "towards = \"{}\"\nspeed = 0.5\n",
                               kind, low.x, low.y, low.z, high.x, high.y, high.z, word);
}

/// Water in a closed box that turns as its sides let it, with a rule for one of its sides.
std::string turning(const std::string& side, const std::string& kind) {
    return fmt::format(R"(gravity = [0, 0, -1e-9]
end = 1.0
[fluid]
method = "grid"
density = 1000.0
kinematic_viscosity = 0.01
spacing = 0.2
open_top = false
domain = {{ low = [0, 0, 0], high = [1, 1, 1] }}
flow = {{ taylor_green = {{ wave_length = 2.0 }} }}
[[fluid.region]]
[[fluid.side]]
side = "{}"
kind = "{}"
)",
                       side, kind);
}

std::string grid_water(const std::string& wave, const std::string& closure, const std::string& more = "absorb = true");

/// Gauges along the way of waves, and what is expected of these.
std::string wave_answer(const std::string& word) {
    return "time_step = 0.005\n" + grid_water("regular", "ding") + R"([[output.gauge]]
name = "level"
kind = "level"
point = [0.05, 0]
end = [0.25, 0]
count = 3
[[expect]]
name = "it"
quantity = "level"
low = -1
high = 1
citation = "none"
waves = { period = 0.02, length = 0.4 }
reduce = ")" +
           word + "\"\n";
}

/// A block that is thrown up and sideways: its height rises and falls, and x is negative and grows.
std::string answer(const std::string& word) {
    if (word == "incident" || word == "reflection") {
        return wave_answer(word);
    }
    const std::map<std::string, std::string> more{{"at", "at = 0.013\n"},
                                                  {"when", "when = \"block.velocity.z\"\nreaches = 0.02\n"},
                                                  {"rms", "curve = { points = [[0.005, 0.1], [0.013, 0.5]] }\n"},
                                                  {"mean_error", "curve = { points = [[0.005, 0.1], [0.013, 0.5]] }\n"},
                                                  {"worst", "curve = { points = [[0.005, 0.1], [0.013, 0.5]] }\n"}};
    // three steps have no noise yet: its number is tried in test_expect_waves.cpp
    const std::string speed = word == "noise" ? "0.2" : "0.1";
    std::string text = falling("{ cube = 0.1 }\nvelocity = [0.1, 0, " + speed + "]\nposition = [-1, 0, -2e-4]");
    for (const std::string axis : {"x", "z"}) {
        text += "[[expect]]\nname = \"" + axis + "\"\nquantity = \"block.position." + axis +
                "\"\nlow = -1\nhigh = 1\ncitation = \"none\"\nreduce = \"" + word + "\"\n" +
                (more.contains(word) ? more.at(word) : "");
    }
    return text;
}

/// A ball that is in the floor at the start and moves into it and along it; both materials differ in one property.
std::string bouncing(const std::string& property, const std::string& rule, const std::string& word) {
    return R"(gravity = [0, 0, -9.81]
end = 1.0
[solid]
method = "sphere_dem"
rolling = "constant"
[material.ball]
density = 1200.0
friction_coefficient = 0.5
)" + property +
           R"( = 0.9
[material.floor]
density = 1200.0
friction_coefficient = 0.5
)" + property +
           R"( = 0.3
[contact]
)" + rule + " = \"" +
           word + R"("
[[body]]
name = "floor"
material = "floor"
shape = { half_space = { normal = [0, 0, 1] } }
fixed = true
[[body]]
name = "ball"
material = "ball"
shape = { sphere = 0.1 }
position = [0, 0, 0.0999]
velocity = [1, 0, -1]
)";
}

/// Ground whose size and place follow the unit of its file.
std::string ground(const std::string& shape) {
    return falling("{ cube = 0.1 }") +
           "[[body]]\nname = \"ground\"\nmaterial = \"rock\"\nfixed = true\nshape = " + shape +
           "\nposition = [0, 0, -5000]\n";
}

/// Water on a grid that is let go beside stones, with waves through its low side.
std::string grid_water(const std::string& wave, const std::string& closure, const std::string& more) {
    const bool is_stokes = wave == "regular" || wave == "second_order";  // too short to be absorbed
    const std::string height = wave == "none" ? "" : "height = 0.12\n",
                      period = wave == "irregular" ? "period = 6.0\n" : "";
    const std::string size = height + (is_stokes ? "period = 1.9\n" : period + more + "\n");
    return R"(dimension = 2
gravity = [0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1e7
[[body]]
name = "sill"
material = "rock"
fixed = true
shape = { box = [0.3, 0.2] }
position = [2.0, 0.05]
[fluid]
method = "grid"
spacing = 0.02
domain = { low = [0, 0], high = [4, 0.8] }
[[fluid.region]]
box = { low = [0, 0], high = [3, 0.4] }
[[fluid.wave]]
towards = "x"
depth = 0.4
)" + size + R"(wave = ")" +
           wave +
           R"("
[[fluid.porous]]
box = { low = [2.5, 0], high = [3.5, 0.3] }
porosity = 0.4
grain_size = 0.02
linear = 200
quadratic = 1.1
closure = ")" +
           closure + "\"\n";
}

/// Water that runs beside a wall, with an instrument in it, or that turns, for those that look at a flow.
std::string gauge(const std::string& word) {
    if (word == "flow_error" || word == "changed") {
        return turning("x", "slip") + "[[output.gauge]]\nname = \"gauge\"\nkind = \"" + word +
               "\"\npoint = [0, 0, 0]\nend = [1, 1, 1]\n";
    }
    const std::map<std::string, std::string> extent{{"pressure", ""},
                                                    {"velocity", ""},
                                                    {"level", ""},
                                                    {"wall_pressure", ""},
                                                    {"surface", "end = [0.3, 0.5]\n"},
                                                    {"run_up", "end = [0.1, 0.5]\n"},
                                                    {"flow", "end = [0.11, 0.3]\n"},
                                                    {"overhang", "end = [0.3, 0.5]\n"},
                                                    {"turbulent_energy", "end = [0.3, 0.4]\n"},
                                                    {"centre", "end = [0.3, 0.4]\n"},
                                                    {"mean_velocity", "end = [0.3, 0.4]\n"},
                                                    {"volume", "end = [0.3, 0.4]\n"}};
    const std::string water =
        word == "turbulent_energy" ? grid_water("regular", "ding") : flume("piston", "regular", "");
    return water + "[[output.gauge]]\nname = \"gauge\"\nkind = \"" + word +
           "\"\npoint = " + (word == "wall_pressure" ? "[0.8, 0.11]" : "[0.11, 0.11]") + "\n" + extent.at(word);
}

/// Water in a square basin on a grid, with waves that travel towards `word` across gravity.
std::string basin(const std::string& word) {
    const bool is_along_z = word.back() == 'z';
    const auto box = [&](double up) {
        return is_along_z ? fmt::format("{{ low = [0, 0, 0], high = [{}, 6.4, 6.4] }}", up)
                          : fmt::format("{{ low = [0, 0, 0], high = [6.4, 6.4, {}] }}", up);
    };
    return std::string("gravity = ") + (is_along_z ? "[-9.81, 0, 0]" : "[0, 0, -9.81]") +
           "\nend = 1.0\n[material.none]\ndensity = 1.0\nnormal_stiffness = 1.0\n[fluid]\nmethod = \"grid\"\n"
           "spacing = 0.4\ndomain = " +
           box(8.0) + "\n[[fluid.region]]\nbox = " + box(4.0) +
           "\n[[fluid.wave]]\ndepth = 4.0\nheight = 2.0\nperiod = 4.0\nwave = \"regular\"\ntowards = \"" + word +
           "\"\n";
}

const std::map<std::string, Scene>& scenes() {
    static const std::map<std::string, Scene> all{
        {"contact.friction_mixing",
         [](const std::string& word) { return mixing("friction_mixing", "cohesion_mixing", word); }},
        {"contact.cohesion_mixing",
         [](const std::string& word) { return mixing("cohesion_mixing", "friction_mixing", word); }},
        {"contact.restitution_mixing",
         [](const std::string& word) { return bouncing("restitution", "restitution_mixing", word); }},
        {"contact.rolling_mixing",
         [](const std::string& word) { return bouncing("rolling_friction", "rolling_mixing", word); }},
        {"shape.hull.units",
         [](const std::string& word) { return falling("{ hull = { file = \"p.csv\", units = \"" + word + "\" } }"); }},
        {"shape.armour.unit",
         [](const std::string& word) {
             return falling("{ armour = { unit = \"" + word +
                            "\", nominal_diameter = 0.1 } }\nangular_velocity = [1, 2, 3]");
         }},
        {"pack.slope.placement",
         [](const std::string& word) {
             return falling("{ cube = 1.0 }") +
                    put("[[pack]]\nname = \"layer\"\nmaterial = \"rock\"\nslope = { shape = { cube = 0.5 }, from = "
                        "[10, 0, 0], "
                        "to = [14, 0, 2], width = 3.0, layers = 1, packing_density = 0.5, placement = \"@\" }\n",
                        word);
         }},
        {"shape.terrain.units",
         [](const std::string& word) {
             return ground("{ terrain = { file = \"p.asc\", units = \"" + word + "\", thickness = 1e-4 } }");
         }},
        {"shape.mesh.units",
         [](const std::string& word) {
             return ground("{ mesh = { file = \"p.obj\", units = \"" + word + "\", thickness = 1e-4 } }");
         }},
        {"body.spheres.units",
         [](const std::string& word) {
             return spheres("{ cube = 10.0 }", "file = \"s.txt\", mass_of = \"spheres\", units = \"" + word + "\"");
         }},
        {"body.spheres.mass_of",
         [](const std::string& word) { return spheres("{ cube = 1.0 }", "shell = 2, mass_of = \"" + word + "\""); }},
        {"fluid.side.side", [](const std::string& word) { return turning(word, "no_slip"); }},
        {"fluid.side.kind", [](const std::string& word) { return turning("x", word); }},
        {"fluid.wave.towards", basin},
        {"fluid.wave.wave", [](const std::string& word) { return grid_water(word, "ding"); }},
        {"fluid.wave.spectrum",
         [](const std::string& word) { return grid_water("irregular", "ding", "spectrum = \"" + word + "\""); }},
        {"fluid.porous.closure", [](const std::string& word) { return grid_water("regular", word); }},
        {"shape.surface.units",
         [](const std::string& word) { return falling("{ obj = { file = \"p.obj\", units = \"" + word + "\" } }"); }},
        {"motion.wave_maker.paddle",
         [](const std::string& word) { return flume(word, "regular", "hinge = [0.0, 0.0]\n"); }},
        {"motion.wave_maker.wave",
         [](const std::string& word) {
             return flume("piston", word, word == "irregular" ? "" : "absorb = [0.0, 0.0]\n");
         }},
        {"motion.wave_maker.spectrum",
         [](const std::string& word) { return flume("piston", "irregular", "spectrum = \"" + word + "\"\n"); }},
        {"fluid.sponge.towards",
         [](const std::string& word) {
             return cube_of_water +
                    put("[[fluid.sponge]]\nlow = [0, 0, 0]\nhigh = [1, 1, 1]\nrate = 5.0\ntowards = \"@\"\n", word);
         }},
        {"fluid.inflow.towards", [](const std::string& word) { return opening("inflow", word, true); }},
        {"fluid.outflow.towards", [](const std::string& word) { return opening("outflow", word, false); }},
        {"output.gauge.kind", gauge},
        {"expect.reduce", answer}};
    return all;
}

/// Choices without a scene here, each with its reason.
const std::map<std::string, std::string>& excused() {
    static const std::map<std::string, std::string> all{
        {"output.probe.quantity", "test_every_quantity.cpp reads all of them in a dozen cases"}};
    return all;
}

TEST(EveryWord, of_a_choice_gives_a_result_of_its_own) {
    const TemporaryFolder folder;
    std::ofstream(folder / "p.csv") << "x,y,z\n0,0,0\n1,0,0\n0,1,0\n0,0,1\n";
    std::ofstream(folder / "s.txt") << "0.1 0 0 0.3\n";
    std::ofstream(folder / "p.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    std::ofstream(folder / "p.asc") << "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 1\n"
                                       "0 0.1 0\n0 0.2 0\n0 0.1 0\n";
    std::size_t used = 0;
    for (const scene::Table* table : scene::all_tables()) {
        for (const scene::Key& key : table->keys) {
            for (const scene::Form& form : key.forms) {
                const std::string name = fmt::format("{}.{}", table->id, key.name);
                if (form.kind != scene::FormKind::choice || form.words.size() < 2 || !table->methods.empty() ||
                    excused().contains(name)) {
                    continue;
                }
                const auto scene = scenes().find(name);
                ASSERT_NE(scene, scenes().end()) << name << " has words and no scene that tries them";
                ++used;
                std::map<std::string, std::string> words;  // by result
                for (const std::string_view word : form.words) {
                    SCOPED_TRACE(fmt::format("{} = \"{}\"", name, word));
                    try {
                        const auto [first, is_new] = words.emplace(
                            result_of(scene->second(std::string(word)), {}, 3, folder.path().string()), word);
                        EXPECT_TRUE(is_new) << "the same as \"" << first->second << "\"";
                    } catch (const std::exception& error) {
                        ADD_FAILURE() << error.what();
                    }
                }
            }
        }
    }
    EXPECT_EQ(used, scenes().size()) << "a scene of a key that is gone";
}

}  // namespace
}  // namespace riprap::run
