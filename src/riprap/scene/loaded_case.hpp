// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "riprap/scene/case/paddle_wave.hpp"
#include "riprap/scene/text/case_files.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::io {
struct OutputChoices;
}

namespace riprap::scene {

/// A case ready to run.
struct LoadedCase {
    sim::Model model;
    sim::State state;                            ///< at t = 0; sim::initialise has not been called
    std::string folder;                          ///< of the case file; relative paths start here
    std::string source_text;                     ///< the case file as read
    std::string resolved_toml;                   ///< every key with its value in SI, defaults and overrides included
    std::string resolved_json;                   ///< the same as JSON
    std::vector<InputFile> inputs;               ///< other files read, sorted by path
    std::vector<std::string> warnings;           ///< worth knowing, no reason to stop
    std::vector<std::string> notes;              ///< what was read from other programs' files
    std::vector<std::string> overrides;          ///< as they were given
    std::vector<PaddleWave> waves;               ///< that paddles are to make
    std::shared_ptr<io::OutputChoices> outputs;  ///< files of a run
};

}  // namespace riprap::scene
