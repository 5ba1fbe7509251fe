// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace riprap::view {

/// Pixels of an SVG in an inch, as CSS has them.
constexpr double svg_dpi = 96;

/// Writes a drawing as SVG, PNG or PDF, by the end of the name. SVG as it is; the others are made by the browser that
/// draws the scenes, in the size that the root element of the SVG names [1/96 inch].
/// @param dpi  pixels in an inch of a PNG, which tells them to whoever prints it
/// @throws FileError where there is no browser, or the picture has more than `most_pixels` along an edge
void write_figure(const std::filesystem::path& path, const std::string& svg, double dpi);

constexpr double most_pixels = 16384;

/// Number of an attribute of the root element of an SVG; 0 where it has none.
double svg_number(const std::string& svg, const std::string& attribute);

}  // namespace riprap::view
