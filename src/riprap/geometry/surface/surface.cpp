// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/surface/surface.hpp"

#include <fmt/format.h>

#include <cmath>

#include "riprap/geometry/text/text_reader.hpp"

namespace riprap::geometry {

namespace {

void check_size(const std::string& file, std::uint64_t size) {
    if (size > SurfaceLimits::bytes) {
        refuse(file, fmt::format("{} bytes", size),
               fmt::format("a surface file has at most {} bytes", SurfaceLimits::bytes));
    }
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

}  // namespace riprap::geometry
