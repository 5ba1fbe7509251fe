// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/damage/damage_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/error.hpp"
#include "riprap/view/bad_request.hpp"
#include "riprap/view/damage/survey.hpp"
#include "riprap/view/seen_boxes.hpp"

namespace riprap::view {

namespace {

/// The frame with bodies nearest to a time.
const FrameFiles& nearest(const std::vector<FrameFiles>& frames, double time) {
    return *std::min_element(frames.begin(), frames.end(), [time](const FrameFiles& a, const FrameFiles& b) {
        return std::abs(a.time - time) < std::abs(b.time - time);
    });
}

std::vector<FrameFiles> frames_of(const RecordedRun& run) {
    std::vector<FrameFiles> frames = run.frames;
    std::erase_if(frames, [](const FrameFiles& frame) { return frame.bodies.empty(); });
    if (frames.size() < 2) {
        throw FileError(
            "damage is found between two frames with bodies; the run has fewer (output.vtk, output.interval)");
    }
    return frames;
}

Vec3 place_of(const BodyFrame& frame, std::size_t body) {
    const double* pose = &frame.pose[pose_values * body];
    return {pose[0], pose[1], pose[2]};
}

/// Angle between the orientations of a body [rad].
double turn_between(const BodyFrame& a, const BodyFrame& b, std::size_t body) {
    double product = 0;
    for (std::size_t k = 3; k < pose_values; ++k) {
        product += a.pose[pose_values * body + k] * b.pose[pose_values * body + k];
    }
    return 2 * std::acos(std::min(1.0, std::abs(product)));
}

/// Numbers of the armour units. @throws BadRequest where there is none
std::vector<std::size_t> units_of(const RecordedRun& run, const DamageRequest& request, const BodyFrame& before) {
    std::vector<std::size_t> units;
    const std::size_t count = before.pose.size() / pose_values;
    for (std::size_t body = 0; body < count; ++body) {
        const bool is_free = before.motion[motion_values * body + 9] > 0;
        const bool is_named = body < run.body_names.size() && run.body_names[body].starts_with(request.units);
        if (request.units.empty() ? is_free : is_named) {
            units.push_back(body);
        }
    }
    if (units.empty()) {
        throw BadRequest(request.units.empty()
                             ? "no body of the run is free: --units says how the names of armour units begin"
                             : fmt::format("no body of the run has a name that begins with '{}'", request.units));
    }
    return units;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Two frames and what they show.
struct Between {
    DrawnBodies bodies;
    BodyFrame before, after;
    std::vector<std::size_t> units;
    Vec3 along, across, up;
    Box box;  ///< of the units, along, across, up
};

/// Adds the corners of a unit in one frame to a box.
void add_to(Box& box, const Between& all, const BodyFrame& frame, std::size_t body) {
    const double* pose = &frame.pose[pose_values * body];
    const Quat q{pose[3], pose[4], pose[5], pose[6]};
    for (const Vec3& corner : all.bodies.shapes[static_cast<std::size_t>(all.bodies.shape[body])].corners) {
        const Vec3 x = place_of(frame, body) + rotate(q, corner);
        box.add(Vec3{dot(x, all.along), dot(x, all.across), dot(x, all.up)});
    }
}

void add_units(const RecordedRun& run, const Between& all, const std::vector<FrameFiles>& frames,
               DamageReport& report) {
    for (const std::size_t body : all.units) {
        const double volume =
            volume_of(all.bodies.shapes[static_cast<std::size_t>(all.bodies.shape[body])], run.is_planar);
        const std::string name = body < run.body_names.size() ? run.body_names[body] : fmt::format("body {}", body);
        report.units.push_back({name, run.is_planar ? std::sqrt(volume) : std::cbrt(volume),
                                dot(place_of(all.before, body), all.up),
                                norm(place_of(all.after, body) - place_of(all.before, body)),
                                turn_between(all.before, all.after, body), 0});
    }
    for (const FrameFiles& frame : frames) {
        if (frame.time < report.from || frame.time > report.to) {
            continue;
        }
        const BodyFrame now = read_body_frame(io::read_vtp(frame.bodies), all.bodies);
        for (std::size_t u = 0; u < all.units.size(); ++u) {
            const float* v = &now.motion[motion_values * all.units[u]];
            const double speed =
                std::hypot(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
            report.units[u].largest_speed = std::max(report.units[u].largest_speed, speed);
        }
    }
}

/// Profiles before and after.
void add_profiles(const Between& all, DamageReport& report) {
    const double step = report.diameter / 20;
    constexpr double most = 20000;
    const double length = all.box.high.x - all.box.low.x + 4 * report.diameter;
    SurveyGrid grid{all.along, all.across, all.up, all.box.low.x - 2 * report.diameter, step, 0, 0, 0, 0};
    grid.step = std::max(step, length / most);
    grid.count = static_cast<std::size_t>(length / grid.step) + 1;
    if (!report.is_planar) {
        grid.across_step = report.diameter / 10;
        grid.rows = static_cast<std::size_t>(std::max(1.0, std::floor(report.width / grid.across_step)));
        const double middle = 0.5 * (all.box.low.y + all.box.high.y);
        grid.across_from = middle - 0.5 * static_cast<double>(grid.rows - 1) * grid.across_step;
    }
    report.before = survey(all.bodies, all.before, grid, 0.5 * report.diameter);
    report.after = survey(all.bodies, all.after, grid, 0.5 * report.diameter);
    for (std::size_t i = 0; i < grid.count; ++i) {
        report.place.push_back(grid.from + static_cast<double>(i) * grid.step);
    }
}

ZoneDamage zone_of(const DamageReport& report, double low, double high) {
    ZoneDamage zone{low, high, 0, 0, 0, 0, 0, 0, 0, 0};
    for (const UnitDamage& unit : report.units) {
        if (unit.level >= low && unit.level < high) {
            zone.units += 1;
            zone.moved_half += unit.displacement > 0.5 * unit.diameter ? 1 : 0;
            zone.moved += unit.displacement > unit.diameter ? 1 : 0;
            zone.moved_twice += unit.displacement > 2 * unit.diameter ? 1 : 0;
        }
    }
    const double step = report.place.size() > 1 ? report.place[1] - report.place[0] : 0;
    for (std::size_t i = 0; i < report.place.size(); ++i) {
        const double fall = report.before[i] - report.after[i];
        if (report.before[i] >= low && report.before[i] < high && std::isfinite(fall)) {
            (fall > 0 ? zone.eroded : zone.deposited) += std::abs(fall) * step;
        }
    }
    zone.number = static_cast<double>(zone.moved) * report.diameter / report.width;
    zone.damage = zone.eroded / (report.diameter * report.diameter);
    return zone;
}

}  // namespace

namespace {

/// Reads both frames and finds the units. @throws BadRequest
Between read_frames(const RecordedRun& run, const DamageRequest& request, const FrameFiles& first,
                    const FrameFiles& last) {
    Between all;
    const io::VtpFile begin = io::read_vtp(first.bodies);
    all.bodies = read_shapes(begin);
    all.before = read_body_frame(begin, all.bodies);
    all.after = read_body_frame(io::read_vtp(last.bodies), all.bodies);
    all.units = units_of(run, request, all.before);
    all.up = normalized(-run.gravity);
    const Vec3 level = request.along - all.up * dot(all.up, request.along);
    if (!(norm(level) > 1e-6 * norm(request.along))) {
        throw BadRequest("the direction along the slope must not be upright");
    }
    all.along = normalized(level);
    all.across = cross(all.up, all.along);
    for (const std::size_t body : all.units) {
        add_to(all.box, all, all.before, body);
        add_to(all.box, all, all.after, body);
    }
    return all;
}

/// Sets D_n50 and the width of the strip.
void set_sizes(const Between& all, const DamageRequest& request, DamageReport& report) {
    std::vector<double> diameters;
    Box start;
    for (std::size_t u = 0; u < all.units.size(); ++u) {
        diameters.push_back(report.units[u].diameter);
        add_to(start, all, all.before, all.units[u]);
    }
    report.diameter = median(diameters);
    report.width = report.is_planar ? report.diameter : request.width.value_or(start.high.y - start.low.y);
}

void add_notices(DamageReport& report) {
    if (report.is_planar) {
        report.notices.emplace_back(
            "in the plane armour does not interlock sideways: N_od is of a strip one D_n50 wide");
    } else if (report.width < 3 * report.diameter) {
        report.notices.push_back(fmt::format("the strip is {:.2g} D_n50 wide: its ends count for much of the damage",
                                             report.width / report.diameter));
    }
    std::size_t lost = 0;
    for (std::size_t i = 0; i < report.place.size(); ++i) {
        lost += std::isfinite(report.before[i]) && !std::isfinite(report.after[i]) ? 1 : 0;
    }
    if (lost > 0) {
        report.notices.push_back(
            fmt::format("at {} of {} stations there is no body left, not even ground: they count for no erosion", lost,
                        report.place.size()));
    }
}

}  // namespace

DamageReport damage_report(const RecordedRun& run, const DamageRequest& request) {
    const std::vector<FrameFiles> frames = frames_of(run);
    const FrameFiles& first = nearest(frames, request.from.value_or(frames.front().time));
    const FrameFiles& last = nearest(frames, request.to.value_or(frames.back().time));
    if (!(first.time < last.time)) {
        throw BadRequest(
            fmt::format("there are no two frames between the times asked for; frames go from {:.6g} to {:.6g} s",
                        frames.front().time, frames.back().time));
    }
    if (!(norm(run.gravity) > 0)) {
        throw BadRequest("without gravity there is no level: damage takes it");
    }
    const Between all = read_frames(run, request, first, last);
    DamageReport report{first.time, last.time, 0, 0, run.is_planar, {}, {}, {}, {}, {}, {}};
    add_units(run, all, frames, report);
    set_sizes(all, request, report);
    add_profiles(all, report);
    const double endless = std::numeric_limits<double>::infinity();
    report.zones.push_back(zone_of(report, -endless, endless));
    for (const auto& [low, high] : request.zones) {
        report.zones.push_back(zone_of(report, low, high));
    }
    add_notices(report);
    return report;
}

}  // namespace riprap::view
