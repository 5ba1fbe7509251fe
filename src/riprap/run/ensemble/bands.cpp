// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/ensemble/bands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "riprap/core/error.hpp"
#include "riprap/core/index.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/io/csv_reader.hpp"
#include "riprap/run/folder/member_table.hpp"
#include "riprap/run/folder/run_folder.hpp"

namespace riprap::run {

namespace {

/// Value of a column at a time, by the straight line; NaN outside of the record.
double value_at(const io::CsvTable& table, std::size_t column, double time) {
    const std::vector<double>&t = table.values[0], &y = table.values[column];
    const double slack = 1e-9 * (1 + std::abs(time));
    if (t.empty() || time < t.front() - slack || time > t.back() + slack) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const auto after = at(std::lower_bound(t.begin(), t.end(), time) - t.begin());
    if (after == 0 || after == t.size()) {
        return after == 0 ? y.front() : y.back();
    }
    const double share = (time - t[after - 1]) / (t[after] - t[after - 1]);
    return y[after - 1] + share * (y[after] - y[after - 1]);
}

/// Returns the quantile of sorted values, NaN of none.
double quantile(const std::vector<double>& sorted, double share) {
    if (sorted.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto k = static_cast<std::size_t>(place);
    const double above = sorted[std::min(k + 1, sorted.size() - 1)];
    return sorted[k] + (place - static_cast<double>(k)) * (above - sorted[k]);
}

Band band_of(const std::vector<io::CsvTable>& tables, std::size_t column, const std::vector<double>& time) {
    Band band{tables[0].columns[column], {}, {}, {}};
    std::vector<double> values;
    for (const double t : time) {
        values.clear();
        double sum = 0;
        for (const io::CsvTable& table : tables) {
            if (const double value = value_at(table, column, t); !std::isnan(value)) {
                values.push_back(value);
                sum += value;
            }
        }
        std::sort(values.begin(), values.end());
        const double none = std::numeric_limits<double>::quiet_NaN();
        band.low.push_back(values.empty() ? none : values.front());
        band.mean.push_back(values.empty() ? none : sum / static_cast<double>(values.size()));
        band.high.push_back(values.empty() ? none : values.back());
        band.tenth.push_back(quantile(values, 0.1));
        band.median.push_back(quantile(values, 0.5));
        band.ninetieth.push_back(quantile(values, 0.9));
    }
    return band;
}

/// The headings of a table as a text that can be compared.
std::string headings_of(const io::CsvTable& table) { return io::csv_heading(table.columns); }

/// The headings that most of the tables have.
std::string usual_headings(const std::vector<io::CsvTable>& tables) {
    std::map<std::string, int> counts;
    for (const io::CsvTable& table : tables) {
        ++counts[headings_of(table)];
    }
    return std::max_element(counts.begin(), counts.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
}

}  // namespace

Bands gather_bands(const std::vector<std::filesystem::path>& members) {
    std::vector<io::CsvTable> tables;
    std::vector<std::string> names;
    Bands bands;
    const auto leave_out = [&bands](const std::string& name, const std::string& why) {
        bands.left_out.push_back(fmt::format("{} is left out of the bands: {}", name, why));
    };
    for (const std::filesystem::path& member : members) {
        const RunFolder folder{member};
        if (!std::filesystem::exists(folder.probes()) && status_of(folder) != "finished") {
            continue;
        }
        try {
            io::CsvTable table = read_probes(folder);
            if (table.row_count() > 0) {
                tables.push_back(std::move(table));
                names.push_back(member.filename().string());
            }
        } catch (const FileError& error) {
            leave_out(member.filename().string(), error.what());
        }
    }
    if (tables.empty()) {
        return bands;
    }
    const std::string usual = usual_headings(tables);
    for (std::size_t i = tables.size(); i-- > 0;) {
        if (headings_of(tables[i]) != usual) {
            leave_out(names[i], "its probes.csv has other columns than those of the other members");
            tables.erase(tables.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }
    bands.time = tables[0].values[0];
    for (std::size_t c = 1; c < tables[0].columns.size(); ++c) {
        bands.bands.push_back(band_of(tables, c, bands.time));
    }
    return bands;
}

void write_bands(const std::filesystem::path& path, const Bands& bands) {
    std::vector<io::CsvColumn> columns{{"time", "s"}};
    for (const Band& band : bands.bands) {
        for (const char* part : {"low", "mean", "high", "p10", "p50", "p90"}) {
            columns.push_back({band.column.name + '.' + part, band.column.unit});
        }
    }
    std::string text = io::csv_heading(columns) + '\n';
    for (std::size_t i = 0; i < bands.time.size(); ++i) {
        std::vector<double> row{bands.time[i]};
        for (const Band& band : bands.bands) {
            row.insert(row.end(),
                       {band.low[i], band.mean[i], band.high[i], band.tenth[i], band.median[i], band.ninetieth[i]});
        }
        text += io::csv_row(row) + '\n';
    }
    io::write_file(path, text);
}

}  // namespace riprap::run
