// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "riprap/io/vtp_reader.hpp"
#include "riprap/view/recorded_parts.hpp"

namespace riprap::view {

namespace {

namespace fs = std::filesystem;
using Frames = std::map<double, FrameFiles>;

void add_frame(Frames& frames, double time, const fs::path& file) {
    FrameFiles& frame = frames[time];
    frame.time = time;
    const std::string name = file.filename().string();
    if (name.starts_with("bodies_")) {
        frame.bodies = file;
    } else if (name.starts_with("water_")) {
        frame.water = file;
    } else if (name.starts_with("contacts_")) {
        frame.contacts = file;
    }
}

/// A frame lies in the folder of frames: an entry that points elsewhere is not one of ours.
void add_listed(const run::RunFolder& folder, const fs::path& list, Frames& frames) {
    for (const io::PvdEntry& entry : io::read_pvd(list)) {
        const fs::path file(entry.file);
        if (file.parent_path() == "frames") {
            add_frame(frames, entry.time, folder.frames() / file.filename());
        }
    }
}

/// The files of frames, by name.
std::vector<fs::path> frame_files(const run::RunFolder& folder) {
    std::vector<fs::path> files;
    if (is_there(folder.frames())) {
        for (const fs::directory_entry& entry : fs::directory_iterator(folder.frames())) {
            if (entry.path().extension() == ".vtp" && entry.path().filename().string().front() != '.') {
                files.push_back(entry.path());
            }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// Without a list: every frame there is, by the time that it carries.
void add_found(RecordedRun& run, const std::vector<fs::path>& files, Frames& frames) {
    for (const fs::path& file : files) {
        attempt(run, [&] { add_frame(frames, io::read_vtp(file).time(), file); });
    }
}

/// A list that a run wrote ends with the mark of its end.
bool is_cut(const fs::path& list) {
    const std::string text = io::read_file(list, text_limit);
    return text.find("</VTKFile>") == std::string::npos;
}

}  // namespace

void find_frames(RecordedRun& run, const run::RunFolder& folder) {
    Frames frames;
    const fs::path list = folder.root / "out.pvd", contacts = folder.root / "contacts.pvd";
    const std::vector<fs::path> files = frame_files(folder);
    if (files.empty() && !is_there(list)) {
        return;  // a run with output.vtk = false
    }
    const char* trouble = "lists no frames";
    attempt(run, [&] {
        add_listed(folder, list, frames);
        if (!frames.empty() && is_cut(list)) {
            trouble = "ends in the middle";
            frames.clear();
        }
    });
    if (frames.empty() && is_there(folder.frames())) {
        run.notices.push_back(fmt::format("'{}' {}; the frames found in '{}' are shown", list.string(), trouble,
                                          folder.frames().string()));
        attempt(run, [&] { add_found(run, files, frames); });
    } else if (is_there(contacts)) {
        attempt(run, [&] { add_listed(folder, contacts, frames); });
    }
    for (const auto& [time, frame] : frames) {
        run.frames.push_back(frame);
    }
}

}  // namespace riprap::view
