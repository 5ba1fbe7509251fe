// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/case_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <deque>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "riprap/core/parallel.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/drive/find_case.hpp"
#include "riprap/run/drive/run_case.hpp"
#include "riprap/run/figures/still_world.hpp"
#include "riprap/run/folder/run_folder.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/assemble/variations.hpp"
#include "riprap/scene/text/toml_reader.hpp"
#include "riprap/validation/compared_runs.hpp"
#include "riprap/validation/cross/scene.hpp"

namespace riprap::validation {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Holds what a listing tells of a case.
struct Facts {
    bool has_answers{false};  ///< it says what it expects
    bool is_long{false};
};

/// Reads them line by line, without parsing: a listing must not fail on a broken case.
Facts facts_of(const fs::path& file) {
    Facts facts;
    bool is_at_top = true;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        is_at_top = is_at_top && line.rfind('[', 0) != 0;
        const bool is_true = line.find("true") < line.find('#');
        facts.is_long = facts.is_long || (is_at_top && line.rfind("long ", 0) == 0 && is_true);
        facts.has_answers = facts.has_answers || line.rfind("[[expect]]", 0) == 0;
    }
    return facts;
}

/// The folder of the runs, gone with it where nobody asked to keep them.
class RunRoot {
 public:
    explicit RunRoot(const CaseSetting& setting) : is_kept_(!setting.results.empty()) {
        if (is_kept_) {
            path_ = setting.results / setting.folder.filename();
            return;
        }
        std::string name = (fs::temp_directory_path() / "riprap-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) {
            throw FileError("no folder can be made in " + fs::temp_directory_path().string());
        }
        path_ = name;
    }
    RunRoot(const RunRoot&) = delete;
    RunRoot& operator=(const RunRoot&) = delete;
    ~RunRoot() {
        std::error_code ignored;
        if (!is_kept_) {
            fs::remove_all(path_, ignored);
        }
    }
    const fs::path& path() const { return path_; }

 private:
    bool is_kept_;
    fs::path path_;
};

/// Returns what a summary would say of the expected answers of one variation if nothing moved.
json still_answers_of(const scene::LoadedCase& loaded) {
    run::Summary summary;
    summary.expects = run::answers_of_still_world(loaded.model, loaded.state);
    return json::parse(run::summary_json(summary)).at("expects");
}

/// Runs one variation and returns what its summary says of the expected answers.
json answers_of(const CaseSetting& setting, scene::LoadedCase loaded, const fs::path& out) {
    if (setting.is_still) {
        return still_answers_of(loaded);
    }
    run::RunOptions options;
    options.out = out;
    options.threads = parallel::thread_count();
    options.force = true;
    options.silent = true;
    options.overrides = loaded.overrides;
    if (setting.after_step) {
        options.watch = [&setting](run::Simulation& simulation) {
            setting.after_step(simulation.state().time, simulation.end());
            return true;
        };
    }
    run::run_loaded(std::move(loaded), options);
    constexpr std::size_t most = std::size_t{16} << 20U;
    const json summary = json::parse(io::read_file(run::RunFolder{out}.summary(), most));
    if (summary.at("status") != "finished") {
        throw std::runtime_error(summary.at("reason").get<std::string>());
    }
    return summary.at("expects");
}

std::optional<CloseBand> close_band(const scene::Value& expect, double value) {
    const scene::Value* close = expect.find("close");
    if (close == nullptr) {
        return std::nullopt;
    }
    const scene::Value* absolute = close->find("tolerance");
    const double margin =
        absolute != nullptr ? absolute->as_number() : scene::get_number(*close, "relative_tolerance") * std::abs(value);
    return CloseBand{value - margin, value + margin, scene::get_text(*close, "reason")};
}

/// Reports one answer of a run, but for one whose time comes after its end: that is for longer runs of [[vary]].
/// @param expect  as the case has it, @param found  as the run judged it
void report_answer(const scene::Value& expect, const json& found, const std::string& label, CaseReport& report) {
    if (found.at("verdict") == "not_judged") {
        return;
    }
    if (found.at("verdict") == "reported") {
        const json& told = found.at("value");
        report.state({found.at("name").get<std::string>() + (label.empty() ? "" : "; " + label),
                      found.at("unit").get<std::string>(), scene::get_text(expect, "citation")},
                     told.is_number() ? told.get<double>() : std::nan(""));
        return;
    }
    Reference reference;
    reference.quantity = found.at("name").get<std::string>() + (label.empty() ? "" : "; " + label);
    reference.unit = found.at("unit").get<std::string>();
    const auto number = [&found](const char* key, double otherwise) {
        const json& given = found.at(key);  // null: not finite
        return given.is_number() ? given.get<double>() : otherwise;
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double low = number("low", -infinity), high = number("high", infinity), value = number("value", std::nan(""));
    if (const scene::Value* exact = expect.find("value")) {
        reference.exact = exact->as_number();
    }
    if (const scene::Value* published = expect.find("published")) {
        reference.paper = published->as_number();
    }
    if (scene::get_boolean(expect, "bookkeeping")) {
        reference.kind = Kind::bookkeeping;
    }
    report.judge(reference, value, low, high, close_band(expect, reference.exact.value_or(0.5 * (low + high))));
}

/// Replaces the values of answers by their means over several runs; one that a run did not come to has none.
void take_means(std::vector<json>& answers) {
    for (std::size_t i = 0; i < answers.front().size(); ++i) {
        double sum = 0;
        for (const json& run : answers) {
            const json& value = run.at(i).at("value");
            sum += value.is_number() ? value.get<double>() : std::nan("");
        }
        answers.front()[i]["value"] = sum / static_cast<double>(answers.size());
    }
}

/// Returns the answers of a run, or their means over all seeds, and what was expected there.
RunAnswers run_variation(const CaseSetting& setting, const scene::Variation& variation, const fs::path& out,
                         CaseReport& report) {
    const std::string file = (setting.folder / "case.toml").string();
    scene::LoadedCase loaded = scene::read_case(file, variation.overrides);
    std::vector<Diagnostic> ignored;
    const scene::Value checked = scene::parse_toml(loaded.resolved_toml, "the resolved case", ignored);
    const auto whole = [&checked](const char* key) {
        const scene::Value* given = checked.find(key);
        return given != nullptr ? given->integer : 1;
    };
    const std::int64_t first = whole("seed"), count = whole("seeds");
    std::vector<json> answers{answers_of(setting, std::move(loaded), out)};
    for (std::int64_t k = 1; k < count; ++k) {
        std::vector<std::string> overrides = variation.overrides;
        overrides.push_back(fmt::format("seed={}", first + k));
        const fs::path beside = out.parent_path() / fmt::format("{}_seed_{}", out.filename().string(), first + k);
        answers.push_back(answers_of(setting, scene::read_case(file, overrides), beside));
    }
    take_means(answers);
    const scene::Value* expects = checked.find("expect");
    for (std::size_t i = 0; i < answers.front().size(); ++i) {
        report_answer(expects->items.at(i), answers.front()[i], variation.label, report);
    }
    return answers_of_run(*expects, answers.front(), variation);
}

}  // namespace

std::vector<ValidationCase> file_cases() {
    static std::deque<std::string> texts;  // cases hold views
    std::vector<ValidationCase> cases;
    for (const run::KnownCase& known : run::known_cases("validation")) {
        const std::size_t slash = known.name.find('/');
        if (slash == std::string::npos) {
            continue;
        }
        const std::string suite = known.name.substr(0, slash), name = known.name.substr(slash + 1);
        const Facts facts = facts_of(known.file);
        if (suite != cross::suite && facts.has_answers) {
            const std::string_view kept_suite = texts.emplace_back(suite), kept_name = texts.emplace_back(name);
            cases.push_back({kept_suite, kept_name, texts.emplace_back(known.title), facts.is_long, run_case_file});
        }
    }
    return cases;
}

void run_case_file(const CaseSetting& setting, CaseReport& report) {
    const scene::LoadedCase plain = scene::read_case((setting.folder / "case.toml").string(), {});
    std::vector<Diagnostic> ignored;
    const scene::Value checked = scene::parse_toml(plain.resolved_toml, "the resolved case", ignored);
    std::vector<scene::Variation> runs{{}};
    for (scene::Variation& run : variations_of(checked)) {
        if (!setting.is_plain && (setting.is_full || !run.is_full)) {
            runs.push_back(std::move(run));
        }
    }
    const RunRoot root(setting);
    std::vector<RunAnswers> answers;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        try {
            answers.push_back(run_variation(setting, runs[i], root.path() / fmt::format("run_{}", i), report));
        } catch (const std::exception& error) {
            report.fail((runs[i].label.empty() ? "" : runs[i].label + ": ") + error.what());
        }
    }
    compare_runs(checked, answers, report);
}

}  // namespace riprap::validation
