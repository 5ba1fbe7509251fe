// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/vtp_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/geometry/surface/number_grain.hpp"
#include "riprap/geometry/text/text_reader.hpp"
#include "riprap/io/vtk_layout.hpp"

namespace riprap::io {

using geometry::Surface;
using geometry::SurfaceLimits;

namespace {

std::string_view between(std::string_view text, std::string_view begin, std::string_view end) {
    const std::size_t from = text.find(begin);
    const std::size_t to = from == std::string_view::npos ? from : text.find(end, from);
    return to == std::string_view::npos ? std::string_view{} : text.substr(from, to - from);
}

/// One array of a file. @throws FileError that names it
std::vector<double> array_of(const VtkLayout& layout, std::string_view section, std::string_view name,
                             std::size_t most) {
    const auto element = vtk_data_array(section, name);
    const std::string_view called = name.empty() ? "Points" : name;
    if (!element) {
        throw FileError(fmt::format("it has no array '{}'", called));
    }
    try {
        const std::string_view components = vtk_attribute(element->tag, "NumberOfComponents");
        if (const char* wanted = name.empty() ? "3" : "1"; !components.empty() && components != wanted) {
            throw FileError(fmt::format("{} components, where {} is read", components, wanted));
        }
        std::vector<double> numbers = layout.numbers(*element, most);
        if (numbers.size() > most) {
            throw FileError("more values than the file says or a surface may have");
        }
        return numbers;
    } catch (const FileError& error) {
        throw FileError(fmt::format("array '{}': {}", called, error.what()));
    }
}

std::size_t count_of(std::string_view piece, std::string_view name, std::size_t most) {
    const std::string_view text = vtk_attribute(piece, name);
    const auto count = text.empty() ? std::optional<std::size_t>(0) : vtk_number<std::size_t>(text);
    if (!count || *count > most) {
        throw FileError(fmt::format("{} {}, where a surface has at most {}", name, geometry::quote(text), most));
    }
    return *count;
}

void add_points(const std::vector<double>& numbers, double scale, Surface& surface) {
    const bool is_single = std::all_of(numbers.begin(), numbers.end(), [](double number) {
        return static_cast<double>(static_cast<float>(number)) == number || !std::isfinite(number);
    });
    for (const double number : numbers) {
        surface.grain = is_single ? std::max(surface.grain, scale * geometry::grain_of(static_cast<float>(number))) : 0;
    }
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
        const Vec3 x = scale * Vec3{numbers[i], numbers[i + 1], numbers[i + 2]};
        if (!std::isfinite(norm(x)) ||
            std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)}) > SurfaceLimits::coordinate) {
            throw FileError(
                fmt::format("point {} is farther than {:g} m or no number", i / 3, SurfaceLimits::coordinate));
        }
        surface.vertices.push_back(x);
    }
}

void add_polygons(const std::vector<double>& corners, const std::vector<double>& ends, Surface& surface) {
    std::size_t from = 0;
    std::vector<std::int32_t> face;
    for (std::size_t f = 0; f < ends.size(); ++f) {
        const double end = ends[f];
        if (!(end >= static_cast<double>(from) + 3) || end > static_cast<double>(corners.size()) ||
            end != std::floor(end)) {
            throw FileError(fmt::format("polygon {} has fewer than three corners, or its offsets are wrong", f));
        }
        face.clear();
        for (; from < static_cast<std::size_t>(end); ++from) {
            if (!(corners[from] >= 0) || corners[from] >= static_cast<double>(surface.vertices.size()) ||
                corners[from] != std::floor(corners[from])) {
                throw FileError(fmt::format("polygon {} has a corner {}, which is no point", f, corners[from]));
            }
            face.push_back(static_cast<std::int32_t>(corners[from]));
        }
        surface.add_face(face, 0, 0);
    }
    if (from != corners.size()) {
        throw FileError(fmt::format("{} corners, of which the polygons use {}", corners.size(), from));
    }
}

void read_piece(std::string_view bytes, double scale, Surface& surface) {
    const VtkLayout layout = VtkLayout::of(bytes);
    const std::string_view text = bytes.substr(0, bytes.find("<AppendedData"));
    const std::size_t at = text.find("<Piece");
    if (text.find("<VTKFile") == std::string_view::npos || text.find("\"PolyData\"") == std::string_view::npos ||
        at == std::string_view::npos) {
        throw FileError("it is no VTK file with polygons (PolyData)");
    }
    if (text.find("<Piece", at + 1) != std::string_view::npos) {
        throw FileError("it has several pieces; ParaView writes one from one process");
    }
    const std::string_view piece = text.substr(at, text.find('>', at) - at);
    const std::size_t points = count_of(piece, "NumberOfPoints", SurfaceLimits::vertices);
    const std::size_t polygons = count_of(piece, "NumberOfPolys", SurfaceLimits::faces);
    if (count_of(piece, "NumberOfStrips", SurfaceLimits::faces) > 0) {
        throw FileError("it has triangle strips; ParaView's filter Triangulate makes triangles of them");
    }
    if (points == 0 || polygons == 0) {
        throw FileError("it has no polygons");
    }
    add_points(array_of(layout, between(text, "<Points", "</Points>"), "", 3 * points), scale, surface);
    const std::string_view polys = between(text, "<Polys", "</Polys>");
    add_polygons(array_of(layout, polys, "connectivity", SurfaceLimits::corners),
                 array_of(layout, polys, "offsets", polygons), surface);
    if (surface.vertices.size() != points || surface.face_count() != polygons) {
        throw FileError(fmt::format("{} points and {} polygons, where it promises {} and {}", surface.vertices.size(),
                                    surface.face_count(), points, polygons));
    }
}

/// Where the element stands that a problem names: an array, the points, the polygons, else the piece.
SourcePlace place_of(std::string_view bytes, const std::string& file, std::string_view problem) {
    constexpr std::string_view array = "array '";
    std::size_t from = 0;
    std::string sought = problem.starts_with("point ")     ? "<Points"
                         : problem.starts_with("polygon ") ? "<Polys"
                         : problem.starts_with("it is no") ? "<VTKFile"
                                                           : "<Piece";
    if (const std::size_t at = problem.find(array); at != std::string_view::npos) {
        const std::string_view name = problem.substr(at + array.size());
        const std::string_view called = name.substr(0, name.find('\''));
        sought = called == "Points" ? "<Points" : fmt::format("Name=\"{}\"", called);
        from = called == "Points" ? 0 : std::min(bytes.find("<Polys"), bytes.size());
    }
    const std::size_t found = bytes.find(sought, from);
    const std::string_view before = bytes.substr(0, found == std::string_view::npos ? from : found);
    const std::size_t begin = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    return {file, static_cast<std::uint32_t>(1 + std::count(before.begin(), before.end(), '\n')),
            static_cast<std::uint32_t>(1 + before.size() - begin)};
}

}  // namespace

Surface read_vtp_surface(std::string_view bytes, const std::string& file, double scale) {
    geometry::check_surface_input(file, bytes.size(), scale);
    Surface surface;
    surface.file = file;
    surface.is_binary = true;
    surface.body_names.emplace_back();
    try {
        read_piece(bytes, scale, surface);
        geometry::check_grain(surface);
    } catch (const FileError& error) {
        throw CaseError(Diagnostic{place_of(bytes, file, error.what()), error.what(),
                                   "a surface as ParaView and VTK write it (.vtp)"});
    }
    return surface;
}

}  // namespace riprap::io
