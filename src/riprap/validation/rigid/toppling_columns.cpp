// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/scene_builder.hpp"

namespace riprap::validation::rigid {

namespace {

constexpr double gravity = 9.81, degree = M_PI / 180;
constexpr double width = 10, step = 1;  // of columns and of the base under them [m]
constexpr int count = 16;

/// Height of column n = 1 (toe) to 16 [m]; the crest is column 10.
double height(int n) { return n <= 10 ? 4.0 * n : 40.0 - 6.0 * (n - 10); }

/// Path of each column: the frame is that of the columns, x towards the toe, y up along them.
struct Columns {
    double late_motion{0};  ///< largest displacement of a column in the last 5 s [m]
    std::array<double, count + 1> turn{},
        slip{};  ///< of column n at the end: rotation [rad], displacement of the base [m]
};

geometry::Outcome<geometry::Polyhedron> rectangle(double w, double h) {
    const std::array<geometry::Point2, 4> corners{
        {{-0.5 * w, -0.5 * h}, {0.5 * w, -0.5 * h}, {0.5 * w, 0.5 * h}, {-0.5 * w, 0.5 * h}}};
    return geometry::planar_prism(corners);
}

Columns stand(double friction_angle, double duration) {
    SceneBuilder scene(true);
    scene.add_material({.name = "rock",
                        .density = 25e3 / gravity,
                        .normal_stiffness = 2e10,
                        .friction = std::tan(friction_angle * degree)});
    const ShapeId base = scene.add_shape(rectangle(width, 4));
    std::array<BodyId, count + 1> columns{};
    for (int n = 1; n <= count; ++n) {
        const double x = -width * (n - 0.5), floor = step * (n - 1);
        BodySpec body;
        body.name = fmt::format("base{}", n);
        body.shape = base;
        body.drive = body::Drive::fixed;
        body.pose.position = {x, floor - 2, 0};
        scene.add_body(body);
        body.name = fmt::format("column{}", n);
        body.shape = scene.add_shape(rectangle(width, height(n)));
        body.drive = body::Drive::free;
        body.pose.position = {x, floor + 0.5 * height(n), 0};
        columns[static_cast<std::size_t>(n)] = scene.add_body(body);
    }
    scene.model.gravity.value = {gravity * std::sin(30 * degree), -gravity * std::cos(30 * degree), 0};
    scene.model.gravity.ramp = 2;
    // Local damping brakes what creeps while contacts chatter: with 0.5 columns that fail move by millimetres a second.
    scene.model.dem()->local_damping = 0.1;
    Trial trial(std::move(scene));
    trial.follow_energy(false);
    const std::vector<Vec3> start = trial.state().bodies.position;
    trial.run_until(duration - 5);
    const std::vector<Vec3> late = trial.state().bodies.position;
    trial.run_until(duration);
    Columns answer;
    for (int n = 1; n <= count; ++n) {
        const auto i = static_cast<std::size_t>(n);
        const BodyId body = columns[i];
        const auto at = static_cast<std::size_t>(body.value);
        answer.late_motion = std::max(answer.late_motion, norm(trial.position(body) - late[at]));
        answer.turn[i] = to_rotation_vector(trial.orientation(body)).z;
        const Vec3 foot{0.5 * width, -0.5 * height(n), 0};  // the corner about which it topples
        answer.slip[i] = (trial.position(body) + rotate(trial.orientation(body), foot) - start[at] - foot).x;
    }
    return answer;
}

}  // namespace

void toppling_columns(const CaseSetting&, CaseReport& report) {
    const double duration = 7;
    const Columns holds = stand(39.0, duration);
    report.judge({"friction angle 39.0: motion in the last 5 s (stands)", "m", {}, 0.0, {}}, holds.late_motion, 0,
                 1e-3);
    const Columns fails = stand(37.3, duration);
    report.judge({"friction angle 37.3: motion in the last 5 s (fails)", "m", {}, {}, "limit: 38.151 degrees"},
                 fails.late_motion, 0.05, 1e3);
    // Modes of limit equilibrium: 16 to 14 stand, 13 to 4 topple, 3 to 1 slide.
    int agreeing = 0;
    std::string modes;
    for (int n = count; n >= 1; --n) {
        const auto i = static_cast<std::size_t>(n);
        const double turned = std::abs(fails.turn[i]) * height(n);
        const bool moves = std::max(turned, std::abs(fails.slip[i])) > 0.05;
        const char mode = !moves ? 'r' : turned > std::abs(fails.slip[i]) ? 't' : 's';
        const char expected = n >= 14 ? 'r' : n >= 4 ? 't' : 's';
        agreeing += mode == expected ? 1 : 0;
        modes += mode;
    }
    report.judge({"columns that fail as in limit equilibrium",
                  "-",
                  {},
                  16.0,
                  "from column 16 down (r rests, t topples, s slides): " + modes},
                 agreeing, 16, 16, CloseBand{13, 16, "columns next to a change of mode do both"});
}

}  // namespace riprap::validation::rigid
