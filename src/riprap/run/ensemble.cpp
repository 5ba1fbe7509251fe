// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "riprap/core/index.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/io/csv_reader.hpp"
#include "riprap/run/run_folder.hpp"
#include "riprap/run/sweep.hpp"
#include "riprap/scene/build/check_spreads.hpp"
#include "riprap/scene/build/random_stream.hpp"

namespace riprap::run {

namespace {

using Json = nlohmann::json;

std::uint64_t seed_of_case(const scene::LoadedCase& loaded) {
    return Json::parse(loaded.resolved_json).value("seed", std::uint64_t{1});
}

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

Band band_of(const std::vector<io::CsvTable>& tables, std::size_t column, const std::vector<double>& time) {
    Band band{tables[0].columns[column], {}, {}, {}};
    for (const double t : time) {
        double low = std::numeric_limits<double>::infinity(), high = -low, sum = 0;
        int count = 0;
        for (const io::CsvTable& table : tables) {
            const double value = value_at(table, column, t);
            if (!std::isnan(value)) {
                low = std::min(low, value);
                high = std::max(high, value);
                sum += value;
                ++count;
            }
        }
        const double none = std::numeric_limits<double>::quiet_NaN();
        band.low.push_back(count > 0 ? low : none);
        band.mean.push_back(count > 0 ? sum / count : none);
        band.high.push_back(count > 0 ? high : none);
    }
    return band;
}

struct Member {
    std::vector<double> values;
    int code{0};
};

void write_members(const std::filesystem::path& path, std::uint64_t seed, const std::vector<Spread>& spreads,
                   const std::vector<Member>& members) {
    std::vector<io::CsvColumn> columns{{"member", "-"}, {"seed", "-"}, {"exit_code", "-"}};
    for (const Spread& spread : spreads) {
        columns.push_back({spread.key, "SI"});
    }
    std::string text = io::csv_heading(columns) + '\n';
    for (std::size_t k = 0; k < members.size(); ++k) {
        std::vector<double> row{static_cast<double>(k + 1), static_cast<double>(seed),
                                static_cast<double>(members[k].code)};
        row.insert(row.end(), members[k].values.begin(), members[k].values.end());
        text += io::csv_row(row) + '\n';
    }
    io::write_file(path, text);
}

}  // namespace

std::vector<Spread> spreads_of(const scene::LoadedCase& loaded) {
    std::vector<Spread> spreads;
    for (const Json& row : Json::parse(loaded.resolved_json).value("spread", Json::array())) {
        Spread spread{row.at("key").get<std::string>()};
        if (row.contains("mean")) {
            spread.is_normal = true;
            spread.mean = row.at("mean").get<double>();
            spread.deviation = row.at("deviation").get<double>();
        } else {
            spread.low = row.at("low").get<double>();
            spread.high = row.at("high").get<double>();
        }
        spreads.push_back(std::move(spread));
    }
    return spreads;
}

std::string text_of(const Spread& spread) {
    return spread.is_normal
               ? fmt::format("{} {:.6g} with a deviation of {:.6g}", spread.key, spread.mean, spread.deviation)
               : fmt::format("{} from {:.6g} to {:.6g}", spread.key, spread.low, spread.high);
}

double draw(const Spread& spread, std::uint64_t seed, std::int64_t member) {
    scene::RandomStream stream(seed, spread.key, static_cast<std::uint64_t>(member));
    if (!spread.is_normal) {
        return stream.uniform(spread.low, spread.high);
    }
    const double radius = std::sqrt(-2 * std::log(1 - stream.uniform()));  // Box and Muller
    return spread.mean + spread.deviation * radius * std::cos(2 * std::numbers::pi * stream.uniform());
}

Bands gather_bands(const std::vector<std::filesystem::path>& members) {
    std::vector<io::CsvTable> tables;
    for (const std::filesystem::path& member : members) {
        io::CsvTable table = io::read_csv(RunFolder{member}.probes());
        if (table.row_count() > 0) {
            tables.push_back(std::move(table));
        }
    }
    Bands bands;
    if (tables.empty()) {
        return bands;
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
        for (const char* part : {"low", "mean", "high"}) {
            columns.push_back({band.column.name + '.' + part, band.column.unit});
        }
    }
    std::string text = io::csv_heading(columns) + '\n';
    for (std::size_t i = 0; i < bands.time.size(); ++i) {
        std::vector<double> row{bands.time[i]};
        for (const Band& band : bands.bands) {
            row.insert(row.end(), {band.low[i], band.mean[i], band.high[i]});
        }
        text += io::csv_row(row) + '\n';
    }
    io::write_file(path, text);
}

namespace {

std::string assignment(const Spread& spread, double value) { return fmt::format("{}={}", spread.key, value); }

/// Refuses members that draw what a key does not allow, before the first one runs.
void try_members(const EnsembleOptions& options, const scene::LoadedCase& loaded, const std::vector<Spread>& spreads,
                 std::uint64_t seed) {
    for (std::int64_t k = 1; k <= options.members; ++k) {
        std::vector<std::string> overrides = options.run.overrides;
        for (const Spread& spread : spreads) {
            overrides.push_back(assignment(spread, draw(spread, seed, k)));
        }
        std::vector<Diagnostic> problems =
            scene::problems_of_keys(loaded.source_text, options.run.case_path, overrides);
        if (!problems.empty()) {
            Diagnostic problem = problems.front();
            problem.message = fmt::format("member {} of {}: {}", k, options.members, problem.message);
            problem.allowed += "; a narrower [[spread]]";
            throw CaseError(std::move(problem));
        }
    }
}

}  // namespace

int run_ensemble(const EnsembleOptions& options) {
    const scene::LoadedCase first = scene::read_case(options.run.case_path, options.run.overrides);
    const std::vector<Spread> spreads = spreads_of(first);
    if (spreads.empty()) {
        Diagnostic problem;
        problem.place = {options.run.case_path, 1, 1};
        problem.message = "an ensemble needs numbers that differ from member to member";
        problem.allowed = "[[spread]] with key, low and high";
        throw CaseError(std::move(problem));
    }
    const std::uint64_t seed = seed_of_case(first);
    try_members(options, first, spreads, seed);
    std::filesystem::create_directories(options.run.out);
    std::vector<std::filesystem::path> folders;
    std::vector<Member> members;
    SweepOptions study;
    study.case_path = options.run.case_path;
    study.overrides = options.run.overrides;
    study.out = options.run.out;
    int worst = 0;
    for (std::int64_t k = 1; k <= options.members; ++k) {
        Member member;
        RunOptions run = options.run;
        SweepPoint& point = study.points.emplace_back(SweepPoint{fmt::format("member-{}", k), {}});
        for (const Spread& spread : spreads) {
            member.values.push_back(draw(spread, seed, k));
            point.overrides.push_back(assignment(spread, member.values.back()));
        }
        run.overrides.insert(run.overrides.end(), point.overrides.begin(), point.overrides.end());
        run.out = options.run.out / point.name;
        run.resume = !run.force;
        run.quiet = true;
        if (!options.run.quiet || !first.model.expects.empty()) {  // above its verdicts
            fmt::print("member {} of {}: {}\n", k, options.members, run.out.string());
        }
        member.code = run_case(run);
        members.push_back(member);
        folders.push_back(run.out);
        write_members(options.run.out / "ensemble.csv", seed, spreads, members);
        io::write_file(options.run.out / "ensemble.json", sweep_json(study));
        worst = worst == 0 ? member.code : worst;
        if (member.code > static_cast<int>(ExitCode::signal_base)) {
            return member.code;
        }
    }
    write_bands(options.run.out / "bands.csv", gather_bands(folders));
    return worst;
}

}  // namespace riprap::run
