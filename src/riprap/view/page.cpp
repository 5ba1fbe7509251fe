// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/page.hpp"

#include <span>

#include "riprap/io/vtk_data.hpp"

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

}  // namespace

std::string page_of(const PageContent& content) {
    const std::string_view page = page_template();
    const std::size_t at = page.find(place_of_run);
    if (at == std::string_view::npos) {
        throw FileError(
            "this riprap carries no page: it was built where Node.js or the packages of page/ were missing; run "
            "scripts/setup, which installs both, and build again");
    }
    std::string text(page.substr(0, at));
    text += script("contents", json_in_html(content.contents_json));
    for (const Chunk& chunk : content.chunks) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(chunk.packed.data());
        text += script(chunk.name, io::encode_base64(std::span(bytes, chunk.packed.size())));
    }
    text += page.substr(at + place_of_run.size());
    return text;
}

}  // namespace riprap::view
