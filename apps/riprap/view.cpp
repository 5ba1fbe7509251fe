// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "commands.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/view/page.hpp"
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

}  // namespace

int view_run(const ViewOptions& options) {
    const auto budget = static_cast<std::size_t>(options.budget_mb * megabyte);
    const auto page = [&options, budget](const run::StopRequest& stop) {
        const view::PageContent content = view::pack_run(view::read_run(options.folder), budget, &stop);
        tell_notices(content);
        return view::page_of(content);
    };
    if (options.is_served) {
        view::serve(page, options.port);
        return 0;
    }
    const std::filesystem::path out = options.out.empty() ? options.folder / "index.html" : options.out;
    const std::string text = page(run::StopRequest());
    io::write_file(out, text);
    tell_size(text.size(), budget);
    fmt::print("{}: {:.2f} MB; open it in a browser, nothing else is needed\n", out.string(),
               static_cast<double>(text.size()) / megabyte);
    return 0;
}

}  // namespace riprap
