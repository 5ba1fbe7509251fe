// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace riprap::view {

/// Contents and look of a picture.
struct RenderOptions {
    std::filesystem::path folder;  ///< of the run
    std::filesystem::path out;     ///< empty: picture.png or movie.mp4 in the folder of the run
    std::optional<int> frame;      ///< from 0; negative counts from the last, -1
    std::optional<double> time;    ///< the frame nearest to it [s]
    bool is_movie{false};
    int width{1280}, height{720};        ///< [pixels]
    std::string camera;                  ///< corner, front, side, top, an address of the page; empty: its own choice
    std::vector<std::string> camera_to;  ///< of a movie: where the camera goes, in equal times
    std::string water, blocks;           ///< what they are coloured by; empty: the page's own choice
    bool shows_contacts{false};          ///< contact forces
    bool shows_page{false};              ///< the page with its plots instead of the scene alone
    std::string theme{"light"};          ///< light, dark
    int frames_per_second{25};           ///< of a movie
    double movie_seconds{0};             ///< 0: every frame once
    std::optional<double> from, to;      ///< of the run, in a movie [s]
};

/// Draws a picture or a movie of a run from its page. @returns what was written, for the user
/// @throws FileError for a run without frames, without a browser, for a frame that is not there; Stopped
std::string render_run(const RenderOptions& options);

}  // namespace riprap::view
