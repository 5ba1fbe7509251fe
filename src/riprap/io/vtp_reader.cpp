// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/vtp_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/io/atomic_file.hpp"
#include "riprap/io/vtk_data.hpp"
#include "riprap/io/vtk_xml.hpp"

namespace riprap::io {

namespace {

constexpr std::size_t frame_limit = std::size_t{4} << 30U;  // bytes of one frame
constexpr std::size_t max_ratio = 1032;                     // of zlib
constexpr std::size_t list_limit = std::size_t{64} << 20U;

struct SectionName {
    std::string_view begin, end;
};
SectionName name_of(VtpSection section) {
    switch (section) {
        case VtpSection::field:
            return {"<FieldData>", "</FieldData>"};
        case VtpSection::points:
            return {"<Points>", "</Points>"};
        case VtpSection::polygons:
            return {"<Polys>", "</Polys>"};
        case VtpSection::point_data:
            return {"<PointData>", "</PointData>"};
        case VtpSection::cell_data:
            return {"<CellData>", "</CellData>"};
    }
    return {};
}

template <class From, class To>
std::vector<To> convert(const std::string& bytes) {
    std::vector<From> from(bytes.size() / sizeof(From));
    std::copy_n(bytes.data(), from.size() * sizeof(From), reinterpret_cast<char*>(from.data()));
    return {from.begin(), from.end()};
}

template <class To>
std::vector<To> convert(const std::string& bytes, std::string_view type) {
    if (type == "Float32") {
        return convert<float, To>(bytes);
    }
    if (type == "Float64") {
        return convert<double, To>(bytes);
    }
    if (type == "Int32") {
        return convert<std::int32_t, To>(bytes);
    }
    if (type == "Int64") {
        return convert<std::int64_t, To>(bytes);
    }
    if (type == "UInt8") {
        return convert<std::uint8_t, To>(bytes);
    }
    throw FileError(fmt::format("values of type '{}'", type));
}

}  // namespace

void VtpFile::refuse(const std::string& why) const { throw FileError(fmt::format("cannot read '{}': {}", name_, why)); }

VtpFile::VtpFile(std::string text, std::string name) : text_(std::move(text)), name_(std::move(name)) {
    const std::string_view all = text_;
    if (all.find("<VTKFile type=\"PolyData\"") == std::string_view::npos) {
        refuse("it is no VTK file with polygons or points");
    }
    if (all.find("</VTKFile>") == std::string_view::npos) {
        refuse("it ends in the middle; the run may have been stopped or copied while it was written");
    }
    if (all.find("header_type=\"UInt64\"") == std::string_view::npos ||
        all.find("compressor=\"vtkZLibDataCompressor\"") == std::string_view::npos) {
        refuse("it is not laid out as Riprap writes it (inline base64, zlib, 64-bit headers)");
    }
    const std::size_t at = all.find("<Piece");
    const std::string_view piece = at == std::string_view::npos ? "" : all.substr(at, all.find('>', at) - at);
    const auto points = vtk_number<std::size_t>(vtk_attribute(piece, "NumberOfPoints"));
    const auto polygons = vtk_number<std::size_t>(vtk_attribute(piece, "NumberOfPolys"));
    if (!points || !polygons) {
        refuse("it does not say how many points and polygons it has");
    }
    if (*points / max_ratio > text_.size() || *polygons / max_ratio > text_.size()) {
        refuse("it promises more points or polygons than can be packed in it");
    }
    point_count_ = *points;
    polygon_count_ = *polygons;
    const auto time_value = vtk_data_array(section(VtpSection::field), "TimeValue");
    const auto time = time_value ? vtk_number<double>(time_value->content) : std::nullopt;
    if (!time || !std::isfinite(*time)) {
        refuse("it does not say its time (TimeValue)");
    }
    time_ = *time;
}

std::string_view VtpFile::section(VtpSection section) const {
    const std::string_view all = text_;
    const SectionName name = name_of(section);
    const std::size_t begin = all.find(name.begin);
    const std::size_t end = all.find(name.end, begin == std::string_view::npos ? 0 : begin);
    return begin == std::string_view::npos || end == std::string_view::npos ? std::string_view{}
                                                                            : all.substr(begin, end - begin);
}

std::vector<std::string> VtpFile::names(VtpSection section) const {
    const std::string_view text = this->section(section);
    std::vector<std::string> found;
    for (std::size_t at = text.find("<DataArray"); at != std::string_view::npos; at = text.find("<DataArray", at + 1)) {
        const std::size_t end = text.find('>', at);
        found.emplace_back(vtk_attribute(text.substr(at, end == std::string_view::npos ? end : end - at), "Name"));
    }
    return found;
}

bool VtpFile::has(VtpSection section, std::string_view array) const {
    return vtk_data_array(this->section(section), array).has_value();
}

template <class T>
std::vector<T> VtpFile::values(VtpSection section, std::string_view array, std::optional<std::size_t> expected) const {
    const auto element = vtk_data_array(this->section(section), array);
    if (!element) {
        refuse(fmt::format("it has no array '{}'", array));
    }
    try {
        if (vtk_attribute(element->tag, "format") != "binary") {
            throw FileError("not inline base64");
        }
        const std::size_t most_bytes = expected ? sizeof(double) * *expected : frame_limit;
        std::vector<T> values =
            convert<T>(decode_vtk_array(element->content, most_bytes), vtk_attribute(element->tag, "type"));
        if (expected && values.size() != *expected) {
            throw FileError(fmt::format("{} values where {} are needed", values.size(), *expected));
        }
        return values;
    } catch (const FileError& error) {
        refuse(fmt::format("array '{}': {}", array, error.what()));
    }
}

std::vector<double> VtpFile::numbers(VtpSection section, std::string_view array,
                                     std::optional<std::size_t> expected) const {
    return values<double>(section, array, expected);
}
std::vector<float> VtpFile::floats(VtpSection section, std::string_view array,
                                   std::optional<std::size_t> expected) const {
    return values<float>(section, array, expected);
}
std::vector<std::int32_t> VtpFile::integers(VtpSection section, std::string_view array,
                                            std::optional<std::size_t> expected) const {
    return values<std::int32_t>(section, array, expected);
}

std::vector<Vec3> VtpFile::points() const {
    const std::vector<double> flat = numbers(VtpSection::points, "Points", 3 * point_count_);
    std::vector<Vec3> points;
    points.reserve(point_count_);
    for (std::size_t i = 0; i < point_count_; ++i) {
        points.push_back({flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]});
    }
    return points;
}

VtpFile read_vtp(const std::filesystem::path& path) { return {read_file(path, frame_limit), path.string()}; }

std::vector<PvdEntry> read_pvd(const std::filesystem::path& path) {
    const std::string text = read_file(path, list_limit);
    const std::string_view all = text;
    if (all.find("<VTKFile type=\"Collection\"") == std::string_view::npos) {
        throw FileError(fmt::format("cannot read '{}': it is no ParaView collection", path.string()));
    }
    std::vector<PvdEntry> entries;
    std::size_t at = 0;
    while ((at = all.find("<DataSet", at)) != std::string_view::npos) {
        const std::size_t end = all.find('>', at);
        if (end == std::string_view::npos) {
            break;  // the list is cut; what stands before it counts
        }
        const std::string_view tag = all.substr(at, end - at);
        const auto time = vtk_number<double>(vtk_attribute(tag, "timestep"));
        const std::string_view file = vtk_attribute(tag, "file");
        if (time && std::isfinite(*time) && !file.empty()) {
            entries.push_back({*time, std::string(file)});
        }
        at = end;
    }
    return entries;
}

}  // namespace riprap::io
