// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/view/read_run.hpp"
#include "riprap/view/sea/sea_report.hpp"

namespace riprap {

namespace {

view::RecordedRun read(const std::filesystem::path& folder) {
    view::RecordedRun run = view::read_run(folder);
    for (const std::string& notice : run.notices) {
        fmt::print(stderr, "riprap: {}\n", printable(notice));
    }
    return run;
}

/// Tells whether the waves are a sea: no regular wave is known, and there are waves enough for statistics.
bool is_sea(const view::WaveReport& waves) {
    constexpr std::int64_t least = 50;
    return !waves.period && !waves.gauges.empty() && waves.gauges.front().waves.count >= least;
}

}  // namespace

int print_waves(const std::vector<std::filesystem::path>& folders, const view::SeaRequest& request, bool is_asked,
                const std::filesystem::path& out, bool as_json) {
    std::vector<view::RecordedRun> runs;
    for (const std::filesystem::path& folder : folders) {
        runs.push_back(read(folder));
    }
    const view::WaveReport waves = view::analyse_waves(runs.front(), request.waves);
    if (!is_asked && !is_sea(waves)) {
        fmt::print("{}", as_json ? view::wave_json(waves) + '\n' : view::wave_text(waves));
        return 0;
    }
    const view::SeaReport sea = view::sea_report(runs, request);
    if (as_json) {
        nlohmann::ordered_json json = nlohmann::ordered_json::parse(view::wave_json(waves));
        json["sea"] = nlohmann::ordered_json::parse(view::sea_json(sea));
        fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    } else {
        fmt::print("{}{}", view::wave_text(waves), view::sea_text(sea));
    }
    if (!out.empty()) {
        for (const std::filesystem::path& file : view::write_sea(out, sea)) {
            fmt::print(as_json ? stderr : stdout, "{}\n", printable(file.string()));
        }
    }
    return 0;
}

}  // namespace riprap
