// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "riprap/core/error.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/io/csv_reader.hpp"
#include "riprap/run/member_table.hpp"
#include "riprap/run/run_folder.hpp"
#include "riprap/run/spreads.hpp"
#include "riprap/run/sweep.hpp"
#include "riprap/scene/assemble/check_spreads.hpp"

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

/// The case of a member as overrides.
std::vector<std::string> overrides_of(const std::vector<Spread>& spreads, const std::vector<double>& values) {
    std::vector<std::string> overrides;
    for (std::size_t i = 0; i < spreads.size(); ++i) {
        overrides.push_back(assignment(spreads[i], values[i]));
    }
    return overrides;
}

/// Why the values that a member draws are not allowed by their keys; nothing where they are.
std::optional<Diagnostic> refusal_of(const EnsembleOptions& options, const scene::LoadedCase& loaded,
                                     const std::vector<std::string>& drawn) {
    std::vector<std::string> overrides = options.run.overrides;
    overrides.insert(overrides.end(), drawn.begin(), drawn.end());
    std::vector<Diagnostic> problems = scene::problems_of_keys(loaded.source_text, options.run.case_path, overrides);
    if (problems.empty()) {
        return std::nullopt;
    }
    problems.front().allowed += "; a narrower [[spread]]";
    return std::move(problems.front());
}

/// Text of what an ensemble asks for, but for the number of members; the same text means that it may be continued.
std::string plan_of(const EnsembleOptions& options, std::uint64_t seed, const std::vector<Spread>& spreads) {
    Json rows = Json::array();
    for (const Spread& spread : spreads) {
        rows.push_back({{"key", spread.key},
                        {"of", spread.is_normal ? Json{{"mean", spread.mean}, {"deviation", spread.deviation}}
                                                : Json{{"low", spread.low}, {"high", spread.high}}}});
    }
    const Json plan{{"case", std::filesystem::absolute(options.run.case_path).lexically_normal().string()},
                    {"set", options.run.overrides},
                    {"seed", seed},
                    {"spread", rows}};
    return plan.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// Takes the folder of an ensemble. Without a plan in it every file under the name of one of ours is the user's.
void claim_ensemble(const EnsembleOptions& options, const std::string& plan) {
    namespace fs = std::filesystem;
    constexpr std::size_t most = std::size_t{16} << 20U;
    const fs::path& out = options.run.out;
    const fs::path file = out / "ensemble_plan.json";
    std::error_code error;
    if (fs::exists(file, error)) {
        if (io::read_file(file, most) == plan) {
            return;
        }
        if (!options.run.force) {
            throw FileError(
                fmt::format("'{}' holds another ensemble; --force replaces it, --out writes elsewhere", out.string()));
        }
    } else {
        for (const char* name : {"ensemble.csv", "ensemble.json", "bands.csv", "bands.svg", "index.html"}) {
            if (fs::exists(fs::symlink_status(out / name, error))) {
                throw FileError(
                    fmt::format("'{}' is in the way, and no ensemble wrote it: the folder has no "
                                "ensemble_plan.json; move it away, or choose another folder with --out",
                                (out / name).string()));
            }
        }
    }
    io::make_folder(out);
    io::write_file(file, plan);
}

/// Tells why a member is not run, on the line where it would have been announced.
void tell_refusal(const EnsembleOptions& options, std::int64_t member, const std::string& text) {
    if (!options.run.silent) {
        fmt::print(stderr, "riprap: member {} of {} is refused: {}\n", member, options.members, printable(text));
    }
}

/// Runs one member. A refusal is told and becomes its exit code.
int run_member(const EnsembleOptions& options, std::int64_t member, const RunOptions& run) {
    try {
        return run_case(run);
    } catch (const CaseError& error) {
        for (const Diagnostic& problem : error.problems()) {
            tell_refusal(options, member, to_string(problem));
        }
        return static_cast<int>(ExitCode::bad_case);
    } catch (const CheckpointError& error) {
        tell_refusal(options, member, error.what());
        return static_cast<int>(ExitCode::bad_checkpoint);
    } catch (const FileError& error) {
        tell_refusal(options, member, error.what());
        return static_cast<int>(ExitCode::file_system);
    }
}

/// The members with what they draw, none run yet. Those whose keys do not allow it are told before the first one runs.
/// @throws CaseError where that are all of them
std::vector<Member> draw_members(const EnsembleOptions& options, const scene::LoadedCase& loaded,
                                 const std::vector<Spread>& spreads, std::uint64_t seed) {
    std::vector<Member> members(static_cast<std::size_t>(options.members));
    std::vector<std::pair<std::int64_t, Diagnostic>> refused;
    for (std::int64_t k = 1; k <= options.members; ++k) {
        Member& member = members[at(k - 1)];
        for (const Spread& spread : spreads) {
            member.values.push_back(draw(spread, seed, k));
        }
        if (std::optional<Diagnostic> problem = refusal_of(options, loaded, overrides_of(spreads, member.values))) {
            member.code = static_cast<int>(ExitCode::bad_case);
            refused.emplace_back(k, std::move(*problem));
        }
    }
    if (std::ssize(refused) == options.members) {
        Diagnostic problem = refused.front().second;
        problem.message =
            fmt::format("all {} members are refused, the first for: {}", options.members, problem.message);
        throw CaseError(std::move(problem));
    }
    for (const auto& [k, problem] : refused) {
        tell_refusal(options, k, to_string(problem));
    }
    return members;
}

/// Writes the bands of all members that ran, and tells of the others.
int finish_ensemble(const EnsembleOptions& options, const std::vector<std::filesystem::path>& folders, int worst) {
    const Bands bands = gather_bands(folders);
    write_bands(options.run.out / "bands.csv", bands);
    for (const std::string& text : bands.left_out) {
        if (!options.run.silent) {
            fmt::print(stderr, "riprap: {}\n", printable(text));
        }
        worst = worst == 0 ? static_cast<int>(ExitCode::file_system) : worst;
    }
    return worst;
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
    std::vector<Member> members = draw_members(options, first, spreads, seed);
    claim_ensemble(options, plan_of(options, seed, spreads));
    std::vector<std::filesystem::path> folders;
    SweepOptions study{options.run.case_path, {}, options.run.overrides, options.run.out};
    int worst = 0;
    for (std::size_t k = 0; k < members.size(); ++k) {
        const auto number = static_cast<std::int64_t>(k) + 1;
        const SweepPoint& point = study.points.emplace_back(
            SweepPoint{fmt::format("member-{}", number), overrides_of(spreads, members[k].values)});
        RunOptions run = options.run;
        run.overrides.insert(run.overrides.end(), point.overrides.begin(), point.overrides.end());
        run.out = options.run.out / point.name;
        run.resume = !run.force;
        run.quiet = true;
        if (members[k].code == 0) {
            if (!options.run.quiet || !first.model.expects.empty()) {  // above its verdicts
                fmt::print("member {} of {}: {}\n", number, options.members, run.out.string());
            }
            members[k].code = run_member(options, number, run);
            folders.push_back(run.out);
        }
        write_members(options.run.out / "ensemble.csv", seed, spreads, {members.begin(), members.begin() + number});
        io::write_file(options.run.out / "ensemble.json", sweep_json(study));
        worst = worst == 0 ? members[k].code : worst;
        if (members[k].code > static_cast<int>(ExitCode::signal_base)) {
            return members[k].code;
        }
    }
    return finish_ensemble(options, folders, worst);
}

}  // namespace riprap::run
