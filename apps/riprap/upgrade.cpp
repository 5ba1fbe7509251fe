// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "command_line_parts.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/drive/find_case.hpp"
#include "riprap/run/folder/run_folder.hpp"
#include "riprap/scene/text/limits.hpp"
#include "riprap/scene/upgrade.hpp"

namespace riprap {

namespace {

/// The case file that is meant: of a run, the one that it keeps.
std::filesystem::path file_of(const std::string& case_text) {
    const std::filesystem::path kept = run::RunFolder{case_text}.case_file();
    return std::filesystem::exists(kept) ? kept : run::find_case(case_text);
}

int upgrade_case(const std::string& case_text, bool is_printed) {
    const std::filesystem::path file = file_of(case_text);
    const std::string before = io::read_file(file, scene::limits::case_bytes);
    const scene::UpgradedCase upgraded = scene::upgrade_case_text(before, file.string());
    std::FILE* report = is_printed ? stderr : stdout;
    for (const scene::OldName& old : upgraded.renamed) {
        fmt::print(report, "{}:{}:{}: '{}' is now '{}'\n", printable(file.string()), old.place.line, old.place.column,
                   printable(old.before), old.now);
    }
    if (is_printed) {
        fmt::print("{}", upgraded.text);
        return 0;
    }
    if (upgraded.renamed.empty()) {
        fmt::print("{} has no name of an older version\n", printable(file.string()));
        return 0;
    }
    const std::filesystem::path kept = file.string() + ".old";
    if (std::filesystem::exists(std::filesystem::symlink_status(kept))) {
        throw FileError(
            fmt::format("'{}' exists already, and would keep the file as it was; move it away, or see the "
                        "new one with --print",
                        kept.string()));
    }
    io::write_file(kept, before);
    io::write_file(file, upgraded.text);
    fmt::print("{} is as it was\n", printable(kept.string()));
    return 0;
}

}  // namespace

void add_upgrade(CLI::App& app, Action& action) {
    struct Options {
        std::string case_text;
        bool is_printed{false};
    };
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("upgrade", "Give keys and words of older versions their names of today");
    command->footer("Example:\n  riprap upgrade my_slope/case.toml --print | diff my_slope/case.toml -");
    command->add_option("CASE", options->case_text, "A case file, a folder with a case.toml, or the folder of a run")
        ->required();
    command->add_flag("--print", options->is_printed,
                      "Print the new file; without it, CASE is rewritten, and CASE.old keeps what it was");
    command->callback(
        [&action, options] { action = [options] { return upgrade_case(options->case_text, options->is_printed); }; });
}

}  // namespace riprap
