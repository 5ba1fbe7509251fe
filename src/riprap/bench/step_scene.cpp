// SPDX-License-Identifier: Apache-2.0
#include "riprap/bench/step_scene.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "riprap/scene/read_case.hpp"

namespace riprap::bench {

namespace {

constexpr const char* head = R"(
title   = "Whole steps"
gravity = [0.0, 0.0, -9.81]
end     = 10.0

[material.rock]
density              = {density}
normal_stiffness     = 1.0e6
friction_coefficient = 0.5
damping_ratio        = 0.2

[fluid]
spacing         = {spacing}
domain          = {{ low = [-0.5, -0.5, -0.5], high = [{x}, {y}, {z}] }}
)";

/// Material, water and its domain [kg/m^3], [m].
std::string start(double density, double spacing, const Vec3& high) {
    return fmt::format(head, fmt::arg("density", density), fmt::arg("spacing", spacing), fmt::arg("x", high.x),
                       fmt::arg("y", high.y), fmt::arg("z", high.z));
}

std::string region(const Vec3& low, const Vec3& high) {
    return fmt::format("\n[[fluid.region]]\nbox = {{ low = [{}, {}, {}], high = [{}, {}, {}] }}\n", low.x, low.y, low.z,
                       high.x, high.y, high.z);
}

std::string plane(const std::string& name, const Vec3& normal, double offset) {
    return fmt::format(
        "\n[[body]]\nname = \"{}\"\nmaterial = \"rock\"\nfixed = true\n"
        "shape = {{ half_space = {{ normal = [{}, {}, {}], offset = {} }} }}\n",
        name, normal.x, normal.y, normal.z, offset);
}

/// Floor and walls of a basin from the origin to a corner; no lid.
std::string basin(double length, double width) {
    return plane("floor", {0, 0, 1}, 0) + plane("left", {1, 0, 0}, 0) + plane("right", {-1, 0, 0}, -length) +
           plane("front", {0, 1, 0}, 0) + plane("back", {0, -1, 0}, -width);
}

std::string box(const std::string& name, const Vec3& edges, const Vec3& place, const std::string& rest) {
    return fmt::format(
        "\n[[body]]\nname = \"{}\"\nmaterial = \"rock\"\nshape = {{ box = [{}, {}, {}] }}\nposition = [{}, {}, "
        "{}]\n{}\n",
        name, edges.x, edges.y, edges.z, place.x, place.y, place.z, rest);
}

std::string repeated(const std::array<int, 3>& counts, const Vec3& pitch, double stagger) {
    return fmt::format("repeat = {{ counts = [{}, {}, {}], pitch = [{}, {}, {}], stagger = {} }}", counts[0], counts[1],
                       counts[2], pitch.x, pitch.y, pitch.z, stagger);
}

StepScene scene_of(const std::string& text) {
    scene::LoadedCase loaded = scene::read_case_text(text, "bench", ".");
    sim::initialise(loaded.model, loaded.state);
    return {std::move(loaded.model), std::move(loaded.state)};
}

}  // namespace

StepScene dam_break_on_box(const StepSize& size) {
    const double spacing = 0.0079 * size.coarser;
    return scene_of(start(2500, spacing, {2.1, 1.17, 1.5}) + region({0, 0, 0}, {0.4, 0.67, 0.3}) + basin(1.6, 0.67) +
                    box("box", {0.12, 0.12, 0.4}, {0.96, 0.3, 0.2}, "fixed = true"));
}

StepScene dam_break_with_floes(const StepSize& size) {
    const double spacing = 0.0048387 * size.coarser;
    return scene_of(
        start(868, spacing, {1.2, 0.65, 0.8}) + region({0, 0, 0}, {0.15, 0.15, 0.15}) +
        region({0.17, 0, 0}, {0.7, 0.15, 0.025}) + basin(0.7, 0.15) +
        box("gate", {0.02, 0.15, 0.3}, {0.16, 0.075, 0.15}, "motion = { linear = { velocity = [0.0, 0.0, 0.4] } }") +
        box("floe", {0.0725, 0.0725, 0.0195}, {0.0375, 0.0375, 0.14282}, repeated({2, 2, 1}, {0.075, 0.075, 1}, 0)));
}

StepScene rubble_in_basin(Rubble rubble, double wet, const StepSize& size) {
    constexpr double edge = 0.1, pitch = 1.5 * edge;
    const double spacing = 0.025 * size.coarser;
    const std::array<int, 3> counts{16 / size.fewer, 16 / size.fewer, 12 / size.fewer};
    const double width = (counts[1] + 0.5) * pitch, height = counts[2] * edge, length = 1.2 * counts[0] * pitch;
    const std::string water =
        start(2500, spacing, {length + 0.5, width + 0.5, height + 1}) +
        region({0, 0, 0}, {length, width, wet * height}) + plane("floor", {0, 0, 1}, 0) + plane("left", {1, 0, 0}, 0) +
        plane("front", {0, 1, 0}, 0) + plane("back", {0, -1, 0}, -width) +
        box("end", {2 * edge, 2 * width, 2 * height}, {length + edge, 0.5 * width, height}, "fixed = true");
    const double first = rubble == Rubble::far_dry ? length + 10 * edge : 0;
    const std::string blocks = box("block", {edge, edge, edge}, {first + 0.5 * pitch, 0.5 * pitch, 0.5 * edge},
                                   repeated(counts, {pitch, pitch, edge}, 0.5 * edge));
    if (rubble == Rubble::in_basin || rubble == Rubble::far_dry) {
        return scene_of(water + blocks);
    }
    StepScene scene = scene_of(water);
    if (rubble == Rubble::none) {
        StepScene with_blocks = rubble_in_basin(Rubble::in_basin, wet, size);
        scene.state.fluid = std::move(with_blocks.state.fluid);
        scene.state.open = std::move(with_blocks.state.open);  // which knows how many there were
    }
    return scene;
}

StepScene slide_into_water(const StepSize& size) {
    constexpr double edge = 0.06, depth = 0.3, width = 0.66, foot = 1.4;
    constexpr double angle = 35 * std::numbers::pi / 180;
    const double spacing = 0.016 * size.coarser;
    const std::array<int, 3> counts{10 / size.fewer, 10 / size.fewer, 5 / size.fewer};
    const Vec3 up{std::cos(angle), 0, std::sin(angle)}, out{-std::sin(angle), 0, std::cos(angle)};
    const Vec3 first = Vec3{foot, 0.5 * edge, 0} + (depth / std::sin(angle) + edge) * up + 0.5 * edge * out;
    const std::string turned = fmt::format("{{ axis_angle = {{ axis = [0.0, 1.0, 0.0], angle = {} }} }}", -angle);
    const std::string sliding = fmt::format(
        "orientation = {}\nvelocity = [{}, 0.0, {}]\n"
        "repeat = {{ counts = [{}, {}, {}], pitch = [{}, {}, {}], orientation = {} }}",
        turned, -2 * up.x, -2 * up.z, counts[0], counts[1], counts[2], 1.05 * edge, 1.08 * edge, edge, turned);
    return scene_of(start(2500, spacing, {4, width + 0.5, 2.5}) + region({0, 0, 0}, {2.2, width, depth}) +
                    plane("floor", {0, 0, 1}, 0) + plane("left", {1, 0, 0}, 0) + plane("front", {0, 1, 0}, 0) +
                    plane("back", {0, -1, 0}, -width) + plane("slope", out, foot * out.x) +
                    box("block", {edge, edge, edge}, first, sliding));
}

}  // namespace riprap::bench
