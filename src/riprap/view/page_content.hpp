// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/view/recorded_run.hpp"
#include "riprap/view/stopped.hpp"

namespace riprap::view {

/// One packed piece of the page.
struct Chunk {
    std::string name;
    std::string packed;  ///< zlib stream
};

/// Content of a page: a table of contents and packed pieces. page/src/recording.js reads the same.
struct PageContent {
    std::string contents_json;
    std::vector<Chunk> chunks;
    std::vector<std::string> notices;  ///< what could not be read, also shown on the page
    double water_error{0};             ///< bound on the error of a coordinate of a particle [m]
    std::size_t packed_bytes() const;
};

/// Reads and packs a run. `budget` bounds the bytes of the page [bytes]: where the water would take more, its
/// coordinates are stored with coarser steps, and then fewer particles are shown. Nothing else gives way: a page whose
/// other parts pass the budget is larger. `stop`, where given, is looked at
/// before every frame.
/// @throws FileError, Stopped
PageContent pack_run(const RecordedRun& run, std::size_t budget, const run::StopRequest* stop = nullptr);

}  // namespace riprap::view
