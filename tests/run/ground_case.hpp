// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "io/temporary_folder.hpp"
#include "riprap/run/simulate/simulation.hpp"

namespace riprap::run {

/// A folder with the files of a case.
class CaseFolder {
 public:
    std::string path() const { return folder_.path().string(); }

    /// Heights of a surface z(x, y) on points `pitch` apart from (x, y) = (-1, -1).
    void write_heights(int columns, int rows, double pitch, const std::function<double(double, double)>& z) const {
        std::ofstream file(folder_ / "bed.asc");
        file << fmt::format("ncols {}\nnrows {}\nxllcenter -1\nyllcenter -1\ncellsize {}\n", columns, rows, pitch);
        for (int j = rows - 1; j >= 0; --j) {
            for (int i = 0; i < columns; ++i) {
                file << fmt::format("{:.17g} ", z(-1 + pitch * i, -1 + pitch * j));
            }
            file << '\n';
        }
    }
    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

 private:
    TemporaryFolder folder_;
};

inline std::unique_ptr<Simulation> start(const CaseFolder& folder, const std::string& text) {
    return std::make_unique<Simulation>(scene::read_case_text(text, "case.toml", folder.path()));
}

inline std::unique_ptr<Simulation> run(const CaseFolder& folder, const std::string& text) {
    auto simulation = start(folder, text);
    while (simulation->steps_left() > 0) {
        const StepOutcome outcome = simulation->step(sim::Measure::energy);
        if (outcome.kind == StepOutcome::Kind::refused) {
            throw std::runtime_error(outcome.why.text);
        }
    }
    return simulation;
}

inline Vec3 place_of_last(const std::unique_ptr<Simulation>& simulation) {
    return simulation->state().bodies.position.back();
}

/// A case with one block on ground.
struct BlockOnGround {
    std::string ground;    ///< keys of the ground: shape, and `fixed` or a motion
    std::string block;     ///< keys of the block: shape and place
    std::string method{};  ///< keys of the run, then [solid]
    double end{0.5};       ///< [s]
    bool is_planar{false};
    std::string material{"density = 2500.0\nnormal_stiffness = 1.0e7\nfriction_angle_deg = 35.0\n"};
};

inline std::string text_of(const BlockOnGround& scene) {
    return fmt::format(R"({}
end = {}
{}
[material.rock]
{}
[[body]]
name = "ground"
material = "rock"
{}
[[body]]
name = "block"
material = "rock"
{}
)",
                       scene.is_planar ? "dimension = 2\ngravity = [0.0, -9.81]" : "gravity = [0.0, 0.0, -9.81]",
                       scene.end, scene.method, scene.material, scene.ground, scene.block);
}

/// A block, or a ball, on a slope of 30 degrees: half a second of sliding.
inline std::string slope(const std::string& ground, const std::string& block, const std::string& method = "") {
    return text_of(
        {.ground = "fixed = true\nshape = " + ground,
         .block = "orientation = { axis_angle = { axis = [0, 1, 0], angle_deg = 30 } }\n" + block,
         .method = method,
         .material = "density = 2500.0\nnormal_stiffness = 1.0e7\nfriction_angle_deg = 20.0\ndamping_ratio = 0.1\n"});
}

/// The slope for blocks, from (0, 0) downwards, as points of a height grid, and as a half-space.
inline const double slope_tangent = std::tan(M_PI / 6);
inline const std::string slope_plane = "{ half_space = { normal = [0.5, 0, 0.8660254037844386] } }";
inline const std::string slope_grid = "{ terrain = { file = 'bed.asc', thickness = 1 } }";
/// A box that lies on the slope.
inline const Vec3 slope_start{0.0625, 0.02, 0.1082531754730548};
inline const std::string slope_box =
    "shape = { box = [0.5, 0.5, 0.25] }\nposition = [0.0625, 0.02, 0.1082531754730548]";

/// An uneven strip of triangles in the plane of the slope.
inline std::string slope_strip() {
    std::string obj;
    for (int i = 0; i < 12; ++i) {
        const double x = -1 + 0.21 * i + 0.05 * (i % 3);
        obj += fmt::format("v {} -1 {}\nv {} {} {}\nv {} 1 {}\n", x, -slope_tangent * x, x + 0.03, 0.1 * (i % 4),
                           -slope_tangent * (x + 0.03), x, -slope_tangent * x);
    }
    for (int i = 0; i < 11; ++i) {
        for (int k = 1; k <= 2; ++k) {
            const int a = 3 * i + k;
            obj += fmt::format("f {} {} {}\nf {} {} {}\n", a, a + 3, a + 4, a, a + 4, a + 1);
        }
    }
    return obj;
}

}  // namespace riprap::run
