// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/solitary_wave.hpp"

#include <cmath>

namespace riprap::wave {

double SolitaryWave::celerity() const { return std::sqrt(gravity * (depth + height)); }

double SolitaryWave::shape_number() const { return std::sqrt(0.75 * height / (depth * depth * depth)); }

double SolitaryWave::elevation(double from_crest) const {
    const double sech = 1 / std::cosh(shape_number() * from_crest);
    return height * sech * sech;
}

double SolitaryWave::mean_velocity(double from_crest) const {
    const double eta = elevation(from_crest);
    return celerity() * eta / (depth + eta);
}

double SolitaryWave::volume() const { return 2 * height / shape_number(); }

}  // namespace riprap::wave
