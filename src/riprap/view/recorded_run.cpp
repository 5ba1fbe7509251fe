// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/recorded_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "riprap/io/vtp_reader.hpp"
#include "riprap/run/find_case.hpp"
#include "riprap/run/run_folder.hpp"
#include "riprap/scene/keys/methods.hpp"
#include "riprap/scene/text/toml_reader.hpp"

namespace riprap::view {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t text_limit = std::size_t{64} << 20U;  // bytes of a case, a summary
constexpr std::size_t json_depth = 64;                      // what a run writes has about five

/// A text of an object; empty where it has none of that name.
std::string text_of(const Json& object, const char* key) {
    const bool has = object.is_object() && object.contains(key) && object[key].is_string();
    return has ? object[key].get<std::string>() : "";
}

/// Does one part of the reading; what goes wrong becomes a notice.
void attempt(RecordedRun& run, const std::function<void()>& part) {
    try {
        part();
    } catch (const FileError& error) {
        run.notices.emplace_back(error.what());
    } catch (const fs::filesystem_error& error) {  // a folder that may not be entered, say
        run.notices.emplace_back(error.what());
    }
}

bool is_there(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

/// Returns the largest number of brackets open at once, outside of texts.
std::size_t depth_of(std::string_view json) {
    std::size_t depth = 0, most = 0;
    bool is_quoted = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (is_quoted) {
            i += c == '\\' ? 1 : 0;
            is_quoted = c != '"';
        } else if (c == '"') {
            is_quoted = true;
        } else if (c == '[' || c == '{') {
            most = std::max(most, ++depth);
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        }
    }
    return most;
}

std::string json_text(const fs::path& path) {
    std::string text = io::read_file(path, text_limit);
    if (depth_of(text) > json_depth) {  // writing JSON goes down one call per bracket
        throw FileError(
            fmt::format("cannot read '{}': its brackets are nested more than {} deep", path.string(), json_depth));
    }
    if (!Json::accept(text)) {
        throw FileError(fmt::format("cannot read '{}': it is no JSON, or ends in the middle", path.string()));
    }
    return text;
}

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

void note_loss(RecordedRun& run, const io::CsvTable& table, const fs::path& path) {
    if (table.lost_from > 0) {
        run.notices.push_back(fmt::format("line {} of '{}' is damaged; it and all lines after it were left out",
                                          table.lost_from, path.string()));
    } else if (table.is_cut) {
        run.notices.push_back(fmt::format("the last line of '{}' is not whole and was left out", path.string()));
    }
}

io::CsvTable read_table(RecordedRun& run, const fs::path& path) {
    io::CsvTable table;
    attempt(run, [&] { table = io::read_csv(path); });
    note_loss(run, table, path);
    return table;
}

void read_bodies(RecordedRun& run, const fs::path& path) {
    if (!is_there(path)) {
        return;  // written at the end of a run
    }
    attempt(run, [&] {
        io::CsvTable table = io::read_csv(path, "name");
        note_loss(run, table, path);
        run.body_names = std::move(table.texts);
        for (std::size_t k = 0; k < table.columns.size(); ++k) {
            if (table.columns[k].name == "mass") {
                run.body_mass = std::move(table.values[k]);
            }
        }
        run.body_mass.resize(run.body_names.size());
    });
}

/// A vector of two or three numbers; nothing else counts.
bool read_vector(const scene::Value* value, Vec3& vector) {
    if (value == nullptr || !value->is_array() || value->items.size() < 2 || value->items.size() > 3 ||
        !std::all_of(value->items.begin(), value->items.end(), [](const scene::Value& v) { return v.is_number(); })) {
        return false;
    }
    const std::vector<scene::Value>& items = value->items;
    vector = {items[0].as_number(), items[1].as_number(), items.size() > 2 ? items[2].as_number() : 0};
    return true;
}

void read_number(const scene::Value& table, const char* key, double& number) {
    if (const scene::Value* value = table.find(key); value != nullptr && value->is_number()) {
        number = value->as_number();
    }
}

void read_gravity(const scene::Value* gravity, body::Gravity& law) {
    if (read_vector(gravity, law.value) || gravity == nullptr || !gravity->is_table()) {
        return;
    }
    read_vector(gravity->find("value"), law.value);
    read_number(*gravity, "ramp", law.ramp);
    const scene::Value* rotation = gravity->find("rotation");
    if (rotation != nullptr && rotation->is_table() && read_vector(rotation->find("axis"), law.axis) &&
        norm(law.axis) > 0) {
        law.axis = law.axis / norm(law.axis);
        read_number(*rotation, "rate", law.rate);
        read_number(*rotation, "start", law.start);
        read_number(*rotation, "stop", law.stop);
    }
}

/// Gauges that stand still; one that names a body moves with it.
void read_gauges(const scene::Value* output, std::vector<GaugePlace>& places) {
    const scene::Value* gauges = output != nullptr && output->is_table() ? output->find("gauge") : nullptr;
    if (gauges == nullptr || !gauges->is_array()) {
        return;
    }
    for (const scene::Value& gauge : gauges->items) {
        const scene::Value* name = gauge.is_table() ? gauge.find("name") : nullptr;
        const scene::Value* kind = gauge.is_table() ? gauge.find("kind") : nullptr;
        GaugePlace place;
        if (name == nullptr || !name->is_text() || gauge.find("body") != nullptr ||
            !read_vector(gauge.find("point"), place.point)) {
            continue;
        }
        place.name = name->text;
        place.kind = kind != nullptr && kind->is_text() ? kind->text : "";
        if (Vec3 end; read_vector(gauge.find("end"), end)) {
            place.end = end;
        }
        places.push_back(std::move(place));
    }
}

std::optional<double> number_at(const scene::Value& table, const char* key) {
    const scene::Value* value = table.find(key);
    return value != nullptr && value->is_number() ? std::optional(value->as_number()) : std::nullopt;
}

/// Tells whether a fluid is given by its levels: then its regions say how high it stands, whatever the method.
bool is_given_by_levels(const scene::Value& method) {
    const std::vector<scene::Method> all = scene::FluidMethods::all();
    return std::ranges::any_of(all, [&method](const scene::Method& one) {
        return method.is_text() && one.word == method.text &&
               std::ranges::find(one.scene_keys, "levels") != one.scene_keys.end();
    });
}

/// Basins and levels of still water. A region without a box is not drawn.
void read_still_water(const scene::Value* fluid, StillWater& water) {
    const scene::Value* method = fluid != nullptr && fluid->is_table() ? fluid->find("method") : nullptr;
    if (method == nullptr || !is_given_by_levels(*method)) {
        return;
    }
    if (const scene::Value* regions = fluid->find("region"); regions != nullptr && regions->is_array()) {
        for (const scene::Value& region : regions->items) {
            const scene::Value* box = region.is_table() ? region.find("box") : nullptr;
            StillWater::Basin basin;
            if (box != nullptr && box->is_table() && read_vector(box->find("low"), basin.low) &&
                read_vector(box->find("high"), basin.high)) {
                basin.level = number_at(region, "level");
                water.basins.push_back(basin);
            }
        }
    }
    if (const scene::Value* levels = fluid->find("levels"); levels != nullptr && levels->is_array()) {
        for (const scene::Value& row : levels->items) {
            if (row.is_array() && row.items.size() == 2 && row.items[0].is_number() && row.items[1].is_number()) {
                water.levels.push_back({row.items[0].as_number(), row.items[1].as_number()});
            }
        }
    }
}

void read_resolved(RecordedRun& run, const fs::path& path) {
    run.resolved_text = io::read_file(path, text_limit);
    std::vector<Diagnostic> problems;
    const scene::Value root = scene::parse_toml(run.resolved_text, path.string(), problems);
    if (!problems.empty()) {
        throw FileError(to_string(problems.front()));
    }
    if (const scene::Value* title = root.find("title"); title != nullptr && title->is_text()) {
        run.title = title->text;
    }
    if (const scene::Value* materials = root.find("material"); materials != nullptr && materials->is_table()) {
        for (const scene::Entry& entry : materials->entries) {
            run.material_names.push_back(entry.key);
        }
    }
    const scene::Value* dimension = root.find("dimension");
    run.is_planar = dimension != nullptr && dimension->is_number() && dimension->as_number() == 2;
    read_gravity(root.find("gravity"), run.gravity_law);
    run.gravity = run.gravity_law.value;
    read_gauges(root.find("output"), run.gauges);
    read_still_water(root.find("fluid"), run.still_water);
}

/// Events in the log of the run, used where the summary lacks them.
struct Events {
    bool goes_on{false};  ///< begun and not ended
    std::vector<std::string> warnings;
    std::string end;  ///< of the last sitting; empty when it did not come to one
};

/// A line of the log that is cut or not ours says nothing.
Events read_events(const fs::path& log) {
    Events events;
    const std::string text = io::read_file(log, text_limit);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        at = end + 1;
        const auto event = depth_of(line) > json_depth ? Json() : Json::parse(line, nullptr, false);
        if (!event.is_object()) {
            continue;
        }
        const std::string kind = text_of(event, "event"), words = text_of(event, "text");
        if (kind == "start") {
            events.end.clear();
            events.goes_on = true;
        } else if (kind == "end") {
            events.end = words;
            events.goes_on = false;
        } else if (kind == "warning" &&
                   std::find(events.warnings.begin(), events.warnings.end(), words) == events.warnings.end()) {
            events.warnings.push_back(words);  // a resumed run says it again
        }
    }
    return events;
}

void read_summary(RecordedRun& run, const fs::path& path) {
    run.summary_json = json_text(path);
    const auto summary = Json::parse(run.summary_json);
    if (const std::string status = text_of(summary, "status"); !status.empty()) {
        run.status = status;
    }
    if (!summary.is_object() || !summary.contains("warnings") || !summary["warnings"].is_array()) {
        return;
    }
    run.warnings.clear();
    for (const Json& warning : summary["warnings"]) {
        run.warnings.push_back(warning.is_string() ? warning.get<std::string>() : warning.dump());
    }
}

/// Without a summary the run goes on, or was killed; a log that says that it ended tells that the summary was lost.
void read_status(RecordedRun& run, const run::RunFolder& folder) {
    run.status = "not finished";
    Events events;
    if (is_there(folder.events())) {
        attempt(run, [&] { events = read_events(folder.events()); });
    }
    run.warnings = events.warnings;
    if (is_there(folder.summary())) {
        attempt(run, [&] { read_summary(run, folder.summary()); });
        run.status = events.goes_on ? "not finished" : run.status;  // taken up since the summary was written
    } else if (!events.end.empty()) {
        run.status = events.end.starts_with("finished") ? "finished"
                     : events.end.starts_with("failed") ? "failed"
                                                        : "interrupted";
        run.notices.push_back(
            fmt::format("'{}' is missing, though the run ended: {}", folder.summary().string(), events.end));
    }
}

bool holds_run(const fs::path& path) { return is_there(run::RunFolder{path}.ticket()); }

/// Folder in which `riprap run` puts a case by default.
fs::path usual_folder(const std::string& name) { return fs::path("runs") / name; }

/// The run that the name of a case means, if there is one.
std::string run_named(const fs::path& name) {
    const fs::path folder = usual_folder(name.filename().string());
    return holds_run(folder) ? fmt::format("; there is a run in '{}'", folder.string()) : "";
}

std::string advice_for(const fs::path& path) {
    if (const fs::path file = path / "case.toml"; is_there(file)) {
        const fs::path folder = usual_folder(run::short_name(file));
        return holds_run(folder)
                   ? fmt::format("it is a case, and there is a run in '{}'", folder.string())
                   : fmt::format("it is a case; `riprap run {}` runs it into '{}'", path.string(), folder.string());
    }
    return fmt::format("`riprap run CASE --out {}` makes one", path.string());
}

}  // namespace

RecordedRun read_run(const fs::path& path) {
    const run::RunFolder folder{path};
    std::error_code ignored;
    if (!fs::is_directory(path, ignored)) {
        throw FileError(fmt::format("'{}' is no folder; give the folder that `riprap run` wrote{}", path.string(),
                                    run_named(path)));
    }
    if (!is_there(folder.ticket()) && !is_there(path / "out.pvd")) {
        throw FileError(fmt::format("'{}' holds no run: there is neither run.json nor out.pvd; {}", path.string(),
                                    advice_for(path)));
    }
    RecordedRun run;
    run.root = path;
    attempt(run, [&] { read_resolved(run, folder.resolved_case()); });
    attempt(run, [&] { run.case_text = io::read_file(folder.case_file(), text_limit); });
    attempt(run, [&] { run.ticket_json = json_text(folder.ticket()); });
    read_status(run, folder);
    run.probes = read_table(run, folder.probes());
    run.ledger = read_table(run, folder.ledger());
    read_bodies(run, folder.bodies());
    find_frames(run, folder);
    return run;
}

}  // namespace riprap::view
