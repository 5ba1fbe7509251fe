// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/folder/member_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"

namespace riprap::run {

namespace {

/// Time at which a run says that it ended [s]; nothing where it does not say so.
std::optional<double> end_of(const RunFolder& folder) {
    constexpr std::size_t most = std::size_t{16} << 20U;
    const auto summary = nlohmann::json::parse(io::read_file(folder.summary(), most), nullptr, false);
    const bool has_time = summary.is_object() && summary.contains("time") && summary["time"].is_number();
    return has_time ? std::optional(summary["time"].get<double>()) : std::nullopt;
}

}  // namespace

io::CsvTable read_probes(const RunFolder& folder) {
    constexpr double round_off = 1e-9;
    io::CsvTable table = io::read_record(folder.probes());
    if (status_of(folder) != "finished") {
        return table;
    }
    const std::optional<double> end = end_of(folder);
    const bool is_short = end && (table.row_count() == 0 ||
                                  std::abs(table.values.front().back() - *end) > round_off * (1 + std::abs(*end)));
    if (table.is_cut || is_short) {
        throw FileError(fmt::format("'{}' is damaged: rows of it are cut off or lost", folder.probes().string()));
    }
    return table;
}

}  // namespace riprap::run
