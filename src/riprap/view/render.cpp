// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/render.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/view/read_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <utility>

#include "riprap/io/own_file.hpp"
#include "riprap/view/browser.hpp"
#include "riprap/view/page.hpp"
#include "riprap/view/stopped.hpp"

namespace riprap::view {

namespace {

namespace fs = std::filesystem;

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

/// The page of the run in a browser, set up as the options say.
class Stage {
 public:
    Stage(const RenderOptions& options, const run::StopRequest& stop)
        : browser_(find_browser(), options.width, options.height), page_(scratch_.path() / "page.html") {
        const PageContent content = pack_run(read_run(options.folder), default_budget, &stop);
        for (const std::string& notice : content.notices) {
            fmt::print(stderr, "riprap: {}\n", printable(notice));
        }
        io::write_file(page_, page_of(content), io::Durability::later);
        browser_.open(page_);
        times_ = browser_.evaluate("riprap.times").get<std::vector<double>>();
        if (times_.empty()) {
            throw FileError(fmt::format("'{}' has no frames to draw", options.folder.string()));
        }
        browser_.evaluate(options.shows_page ? fmt::format("riprap.theme({})", quoted(options.theme))
                                             : fmt::format("riprap.picture({})", quoted(options.theme)));
        const auto known = browser_.evaluate("riprap.blockColours").get<std::vector<std::string>>();
        if (!options.blocks.empty() && std::find(known.begin(), known.end(), options.blocks) == known.end()) {
            throw FileError(fmt::format("blocks of this run cannot be coloured by '{}'; allowed: {}", options.blocks,
                                        fmt::join(known, ", ")));
        }
        browser_.evaluate(fmt::format("riprap.choose({{water: {}, blocks: {}, contacts: {}}})", quoted(options.water),
                                      quoted(options.blocks), options.shows_contacts));
        std::vector<std::string> stops;
        if (!options.camera.empty() || !options.camera_to.empty()) {
            stops.push_back(options.camera);
        }
        stops.insert(stops.end(), options.camera_to.begin(), options.camera_to.end());
        const auto trouble = browser_.evaluate(fmt::format("riprap.stops({})", nlohmann::json(stops).dump()));
        if (trouble.is_string()) {
            throw FileError(trouble.get<std::string>());
        }
    }

    int frame_count() const { return static_cast<int>(times_.size()); }

    const std::vector<double>& times() const { return times_; }

    /// The frame nearest to a time of the run.
    int frame_at(double time) const {
        // Frames may lie a step beside round times: half a frame beyond the ends still means the end.
        double gap = 0;
        for (std::size_t k = 1; k < times_.size(); ++k) {
            gap = std::max(gap, times_[k] - times_[k - 1]);
        }
        if (!(time >= times_.front() - gap / 2 && time <= times_.back() + gap / 2)) {
            throw FileError(fmt::format("there is no frame at {:.6g} s: the run has them from {:.6g} s to {:.6g} s",
                                        time, times_.front(), times_.back()));
        }
        const auto nearest = std::min_element(times_.begin(), times_.end(), [time](double a, double b) {
            return std::fabs(a - time) < std::fabs(b - time);
        });
        return static_cast<int>(nearest - times_.begin());
    }

    /// Shows a frame, from the last one where the number is negative. @returns what is shown, for the user
    std::string show(int frame) {
        const int index = frame < 0 ? frame_count() + frame : frame;
        if (index < 0 || index >= frame_count()) {
            throw FileError(fmt::format("there is no frame {}: the run has {}, from 0 to {}, or from -1 backwards",
                                        frame, frame_count(), frame_count() - 1));
        }
        browser_.evaluate(fmt::format("riprap.show({})", index));
        return fmt::format("frame {} of 0 to {}, t = {:.6g} s", index, frame_count() - 1,
                           times_[static_cast<std::size_t>(index)]);
    }
    /// Brings the camera to a share of its way through the stops, from 0 to 1.
    void travel(double share) { browser_.evaluate(fmt::format("riprap.travel({})", share)); }
    std::string picture() { return browser_.picture(); }

 private:
    ScratchFolder scratch_;
    Browser browser_;
    fs::path page_;
    std::vector<double> times_;  ///< of the frames [s]
};

/// Takes pictures and makes a movie of them.
class Encoder {
 public:
    Encoder(const fs::path& ffmpeg, fs::path out, int frames_per_second) : out_(std::move(out)) {
        std::array<int, 2> ends{};
        if (::pipe(ends.data()) != 0) {
            throw FileError(fmt::format("cannot make a pipe to ffmpeg: {}", std::strerror(errno)));
        }
        const std::string rate = std::to_string(frames_per_second);
        const std::string file = "file:" + out_.string();  // else '-x.mp4' is an option and 'a:b.mp4' a protocol
        child_ = ::fork();
        if (child_ == 0) {
            ::dup2(ends[0], 0);
            ::close(ends[0]);
            ::close(ends[1]);
            // H.264 halves colours in pairs of pixels: odd sizes lose a line.
            ::execl(ffmpeg.c_str(), ffmpeg.c_str(), "-y", "-loglevel", "error", "-f", "image2pipe", "-framerate",
                    rate.c_str(), "-c:v", "png", "-i", "-", "-vf", "crop=trunc(iw/2)*2:trunc(ih/2)*2", "-c:v",
                    "libx264", "-crf", "20", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4",
                    file.c_str(), static_cast<char*>(nullptr));
            ::_exit(127);
        }
        const int fork_error = errno;
        ::close(ends[0]);
        pipe_ = io::FileDescriptor(ends[1]);
        if (child_ < 0) {
            throw FileError(fmt::format("cannot start ffmpeg: {}", std::strerror(fork_error)));
        }
    }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;
    /// Without finish() the movie is not whole: nothing of it stays.
    ~Encoder() {
        if (child_ > 0) {
            ::kill(child_, SIGKILL);
            wait();
            remove();
        }
    }
    void add(const std::string& png) { io::write_all(pipe_, png.data(), png.size(), "the pipe to ffmpeg"); }
    bool finish() {
        pipe_.close();
        const bool is_made = wait();
        if (!is_made) {
            remove();
        }
        return is_made;
    }

 private:
    bool wait() {
        int status = 0;
        pid_t ended = -1;
        do {
            ended = ::waitpid(child_, &status, 0);
        } while (ended < 0 && errno == EINTR);
        child_ = -1;
        return ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }
    void remove() const {
        std::error_code ignored;
        fs::remove(out_, ignored);
    }

    fs::path out_;
    pid_t child_{-1};
    io::FileDescriptor pipe_;
};

/// The frames of a movie, one for each of its pictures.
std::vector<int> frames_of_movie(const Stage& stage, const RenderOptions& options) {
    const int first = options.from ? stage.frame_at(*options.from) : 0;
    const int last = options.to ? stage.frame_at(*options.to) : stage.frame_count() - 1;
    if (last < first) {
        throw FileError(fmt::format("the movie would end at {:.6g} s, before it begins", *options.to));
    }
    std::vector<int> frames;
    if (!(options.movie_seconds > 0)) {
        for (int frame = first; frame <= last; ++frame) {
            frames.push_back(frame);
        }
        return frames;
    }
    const std::vector<double>& times = stage.times();
    const double begin = times[static_cast<std::size_t>(first)], end = times[static_cast<std::size_t>(last)];
    const int count = std::max(2, static_cast<int>(std::lround(options.movie_seconds * options.frames_per_second)));
    for (int k = 0; k < count; ++k) {
        frames.push_back(stage.frame_at(begin + (end - begin) * k / (count - 1)));
    }
    return frames;
}

/// Draws the pictures of a movie one after another.
template <class Take>
void draw_movie(Stage& stage, const std::vector<int>& frames, const run::StopRequest& stop, const Take& take) {
    for (std::size_t k = 0; k < frames.size(); ++k) {
        heed(&stop);
        stage.show(frames[k]);
        stage.travel(frames.size() > 1 ? static_cast<double>(k) / static_cast<double>(frames.size() - 1) : 0);
        take(k, stage.picture());
    }
}

std::string render_movie(Stage& stage, const RenderOptions& options, const run::StopRequest& stop) {
    const std::vector<int> frames = frames_of_movie(stage, options);
    const auto ffmpeg = find_program("ffmpeg");
    if (!ffmpeg) {
        const fs::path folder =
            options.out.empty() ? options.folder / "movie" : fs::path(options.out).replace_extension();
        if (options.out.empty()) {
            io::refuse_linked_folder(folder);
        }
        io::make_folder(folder);
        draw_movie(stage, frames, stop, [&](std::size_t k, const std::string& png) {
            io::write_file(folder / fmt::format("{:06}.png", k), png, io::Durability::later);
        });
        return fmt::format("there is no ffmpeg to make a movie (Debian's package ffmpeg); its {} pictures are in {}",
                           frames.size(), folder.string());
    }
    const fs::path out = options.out.empty() ? options.folder / "movie.mp4" : options.out;
    const fs::path partial = out.string() + ".partial";
    io::create_own(partial, out);  // ffmpeg would write through a link that stands there
    Encoder encoder(*ffmpeg, partial, options.frames_per_second);
    draw_movie(stage, frames, stop, [&](std::size_t, const std::string& png) { encoder.add(png); });
    if (!encoder.finish()) {
        throw FileError("ffmpeg could not make the movie; what it said is above");
    }
    fs::rename(partial, out);
    const auto time = [&](int frame) { return stage.times()[static_cast<std::size_t>(frame)]; };
    return fmt::format("{}: {} pictures, {:.4g} s, t = {:.6g} to {:.6g} s", out.string(), frames.size(),
                       static_cast<double>(frames.size()) / options.frames_per_second, time(frames.front()),
                       time(frames.back()));
}

std::string render(const RenderOptions& options, const run::StopRequest& stop) {
    Stage stage(options, stop);
    if (options.is_movie) {
        return render_movie(stage, options, stop);
    }
    stage.travel(0);
    const std::string shown = stage.show(options.time ? stage.frame_at(*options.time) : options.frame.value_or(-1));
    const fs::path out = options.out.empty() ? options.folder / "picture.png" : options.out;
    io::write_file(out, stage.picture());
    return fmt::format("{}: {}", out.string(), shown);
}

}  // namespace

std::string render_run(const RenderOptions& options) {
    const run::StopRequest stop;
    try {
        return render(options, stop);
    } catch (const FileError&) {
        heed(&stop);  // Ctrl-C goes to the browser and to ffmpeg as well; that they ended is no error then
        throw;
    }
}

}  // namespace riprap::view
