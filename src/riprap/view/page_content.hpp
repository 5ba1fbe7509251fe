// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <string>
#include <vector>

#include "riprap/run/signals.hpp"
#include "riprap/view/recorded_run.hpp"

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

/// The user stopped the program in the middle of packing or drawing a run.
class Stopped : public std::exception {
 public:
    explicit Stopped(int signal) : signal_(signal) {}
    const char* what() const noexcept override { return "stopped by a signal"; }
    int signal() const { return signal_; }

 private:
    int signal_;
};

/// @throws Stopped where the user has asked for it
inline void heed(const run::StopRequest* stop) {
    if (stop != nullptr && stop->signal() != 0) {
        throw Stopped(stop->signal());
    }
}

/// Reads and packs a run. `budget` bounds the bytes of the page [bytes]: where the water would take more, its
/// coordinates are stored with coarser steps, and then fewer particles are shown. Nothing else gives way: a page whose
/// other parts pass the budget is larger. `stop`, where given, is looked at
/// before every frame.
/// @throws FileError, Stopped
PageContent pack_run(const RecordedRun& run, std::size_t budget, const run::StopRequest* stop = nullptr);

}  // namespace riprap::view
