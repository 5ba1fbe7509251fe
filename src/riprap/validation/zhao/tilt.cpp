// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/zhao/tilt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "riprap/validation/side_view.hpp"

namespace riprap::validation::zhao {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double gravity = 9.81;       // [m/s^2]
constexpr double tilt_rate = 0.03;     // of the published platform [rad/s]
constexpr double approach_rate = 0.3;  // far below failure, in the short version [rad/s]
constexpr double settling_time = 0.5;  // under upright gravity [s]
constexpr double slope_height = 0.5;   // of all five [m]
constexpr double hold_step = 0.1;      // between the angles held near failure [deg]
constexpr double hold_time = 0.35;     // a row that 0.1 deg too much sets sliding moves by 1 mm in 0.33 s [s]
constexpr double collapse_time = 2;    // and by 20 mm in 1.5 s [s]
constexpr double going_speed =
    1e-3;  // after hold_time; such a row has 6 mm/s, blocks that found a new stand none [m/s]

/// Gravity from here on: turned by `angle`, and turning about -y at `rate`.
void turn_gravity(Trial& trial, double angle, double rate) {
    body::Gravity& g = trial.model().gravity;
    g.value = {gravity * std::sin(angle), 0, -gravity * std::cos(angle)};
    g.axis = {0, -1, 0};
    g.rate = rate;
    g.start = trial.time();
}

class Tilting {
 public:
    Tilting(const CaseSetting& setting, Trial trial, double approach)
        : setting_(setting), approach_(approach), trial_(std::move(trial)), initial_(trial_.state()) {
        trial_.follow_energy(false);
    }

    Failures run() {
        Failures failures;
        turn_at(0, 0);
        trial_.run_until(settling_time);
        failures.rest_depth = trial_.report().max_potential;
        initial_ = trial_.state();
        if (!setting_.is_full && approach_ > 0) {
            turn_at(0, approach_rate);
            trial_.run_until(trial_.time() + approach_ * degree / approach_rate);
            turn_at(approach_ * degree, tilt_rate);
        } else {
            turn_at(0, tilt_rate);
        }
        failures.approach_slip = largest_slip();
        failures.turned = turn_until_failure();
        if (failures.turned.collapsed) {
            failures.held = hold_until_failure();
        }
        return failures;
    }

 private:
    /// A State on the way, one for every degree.
    struct Stop {
        double angle;  ///< [rad]
        sim::State state;
    };

    Failure turn_until_failure() {
        forget_passages();
        constexpr double last_angle = 32 * degree;
        stops_.push_back({angle(), trial_.state()});
        while (!failure_.collapsed && angle() < last_angle) {
            step();
            draw_frames();
            if (angle() > stops_.back().angle + degree) {
                stops_.push_back({angle(), trial_.state()});
            }
        }
        return failure_;
    }

    /// Goes back to the last stop a degree or more before the failure, and on in steps of hold_step, each held.
    Failure hold_until_failure() {
        while (stops_.size() > 1 && stops_.back().angle > (failure_.angle - 1) * degree) {
            stops_.pop_back();
        }
        trial_.state() = stops_.back().state;
        const double start = stops_.back().angle;
        turn_at(start, 0);
        forget_passages();
        constexpr double last_angle = 32 * degree;
        for (int i = 1; !failure_.collapsed && angle() < last_angle; ++i) {
            turn_at(angle(), tilt_rate);
            while (!failure_.collapsed && angle() < start + i * hold_step * degree) {
                step();
            }
            turn_at(angle(), 0);
            hold(hold_time);
            hold(largest_slip() > failure_slip && largest_speed() > going_speed ? collapse_time : 0);
        }
        return failure_;
    }

    void hold(double duration) {
        const double end = trial_.time() + duration;
        while (!failure_.collapsed && trial_.time() < end) {
            step();
        }
    }

    /// Gravity from here on: turned by `angle`, and turning at `rate`.
    void turn_at(double angle, double rate) {
        angle_ = angle;
        rate_ = rate;
        since_ = trial_.time();
        turn_gravity(trial_, angle, rate);
    }
    void step() {
        trial_.step();
        look();
    }
    void forget_passages() {
        failure_ = {};
        first_passage_.assign(initial_.bodies.position.size(), std::nan(""));
        speed_then_.assign(first_passage_.size(), 0.0);
    }
    double angle() const { return angle_ + rate_ * (trial_.time() - since_); }
    double slip(std::size_t i) const { return norm(trial_.state().bodies.position[i] - initial_.bodies.position[i]); }
    bool is_free(std::size_t i) const { return trial_.model().bodies.drive[i] == body::Drive::free; }
    double largest_slip() const {
        double largest = 0;
        for (std::size_t i = 0; i < initial_.bodies.position.size(); ++i) {
            largest = std::max(largest, is_free(i) ? slip(i) : 0.0);
        }
        return largest;
    }

    double largest_speed() const {
        double largest = 0;
        for (std::size_t i = 0; i < initial_.bodies.position.size(); ++i) {
            largest = std::max(largest, is_free(i) ? norm(trial_.state().bodies.velocity[i]) : 0.0);
        }
        return largest;
    }

    void look() {
        for (std::size_t i = 0; i < first_passage_.size(); ++i) {
            const double moved = is_free(i) ? slip(i) : 0;
            const double speed = norm(trial_.state().bodies.velocity[i]);
            if (moved < failure_slip) {
                first_passage_[i] = std::nan("");  // it came back: that was no failure
            } else if (std::isnan(first_passage_[i])) {
                first_passage_[i] = angle();
                speed_then_[i] = speed;
            }
            if (moved > collapse_slip && speed > speed_then_[i]) {
                failure_.angle = first_passage_[i] / degree;
                failure_.collapsed = true;
                failure_.toppling_share = toppling_share();
                return;
            }
        }
    }

    /// A block counts as toppling when its turn accounts for its displacement: turn * slope_height > displacement, as
    /// in a column that turns about its foot; a sliding block hardly turns.
    double toppling_share() const {
        double toppling = 0, all = 0;
        const auto& now = trial_.state().bodies.orientation;
        for (std::size_t i = 0; i < now.size(); ++i) {
            if (!is_free(i) || slip(i) < failure_slip) {
                continue;
            }
            const double turned = norm(to_rotation_vector(now[i] * conjugate(initial_.bodies.orientation[i])));
            all += trial_.model().bodies.mass[i];
            toppling += turned * slope_height > slip(i) ? trial_.model().bodies.mass[i] : 0;
        }
        return all > 0 ? toppling / all : 0;
    }

    /// Frames as the paper shows them: before the tilt, when blocks have moved by 1 mm, 5 mm and 20 mm.
    void draw_frames() {
        constexpr std::array limits{0.0, 1e-3, 5e-3, 20e-3};
        if (setting_.results.empty() || frame_ == limits.size() || largest_slip() < limits[frame_]) {
            return;
        }
        const View platform{};
        write_plot(setting_, fmt::format("{}_frame_{}", setting_.folder.filename().string(), frame_),
                   side_view_plot(trial_.model(), trial_.state(), platform,
                                  fmt::format("tilt {:.2f} deg, largest displacement {:.3g} mm", angle() / degree,
                                              largest_slip() * 1e3)));
        ++frame_;
    }

    const CaseSetting& setting_;
    double approach_;  ///< [deg]
    Trial trial_;
    sim::State initial_;  ///< after settling
    Failure failure_;     ///< of the pass in progress
    std::vector<Stop> stops_;
    std::vector<double> first_passage_;     ///< angle at which a block last passed failure_slip [rad]
    std::vector<double> speed_then_;        ///< its speed at that moment [m/s]
    double angle_{0}, rate_{0}, since_{0};  ///< of gravity: angle_ + rate_ (t - since_) [rad], [rad/s], [s]
    std::size_t frame_{0};
};

}  // namespace

Failures tilt_until_failure(const CaseSetting& setting, Trial trial, double approach) {
    return Tilting(setting, std::move(trial), approach).run();
}

double lag_of_failure(bool topples) {
    const double compliance = topples ? 0.9 / 4 : 1 / (6 * std::cos(26 * degree));
    return tilt_rate * std::cbrt(failure_slip / (compliance * gravity * tilt_rate)) / degree;
}

}  // namespace riprap::validation::zhao
