// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/sweep_page.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "riprap/io/atomic_file.hpp"
#include "riprap/io/csv_reader.hpp"
#include "riprap/scene/keys/key_unit.hpp"
#include "riprap/view/page.hpp"

namespace riprap::view {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_points = 400;  ///< of a curve on the page

/// Returns the curves of a run, thinned out evenly, with the last row.
Json curves_of(const std::filesystem::path& file) {
    Json curves = Json::object();
    if (!std::filesystem::exists(file)) {
        return curves;
    }
    io::CsvTable table;
    try {
        table = io::read_record(file);
    } catch (const FileError&) {
        return curves;  // the status of the run says so
    }
    const std::size_t rows = table.row_count(), step = std::max<std::size_t>(1, (rows + most_points - 1) / most_points);
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        Json values = Json::array();
        for (std::size_t r = 0; r < rows; r += step) {
            values.push_back(static_cast<float>(table.values[c][r]));
        }
        if (rows > 0 && (rows - 1) % step != 0) {
            values.push_back(static_cast<float>(table.values[c].back()));
        }
        curves[c == 0 ? "time" : table.columns[c].name] = std::move(values);
    }
    return curves;
}

/// Title of the case, from the first run that has written its summary; empty where none has.
std::string title_of(const std::filesystem::path& folder, const Json& study) {
    constexpr std::size_t most = std::size_t{64} << 20U;
    for (const Json& run : study["runs"]) {
        const std::filesystem::path file = folder / run["name"].get<std::string>() / "summary.json";
        if (run["status"] != "unreadable" && std::filesystem::exists(file)) {
            const Json summary = Json::parse(io::read_file(file, most), nullptr, false);
            if (summary.is_object() && summary.contains("title") && summary["title"].is_string()) {
                return summary["title"].get<std::string>();
            }
        }
    }
    return "";
}

/// Returns the end of what a run said before it could leave a summary: why its case was refused.
std::string last_words(const std::filesystem::path& log) {
    constexpr std::size_t most = std::size_t{16} << 20U, kept = 2000;
    if (!std::filesystem::exists(log)) {
        return "";
    }
    try {
        std::string text = io::read_file(log, most);
        text.erase(text.find_last_not_of(" \n") + 1);
        return text.size() <= kept ? text : text.substr(text.find('\n', text.size() - kept) + 1);
    } catch (const FileError&) {
        return "";  // of the user, or too long to be a reason
    }
}

/// Returns the units of the keys that differ from run to run, where they have one.
Json units_of_keys(const Json& study) {
    Json units = Json::object();
    for (const Json& run : study["runs"]) {
        for (const auto& [key, value] : run["set"].items()) {
            if (const std::string unit = scene::unit_of_key(key); !unit.empty()) {
                units[key] = unit;
            }
        }
    }
    return units;
}

std::filesystem::path write_study_page(const std::filesystem::path& folder, const std::string& name, Json bands) {
    if (!has_page()) {
        return folder / (name + ".csv");
    }
    constexpr std::size_t most = std::size_t{64} << 20U;
    Json study = Json::parse(io::read_file(folder / (name + ".json"), most));
    const std::string own_title = study.value("title", "");
    study["title"] = own_title.empty() ? title_of(folder, study) : own_title + ". " + title_of(folder, study);
    study["units"] = units_of_keys(study);
    for (Json& run : study["runs"]) {
        const std::string own = run["name"].get<std::string>();
        if (run["status"] != "finished" && run["reason"] == "") {
            run["reason"] = last_words(folder / (own + ".log"));
        }
        run["curves"] = curves_of(folder / own / "probes.csv");
        run["page"] = std::filesystem::exists(folder / own / "index.html") ? own + "/index.html" : "";
    }
    if (!bands.is_null()) {
        study["bands"] = std::move(bands);
    }
    const std::filesystem::path page = folder / "index.html";
    io::write_file(page, page_of_study(study.dump(-1, ' ', false, Json::error_handler_t::replace)));
    return page;
}

}  // namespace

std::filesystem::path write_sweep_page(const std::filesystem::path& folder) {
    return write_study_page(folder, "sweep", nullptr);
}

std::filesystem::path write_ensemble_page(const std::filesystem::path& folder) {
    return write_study_page(folder, "ensemble", curves_of(folder / "bands.csv"));
}

std::filesystem::path write_fos_page(const std::filesystem::path& folder) {
    return write_study_page(folder, "fos", nullptr);
}

}  // namespace riprap::view
