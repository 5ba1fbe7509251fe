// SPDX-License-Identifier: Apache-2.0
#pragma once

// Verdict on one trial of a search for the factor of safety, by the frames of its run.

#include <string>
#include <vector>

#include "riprap/core/vec3.hpp"
#include "riprap/run/strength/trial_plan.hpp"
#include "riprap/view/recorded_run.hpp"

namespace riprap::view {

/// Criteria. Movements are those of the corner of a body that moves farthest, over the size of the body, twice the
/// distance of its farthest corner from its centre.
struct FailureCriteria {
    /// A body fails that moves farther than this while strength is held, and in the second half of that time at more
    /// than half its speed in the first: it does not slow down [-].
    double creep{1e-3};
    /// A body fails that has moved farther than this since strength began to fall, at rest or not [-].
    double displaced{0.1};
};

/// One watched body, since strength began to fall.
struct BodyVerdict {
    std::string name;
    double size{0};                        ///< [m]
    double moved{0};                       ///< in all, over its size [-]
    double crept{0};                       ///< while strength was held, over its size [-]
    double first_speed{0}, last_speed{0};  ///< mean of both halves of the hold [m/s]
    bool fails{false};
    std::string why;   ///< it fails
    std::string mode;  ///< "slides", "topples", "falls", "rests"
    Vec3 way{};        ///< of its centre at the onset [m]
    double turned{0};  ///< at the onset [rad]
};

struct TrialVerdict {
    double factor{0};
    bool stands{true};
    std::string why;         ///< of the body that moved farthest among those that fail; empty where it stands
    bool is_slowing{false};  ///< a body still moved at the end, but slowed down
    double onset{0};         ///< time at which a body first moved farther than 2 % of its size [s]; 0: none did
    std::vector<BodyVerdict> bodies;
    std::vector<std::string> warnings;  ///< of its run, about results
    std::vector<double> time,
        moved;  ///< of every frame since strength began to fall: largest movement over size [s], [-]
};

/// Judges the run of a trial. The mode of a body is that at the onset: it rests where it moved less than a tenth as far
/// as the body that moved farthest; it falls where it touches nothing; it topples where its turn moves its corners more
/// than half as far as its centre goes; else it slides.
/// @param watched  numbers of bodies
/// @throws FileError where the run has no frames to judge by
TrialVerdict judge_trial(const RecordedRun& run, const run::TrialTimes& times, double factor,
                         const std::vector<std::int32_t>& watched, const FailureCriteria& criteria);

}  // namespace riprap::view
