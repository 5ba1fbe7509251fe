// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/strength/trial_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"

namespace riprap::run {

namespace {

/// Frames of the time in which strength falls and is held.
constexpr int frames_of_trial = 40;

/// Lengths of the fall and of the hold over sqrt(size/g) [-].
constexpr double fall_length = 6, hold_length = 6;

}  // namespace

std::vector<std::int32_t> watched_bodies(const sim::Model& model, const std::string& beginning) {
    std::vector<std::int32_t> watched;
    for (std::int32_t b = 0; b < model.bodies.size(); ++b) {
        if (body::may_move(model.bodies, at(b)) && model.bodies.name(BodyId{b}).starts_with(beginning)) {
            watched.push_back(b);
        }
    }
    return watched;
}

double largest_size(const sim::Model& model, const std::vector<std::int32_t>& bodies) {
    double largest = 0;
    for (const std::int32_t b : bodies) {
        for (std::int32_t p = model.bodies.part_begin[at(b)]; p < model.bodies.part_begin[at(b + 1)]; ++p) {
            const body::Part& part = model.bodies.parts[at(p)];
            const geometry::ConvexView shape = model.shapes.view(part.shape);
            for (int v = 0; v < shape.vertex_count; ++v) {
                const Vec3 corner = to_world(part.local, shape.vertex(v));
                largest = std::max(largest, 2 * norm(model.bodies.is_planar ? Vec3{corner.x, corner.y, 0} : corner));
            }
        }
    }
    return largest;
}

TrialTimes usual_times(const sim::Model& model, double size) {
    const double g = norm(model.gravity.value), unit = g > 0 ? std::sqrt(size / g) : 0;
    const bool is_at_rest = model.time.settle > 0 && !model.has_fluid();
    return {is_at_rest ? 0 : model.time.end, fall_length * unit, hold_length * unit};
}

std::vector<std::string> settings_of_trials(const TrialTimes& times, const std::vector<std::string>& reduces) {
    std::vector<std::string> settings{fmt::format("strength.begins={}", times.begins),
                                      fmt::format("strength.over={}", times.over),
                                      fmt::format("end={}", times.end()),
                                      fmt::format("output.interval={}", (times.over + times.hold) / frames_of_trial),
                                      "output.vtk=true",
                                      "expect=[]"};
    if (!reduces.empty()) {
        settings.push_back(fmt::format("strength.reduces=[\"{}\"]", fmt::join(reduces, "\", \"")));
    }
    return settings;
}

SweepPoint trial_at(double factor, double initial) {
    SweepPoint point{fmt::format("F_{:.5f}", factor), {fmt::format("strength.reduction={}", factor)}};
    if (initial != 1) {
        point.name += fmt::format("_from_{:.5g}", initial);
        point.overrides.push_back(fmt::format("strength.initial={}", initial));
    }
    return point;
}

}  // namespace riprap::run
