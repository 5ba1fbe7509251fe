// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/water_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/error.hpp"
#include "riprap/io/vtp_reader.hpp"
#include "riprap/view/stopped.hpp"

namespace riprap::view {

namespace {

void require_finite(double value, const std::filesystem::path& path) {
    if (!std::isfinite(value)) {
        throw FileError(
            fmt::format("cannot read '{}': its spacing or a position of its water is not finite", path.string()));
    }
}

}  // namespace

WaterFrame WaterReader::read(std::size_t f) {
    heed(stop_);
    const FrameFiles& files = frames_[f];
    if (files.water.empty()) {
        return {};
    }
    try {
        const io::VtpFile frame = io::read_vtp(files.water);
        const std::size_t count = frame.point_count();
        if (frame.has(io::VtpSection::field, "spacing")) {
            const double spacing = frame.numbers(io::VtpSection::field, "spacing", 1)[0];
            require_finite(spacing, files.water);
            spacing_ = spacing;
        }
        WaterFrame water{frame.integers(io::VtpSection::point_data, "id", count), frame.points(),
                         frame.floats(io::VtpSection::point_data, "pressure", count),
                         frame.floats(io::VtpSection::point_data, "speed", count)};
        for (const Vec3& x : water.position) {
            require_finite(dot(x, x), files.water);  // the square: differences of positions are finite then, too
        }
        return water;
    } catch (const FileError& error) {
        if (std::find(notices_.begin(), notices_.end(), error.what()) == notices_.end()) {
            notices_.emplace_back(error.what());
        }
        return {};
    }
}

}  // namespace riprap::view
