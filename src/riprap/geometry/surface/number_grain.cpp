// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/surface/number_grain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/geometry/text/text_reader.hpp"

namespace riprap::geometry {

namespace {

constexpr double told_share = 1e-4;  ///< of the median edge
constexpr double refused_share = 0.02;

double median_edge(const Surface& surface) {
    std::vector<double> lengths;
    for (std::size_t f = 0; f < surface.face_count(); ++f) {
        const auto face = surface.face(f);
        for (std::size_t k = 0; k < face.size(); ++k) {
            const Vec3& a = surface.vertices[at(face[k])];
            lengths.push_back(norm(surface.vertices[at(face[(k + 1) % face.size()])] - a));
        }
    }
    if (lengths.empty()) {
        return 0;
    }
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
}

}  // namespace

double grain_of(float value) {
    constexpr std::uint32_t last_bits = 3;
    if (!std::isfinite(value) || (std::bit_cast<std::uint32_t>(value) & last_bits) == 0) {
        return 0;
    }
    const float size = std::abs(value);
    return static_cast<double>(std::nextafter(size, std::numeric_limits<float>::infinity())) -
           static_cast<double>(size);
}

double grain_of(std::string_view number) {
    constexpr std::size_t least_decimals = 5;
    const std::size_t point = number.find('.'), power = number.find_first_of("eE");
    if (point == std::string_view::npos || power == std::string_view::npos || power < point + 1 + least_decimals ||
        number[power - 1] == '0') {
        return 0;
    }
    std::string_view digits = number.substr(power + 1);
    digits.remove_prefix(digits.starts_with('+') ? 1 : 0);
    const auto exponent = parse_integer(digits);
    return exponent ? std::pow(10.0, static_cast<double>(*exponent) - static_cast<double>(power - point - 1)) : 0;
}

void check_grain(Surface& surface) {
    const double edge = surface.grain > 0 ? median_edge(surface) : 0;
    const double share = edge > 0 ? 0.5 * surface.grain / edge : 0;
    if (!(share > told_share)) {
        return;
    }
    double most = 0;
    for (const Vec3& x : surface.vertices) {
        most = std::max({most, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
    }
    const std::string message =
        fmt::format("coordinates up to {:.6g} m are rounded to {:.2g} m in the file, where edges are {:.3g} m long",
                    most, surface.grain, edge);
    if (share > refused_share) {
        refuse(surface.file, message, "coordinates counted from a point beside the surface, then written as a file");
    }
    surface.add_note({surface.file, 0, 0}, message, "count them from a point beside the surface");
}

}  // namespace riprap::geometry
