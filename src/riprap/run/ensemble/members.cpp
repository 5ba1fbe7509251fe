// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/ensemble/members.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "riprap/core/index.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/io/csv.hpp"
#include "riprap/run/figures/expects.hpp"
#include "riprap/run/folder/run_folder.hpp"
#include "riprap/scene/assemble/check_spreads.hpp"

namespace riprap::run {

namespace {

using Json = nlohmann::json;

constexpr std::size_t most_bytes = std::size_t{16} << 20U;
constexpr double not_run = std::numeric_limits<double>::quiet_NaN();

std::filesystem::path plan_file(const std::filesystem::path& out) { return out / "ensemble_plan.json"; }

std::uint64_t seed_of_case(const scene::LoadedCase& loaded) {
    return Json::parse(loaded.resolved_json).value("seed", std::uint64_t{1});
}

/// The case of a member as overrides.
std::vector<std::string> overrides_of(const std::vector<Spread>& spreads, const std::vector<double>& values) {
    std::vector<std::string> overrides;
    for (std::size_t i = 0; i < spreads.size(); ++i) {
        overrides.push_back(fmt::format("{}={}", spreads[i].key, values[i]));
    }
    return overrides;
}

/// Why the values that a member draws are not allowed by their keys; nothing where they are.
std::optional<Diagnostic> refusal_of(const SweepOptions& study, const scene::LoadedCase& loaded,
                                     const std::vector<std::string>& drawn) {
    std::vector<std::string> overrides = study.overrides;
    overrides.insert(overrides.end(), drawn.begin(), drawn.end());
    std::vector<Diagnostic> problems = scene::problems_of_keys(loaded.source_text, study.case_path, overrides);
    if (problems.empty()) {
        return std::nullopt;
    }
    problems.front().allowed += "; a narrower [[spread]]";
    return std::move(problems.front());
}

/// Text of what an ensemble asks for, but for the number of members; the same text means that it may be continued.
std::string plan_of(const SweepOptions& study, const Members& members) {
    Json rows = Json::array();
    for (const Spread& spread : members.spreads) {
        rows.push_back({{"key", spread.key},
                        {"of", spread.is_normal ? Json{{"mean", spread.mean}, {"deviation", spread.deviation}}
                                                : Json{{"low", spread.low}, {"high", spread.high}}}});
    }
    const Json plan{{"case", std::filesystem::absolute(study.case_path).lexically_normal().string()},
                    {"set", study.overrides},
                    {"seed", members.seed},
                    {"spread", rows}};
    return plan.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace

double ended_code(const RunFolder& folder) {
    const std::string status = status_of(folder);
    if (status == "failed") {
        return static_cast<double>(ExitCode::numerical);
    }
    if (status != "finished") {
        return not_run;
    }
    const Json summary = Json::parse(io::read_file(folder.summary(), most_bytes), nullptr, false);
    if (summary.is_object() && summary.contains("expects")) {
        for (const Json& answer : summary["expects"]) {
            if (answer.is_object() && answer.value("verdict", "") == to_string(Verdict::failed)) {
                return static_cast<double>(ExitCode::failed);
            }
        }
    }
    return static_cast<double>(ExitCode::success);
}

std::vector<RefusedMember> draw_members(const scene::LoadedCase& loaded, std::int64_t count, SweepOptions& study,
                                        Members& members) {
    members.spreads = spreads_of(loaded);
    if (members.spreads.empty()) {
        Diagnostic problem;
        problem.place = {study.case_path, 1, 1};
        problem.message = "an ensemble needs numbers that differ from member to member";
        problem.allowed = "[[spread]] with key, low and high";
        throw CaseError(std::move(problem));
    }
    members.seed = seed_of_case(loaded);
    std::vector<RefusedMember> refused;
    for (std::int64_t k = 1; k <= count; ++k) {
        Member& member = members.list.emplace_back(Member{{}, not_run});
        for (const Spread& spread : members.spreads) {
            member.values.push_back(draw(spread, members.seed, k));
        }
        study.points.push_back({fmt::format("member-{}", k), overrides_of(members.spreads, member.values)});
        if (std::optional<Diagnostic> problem = refusal_of(study, loaded, study.points.back().overrides)) {
            member.code = static_cast<double>(ExitCode::bad_case);
            refused.push_back({k, std::move(*problem)});
        }
    }
    if (std::ssize(refused) == count) {
        Diagnostic problem = refused.front().problem;
        problem.message = fmt::format("all {} members are refused, the first for: {}", count, problem.message);
        throw CaseError(std::move(problem));
    }
    return refused;
}

void claim_ensemble(const SweepOptions& study, const Members& members, bool force) {
    namespace fs = std::filesystem;
    const std::string plan = plan_of(study, members);
    const fs::path file = plan_file(study.out);
    std::error_code error;
    if (fs::exists(file, error)) {
        if (io::read_file(file, most_bytes) == plan) {
            return;
        }
        if (!force) {
            throw FileError(fmt::format("'{}' holds another ensemble; --force replaces it, --out writes elsewhere",
                                        study.out.string()));
        }
    } else {
        for (const char* name :
             {"ensemble.csv", "ensemble.json", "bands.csv", "bands.svg", "index.html", "sweep_plan.json"}) {
            if (fs::exists(fs::symlink_status(study.out / name, error))) {
                throw FileError(
                    fmt::format("'{}' is in the way, and no ensemble wrote it: the folder has no "
                                "ensemble_plan.json; move it away, or choose another folder with --out",
                                (study.out / name).string()));
            }
        }
    }
    io::make_folder(study.out);
    io::write_file(file, plan);
}

void write_members(const SweepOptions& study, const Members& members) {
    std::vector<io::CsvColumn> columns{{"member", "-"}, {"seed", "-"}, {"exit_code", "-"}};
    for (const Spread& spread : members.spreads) {
        columns.push_back({spread.key, "SI"});
    }
    std::string text = io::csv_heading(columns) + '\n';
    for (std::size_t k = 0; k < members.list.size(); ++k) {
        std::vector<double> row{static_cast<double>(k + 1), static_cast<double>(members.seed), members.list[k].code};
        row.insert(row.end(), members.list[k].values.begin(), members.list[k].values.end());
        text += io::csv_row(row) + '\n';
    }
    io::write_file(study.out / "ensemble.csv", text);
    io::write_file(study.out / "ensemble.json", sweep_json(study));
}

bool is_ensemble(const std::filesystem::path& out) { return std::filesystem::exists(plan_file(out)); }

Members read_members(const SweepOptions& study) {
    Members members{};
    try {
        const Json plan = Json::parse(io::read_file(plan_file(study.out), most_bytes));
        members.seed = plan.at("seed").get<std::uint64_t>();
        for (const Json& row : plan.at("spread")) {
            members.spreads.push_back({row.at("key").get<std::string>()});
        }
    } catch (const Json::exception& error) {
        throw FileError(fmt::format("'{}' is damaged: {}", plan_file(study.out).string(), error.what()));
    }
    for (const SweepPoint& point : study.points) {
        Member member{{}, ended_code(RunFolder{study.out / point.name})};
        for (const std::string& text : point.overrides) {
            member.values.push_back(std::strtod(text.c_str() + text.find('=') + 1, nullptr));
        }
        members.list.push_back(std::move(member));
    }
    return members;
}

}  // namespace riprap::run
