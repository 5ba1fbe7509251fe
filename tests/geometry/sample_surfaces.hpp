// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "riprap/geometry/polyhedra/polyhedron.hpp"
#include "riprap/geometry/surface/surface.hpp"

namespace riprap::geometry {

/// A box between two corners, faces in the order -x +x -y +y -z +z.
inline Polyhedron sample_box(const Vec3& low, const Vec3& high) {
    Polyhedron box;
    for (int i = 0; i < 8; ++i) {
        box.vertices.push_back(
            {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z});
    }
    box.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    return box;
}

/// The faces of polyhedra as one unaudited surface, one body each; `is_soup` writes every triangle with corners of its
/// own, as STL does.
inline Surface sample_surface(const std::vector<Polyhedron>& bodies, bool is_soup = true) {
    Surface surface;
    surface.file = "sample.stl";
    for (const Polyhedron& body : bodies) {
        const auto number = static_cast<std::int32_t>(surface.body_names.size());
        surface.body_names.emplace_back();
        const auto first = static_cast<std::int32_t>(surface.vertices.size());
        if (!is_soup) {
            surface.vertices.insert(surface.vertices.end(), body.vertices.begin(), body.vertices.end());
        }
        for (const auto& face : body.faces) {
            const auto line = static_cast<std::uint32_t>(surface.face_count() + 1);
            if (!is_soup) {
                std::vector<std::int32_t> corners;
                for (const std::int32_t v : face) {
                    corners.push_back(first + v);
                }
                surface.add_face(corners, number, line);
                continue;
            }
            for (std::size_t k = 2; k < face.size(); ++k) {
                const auto at = static_cast<std::int32_t>(surface.vertices.size());
                for (const std::int32_t v : {face[0], face[k - 1], face[k]}) {
                    surface.vertices.push_back(body.vertices[static_cast<std::size_t>(v)]);
                }
                surface.add_face(std::array{at, at + 1, at + 2}, number,
                                 static_cast<std::uint32_t>(surface.face_count() + 1));
            }
        }
    }
    return surface;
}

inline double total_volume(const std::vector<Polyhedron>& parts) {
    double sum = 0.0;
    for (const Polyhedron& part : parts) {
        sum += mass_properties(part).volume;
    }
    return sum;
}

/// Path of a file among the surfaces of the tests.
inline std::filesystem::path sample_path(const std::string& name) {
    return std::filesystem::path(RIPRAP_SOURCE_DIR) / "tests" / "data" / "surfaces" / name;
}

inline std::string sample_bytes(const std::string& name) {
    std::ifstream stream(sample_path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// The binary STL file of a surface of triangles; `header` fills the first 80 bytes.
inline std::string binary_stl(const Surface& surface, std::string header = "binary") {
    header.resize(80, ' ');
    const auto append = [&](const auto& value) { header.append(reinterpret_cast<const char*>(&value), sizeof value); };
    append(static_cast<std::uint32_t>(surface.face_count()));
    for (std::size_t f = 0; f < surface.face_count(); ++f) {
        for (int i = 0; i < 3; ++i) {
            append(0.0F);
        }
        for (const std::int32_t v : surface.face(f)) {
            const Vec3& x = surface.vertices[static_cast<std::size_t>(v)];
            for (int axis = 0; axis < 3; ++axis) {
                append(static_cast<float>(x[axis]));
            }
        }
        append(std::uint16_t{0});
    }
    return header;
}

}  // namespace riprap::geometry
