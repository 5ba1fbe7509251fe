// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "riprap/validation/registry.hpp"
#include "riprap/validation/scene_builder.hpp"

namespace riprap::validation::zhao {

/// Failure of a slope that tilts.
struct Failure {
    double angle{std::nan("")};  ///< when the block that falls first has moved by failure_slip [deg]
    bool collapsed{false};       ///< and gone on to collapse_slip, accelerating
    double toppling_share{0};    ///< of the mass that moves, at collapse [-]
};

/// The failures of one slope: on a platform that keeps turning, and on one that is held at every hold_step.
struct Failures {
    Failure turned, held;
    double rest_depth{0};     ///< deepest overlap over the inscribed radius after settling [-]
    double approach_slip{0};  ///< largest displacement when the slow tilt begins [m]
};

/// Tilts a scene of blocks on a platform until they fall: gravity turns about -y, so that +x becomes downhill. The
/// blocks settle for 0.5 s first; in the short version gravity then turns fast up to `approach`, and at the published
/// 0.03 rad/s from there (validation/zhao/slope_1/README.md).
/// @param trial     before its first step
/// @param approach  [deg]; 0: slow from the start
Failures tilt_until_failure(const CaseSetting& setting, Trial trial, double approach);

/// Turn of the platform between the loss of equilibrium and a displacement of 1 mm at 0.03 rad/s [deg]. The resultant
/// grows as g w t from there on: a sliding block moves by s = g w t^3/(6 cos phi), the top block of a column of five
/// that turns about its foot by 9/10 D * g w t^3/(4 D), D its diagonal.
double lag_of_failure(bool topples);

/// The displacement at which a block counts as failing [m], and that up to which it has to go on [m]
constexpr double failure_slip = 1e-3, collapse_slip = 20e-3;

}  // namespace riprap::validation::zhao
