// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/run/drive/signals.hpp"
#include "riprap/view/pack_water.hpp"
#include "riprap/view/recorded_run.hpp"

namespace riprap::view {

/// Reads the water of frames, as often as is asked.
class WaterReader {
 public:
    /// @param notices  takes what could not be read, once
    WaterReader(const std::vector<FrameFiles>& frames, const run::StopRequest* stop, std::vector<std::string>& notices)
        : frames_(frames), stop_(stop), notices_(notices) {}

    /// The water of a frame; none, with a notice, where it cannot be read.
    WaterFrame read(std::size_t f);
    double spacing() const { return spacing_; }  ///< of the frames read so far [m]

 private:
    const std::vector<FrameFiles>& frames_;
    const run::StopRequest* stop_;
    std::vector<std::string>& notices_;
    double spacing_{0};
};

}  // namespace riprap::view
