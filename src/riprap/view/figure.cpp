// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/figure.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/view/browser.hpp"

namespace riprap::view {

namespace {

std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (const unsigned shift : {24U, 16U, 8U, 0U}) {
        bytes += static_cast<char>(value >> shift & 0xFFU);
    }
    return bytes;
}

/// Adds the chunk pHYs [PNG, 11.3.5.3], pixels per metre, behind the header of a PNG.
std::string with_resolution(std::string png, double dpi) {
    constexpr double inch = 0.0254;         // [m]
    constexpr std::size_t header_end = 33;  // signature of 8 bytes, IHDR of 25
    const std::string density = big_endian(static_cast<std::uint32_t>(std::lround(dpi / inch)));
    const std::string chunk = "pHYs" + density + density + '\1';
    const auto* bytes = reinterpret_cast<const unsigned char*>(chunk.data());
    const auto sum = static_cast<std::uint32_t>(::crc32(0, bytes, static_cast<unsigned>(chunk.size())));
    return png.insert(header_end, big_endian(static_cast<std::uint32_t>(chunk.size() - 4)) + chunk + big_endian(sum));
}

}  // namespace

double svg_number(const std::string& svg, const std::string& attribute) {
    const std::size_t at = svg.find(fmt::format(" {}='", attribute), svg.find("<svg"));
    return at == std::string::npos ? 0 : std::atof(svg.c_str() + at + attribute.size() + 3);
}

void write_figure(const std::filesystem::path& path, const std::string& svg, double dpi) {
    if (path.extension() == ".svg") {
        io::write_file(path, svg);
        return;
    }
    const double width = svg_number(svg, "width"), height = svg_number(svg, "height"), scale = dpi / svg_dpi;
    if (path.extension() == ".png" && std::max(width, height) * scale > most_pixels) {
        throw FileError(
            fmt::format("the picture would have {:.0f} x {:.0f} pixels, of at most {} along an edge; fewer "
                        "--dpi, a smaller --size or fewer columns",
                        width * scale, height * scale, most_pixels));
    }
    const ScratchFolder scratch;
    const std::filesystem::path page = scratch.path() / "figure.html";
    io::write_file(page,
                   "<!doctype html><html data-opened=\"1\"><meta charset=\"utf-8\"><style>*{margin:0}svg{display:block}"
                   "</style>" +
                       svg,
                   io::Durability::later);
    const bool is_pdf = path.extension() == ".pdf";
    Browser browser(find_browser(), static_cast<int>(std::ceil(width)), static_cast<int>(std::ceil(height)),
                    is_pdf ? 1 : scale);
    browser.open(page);
    io::write_file(path,
                   is_pdf ? browser.print(width / svg_dpi, height / svg_dpi) : with_resolution(browser.picture(), dpi));
}

}  // namespace riprap::view
