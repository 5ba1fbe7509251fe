// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "riprap/view/pack_bodies.hpp"

namespace riprap::view {

/// The largest values of what blocks can be coloured by, over all frames noted.
struct BodyExtremes {
    struct Range {
        double low{std::numeric_limits<double>::quiet_NaN()}, high{std::numeric_limits<double>::quiet_NaN()};
    };
    double speed{0}, displacement{0}, force{0}, contact{0};  ///< [m/s], [m], [N], [N]
    std::vector<Range> fields;                               ///< of the fields shown of free bodies
    std::vector<double> first_pose;                          ///< that displacements count from

    void note(const BodyFrame& frame, const DrawnBodies& bodies);
    void note_contact(float strength) { contact = std::fmax(contact, static_cast<double>(strength)); }
};

}  // namespace riprap::view
