// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/core/tint.hpp"
#include "riprap/run/check/check_case.hpp"
#include "riprap/run/drive/find_case.hpp"

namespace riprap {

namespace {

std::string problems_json(const CaseError& error) {
    nlohmann::ordered_json problems = nlohmann::ordered_json::array();
    for (const Diagnostic& problem : error.problems()) {
        problems.push_back({{"file", problem.place.file},
                            {"line", problem.place.line},
                            {"column", problem.place.column},
                            {"message", problem.message},
                            {"allowed", problem.allowed}});
    }
    const auto* partly = dynamic_cast<const scene::PartlySeenCaseError*>(&error);
    const nlohmann::ordered_json answer{{"problems", problems}, {"unseen", partly != nullptr ? partly->unseen() : ""}};
    return answer.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

int print_check(const std::string& case_text, const std::vector<std::string>& overrides, bool as_json) {
    try {
        const scene::LoadedCase loaded = scene::read_case(run::find_case(case_text).string(), overrides);
        const run::CaseCheck check = run::check_case(loaded);
        fmt::print("{}\n", as_json ? run::check_json(check) : run::check_text(check, shows_colours(stdout)));
        if (!check.refusal.empty()) {
            std::fflush(stdout);
            fmt::print(stderr, "{} a run of this case is refused: {}\n",
                       tinted("riprap:", Tint::bad, shows_colours(stderr)), printable(check.refusal));
        }
        return static_cast<int>(check.refusal.empty() ? ExitCode::success : ExitCode::numerical);
    } catch (const CaseError& error) {
        if (!as_json) {
            throw;
        }
        fmt::print("{}\n", problems_json(error));
        return static_cast<int>(ExitCode::bad_case);
    }
}

}  // namespace riprap
