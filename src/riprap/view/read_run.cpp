// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/read_run.hpp"

#include <fmt/format.h>

#include "riprap/run/drive/find_case.hpp"
#include "riprap/run/folder/run_folder.hpp"
#include "riprap/run/folder/runs_within.hpp"
#include "riprap/view/recorded_parts.hpp"

namespace riprap::view {

namespace {

namespace fs = std::filesystem;

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
    attempt(run, [&] { table = io::read_record(path); });
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
    const std::string within = run::runs_within(path);
    return within.empty() ? fmt::format("`riprap run CASE --out {}` makes one", path.string()) : within;
}

}  // namespace

bool is_there(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

void attempt(RecordedRun& run, const std::function<void()>& part) {
    try {
        part();
    } catch (const FileError& error) {
        run.notices.emplace_back(error.what());
    } catch (const fs::filesystem_error& error) {  // a folder that may not be entered, say
        run.notices.emplace_back(error.what());
    }
}

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
