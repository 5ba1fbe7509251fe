// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/text/file_kinds.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace riprap::scene {

namespace {

using namespace std::string_view_literals;

struct Signature {
    std::string_view begin, what, allowed;
};

constexpr std::string_view unpacked = "the file unpacked";
constexpr std::string_view as_text = "the table saved as text (.csv)";
constexpr std::string_view as_heights = "heights as an ESRI ASCII grid (.asc) or rows of x, y, z";
constexpr std::string_view as_utf8 = "UTF-8 or plain ASCII";

constexpr std::array<Signature, 16> signatures{{
    {"\x1F\x8B"sv, "is compressed (gzip)", unpacked},
    {"BZh91AY&SY"sv, "is compressed (bzip2)", unpacked},
    {"\xFD"
     "7zXZ\0"sv,
     "is compressed (xz)", unpacked},
    {"\x28\xB5\x2F\xFD"sv, "is compressed (zstd)", unpacked},
    {"7z\xBC\xAF"sv, "is an archive (7z)", unpacked},
    {"PK\x03\x04"sv, "is an archive (zip) or a workbook (.xlsx, .ods)",
     "the file unpacked, or its table as text (.csv)"},
    {"\xD0\xCF\x11\xE0"sv, "is a workbook (.xls)", as_text},
    {"%PDF-"sv, "is a PDF", as_text},
    {"II*\0"sv, "is an image (TIFF)", as_heights},
    {"MM\0*"sv, "is an image (TIFF)", as_heights},
    {"\x89PNG"sv, "is an image (PNG)", as_heights},
    {"\x89HDF"sv, "is an HDF5 file", as_heights},
    {"CDF\x01"sv, "is a NetCDF file", as_heights},
    {"LASF"sv, "is a cloud of points (LAS)", as_heights},
    {"\xFF\xFE"sv, "is text in UTF-16", as_utf8},
    {"\xFE\xFF"sv, "is text in UTF-16", as_utf8},
}};

/// True where the 84 bytes before the facets of an STL count what follows.
bool is_counted_stl(std::string_view bytes) {
    constexpr std::size_t head = 84, facet = 50, place = 80;
    if (bytes.size() < head) {
        return false;
    }
    std::uint64_t count = 0;
    for (std::size_t i = 4; i-- > 0;) {
        count = count << 8U | static_cast<unsigned char>(bytes[place + i]);
    }
    return count > 0 && bytes.size() == head + facet * count;
}

/// True where every other one of the first bytes is zero: UTF-16 without a mark of its order.
bool alternates(std::string_view bytes) {
    constexpr std::size_t least = 8, most = 64;
    if (bytes.size() < least) {
        return false;
    }
    const std::string_view begin = bytes.substr(0, most);
    for (const std::size_t odd : {std::size_t{0}, std::size_t{1}}) {
        bool is_so = true;
        for (std::size_t i = 0; i < begin.size(); ++i) {
            is_so = is_so && (begin[i] == '\0') == (i % 2 == odd);
        }
        if (is_so) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::optional<OtherKind> other_kind(std::string_view bytes) {
    if (is_counted_stl(bytes)) {
        return std::nullopt;
    }
    for (const Signature& signature : signatures) {
        if (bytes.starts_with(signature.begin)) {
            return OtherKind{std::string(signature.what), std::string(signature.allowed)};
        }
    }
    return alternates(bytes) ? std::optional(OtherKind{"is text in UTF-16", std::string(as_utf8)}) : std::nullopt;
}

}  // namespace riprap::scene
