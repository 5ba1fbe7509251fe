// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/strength/trial_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/core/error.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/quat.hpp"
#include "riprap/view/pack_bodies.hpp"

namespace riprap::view {

namespace {

/// Movement over size at which a body is said to have begun to move [-].
constexpr double onset_share = 0.02;
/// Share of the largest movement below which a body rests.
constexpr double resting_share = 0.1;

/// The frames of a trial since strength began to fall.
struct Film {
    DrawnBodies drawn;
    std::vector<double> time;  ///< [s]
    std::vector<BodyFrame> frames;

    std::size_t nearest(double t) const {
        const auto by_distance = [t](double a, double b) { return std::abs(a - t) < std::abs(b - t); };
        return static_cast<std::size_t>(std::ranges::min_element(time, by_distance) - time.begin());
    }
    const DrawnShape& shape(std::int32_t body) const { return drawn.shapes[at(drawn.shape[at(body)])]; }
};

Vec3 centre_of(const BodyFrame& frame, std::int32_t body) {
    const double* pose = &frame.pose[pose_values * at(body)];
    return {pose[0], pose[1], pose[2]};
}

Quat turn_of(const BodyFrame& frame, std::int32_t body) {
    const double* pose = &frame.pose[pose_values * at(body)];
    return {pose[3], pose[4], pose[5], pose[6]};
}

/// Does anything touch the body? Unknown forces say yes.
bool is_touched(const BodyFrame& frame, std::int32_t body) {
    const float* force = &frame.motion[motion_values * at(body) + 6];
    return std::isnan(force[0]) || force[0] != 0 || force[1] != 0 || force[2] != 0;
}

double size_of(const Film& film, std::int32_t body) {
    double radius = 0;
    for (const Vec3& corner : film.shape(body).corners) {
        radius = std::max(radius, norm(corner));
    }
    return 2 * radius;
}

/// Movement of the corner of a body that moves farthest between two frames [m].
double movement(const Film& film, std::int32_t body, const BodyFrame& from, const BodyFrame& to) {
    const Vec3 way = centre_of(to, body) - centre_of(from, body);
    const Quat before = turn_of(from, body), after = turn_of(to, body);
    double farthest = 0;
    for (const Vec3& corner : film.shape(body).corners) {
        farthest = std::max(farthest, norm(way + rotate(after, corner) - rotate(before, corner)));
    }
    return farthest;
}

Film film_of(const RecordedRun& run, const run::TrialTimes& times) {
    Film film;
    const double slack = 1e-6 * times.end();
    for (const FrameFiles& files : run.frames) {
        // One frame before strength falls, too: at its beginning there may be none.
        const bool is_late = files.time >= times.begins - slack;
        if (files.bodies.empty() || (!is_late && files.time < times.begins - 0.1 * (times.over + times.hold))) {
            continue;
        }
        const io::VtpFile file = io::read_vtp(files.bodies);
        if (film.frames.empty()) {
            film.drawn = read_shapes(file);
        }
        film.time.push_back(files.time);
        film.frames.push_back(read_body_frame(file, film.drawn));
    }
    if (film.frames.size() < 4) {
        throw FileError(fmt::format("'{}' has too few frames to be judged", run.root.string()));
    }
    return film;
}

/// Judges one body by four frames: start of the fall, start, middle and end of the hold.
BodyVerdict judge(const Film& film, std::int32_t body, const std::array<std::size_t, 4>& key,
                  const FailureCriteria& criteria) {
    const auto moved = [&](std::size_t from, std::size_t to) {
        return movement(film, body, film.frames[key[from]], film.frames[key[to]]);
    };
    const auto speed = [&](std::size_t from, std::size_t to) {
        return moved(from, to) / (film.time[key[to]] - film.time[key[from]]);
    };
    BodyVerdict verdict;
    verdict.size = size_of(film, body);
    verdict.moved = moved(0, 3) / verdict.size;
    verdict.crept = moved(1, 3) / verdict.size;
    verdict.first_speed = speed(1, 2);
    verdict.last_speed = speed(2, 3);
    const bool keeps_on = verdict.last_speed > 0.5 * verdict.first_speed;
    const bool let_go = is_touched(film.frames[key[0]], body) && !is_touched(film.frames[key[3]], body);
    if (verdict.moved > criteria.displaced) {
        verdict.why = fmt::format("moved {:.3g} of its size", verdict.moved);
    } else if (verdict.crept > criteria.creep && let_go) {
        verdict.why = fmt::format("lost its contacts, {:.3g} of its size away", verdict.moved);
    } else if (verdict.crept > criteria.creep && keeps_on) {
        verdict.why = fmt::format("creeps, {:.3g} of its size in the hold, {:.3g} m/s after {:.3g} m/s", verdict.crept,
                                  verdict.last_speed, verdict.first_speed);
    }
    verdict.fails = !verdict.why.empty();
    return verdict;
}

/// Judges one body of a run that stopped after it had begun to fail.
BodyVerdict judge_part(const Film& film, std::int32_t body, std::size_t begin, const FailureCriteria& criteria) {
    BodyVerdict verdict;
    verdict.size = size_of(film, body);
    verdict.moved = movement(film, body, film.frames[begin], film.frames.back()) / verdict.size;
    if (verdict.moved > criteria.displaced) {
        verdict.why = fmt::format("moved {:.3g} of its size before the run stopped", verdict.moved);
    }
    verdict.fails = !verdict.why.empty();
    return verdict;
}

void add_mode(const Film& film, std::int32_t body, std::size_t begin, std::size_t onset, double largest,
              BodyVerdict& verdict) {
    const BodyFrame &before = film.frames[begin], &now = film.frames[onset];
    const double moved = movement(film, body, before, now);
    verdict.way = centre_of(now, body) - centre_of(before, body);
    const Quat turn = turn_of(now, body) * conjugate(turn_of(before, body));
    verdict.turned = 2 * std::atan2(std::sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z), std::abs(turn.w));
    const double by_turn = 0.5 * verdict.turned * verdict.size;
    if (moved < resting_share * largest) {
        verdict.mode = "rests";
    } else if (!is_touched(now, body)) {
        verdict.mode = "falls";
    } else {
        verdict.mode = by_turn > 0.5 * norm(verdict.way) ? "topples" : "slides";
    }
}

/// Writes the largest movement of every frame, and finds the onset: the first frame beyond it, or the last frame.
std::size_t add_history(const Film& film, std::size_t begin, const std::vector<std::int32_t>& watched,
                        TrialVerdict& verdict) {
    std::size_t onset = film.frames.size() - 1;
    for (std::size_t k = begin; k < film.frames.size(); ++k) {
        double largest = 0;
        for (const std::int32_t body : watched) {
            largest = std::max(largest, movement(film, body, film.frames[begin], film.frames[k]) / size_of(film, body));
        }
        verdict.time.push_back(film.time[k]);
        verdict.moved.push_back(largest);
        if (largest > onset_share && verdict.onset == 0) {
            verdict.onset = film.time[k];
            onset = k;
        }
    }
    return onset;
}

}  // namespace

TrialVerdict judge_trial(const RecordedRun& run, const run::TrialTimes& times, double factor,
                         const std::vector<std::int32_t>& watched, const FailureCriteria& criteria) {
    const Film film = film_of(run, times);
    const std::array<std::size_t, 4> key{film.nearest(times.begins), film.nearest(times.ramp_end()),
                                         film.nearest(times.ramp_end() + 0.5 * times.hold), film.frames.size() - 1};
    TrialVerdict verdict;
    verdict.factor = factor;
    verdict.warnings = run.warnings;
    const std::size_t onset = add_history(film, key[0], watched, verdict);
    const bool is_whole = key[0] < key[1] && key[1] < key[2] && key[2] < key[3] &&
                          film.time.back() > times.end() - 0.5 * (film.time[key[3]] - film.time[key[3] - 1]);
    if (!is_whole && verdict.moved.back() <= criteria.displaced) {
        throw FileError(fmt::format("'{}' ended at {:.6g} s, before its verdict: {}", run.root.string(),
                                    film.time.back(), run.status));
    }
    double largest = 0, worst = -1;
    for (const std::int32_t body : watched) {
        largest = std::max(largest, movement(film, body, film.frames[key[0]], film.frames[onset]));
    }
    for (const std::int32_t body : watched) {
        BodyVerdict one = is_whole ? judge(film, body, key, criteria) : judge_part(film, body, key[0], criteria);
        one.name = at(body) < run.body_names.size() ? run.body_names[at(body)] : fmt::format("body {}", body);
        add_mode(film, body, key[0], onset, largest, one);
        if (one.fails && one.moved > worst) {
            worst = one.moved;
            verdict.why = fmt::format("'{}' {}", one.name, one.why);
        }
        verdict.stands = verdict.stands && !one.fails;
        verdict.is_slowing = verdict.is_slowing || (!one.fails && one.crept > criteria.creep);
        verdict.bodies.push_back(std::move(one));
    }
    return verdict;
}

}  // namespace riprap::view
