// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "riprap/view/recorded_run.hpp"

namespace riprap::view {

/// One packed piece of the page.
struct Chunk {
    std::string name;
    std::string packed;  ///< zlib stream
};

/// What a page shows: a table of contents and packed pieces. page/src/recording.js reads the same.
struct PageContent {
    std::string contents_json;
    std::vector<Chunk> chunks;
    std::vector<std::string> notices;  ///< what could not be read, also shown on the page
    double water_error{0};             ///< bound on the error of a coordinate of a particle [m]
    std::size_t packed_bytes() const;
};

/// Reads and packs a run. `budget` bounds the bytes of the page [bytes]: where the water would take more, its
/// coordinates are stored with coarser steps, and then fewer particles are shown. @throws FileError
PageContent pack_run(const RecordedRun& run, std::size_t budget);

}  // namespace riprap::view
