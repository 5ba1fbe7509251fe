// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/core/vec3.hpp"

namespace riprap::geometry {

/// Limits of a surface file. A file beyond any of these is refused with a message, before memory is spent on it.
struct SurfaceLimits {
    static constexpr std::uint64_t bytes = 512ull << 20;      ///< size of the file
    static constexpr std::size_t faces = 2'000'000;           ///< faces
    static constexpr std::size_t vertices = 6'000'000;        ///< vertices as written, before equal ones are joined
    static constexpr std::size_t corners = 8'000'000;         ///< sum of the corners of all faces
    static constexpr std::size_t corners_of_a_face = 10'000;  ///< corners of one polygon
    static constexpr std::size_t bodies = 100'000;            ///< named solids, objects and groups
    static constexpr double coordinate = 1e9;                 ///< largest |x|, |y|, |z| after scaling [m]
};

/// Polygons as a file states them: nothing is promised before `audit_surface` (surface_audit.hpp) has looked at them.
struct Surface {
    std::string file;                         ///< name used in messages
    bool is_binary{false};                    ///< places are byte offsets instead of lines
    std::vector<Vec3> vertices;               ///< [m]
    std::vector<std::int32_t> face_start{0};  ///< face_count + 1 entries into face_vertex
    std::vector<std::int32_t> face_vertex;    ///< corners of each face in the file's order
    std::vector<std::int32_t> face_body;      ///< per face: index into body_names
    std::vector<std::uint32_t> face_place;    ///< per face: line, or byte offset when binary
    std::vector<std::string> body_names;      ///< solids (STL), objects and groups (OBJ)
    double grain{0};                          ///< coordinates were rounded to this by the file; 0 = hardly [m]
    std::vector<Diagnostic> notes;            ///< oddities that are no errors, to be shown to the user

    std::size_t face_count() const { return face_start.size() - 1; }
    std::span<const std::int32_t> face(std::size_t f) const {
        return {face_vertex.data() + face_start[f], static_cast<std::size_t>(face_start[f + 1] - face_start[f])};
    }
    void add_face(std::span<const std::int32_t> corners, std::int32_t body, std::uint32_t place);
    void add_note(SourcePlace place, std::string message, std::string remedy);
    /// File and line of a face; only the file when binary.
    SourcePlace place_of(std::size_t f) const;
    /// "face 12", and " (at byte 684)" when binary; faces count from 1.
    std::string name_of(std::size_t f) const;
};

/// Refuses a file beyond the limit of size and a scale that is not a finite number above zero. @throws CaseError
void check_surface_input(const std::string& file, std::uint64_t size, double scale);

}  // namespace riprap::geometry
