// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "riprap/geometry/convex_hull.hpp"
#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/settle.hpp"

namespace riprap::validation::rigid {

namespace {

constexpr double gravity = 9.81, degree = M_PI / 180, density = 2500;
constexpr double taper = 10 * degree;  ///< eta, of the keystone's sides from the vertical
constexpr double key_width = 0.4, key_height = 0.2, key_length = 0.3,
                 key_level = 0.2;                                         ///< at mid-height; of its centre [m]
constexpr double side_width = 0.8, side_height = 0.4, side_length = 0.6;  ///< of the blocks beside it [m]

using Corners = std::vector<Vec3>;

/// Half the width of the gap between the blocks at a height over their mid-height.
double gap_at(double z) { return 0.5 * key_width - z * std::tan(taper); }

/// The keystone, wider below than above, held between two blocks that are pushed together.
class Roof {
 public:
    Roof(double friction, double thrust) : trial_(scene_of(friction, thrust)) {
        trial_.follow_energy(false);
        settle(trial_, 10000);
        level_at_start_ = trial_.position(keystone).z;
    }
    static double key_weight() { return density * key_width * key_height * key_length * gravity; }
    double sunk() const { return level_at_start_ - trial_.position(keystone).z; }
    Trial& trial() { return trial_; }
    static constexpr BodyId keystone{1};

 private:
    static SceneBuilder scene_of(double friction, double thrust) {
        SceneBuilder scene;
        const MaterialId ice = scene.add_material({.name = "ice", .density = density, .normal_stiffness = 1e9});
        const MaterialId rock = scene.add_material({.name = "rock",
                                                    .density = density,
                                                    .normal_stiffness = 1e9,
                                                    .friction = friction,
                                                    .damping_ratio = 0.1,
                                                    .has_torsion = true});
        scene.model.materials.pairs[0 * 2 + 1].friction = scene.model.materials.pairs[1 * 2 + 0].friction = 0;
        BodySpec floor;
        floor.name = "floor";
        floor.material = ice;
        floor.shape = scene.add_half_space({0, 0, 1}, 0);
        floor.drive = body::Drive::fixed;
        scene.add_body(floor);
        BodySpec body;
        body.material = rock;
        body.name = "keystone";
        body.shape = scene.add_shape(geometry::convex_hull(corners(key_height, key_length, [](double z) {
            return std::pair{-gap_at(z), gap_at(z)};
        })));
        body.pose.position.z = key_level;
        scene.add_body(body);
        for (const double side : {-1.0, 1.0}) {
            body.name = side < 0 ? "left" : "right";
            body.shape = scene.add_shape(geometry::convex_hull(corners(side_height, side_length, [side](double z) {
                return std::pair{side * gap_at(z), side * (0.5 * key_width + side_width)};
            })));
            const BodyId id = scene.add_body(body);
            // The thrust goes through the centre of the keystone, at the height of the block's own middle.
            const double lift = key_level - scene.state.bodies.position[static_cast<std::size_t>(id.value)].z;
            scene.model.loads.push_back({.body = id, .force = {-side * thrust, 0, 0}, .point = {0, 0, lift}});
        }
        scene.model.gravity.value = {0, 0, -gravity};
        return scene;
    }
    /// A prism along y whose ends in x are given at both heights.
    template <class Ends>
    static Corners corners(double height, double length, Ends ends) {
        Corners points;
        for (const double z : {-0.5 * height, 0.5 * height}) {
            const auto [a, b] = ends(z);
            for (const double y : {-0.5 * length, 0.5 * length}) {
                points.push_back({a, y, z});
                points.push_back({b, y, z});
            }
        }
        return points;
    }

    Trial trial_;
    double level_at_start_{0};
};

/// Weight and load on the keystone when it has slipped by a thousandth of its height, the load growing slowly [N].
double carried_weight(double friction_angle, double thrust) {
    Roof roof(std::tan(friction_angle), thrust);
    const double limit = 2 * thrust * std::tan(friction_angle - taper), duration = 4;
    const double load = 1.1 * limit - Roof::key_weight(), start = roof.trial().time();
    roof.trial().model().loads.push_back(
        {.body = Roof::keystone, .force = {0, 0, -load}, .start = start, .ramp = duration});
    while (roof.trial().time() < start + duration) {
        roof.trial().step();
        if (roof.sunk() > 1e-3 * key_height) {
            return Roof::key_weight() + load * (roof.trial().time() - start) / duration;
        }
    }
    return std::nan("");
}

}  // namespace

void keystone(const CaseSetting&, CaseReport& report) {
    {
        const double angle = 35 * degree, thrust = 10e3;
        report.judge({"sides 10, friction angle 35: carried weight over the thrust of a side",
                      "-",
                      {},
                      2 * std::tan(angle - taper),
                      {}},
                     carried_weight(angle, thrust) / thrust, Relative{0.02});
    }
    // Thrust enough to hold 1/0.9 times the keystone at 10.5 degrees; at 9.5 none is enough.
    const double thrust = Roof::key_weight() / (0.9 * 2 * std::tan(0.5 * degree));
    for (const double angle : {10.5, 9.5}) {
        Roof roof(std::tan(angle * degree), thrust);
        roof.trial().run_until(roof.trial().time() + 1);
        const std::string name = fmt::format("friction angle {}: motion in 1 s", angle);
        if (angle * degree > taper) {
            report.judge_below({name + " (holds)", "m", {}, {}, {}}, roof.sunk(), 1e-6);
        } else {
            report.judge({name + " (falls)", "m", {}, {}, {}}, roof.sunk(), 0.05, 10);
        }
    }
}

}  // namespace riprap::validation::rigid
