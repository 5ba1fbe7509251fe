// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/scene_builder.hpp"

namespace riprap::validation::rigid {

namespace {

constexpr double gravity = 9.81, radius = 10;  // of the centre line [m]
constexpr int count = 21;                      // voussoirs

struct Arch {
    double sinking{0};       ///< of the keystone at the end [m]
    double late_sinking{0};  ///< of that, in the second half of the run [m]
    std::array<double, count + 1>
        joint_turn{};  ///< of joint 0 (left springing) to 21 when the keystone is 1 % down [rad]
    std::vector<Curve> drawing;
};

Curve outline(const Trial& trial, const char* label) {
    Curve curve;
    curve.label = label;
    for (int i = 1; i <= count; ++i) {
        const geometry::Polyhedron shape = trial.model().shapes.polyhedron(ShapeId{i});
        const Pose pose{trial.position(BodyId{i}), trial.orientation(BodyId{i})};
        for (const auto& face : shape.faces) {
            if (face.size() != 4 || shape.vertices[static_cast<std::size_t>(face[0])].z < 0 ||
                shape.vertices[static_cast<std::size_t>(face[1])].z < 0 ||
                shape.vertices[static_cast<std::size_t>(face[2])].z < 0) {
                continue;
            }
            for (std::size_t k = 0; k <= face.size(); ++k) {
                const Vec3 corner = to_world(pose, shape.vertices[static_cast<std::size_t>(face[k % 4])]);
                curve.x.push_back(corner.x);
                curve.y.push_back(corner.y);
            }
            curve.x.push_back(std::nan(""));
            curve.y.push_back(std::nan(""));
        }
    }
    return curve;
}

Arch stand(double thickness, double duration) {
    SceneBuilder scene(true);
    scene.add_material({.name = "stone", .density = 2500, .normal_stiffness = 1e10, .friction = 0.8});
    BodySpec body;
    body.name = "ground";
    body.shape = scene.add_half_space({0, 1, 0}, 0);
    body.drive = body::Drive::fixed;
    scene.add_body(body);
    body.drive = body::Drive::free;
    const double inner = radius * (1 - 0.5 * thickness), outer = radius * (1 + 0.5 * thickness);
    for (int i = 0; i < count; ++i) {
        const double a0 = M_PI * (1 - double(i) / count), a1 = M_PI * (1 - double(i + 1) / count);
        const std::array<geometry::Point2, 4> corners{{{inner * std::cos(a0), inner * std::sin(a0)},
                                                       {inner * std::cos(a1), inner * std::sin(a1)},
                                                       {outer * std::cos(a1), outer * std::sin(a1)},
                                                       {outer * std::cos(a0), outer * std::sin(a0)}}};
        body.name = fmt::format("voussoir{}", i + 1);
        body.shape = scene.add_shape(geometry::planar_prism(corners));
        scene.add_body(body);
    }
    scene.model.gravity.value = {0, -gravity, 0};
    scene.model.gravity.ramp = 1;
    scene.model.dem()->local_damping = 0.5;
    Trial trial(std::move(scene));
    trial.follow_energy(false);
    const BodyId key{count / 2 + 1};
    const double top = trial.position(key).y;
    Arch arch;
    double half_way = 0;
    bool has_joints = false;
    arch.drawing.push_back(outline(trial, "at the start"));
    while (trial.time() < duration && arch.sinking < 0.1 * radius) {
        trial.step();
        arch.sinking = top - trial.position(key).y;
        half_way = trial.time() < 0.5 * duration ? arch.sinking : half_way;
        if (!has_joints && arch.sinking > 0.02 * radius) {
            has_joints = true;
            double before = 0;
            for (int i = 0; i <= count; ++i) {
                const double turn =
                    i < count ? to_rotation_vector(trial.orientation(BodyId{i + 1})).z : 0;  // the ground does not turn
                arch.joint_turn[static_cast<std::size_t>(i)] = std::abs(turn - before);
                before = turn;
            }
        }
    }
    arch.late_sinking = arch.sinking - half_way;
    arch.drawing.push_back(outline(trial, "at the end"));
    return arch;
}

/// Angle from the crown of the joint that opens most among those from `from` to `to` degrees [deg].
double widest_joint(const Arch& arch, double from, double to) {
    double widest = -1, angle = std::nan("");
    for (int i = 0; i <= count; ++i) {
        const double at = std::abs(90 - 180.0 * i / count);
        if (at >= from && at <= to && arch.joint_turn[static_cast<std::size_t>(i)] > widest) {
            widest = arch.joint_turn[static_cast<std::size_t>(i)];
            angle = at;
        }
    }
    return angle;
}

}  // namespace

void arch(const CaseSetting& setting, CaseReport& report) {
    const double voussoir = 180.0 / count;
    const Arch holds = stand(0.115, 10);
    report.judge({"t/R = 0.115: sinking of the keystone over R", "-", {}, 0.0, {}}, holds.sinking / radius, 0, 1e-3);
    report.state({"t/R = 0.115: sinking in the last 5 s over R", "-", "the source only says that it stands"},
                 holds.late_sinking / radius);
    const Arch falls = stand(0.100, 10);
    report.judge({"t/R = 0.100: sinking of the keystone over R (falls)", "-", {}, {}, {}}, falls.sinking / radius, 0.1,
                 10);
    report.judge({"t/R = 0.100: hinge at the haunch, from the crown", "deg", {}, 54.5, {}}, widest_joint(falls, 20, 75),
                 Absolute{voussoir});
    report.judge({"t/R = 0.100: hinge at the springing, from the crown", "deg", {}, 90.0, {}},
                 widest_joint(falls, 75, 90), Absolute{voussoir});
    report.judge({"t/R = 0.100: hinge at the crown", "deg", {}, 0.0, {}}, widest_joint(falls, 0, 20),
                 Absolute{voussoir});
    Plot plot;
    plot.title = "Semicircular arch of 21 voussoirs, thickness 0.100 R: it falls";
    plot.subtitle = "least thickness 0.1075 R; five hinges: crown, haunches at 54.5 degrees, springings";
    plot.x.label = "x [m]";
    plot.y.label = "y [m]";
    plot.has_equal_scales = true;
    plot.curves = falls.drawing;
    plot.curves.front().style = CurveStyle::dashed;
    write_plot(setting, "arch", plot);
}

}  // namespace riprap::validation::rigid
