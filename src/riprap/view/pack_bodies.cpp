// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/pack_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/error.hpp"
#include "riprap/view/chunk.hpp"

namespace riprap::view {

namespace {

using io::VtpSection;

/// Two corners are the same when they differ by less than this share of the size of the shape.
constexpr double same_corner = 1e-6;

Vec3 position_of(const std::vector<double>& position, std::size_t body) {
    return {position[3 * body], position[3 * body + 1], position[3 * body + 2]};
}
Quat orientation_of(const std::vector<double>& q, std::size_t body) {
    return {q[4 * body], q[4 * body + 1], q[4 * body + 2], q[4 * body + 3]};
}

/// Positions and orientations of all bodies, which tell how many there are.
struct Poses {
    std::vector<double> position, orientation;
    std::size_t count() const { return position.size() / 3; }
};

Poses read_poses(const io::VtpFile& frame) {
    if (!frame.has(VtpSection::field, "body_position")) {
        throw FileError(
            "the frames do not say where the bodies are (body_position); an earlier Riprap wrote them; run "
            "the case again to see its bodies");
    }
    Poses poses{frame.numbers(VtpSection::field, "body_position", std::nullopt), {}};
    poses.orientation = frame.numbers(VtpSection::field, "body_orientation", poses.position.size() / 3 * 4);
    return poses;
}

double size_of(const DrawnShape& shape) {
    double size = 0;
    for (const Vec3& x : shape.corners) {
        size = std::max(size, norm(x));
    }
    return size;
}

bool are_same(const DrawnShape& a, const DrawnShape& b) {
    if (a.faces != b.faces || a.corners.size() != b.corners.size()) {
        return false;
    }
    const double tolerance = same_corner * size_of(a);
    return std::equal(a.corners.begin(), a.corners.end(), b.corners.begin(),
                      [&](const Vec3& x, const Vec3& y) { return norm(x - y) <= tolerance; });
}

/// Returns a key that equal shapes share: only shapes with the same key are compared.
std::pair<std::size_t, std::int64_t> key_of(const DrawnShape& shape) {
    double sum = 0;
    for (const Vec3& x : shape.corners) {
        sum += norm(x);
    }
    return {shape.corners.size(), sum > 0 ? std::llround(std::log(sum) * 1e4) : 0};
}

/// Keeps every shape once. Shapes at the border of a key may be kept twice, which costs a little and harms nothing.
class ShapeList {
 public:
    explicit ShapeList(std::vector<DrawnShape>& shapes) : shapes_(shapes) {}
    std::int32_t add(DrawnShape shape) {
        std::vector<std::int32_t>& alike = by_key_[key_of(shape)];
        for (const std::int32_t known : alike) {
            if (are_same(shape, shapes_[static_cast<std::size_t>(known)])) {
                return known;
            }
        }
        alike.push_back(static_cast<std::int32_t>(shapes_.size()));
        shapes_.push_back(std::move(shape));
        return alike.back();
    }

 private:
    std::vector<DrawnShape>& shapes_;
    std::map<std::pair<std::size_t, std::int64_t>, std::vector<std::int32_t>> by_key_;
};

/// Polygons of a frame and whose they are.
struct Polygons {
    std::vector<Vec3> points;
    std::vector<std::int32_t> connectivity, end, body;
    std::size_t begin(std::size_t face) const { return face == 0 ? 0 : static_cast<std::size_t>(end[face - 1]); }
};

Polygons read_polygons(const io::VtpFile& frame, std::size_t body_count) {
    Polygons polygons{frame.points(), frame.integers(VtpSection::polygons, "connectivity", std::nullopt),
                      frame.integers(VtpSection::polygons, "offsets", frame.polygon_count()),
                      frame.integers(VtpSection::cell_data, "body", frame.polygon_count())};
    const auto is_within = [](std::size_t count) {
        return [count](std::int32_t i) { return i >= 0 && static_cast<std::size_t>(i) < count; };
    };
    const bool is_whole =
        std::all_of(polygons.connectivity.begin(), polygons.connectivity.end(), is_within(polygons.points.size())) &&
        std::all_of(polygons.body.begin(), polygons.body.end(), is_within(body_count)) &&
        std::is_sorted(polygons.end.begin(), polygons.end.end()) &&
        (polygons.end.empty() ||
         (polygons.end.front() >= 0 && static_cast<std::size_t>(polygons.end.back()) <= polygons.connectivity.size()));
    if (!is_whole) {
        throw FileError("a frame has polygons that refer to points or bodies that are not there");
    }
    return polygons;
}

/// The shape of one body in its own frame, from its polygons in the world.
DrawnShape shape_of(const Polygons& polygons, const std::vector<std::size_t>& faces, const Vec3& x, const Quat& q) {
    DrawnShape shape;
    std::map<std::int32_t, std::int32_t> corner_of;
    for (const std::size_t face : faces) {
        shape.faces.emplace_back();
        for (std::size_t k = polygons.begin(face); k < static_cast<std::size_t>(polygons.end[face]); ++k) {
            const std::int32_t point = polygons.connectivity[k];
            const auto [found, is_new] = corner_of.try_emplace(point, static_cast<std::int32_t>(shape.corners.size()));
            if (is_new) {
                shape.corners.push_back(rotate_back(q, polygons.points[static_cast<std::size_t>(point)] - x));
            }
            shape.faces.back().push_back(found->second);
        }
    }
    return shape;
}

}  // namespace

DrawnBodies read_shapes(const io::VtpFile& frame) {
    const Poses poses = read_poses(frame);
    const Polygons polygons = read_polygons(frame, poses.count());
    const std::vector<std::int32_t> material = frame.integers(VtpSection::cell_data, "material", frame.polygon_count());
    std::vector<std::vector<std::size_t>> faces(poses.count());
    for (std::size_t face = 0; face < polygons.body.size(); ++face) {
        faces[static_cast<std::size_t>(polygons.body[face])].push_back(face);
    }
    DrawnBodies bodies;
    ShapeList shapes(bodies.shapes);
    for (std::size_t b = 0; b < poses.count(); ++b) {
        if (faces[b].empty()) {
            throw FileError(fmt::format("a frame has no polygon of body {}", b));
        }
        bodies.shape.push_back(shapes.add(
            shape_of(polygons, faces[b], position_of(poses.position, b), orientation_of(poses.orientation, b))));
        bodies.first_face.push_back(faces[b].front());
        bodies.material.push_back(material[faces[b].front()]);
    }
    for (std::string& name : frame.names(VtpSection::cell_data)) {
        if (name.ends_with(']')) {
            bodies.shown.push_back(std::move(name));
        }
    }
    return bodies;
}

BodyFrame read_body_frame(const io::VtpFile& frame, const DrawnBodies& bodies) {
    const std::size_t count = bodies.body_count(), faces = frame.polygon_count();
    const Poses poses = read_poses(frame);
    if (poses.count() != count ||
        (count > 0 && *std::max_element(bodies.first_face.begin(), bodies.first_face.end()) >= faces)) {
        throw FileError("a frame has other bodies than the first one");
    }
    const std::vector<float> velocity = frame.floats(VtpSection::cell_data, "velocity", 3 * faces);
    const std::vector<float> turn = frame.floats(VtpSection::cell_data, "angular_velocity", 3 * faces);
    const std::vector<std::int32_t> is_free = frame.integers(VtpSection::cell_data, "is_free", faces);
    const std::vector<float> force = frame.has(VtpSection::cell_data, "contact_force")
                                         ? frame.floats(VtpSection::cell_data, "contact_force", 3 * faces)
                                         : std::vector<float>(3 * faces, std::numeric_limits<float>::quiet_NaN());
    std::vector<std::vector<float>> shown;
    for (const std::string& name : bodies.shown) {
        shown.push_back(frame.floats(VtpSection::cell_data, name, faces));
    }
    BodyFrame out;
    for (std::size_t b = 0; b < count; ++b) {
        const std::size_t face = bodies.first_face[b];
        out.pose.insert(out.pose.end(), &poses.position[3 * b], &poses.position[3 * b] + 3);
        out.pose.insert(out.pose.end(), &poses.orientation[4 * b], &poses.orientation[4 * b] + 4);
        for (const std::vector<float>* values : {&velocity, &turn, &force}) {
            out.motion.insert(out.motion.end(), &(*values)[3 * face], &(*values)[3 * face] + 3);
        }
        out.motion.push_back(static_cast<float>(is_free[face]));
        for (const std::vector<float>& values : shown) {
            out.shown.push_back(values[face]);
        }
    }
    return out;
}

std::vector<float> read_contacts(const io::VtpFile& frame) {
    const std::size_t count = frame.point_count();
    const std::vector<double> points = frame.numbers(VtpSection::points, "Points", 3 * count);
    const std::vector<float> force = frame.floats(VtpSection::point_data, "force", 3 * count);
    const std::vector<float> overlap = frame.floats(VtpSection::point_data, "overlap", count);
    const std::vector<float> a = frame.floats(VtpSection::point_data, "body_a", count);
    const std::vector<float> b = frame.floats(VtpSection::point_data, "body_b", count);
    const std::vector<float> slides = frame.floats(VtpSection::point_data, "is_sliding", count);
    std::vector<float> rows;
    rows.reserve(contact_values * count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            rows.push_back(static_cast<float>(points[3 * i + k]));
        }
        rows.insert(rows.end(), {force[3 * i], force[3 * i + 1], force[3 * i + 2], overlap[i], a[i], b[i], slides[i]});
    }
    return rows;
}

template <class T>
std::string pack_rows(std::span<const std::vector<T>> frames) {
    std::string bytes;
    for (const std::vector<T>& frame : frames) {
        bytes += bytes_of(std::span<const T>(frame));
    }
    if (!frames.empty()) {
        difference_rows(bytes, frames.front().size() * sizeof(T));
    }
    return compress(split_planes(bytes, sizeof(T)));
}

template std::string pack_rows(std::span<const std::vector<double>> frames);
template std::string pack_rows(std::span<const std::vector<float>> frames);

}  // namespace riprap::view
