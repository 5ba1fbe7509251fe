// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "riprap/view/pack_bodies.hpp"

namespace riprap::view {

/// Stations of a survey: `count` along a slope and `rows` beside each other across it.
struct SurveyGrid {
    Vec3 along, across, up;  ///< unit vectors
    double from, step;       ///< along [m]
    std::size_t count;
    double across_from, across_step;  ///< [m]
    std::size_t rows;                 ///< 0: a planar scene, whose bodies are polygons
};

/// Heights of the highest bodies at the stations, averaged over the rows, as a round foot of diameter `foot` feels
/// them: a mechanical profiler, whose foot does not enter gaps narrower than itself. Not a number where no row meets a
/// body.
/// @param foot  half D_n50 of the armour is usual [m]
std::vector<double> survey(const DrawnBodies& bodies, const BodyFrame& frame, const SurveyGrid& grid, double foot);

/// Volume of a closed shape [m^3]; of a planar one its area [m^2].
double volume_of(const DrawnShape& shape, bool is_planar);

}  // namespace riprap::view
