// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <type_traits>

#include "riprap/core/timer.hpp"
#include "riprap/validation/validate.hpp"

namespace riprap::validation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

void passes(const CaseSetting&, CaseReport& report) {
    report.judge({"drop", "m", 2.6, 2.592, {}}, 2.5921, Relative{1e-3});
}
void misses(const CaseSetting&, CaseReport& report) {
    report.judge({"drop", "m", "about 2.6", 2.592, {}}, 2.7, Relative{1e-3});
}
void throws(const CaseSetting&, CaseReport& report) {
    report.judge({"drop", "m", {}, 2.592, {}}, 2.592, Relative{1e-3});
    throw std::runtime_error("block 3 fell through the floor");
}
void says_nothing(const CaseSetting&, CaseReport&) {}
void is_slow(const CaseSetting& setting, CaseReport& report) {
    report.state({"full", "-", {}}, setting.is_full ? 1 : 0);
}

struct Answer {
    int code;
    std::string text;
};
Answer run(std::span<const ValidationCase> cases, const ValidateOptions& options) {
    std::ostringstream out;
    const int code = validate(options, cases, out, nullptr);
    return {code, out.str()};
}
ValidateOptions json_of(std::vector<std::string> selection = {}) {
    return {.selection = std::move(selection), .is_full = false, .as_json = true, .results = "", .folder = ""};
}

TEST(Validate, succeeds_only_if_nothing_is_not_reproduced) {
    const std::array good{ValidationCase{"s", "a", "", false, passes}};
    const std::array bad{ValidationCase{"s", "a", "", false, passes}, ValidationCase{"s", "b", "", false, misses}};
    EXPECT_EQ(run(good, json_of()).code, 0);
    EXPECT_EQ(run(bad, json_of()).code, 1);
}

TEST(Validate, a_case_that_throws_is_a_failed_result_with_the_message_and_the_next_case_runs) {
    const std::array cases{ValidationCase{"s", "a", "", false, throws}, ValidationCase{"s", "b", "", false, passes}};
    const Answer result = run(cases, json_of());
    EXPECT_EQ(result.code, 1);
    const auto json = nlohmann::json::parse(result.text);
    ASSERT_EQ(json["results"].size(), 3);
    EXPECT_EQ(json["results"][0]["verdict"], "reproduced");  // what was known before stays
    EXPECT_EQ(json["results"][1]["verdict"], "not_reproduced");
    EXPECT_EQ(json["results"][1]["note"], "block 3 fell through the floor");
    EXPECT_EQ(json["results"][1]["value"], nullptr);
    EXPECT_EQ(json["results"][2]["case"], "b");
}

TEST(Validate, a_case_that_compares_nothing_has_failed) {
    const std::array cases{ValidationCase{"s", "a", "", false, says_nothing}};
    EXPECT_EQ(run(cases, json_of()).code, 1);
}

TEST(Validate, json_has_the_promised_keys_in_order) {
    const std::array cases{ValidationCase{"s", "a", "", false, passes}};
    const auto json = nlohmann::ordered_json::parse(run(cases, json_of()).text);
    std::vector<std::string> top, row;
    for (const auto& [key, value] : json.items()) {
        top.push_back(key);
    }
    for (const auto& [key, value] : json["results"][0].items()) {
        row.push_back(key);
    }
    EXPECT_THAT(top, ElementsAre("suite", "version", "build", "machine", "totals", "results"));
    EXPECT_THAT(row, ElementsAre("case", "kind", "quantity", "unit", "paper", "exact", "value", "low", "high",
                                 "verdict", "note", "seconds"));
    EXPECT_EQ(json["suite"], "s");
    EXPECT_EQ(json["results"][0]["paper"], 2.6);
    EXPECT_DOUBLE_EQ(json["results"][0]["low"], 2.592 * (1 - 1e-3));
    EXPECT_TRUE(json["results"][0]["seconds"].is_number());
}

TEST(Validate, several_suites_make_one_json_document) {
    const std::array cases{ValidationCase{"s", "a", "", false, passes}, ValidationCase{"t", "a", "", false, passes}};
    const auto json = nlohmann::json::parse(run(cases, json_of()).text);
    EXPECT_EQ(json["suite"], "all");
    EXPECT_EQ(json["results"][0]["case"], "s/a");
    EXPECT_EQ(json["results"][1]["case"], "t/a");
}

TEST(Validate, tells_all_results_so_far_after_every_case) {
    const std::array cases{ValidationCase{"s", "a", "", false, passes}, ValidationCase{"s", "b", "", false, throws}};
    ValidateOptions options = json_of();
    std::vector<std::string> told;
    options.after_case = [&told](const std::string& so_far) { told.push_back(so_far); };
    const std::string at_the_end = run(cases, options).text;
    ASSERT_EQ(told.size(), 2U);
    EXPECT_EQ(nlohmann::json::parse(told[0])["results"].size(), 1U);
    EXPECT_EQ(nlohmann::json::parse(told[1])["results"].size(), 3U);
    EXPECT_EQ(nlohmann::json::parse(at_the_end)["results"].size(), 3U);
}

TEST(Validate, tells_how_far_a_long_simulation_is) {
    const auto steps = [](const CaseSetting& setting, CaseReport& report) {
        AfterStep one = setting.after_step, another = setting.after_step;  // as two simulations of a case have it
        one(0.25, 4);
        one(0.5, 4);
        another(0.125, 4);
        passes(setting, report);
    };
    const std::array cases{ValidationCase{"s", "a", "slow", false, steps}};
    ValidateOptions options = json_of();
    std::ostringstream out, progress;
    validate(options, cases, out, &progress);
    EXPECT_EQ(progress.str(), "s/a: slow\n");
    options.tell_every = 0;
    validate(options, cases, out, &progress);
    EXPECT_THAT(progress.str(), HasSubstr("s/a: slow\n  t = 0.25 s of at most 4 s after 0 min\n  t = 0.5 s of"));
    EXPECT_THAT(progress.str(), HasSubstr("\n  simulation 2, t = 0.125 s of at most 4 s after 0 min\n"));
    options.tell_every = 0.5;
    const std::array pauses{
        ValidationCase{"s", "b", "pauses", false, [](const CaseSetting& setting, CaseReport& report) {
                           const Timer timer;
                           AfterStep one = setting.after_step, another = setting.after_step;
                           while (timer.seconds() < 0.5) {
                           }
                           one(1, 4);
                           another(2, 4);
                           passes(setting, report);
                       }}};
    progress.str("");
    validate(options, pauses, out, &progress);
    EXPECT_EQ(progress.str(), "s/b: pauses\n  t = 1 s of at most 4 s after 0 min\n");
}

TEST(Validate, a_selection_runs_a_suite_or_one_case_and_refuses_other_names) {
    const std::array cases{ValidationCase{"s", "a", "", false, passes}, ValidationCase{"s", "b", "", false, passes},
                           ValidationCase{"t", "c", "", false, passes}};
    EXPECT_EQ(nlohmann::json::parse(run(cases, json_of({"s"})).text)["results"].size(), 2);
    EXPECT_EQ(nlohmann::json::parse(run(cases, json_of({"s/b"})).text)["results"].size(), 1);
    testing::internal::CaptureStderr();
    EXPECT_EQ(run(cases, json_of({"s/d"})).code, 2);
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("s/b"));
}

TEST(Validate, a_long_case_runs_only_when_named_or_in_full) {
    const std::array cases{ValidationCase{"s", "a", "", false, passes}, ValidationCase{"s", "b", "", true, is_slow}};
    EXPECT_EQ(nlohmann::json::parse(run(cases, json_of()).text)["results"].size(), 1);
    EXPECT_EQ(nlohmann::json::parse(run(cases, json_of({"s/b"})).text)["results"].size(), 1);
    ValidateOptions full = json_of();
    full.is_full = true;
    const auto json = nlohmann::json::parse(run(cases, full).text);
    ASSERT_EQ(json["results"].size(), 2);
    EXPECT_EQ(json["results"][1]["value"], 1);
    ValidateOptions table = json_of();
    table.as_json = false;
    EXPECT_THAT(run(cases, table).text, HasSubstr("not run, as it is long: s/b"));
    table.selection = {"s/a"};
    EXPECT_THAT(run(cases, table).text, Not(HasSubstr("not run")));
}

TEST(Validate, the_table_shows_paper_exact_ours_band_and_verdict) {
    const std::array cases{ValidationCase{"s", "a", "", false, misses}};
    ValidateOptions options = json_of();
    options.as_json = false;
    const std::string text = run(cases, options).text;
    EXPECT_THAT(text, HasSubstr("drop [m]"));
    EXPECT_THAT(text, HasSubstr("about 2.6"));
    EXPECT_THAT(text, HasSubstr("2.592 "));
    EXPECT_THAT(text, HasSubstr("2.7 "));
    EXPECT_THAT(text, HasSubstr("2.58941 .. 2.59459"));
    EXPECT_THAT(text, HasSubstr("not reproduced"));
    EXPECT_THAT(text, HasSubstr("s, physics: 0 reproduced, 0 close, 1 not reproduced, 0 under-specified"));
    EXPECT_THAT(text, Not(HasSubstr("bookkeeping")));
}

void falls_and_keeps_books(const CaseSetting&, CaseReport& report) {
    report.judge_below({"energy missing", "-", {}, {}, {}, Kind::bookkeeping}, 1e-3, 0.01);
    report.judge({"drop", "m", {}, 2.592, {}}, 2.7, Relative{1e-3});
    report.judge_below({"mass missing", "-", {}, {}, {}, Kind::bookkeeping}, 0, 0.01);
}

TEST(Validate, a_ledger_that_closes_is_no_comparison_with_nature) {
    const std::array cases{ValidationCase{"s", "a", "", false, falls_and_keeps_books}};
    const auto json = nlohmann::json::parse(run(cases, json_of()).text);
    EXPECT_EQ(json["totals"]["physics"]["reproduced"], 0);
    EXPECT_EQ(json["totals"]["physics"]["not_reproduced"], 1);
    EXPECT_EQ(json["totals"]["bookkeeping"]["reproduced"], 2);
    EXPECT_EQ(json["results"][0]["kind"], "bookkeeping");
    EXPECT_EQ(json["results"][1]["kind"], "physics");
    ValidateOptions options = json_of();
    options.as_json = false;
    const std::string text = run(cases, options).text;
    EXPECT_THAT(text, HasSubstr("s, physics: 0 reproduced, 0 close, 1 not reproduced, 0 under-specified\n"
                                "s, bookkeeping: 2 reproduced, 0 close, 0 not reproduced, 0 under-specified\n"));
    EXPECT_LT(text.find("drop [m]"), text.find("bookkeeping of s"));
    EXPECT_LT(text.find("bookkeeping of s"), text.find("energy missing"));
}

TEST(Validate, bookkeeping_that_fails_fails_the_validation) {
    const auto loses_mass = [](const CaseSetting&, CaseReport& report) {
        report.judge_below({"mass missing", "-", {}, {}, {}, Kind::bookkeeping}, 0.1, 0.01);
    };
    const std::array cases{ValidationCase{"s", "a", "", false, loses_mass}};
    EXPECT_EQ(run(cases, json_of()).code, 1);
}

// A row with a reference has a band: what only reports takes no reference.
static_assert(!std::is_constructible_v<Reported, Reference>);
static_assert(!std::is_convertible_v<Reference, Reported>);

TEST(CaseReport, judges_by_the_band_then_by_the_wider_band_with_its_reason) {
    CaseReport report("a");
    const CloseBand wider{0.5, 2, "steps are coarse"};
    report.judge({"x", "-", {}, 1.0, {}}, 1.05, 0.9, 1.1, wider);
    report.judge({"x", "-", {}, 1.0, {}}, 1.50, 0.9, 1.1, wider);
    report.judge({"x", "-", {}, 1.0, {}}, 2.50, 0.9, 1.1, wider);
    report.judge({"x", "-", {}, 1.0, {}}, std::nan(""), 0.9, 1.1, wider);
    EXPECT_EQ(report.results()[0].verdict, Verdict::reproduced);
    EXPECT_EQ(report.results()[0].note, "");
    EXPECT_EQ(report.results()[1].verdict, Verdict::close);
    EXPECT_EQ(report.results()[1].note, "steps are coarse");
    EXPECT_EQ(report.results()[2].verdict, Verdict::not_reproduced);
    EXPECT_EQ(report.results()[3].verdict, Verdict::not_reproduced);
}

TEST(CaseReport, a_negative_reference_has_its_band_around_it) {
    CaseReport report("a");
    report.judge({"x", "-", {}, -2.0, {}}, -2.01, Relative{0.01});
    EXPECT_EQ(report.results()[0].verdict, Verdict::reproduced);
}

TEST(Registry, names_are_unique_and_every_case_has_a_title) {
    std::vector<std::string> names;
    for (const ValidationCase& one : all_cases()) {
        names.push_back(std::string(one.suite) + "/" + std::string(one.name));
        EXPECT_FALSE(one.title.empty());
        EXPECT_NE(one.run, nullptr);
    }
    auto unique = names;
    std::sort(unique.begin(), unique.end());
    EXPECT_EQ(std::unique(unique.begin(), unique.end()), unique.end());
}

}  // namespace
}  // namespace riprap::validation
