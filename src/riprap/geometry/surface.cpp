// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/surface.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <system_error>

#include "riprap/geometry/obj.hpp"
#include "riprap/geometry/stl.hpp"
#include "riprap/geometry/text_reader.hpp"

namespace riprap::geometry {

namespace {

void check_size(const std::string& file, std::uint64_t size) {
    if (size > SurfaceLimits::bytes) {
        refuse(file, fmt::format("{} bytes", size),
               fmt::format("a surface file has at most {} bytes", SurfaceLimits::bytes));
    }
}

std::string read_bytes(const std::filesystem::path& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        throw FileError(fmt::format("{}: no such file; the path is taken from the folder of the case", path.string()));
    }
    if (!std::filesystem::is_regular_file(status)) {
        throw FileError(fmt::format("{}: not a regular file", path.string()));
    }
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) {
        throw FileError(fmt::format("{}: {}", path.string(), error.message()));
    }
    check_size(path.string(), size);
    std::string bytes(size, '\0');
    std::ifstream stream(path, std::ios::binary);
    if (!stream || !stream.read(bytes.data(), static_cast<std::streamsize>(size))) {
        throw FileError(fmt::format("{}: cannot be read; check its permissions", path.string()));
    }
    return bytes;
}

}  // namespace

void Surface::add_face(std::span<const std::int32_t> corners, std::int32_t body, std::uint32_t place) {
    face_vertex.insert(face_vertex.end(), corners.begin(), corners.end());
    face_start.push_back(static_cast<std::int32_t>(face_vertex.size()));
    face_body.push_back(body);
    face_place.push_back(place);
}

void Surface::add_note(SourcePlace place, std::string message, std::string remedy) {
    Diagnostic& note = notes.emplace_back();
    note.place = std::move(place);
    note.message = std::move(message);
    note.allowed = std::move(remedy);
}

SourcePlace Surface::place_of(std::size_t f) const {
    return is_binary ? SourcePlace{file, 0, 0} : SourcePlace{file, face_place[f], 1};
}

std::string Surface::name_of(std::size_t f) const {
    return is_binary ? fmt::format("face {} (at byte {})", f + 1, face_place[f]) : fmt::format("face {}", f + 1);
}

void check_surface_input(const std::string& file, std::uint64_t size, double scale) {
    check_size(file, size);
    if (!std::isfinite(scale) || scale <= 0.0) {
        refuse(file, fmt::format("scale {}", scale), "metres per unit of the file, above zero");
    }
}

Surface read_surface(const std::filesystem::path& path, double scale) {
    const std::string extension = path.extension().string();
    if (is_same_keyword(extension, ".stl")) {
        return read_stl(read_bytes(path), path.string(), scale);
    }
    if (is_same_keyword(extension, ".obj")) {
        return read_obj(read_bytes(path), path.string(), scale);
    }
    refuse(path.string(), "unknown kind of surface file " + quote(extension), ".stl or .obj");
}

}  // namespace riprap::geometry
