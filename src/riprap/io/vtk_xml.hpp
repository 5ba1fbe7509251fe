// SPDX-License-Identifier: Apache-2.0
#pragma once

// Elements and attributes of ParaView's XML files. No general XML: the files come from programs.

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace riprap::io {

/// An element: what stands in its opening tag and between its tags.
struct VtkElement {
    std::string_view tag, content;
};

/// The value of an attribute; empty where the tag has none of this name.
std::string_view vtk_attribute(std::string_view tag, std::string_view name);

/// The DataArray of this name in a section; an empty name takes the first one.
std::optional<VtkElement> vtk_data_array(std::string_view section, std::string_view name);

/// A number that is the whole text.
template <class T>
std::optional<T> vtk_number(std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional<T>(value) : std::nullopt;
}

}  // namespace riprap::io
