// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/vtk_xml.hpp"

#include <string>

namespace riprap::io {

std::string_view vtk_attribute(std::string_view tag, std::string_view name) {
    const std::string key = ' ' + std::string(name) + "=\"";
    const std::size_t at = tag.find(key);
    if (at == std::string_view::npos) {
        return {};
    }
    const std::size_t begin = at + key.size();
    const std::size_t end = tag.find('"', begin);
    return end == std::string_view::npos ? std::string_view{} : tag.substr(begin, end - begin);
}

std::optional<VtkElement> vtk_data_array(std::string_view section, std::string_view name) {
    std::size_t at = 0;
    while ((at = section.find("<DataArray", at)) != std::string_view::npos) {
        const std::size_t tag_end = section.find('>', at);
        if (tag_end == std::string_view::npos) {
            return std::nullopt;
        }
        const std::string_view tag = section.substr(at, tag_end - at);
        // Appended arrays are closed in the tag.
        const bool is_closed = tag.back() == '/';
        const std::size_t end = is_closed ? tag_end + 1 : section.find("</DataArray>", tag_end);
        if (end == std::string_view::npos) {
            return std::nullopt;
        }
        if (name.empty() || vtk_attribute(tag, "Name") == name) {
            return VtkElement{tag, section.substr(tag_end + 1, end - tag_end - 1)};
        }
        at = end;
    }
    return std::nullopt;
}

}  // namespace riprap::io
