// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/page.hpp"

#include <nlohmann/json.hpp>
#include <span>

#include "riprap/io/vtk_data.hpp"
#include "riprap/view/page_template.hpp"

namespace riprap::view {

namespace {

/// Stands in page/index.html where the run goes.
constexpr std::string_view place_of_run = "<!--riprap:run-->";

/// JSON within a script element: no text in it may end the element.
std::string json_in_html(const std::string& json) {
    std::string text;
    text.reserve(json.size() + 64);
    for (const char c : json) {
        if (c == '<') {
            text += "\\u003c";  // stands within a JSON text, where that is the same character
        } else {
            text += c;
        }
    }
    return text;
}

std::string script(const std::string& name, const std::string& content) {
    return "<script type=\"application/x-riprap\" id=\"" + name + "\">" + content + "</script>\n";
}

/// The scripts that hold one run; their names begin with `prefix`.
std::string scripts_of(const PageContent& content, const std::string& prefix) {
    std::string text = script(prefix + "contents", json_in_html(content.contents_json));
    for (const Chunk& chunk : content.chunks) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(chunk.packed.data());
        text += script(prefix + chunk.name, io::encode_base64(std::span(bytes, chunk.packed.size())));
    }
    return text;
}

std::string page_with(const std::string& scripts) {
    const std::string_view page = page_template();
    const std::size_t at = page.find(place_of_run);
    if (at == std::string_view::npos) {
        throw FileError(
            "this riprap carries no page: it was built where Node.js or the packages of page/ were missing; run "
            "scripts/setup, which installs both, and build again");
    }
    return std::string(page.substr(0, at)) + scripts + std::string(page.substr(at + place_of_run.size()));
}

}  // namespace

bool has_page() { return page_template().find(place_of_run) != std::string_view::npos; }

std::string page_of_study(const std::string& json) { return page_with(script("study", json_in_html(json))); }

std::string page_of(const PageContent& content) { return page_with(scripts_of(content, "")); }

std::string page_of(const std::vector<PageContent>& contents, const std::vector<std::string>& names) {
    std::string scripts = script("compared", json_in_html(nlohmann::json(names).dump()));
    for (std::size_t run = 0; run < contents.size(); ++run) {
        scripts += scripts_of(contents[run], "run" + std::to_string(run) + ".");
    }
    return page_with(scripts);
}

}  // namespace riprap::view
