// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <set>

#include "commands.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/view/page.hpp"
#include "riprap/view/read_run.hpp"
#include "riprap/view/serve.hpp"

namespace riprap {

namespace {

constexpr double megabyte = 1e6;

void tell_notices(const view::PageContent& content) {
    for (const std::string& notice : content.notices) {
        fmt::print(stderr, "riprap: {}\n", printable(notice));
    }
}

void tell_size(std::size_t bytes, std::size_t budget) {
    if (bytes > budget) {
        fmt::print(
            stderr,
            "riprap: the page is {:.2f} MB larger than the budget of {:.2f} MB: only water is rounded to fit, and "
            "the program of the page, blocks, tables and texts take the rest\n",
            static_cast<double>(bytes - budget) / megabyte, static_cast<double>(budget) / megabyte);
    }
}

/// Headings that tell the runs apart: names of their folders, or whole paths where two folders have one name.
std::vector<std::string> names_of(const std::vector<std::filesystem::path>& folders) {
    std::vector<std::string> names;
    for (const std::filesystem::path& folder : folders) {
        names.push_back(std::filesystem::absolute(folder / ".").lexically_normal().parent_path().filename().string());
    }
    if (std::set<std::string>(names.begin(), names.end()).size() < names.size()) {
        names.assign(folders.begin(), folders.end());
    }
    return names;
}

view::PageContent packed(const std::filesystem::path& folder, std::size_t budget, const run::StopRequest& stop) {
    view::PageContent content = view::pack_run(view::read_run(folder), budget, &stop);
    tell_notices(content);
    return content;
}

std::string page_of_runs(const ViewOptions& options, std::size_t budget, const run::StopRequest& stop) {
    if (options.folders.size() == 1) {
        return view::page_of(packed(options.folders.front(), budget, stop));
    }
    std::vector<view::PageContent> contents;
    for (const std::filesystem::path& folder : options.folders) {
        contents.push_back(packed(folder, budget / options.folders.size(), stop));
    }
    return view::page_of(contents, names_of(options.folders));
}

}  // namespace

int view_run(const ViewOptions& options) {
    const auto budget = static_cast<std::size_t>(options.budget_mb * megabyte);
    const auto page = [&options, budget](const run::StopRequest& stop) { return page_of_runs(options, budget, stop); };
    if (options.is_served) {
        view::serve(page, options.port);
        return 0;
    }
    const std::filesystem::path usual =
        options.folders.size() == 1 ? options.folders.front() / "index.html" : "compare.html";
    const std::filesystem::path out = options.out.empty() ? usual : options.out;
    const std::string text = page(run::StopRequest());
    io::write_file(out, text);
    tell_size(text.size(), budget);
    fmt::print("{}: {:.2f} MB; open it in a browser, nothing else is needed\n", out.string(),
               static_cast<double>(text.size()) / megabyte);
    return 0;
}

}  // namespace riprap
