// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/bench/measure.hpp"
#include "riprap/validation/zhao/cases.hpp"
#include "riprap/validation/zhao/pile.hpp"

namespace riprap::validation::zhao {

namespace {

constexpr double edge = 1e-3, room = 13e-3 / 7, stiffness = 1e6;  // [m], [m], [Pa]

/// The potential that the normal force f asks of a corner of a cube upright on a face of another, d its depth:
/// E = k d^4/r (sqrt(3)/8 + 1/8), so f = 1.366 k d^3/r and phi = d/r. A corner that leans, an edge, a face are stiffer.
double corner_potential(double force) {
    const double radius = 0.5 * edge;
    return std::cbrt(force / (0.5 * (1 + std::sqrt(3.0)) * stiffness * radius * radius));
}

/// The five tetrahedra of a cube about the origin: one inside on alternate corners, four that cut off the others.
std::array<std::array<Vec3, 4>, 5> tetrahedra_of_cube() {
    const double h = 0.5 * edge;
    std::array<std::array<Vec3, 4>, 5> pieces{{{{{h, h, h}, {h, -h, -h}, {-h, h, -h}, {-h, -h, h}}}}};
    std::size_t count = 1;
    for (const Vec3& c : {Vec3{-h, -h, -h}, Vec3{h, h, -h}, Vec3{h, -h, h}, Vec3{-h, h, h}}) {
        pieces[count++] = {{c, {-c.x, c.y, c.z}, {c.x, -c.y, c.z}, {c.x, c.y, -c.z}}};
    }
    return pieces;
}

/// The same scene with every cube made of five tetrahedra, each with its own FDEM potential on all four faces as in
/// the source. Twice the modulus: the potential then rises from a face of the cube as steeply as the distance
/// potential does, k/H with H = a instead of k/r with r = a/2.
Trial tetrahedral_twin(const sim::Model& cubes, const sim::State& state) {
    sim::Model model;
    sim::State made;
    model.materials = cubes.materials;
    for (material::Material& material : model.materials.materials) {
        material.normal_stiffness *= 2;
    }
    model.shapes = cubes.shapes;
    model.gravity = cubes.gravity;
    model.time = cubes.time;
    model.solid = cubes.solid;
    model.dem()->contact.potential = contact::Potential::fdem;
    // The bound for bodies covered all over counts the inner faces too. With three times its share both scenes step at
    // about the same share of the bound for the contacts that there are.
    model.time.factor = 3 * cubes.time.factor;
    std::vector<body::Part> pieces;
    for (const auto& [a, b, c, d] : tetrahedra_of_cube()) {
        Vec3 centroid{};
        const ShapeId shape = model.shapes.add_convex(geometry::tetrahedron(a, b, c, d).value(), false, &centroid);
        pieces.push_back({BodyId{}, shape, Pose{centroid, Quat{}}});
    }
    for (std::int32_t i = 0; i < cubes.bodies.size(); ++i) {
        const auto b = static_cast<std::size_t>(i);
        const bool is_free = cubes.bodies.drive[b] == body::Drive::free;
        body::NewBody body;
        body.name = is_free ? "cube" : "wall";
        body.name_index = i;
        body.material = cubes.bodies.material[b];
        body.density = model.materials[body.material].density;
        body.drive = cubes.bodies.drive[b];
        body.pose = {state.bodies.position[b], state.bodies.orientation[b]};
        const auto part = static_cast<std::size_t>(cubes.bodies.part_begin[b]);
        body.parts = is_free ? pieces : std::vector<body::Part>{cubes.bodies.parts[part]};
        body::add_body(model.bodies, made.bodies, model.shapes, body);
    }
    return Trial(std::move(model), std::move(made));
}

double total_mass(const Trial& trial) {
    const body::BodySet& bodies = trial.model().bodies;
    double mass = 0;
    for (std::int32_t i = 0; i < bodies.size(); ++i) {
        const auto b = static_cast<std::size_t>(i);
        mass += bodies.drive[b] == body::Drive::free ? bodies.mass[b] : 0;
    }
    return mass;
}

/// Processor time of a step [s], over `count` steps after as many to warm up.
double time_of_step(Trial& trial, int count) {
    const bench::ThreadScope one(1);
    trial.follow_energy(false);
    double start = 0;
    for (int i = 0; i < 2 * count; ++i) {
        start = i == count ? bench::now() : start;
        trial.step();
    }
    return (bench::now() - start) / count;
}

Trial lattice(const CaseSetting& setting, std::array<int, 3> counts) {
    const double wide = room * counts[0], deep = room * counts[1];
    return trial_of(setting, std::vector<std::string>{
                                 fmt::format("body.cube.repeat.counts=[{},{},{}]", counts[0], counts[1], counts[2]),
                                 fmt::format("body.east.position=[{:.9g},0,0]", wide),
                                 fmt::format("body.north.position=[0,{:.9g},0]", deep)});
}

/// Share of solid in the filled part, whose height is twice that of the centre of mass.
double solid_fraction(double mean_height, int count, double width) {
    return count * std::pow(edge, 3) / (width * width * 2 * mean_height);
}

void plot_rest(const CaseSetting& setting, const PileRun& run, const PileRun* twin) {
    Plot plot;
    plot.title = "Cubes in a box: kinetic energy over its largest";
    plot.subtitle = "means over 0.02 s";
    plot.x.label = "time [s]";
    plot.y = {"kinetic energy over its largest [-]", true};
    plot.curves.push_back({"distance potential", run.times, run.kinetic, CurveStyle::line, -1});
    if (twin != nullptr) {
        plot.curves.push_back({"FDEM, five tetrahedra a cube", twin->times, twin->kinetic, CurveStyle::line, -1});
    }
    write_plot(setting, twin == nullptr ? "cubes_in_box_energy" : "cubes_of_tetrahedra_energy", plot);
}

}  // namespace

void cubes_in_box(const CaseSetting& setting, CaseReport& report) {
    const std::array<int, 3> counts = setting.is_full ? std::array{7, 7, 15} : std::array{2, 2, 3};
    const int count = counts[0] * counts[1] * counts[2];
    const double width = room * counts[0];
    Trial cubes = lattice(setting, counts);
    const PileRun run = fall_to_rest(cubes, width, setting, "cubes_in_box");
    const double weight = 2500 * std::pow(edge, 3) * 9.81;
    const std::string why = fmt::format("a corner on a face; {:.2g} of one cube alone", corner_potential(weight));
    judge_pile(run, corner_potential, why, fmt::format("{} cubes, ", count), report);
    const double fraction = solid_fraction(run.mean_height, count, width);
    const Reference of_fraction{fmt::format("{} cubes, share of solid in the filled part", count),
                                "-",
                                {},
                                {},
                                setting.is_full ? "" : "a few cubes lie looser: walls, floor and an uneven top"};
    if (setting.is_full) {
        report.judge(of_fraction, fraction, 0.55, 0.72);
    } else {
        report.state({of_fraction.quantity, of_fraction.unit, of_fraction.note}, fraction);
    }

    Trial twin = tetrahedral_twin(cubes.model(), cubes.state());
    report.judge({fmt::format("{} cubes, mass of the tetrahedra over that of the cubes", count),
                  "-",
                  {},
                  1.0,
                  {},
                  Kind::bookkeeping},
                 total_mass(twin) / total_mass(cubes), Absolute{1e-12});
    const int timed = setting.is_full ? 200 : 1000;
    const double ratio = time_of_step(twin, timed) / time_of_step(cubes, timed), steps = cubes.dt() / twin.dt();
    report.judge({fmt::format("{} cubes at rest, processor time of a step with FDEM over ours", count),
                  "-",
                  std::string("nearly quintuple"),
                  {},
                  "the same step and the same poses"},
                 ratio, 4.5, 5.0);
    report.judge({fmt::format("{} cubes at rest, processor time of a second with FDEM over ours", count),
                  "-",
                  56.9,
                  {},
                  fmt::format("the paper's table: 916165.54 s over 16112.14 s; ours takes {:.2f} times as many steps "
                              "for the tetrahedra",
                              steps)},
                 ratio * steps, 0.9 * 56.9, 1.1 * 56.9);
    plot_rest(setting, run, nullptr);
}

void cubes_of_tetrahedra(const CaseSetting& setting, CaseReport& report) {
    CaseSetting of_cubes = setting;  // the same scene
    of_cubes.folder = setting.folder.parent_path() / "cubes_in_box";
    const std::array<int, 3> counts{7, 7, 15};
    Trial cubes = lattice(of_cubes, counts);
    Trial twin = tetrahedral_twin(cubes.model(), cubes.state());
    twin.tell(setting.after_step);
    const PileRun ours = fall_to_rest(cubes, room * counts[0], setting, "cubes_in_box");
    const PileRun fdem = fall_to_rest(twin, room * counts[0], setting, "cubes_of_tetrahedra");
    report.judge({"735 cubes, mean height with FDEM over ours", "-", {}, 1.0, {}}, fdem.mean_height / ours.mean_height,
                 Absolute{0.05});
    report.judge_below({"735 cubes with FDEM, kinetic energy over its largest", "-", {}, {}, {}}, fdem.kinetic_share,
                       1e-6);
    report.judge({"735 cubes with FDEM, force of floor and walls over the weight", "-", {}, 1.0, {}}, fdem.support,
                 Absolute{1e-3});
    report.judge({"735 cubes with FDEM, energy that the ledger does not close by, over the turnover",
                  "-",
                  {},
                  0.0,
                  {},
                  Kind::bookkeeping},
                 fdem.energy_error, 0, 0.01);
    report.judge({"735 cubes with FDEM, blocks outside the box", "-", {}, 0.0, {}, Kind::bookkeeping}, fdem.escaped, 0,
                 0);
    report.judge({"735 cubes with FDEM, largest step over the bound for the contacts of the moment",
                  "-",
                  {},
                  {},
                  {},
                  Kind::bookkeeping},
                 fdem.share_of_bound, 0, 0.2);
    plot_rest(setting, ours, &fdem);
}

}  // namespace riprap::validation::zhao
