// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/rigid/tipping.hpp"
#include "riprap/validation/scene_builder.hpp"

namespace riprap::validation::rigid {

namespace {

constexpr double gravity = 9.81, degree = M_PI / 180, density = 2500, stiffness = 1e9;

Vec3 tilted(double angle) { return {gravity * std::sin(angle), 0, -gravity * std::cos(angle)}; }

struct Failure {
    double angle{std::nan("")};  ///< of the slope when the block begins to go [rad]
    bool is_toppling{false};
};

/// A block on a slope that is raised, by turning gravity, until the block goes.
class TiltedBlock {
 public:
    TiltedBlock(const StandingBlock& block, double friction, double from)
        : edge_{0.5 * block.width, 0, -0.5 * block.height},
          largest_slip_(1e-3 * block.width),
          largest_turn_(2 * tipping_tilt(block.foot())),
          angle_(from),
          trial_(scene_of(block, friction, from)) {
        trial_.follow_energy(false);
        // Close to tipping the block rocks a hundred times slower than its contact swings: local damping takes the same
        // share of every mode, where mass damping would stop the slow ones from settling at all.
        trial_.model().dem()->local_damping = 0.5;
        trial_.run_until(1);
        edge_at_start_ = edge_position();
    }

    /// Raises the slope to `to` at `rate` [rad/s], unless the block goes before.
    void raise(double to, double rate) {
        body::Gravity& turning = trial_.model().gravity;
        turning.value = tilted(angle_);
        turning.axis = {0, -1, 0};  // turns (0, 0, -g) towards +x
        turning.rate = rate;
        turning.start = trial_.time();
        const double from = angle_;
        while (angle_ < to && std::isnan(failure_.angle)) {
            trial_.step();
            angle_ = from + rate * (trial_.time() - turning.start);
            const double slip = edge_position() - edge_at_start_;
            const double turn = norm(to_rotation_vector(trial_.orientation(body)));
            if (slip > largest_slip_ || turn > largest_turn_) {
                failure_ = {angle_, turn > largest_turn_};
            }
        }
    }

    const Failure& failure() const { return failure_; }

 private:
    static constexpr BodyId body{1};

    static SceneBuilder scene_of(const StandingBlock& block, double friction, double slope) {
        SceneBuilder scene;
        scene.add_material(
            {.name = "rock", .density = block.density, .normal_stiffness = block.stiffness, .friction = friction});
        BodySpec ground;
        ground.name = "ground";
        ground.shape = scene.add_half_space({0, 0, 1}, 0);
        ground.drive = body::Drive::fixed;
        scene.add_body(ground);
        BodySpec spec;
        spec.name = "block";
        spec.shape = scene.add_shape(geometry::box({block.width, 1, block.height}));
        spec.pose.position.z = 0.5 * block.height;
        scene.add_body(spec);
        scene.model.gravity.value = tilted(slope);
        return scene;
    }

    /// Slip is that of the lower edge: the centre of a block that leans on its elastic base goes along with the lean.
    double edge_position() const { return trial_.position(body).x + rotate(trial_.orientation(body), edge_).x; }

    Vec3 edge_;
    double largest_slip_, largest_turn_, angle_;
    double edge_at_start_{0};
    Trial trial_;
    Failure failure_;
};

}  // namespace

void tip_or_slide(const CaseSetting&, CaseReport& report) {
    for (const double ratio : {0.2, 0.4, 0.8}) {
        for (const double side : {0.8, 1.25}) {
            const double height = 0.5, friction = side * ratio;
            const StandingBlock block{ratio * height, height, density, stiffness};
            const bool must_topple = side > 1;
            const double exact = std::atan(must_topple ? ratio : friction);
            TiltedBlock trial(block, friction, exact - degree);
            // The last quarter of a degree is slow: a block past its limit takes a second to show it.
            trial.raise(exact - 0.25 * degree, 0.1 * degree);
            trial.raise(exact + 0.5 * degree, 0.02 * degree);
            const std::string name =
                fmt::format("b/h = {}, tan phi = {:.3g}: {}", ratio, friction, must_topple ? "topples" : "slides");
            report.judge({name + " at", "deg", {}, exact / degree, {}}, trial.failure().angle / degree, Absolute{0.1});
            report.judge({name + " (1 = topples)", "-", {}, must_topple ? 1.0 : 0.0, {}},
                         trial.failure().is_toppling ? 1 : 0, Absolute{0});
        }
    }
}

}  // namespace riprap::validation::rigid
