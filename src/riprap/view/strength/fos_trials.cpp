// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/strength/fos_trials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <nlohmann/json.hpp>
#include <variant>

#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/drive/progress.hpp"
#include "riprap/run/study/sweep_plan.hpp"
#include "riprap/run/study/sweep_processes.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/view/read_run.hpp"

namespace riprap::view {

namespace {

using Json = nlohmann::ordered_json;
using Seconds = std::chrono::duration<double>;

/// Takes the folder of a search. @throws FileError where it holds another one, or anything else
void claim(const FosPlan& plan) {
    const std::filesystem::path file = plan.study.out / "fos_plan.json";
    const Json said{{"case", std::filesystem::absolute(plan.study.case_path).lexically_normal().string()},
                    {"set", plan.study.overrides}};
    const std::string text = said.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
    constexpr std::size_t most = std::size_t{16} << 20U;
    if (std::filesystem::exists(file)) {
        if (io::read_file(file, most) != text) {
            throw FileError(
                fmt::format("'{}' holds another search (another case, --set, --reduce or other times); "
                            "--out writes elsewhere",
                            plan.study.out.string()));
        }
        return;
    }
    if (std::filesystem::exists(plan.study.out) && !std::filesystem::is_empty(plan.study.out)) {
        throw FileError(
            fmt::format("'{}' is not empty and holds no search; --out writes elsewhere", plan.study.out.string()));
    }
    std::filesystem::create_directories(plan.study.out);
    io::write_file(file, text);
}

/// One search on its way.
class Trials {
 public:
    Trials(const FosRequest& request, const FosPlan& plan)
        : request_(request), plan_(plan), study_(plan.study), search_(request.range) {}

    /// @returns the exit code of what stopped it; 0 once there is nothing more to try
    int run() {
        for (std::vector<double> factors = search_.next(); !factors.empty(); factors = search_.next()) {
            if (const int code = run_round(factors); code != 0) {
                return code;
            }
        }
        return 0;
    }

    /// Trials by factor, and the report on them.
    FosReport report() {
        FosReport report{request_.range,  plan_.times,      request_.criteria,        request_.reduces,
                         search_.stood(), search_.failed(), search_.contradictions(), {}};
        study_.points.clear();
        for (const auto& [factor, verdict] : verdicts_) {
            study_.points.push_back(point_of(factor));
            report.trials.push_back(verdict);
        }
        return report;
    }
    const run::SweepOptions& study() const { return study_; }

 private:
    /// Below 1 strength begins as high as at the lower end of the range and falls from there, too.
    run::SweepPoint point_of(double factor) const {
        return run::trial_at(factor, factor < 1 || request_.range.high <= 1 ? std::min(1.0, request_.range.low) : 1);
    }

    int run_round(const std::vector<double>& factors) {
        run::SweepOptions round = study_;
        round.points.clear();
        for (const double factor : factors) {
            round.points.push_back(point_of(factor));
        }
        std::vector<int> codes(factors.size(), 0);
        const int code = run::run_processes(round, request_.jobs, false, [&](const run::SweepPoint& point, int ended) {
            codes[static_cast<std::size_t>(&point - round.points.data())] = ended;
        });
        if (code > static_cast<int>(ExitCode::signal_base)) {
            return code;
        }
        for (std::size_t i = 0; i < factors.size(); ++i) {
            if (const int refused = judge(factors[i], round.points[i], codes[i]); refused != 0) {
                return refused;
            }
        }
        tell_left();
        return 0;
    }

    /// Judges a trial that has ended with a code. @returns an exit code
    int judge(double factor, const run::SweepPoint& point, int code) {
        if (code > static_cast<int>(ExitCode::failed) && code != static_cast<int>(ExitCode::numerical)) {
            fmt::print(stderr, "riprap: the trial at F = {:.5g} ended with code {}, see {}.log\n", factor, code,
                       printable((study_.out / point.name).string()));
            return code;
        }
        try {
            const RecordedRun recorded = read_run(study_.out / point.name);
            TrialVerdict verdict = judge_trial(recorded, plan_.times, factor, plan_.watched, request_.criteria);
            search_.tell(factor, verdict.stands);
            if (!request_.quiet) {
                fmt::print("F = {:<8.5g} {}\n", factor,
                           verdict.stands ? stands_by(verdict) : "fails: " + printable(verdict.why));
                std::fflush(stdout);
            }
            verdicts_[factor] = std::move(verdict);
        } catch (const FileError& error) {
            if (code != static_cast<int>(ExitCode::numerical)) {
                throw;
            }
            fmt::print(stderr, "riprap: the trial at F = {:.5g} has no verdict: {}; see {}.log\n", factor, error.what(),
                       printable((study_.out / point.name).string()));
            return code;
        }
        return 0;
    }

    static std::string stands_by(const TrialVerdict& verdict) {
        const auto crept = std::ranges::max_element(verdict.bodies, {}, &BodyVerdict::crept);
        return fmt::format("stands: no body creeps more than {:.2g} of its size while strength is held", crept->crept);
    }

    void tell_left() const {
        const int left = search_.next().empty() ? 0 : search_.trials_left();
        if (request_.quiet || left == 0) {
            return;
        }
        const double so_far = Seconds(std::chrono::steady_clock::now() - begin_).count();
        const std::string bracket =
            search_.is_bracketed() ? fmt::format("between {:.5g} and {:.5g}; ", search_.stood(), search_.failed()) : "";
        fmt::print("{}up to {} more trials, about {}\n", bracket, left,
                   run::duration_text(so_far / static_cast<double>(verdicts_.size()) * left));
        std::fflush(stdout);
    }

    const FosRequest& request_;
    const FosPlan& plan_;
    run::SweepOptions study_;
    run::FactorSearch search_;
    std::map<double, TrialVerdict> verdicts_;
    const std::chrono::steady_clock::time_point begin_{std::chrono::steady_clock::now()};
};

}  // namespace

FosPlan plan_fos(const FosRequest& request) {
    const scene::LoadedCase loaded = scene::read_case(request.case_path, request.overrides);
    const auto refuse = [&request](std::string message, std::string allowed) {
        throw CaseError(Diagnostic{{request.case_path}, std::move(message), std::move(allowed)});
    };
    if (loaded.model.strength.is_active()) {
        refuse("the case reduces strength itself, which the search does", "the case without [strength]");
    }
    FosPlan plan;
    plan.watched = run::watched_bodies(loaded.model, request.watched);
    if (plan.watched.empty()) {
        refuse(request.watched.empty() ? "no body of the case is free: nothing can fail"
                                       : fmt::format("no free body has a name that begins with '{}'", request.watched),
               "a free body to watch");
    }
    plan.method =
        std::visit([](const auto& settings) { return std::string(settings.method_name); }, loaded.model.solid);
    plan.proposed = loaded.model.bodies.is_planar ? "planar_dda" : "implicit_dda";
    plan.size = run::largest_size(loaded.model, plan.watched);
    plan.times = run::usual_times(loaded.model, plan.size);
    plan.times.begins = request.begins >= 0 ? request.begins : plan.times.begins;
    plan.times.over = request.over > 0 ? request.over : plan.times.over;
    plan.times.hold = request.hold > 0 ? request.hold : plan.times.hold;
    const body::Gravity& pull = loaded.model.gravity;
    if (norm(pull.at(plan.times.end()) - pull.at(plan.times.begins)) > 1e-9 * norm(pull.value)) {
        refuse("gravity still turns or grows while strength falls, so that the factor is that of no one moment",
               "gravity that has come to its end before --begins");
    }
    if (!(plan.times.over > 0 && plan.times.hold > 0)) {
        refuse("without gravity the times of a trial are not known", "--over and --hold");
    }
    plan.study.case_path = request.case_path;
    plan.study.out = request.out;
    plan.study.jobs = request.jobs;
    plan.study.threads = request.threads;
    plan.study.quiet = true;
    const std::vector<std::string> settings = run::settings_of_trials(plan.times, request.reduces);
    const auto key_of = [](const std::string& text) { return text.substr(0, text.find('=')); };
    std::ranges::copy_if(request.overrides, std::back_inserter(plan.study.overrides), [&](const std::string& given) {
        return std::ranges::none_of(settings, [&](const std::string& own) { return key_of(own) == key_of(given); });
    });
    plan.study.overrides.insert(plan.study.overrides.end(), settings.begin(), settings.end());
    std::vector<std::string> first = plan.study.overrides;
    first.push_back(run::trial_at(request.range.high, 1).overrides.front());
    scene::read_case(request.case_path, first);  // says what is wrong with all trials before anything is written
    return plan;
}

int run_fos(const FosRequest& request, const FosPlan& plan) {
    claim(plan);
    Trials trials(request, plan);
    const int code = trials.run();
    const FosReport report = trials.report();
    run::write_plan(trials.study());
    const std::filesystem::path page = write_fos(trials.study(), report);
    if (code != 0) {
        return code;
    }
    fmt::print("{}{}\n", fos_text(report), printable(page.string()));
    return static_cast<int>(report.is_found() && report.contradictions.empty() ? ExitCode::success : ExitCode::failed);
}

}  // namespace riprap::view
