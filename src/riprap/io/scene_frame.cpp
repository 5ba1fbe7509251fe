// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/scene_frame.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/io/csv.hpp"
#include "riprap/sim/quantity.hpp"
#include "riprap/sim/shown.hpp"

namespace riprap::io {

namespace {

/// Share of the scene's size by which a drawn plane reaches beyond it.
constexpr double plane_margin = 0.15;

std::size_t index(BodyId body) { return static_cast<std::size_t>(body.value); }

Pose pose_of(const sim::State& state, BodyId body) {
    return {state.bodies.position[index(body)], state.bodies.orientation[index(body)]};
}

/// Part frame to world.
Vec3 part_to_world(const body::Part& part, const Pose& body_pose, const Vec3& x) {
    return to_world(body_pose, to_world(part.local, x));
}
Vec3 world_to_part(const body::Part& part, const Pose& body_pose, const Vec3& x) {
    return to_body(part.local, to_body(body_pose, x));
}

struct Box {
    Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    bool is_empty() const { return low.x > high.x; }
};

/// Bounds of all bodies with a size.
Box bounds(const sim::Model& model, const sim::State& state) {
    Box box;
    for (const body::Part& part : model.bodies.parts) {
        if (model.shapes.is_half_space(part.shape)) {
            continue;
        }
        const double r = model.shapes.view(part.shape).circumradius;
        const Vec3 center = part_to_world(part, pose_of(state, part.body), {});
        box.low = min(box.low, center - Vec3{r, r, r});
        box.high = max(box.high, center + Vec3{r, r, r});
    }
    return box;
}

/// Two unit vectors that complete the unit vector `n` to a right-handed frame.
std::array<Vec3, 2> tangents(const Vec3& n) {
    const Vec3 aside = std::abs(n.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    const Vec3 s = normalized(cross(aside, n));
    return {s, cross(n, s)};
}

/// Polygons of one part, appended; returns how many.
int append_part(const sim::Model& model, const body::Part& part, const Pose& pose, const DrawnPlane& plane,
                PolyData& data) {
    const auto first = static_cast<std::int32_t>(data.points.size());
    const geometry::ConvexView view = model.shapes.view(part.shape);
    if (model.shapes.is_half_space(part.shape)) {
        for (int i = 0; i < 4; ++i) {
            data.points.push_back(part_to_world(part, pose, plane.corners[static_cast<std::size_t>(i)]));
            data.connectivity.push_back(first + i);
        }
        data.offsets.push_back(static_cast<std::int32_t>(data.connectivity.size()));
        return 1;
    }
    for (int i = 0; i < view.vertex_count; ++i) {
        data.points.push_back(part_to_world(part, pose, view.vertex(i)));
    }
    int count = 0;
    for (int face = 0; face < view.face_count; ++face) {
        // The end faces of planar prisms carry no field either, but they are outer faces and worth seeing.
        if (view.is_internal[face] != 0 && !model.bodies.is_planar) {
            continue;
        }
        for (int k = view.face_start[face]; k < view.face_start[face + 1]; ++k) {
            data.connectivity.push_back(first + view.face_vertex[k]);
        }
        data.offsets.push_back(static_cast<std::int32_t>(data.connectivity.size()));
        ++count;
    }
    return count;
}

/// Where every body is, to the last bit.
void add_poses(const sim::State& state, PolyData& data) {
    std::vector<double> position, orientation;
    for (const Vec3& x : state.bodies.position) {
        position.insert(position.end(), {x.x, x.y, x.z});
    }
    for (const Quat& q : state.bodies.orientation) {
        orientation.insert(orientation.end(), {q.w, q.x, q.y, q.z});
    }
    data.add_field_array("body_position", position, 3);
    data.add_field_array("body_orientation", orientation, 4);
}

/// Values per body, spread over the polygons of each.
class CellValues {
 public:
    explicit CellValues(std::span<const std::int32_t> body_of_cell) : body_of_cell_(body_of_cell) {}

    template <class OfBody>
    std::vector<float> vectors(OfBody&& of_body) const {
        std::vector<float> values;
        values.reserve(3 * body_of_cell_.size());
        for (const std::int32_t body : body_of_cell_) {
            const Vec3 v = of_body(static_cast<std::size_t>(body));
            values.insert(values.end(), {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
        }
        return values;
    }
    template <class T, class OfBody>
    std::vector<T> scalars(OfBody&& of_body) const {
        std::vector<T> values;
        values.reserve(body_of_cell_.size());
        for (const std::int32_t body : body_of_cell_) {
            values.push_back(static_cast<T>(of_body(static_cast<std::size_t>(body))));
        }
        return values;
    }

 private:
    std::span<const std::int32_t> body_of_cell_;
};

}  // namespace

std::vector<DrawnPlane> draw_planes(const sim::Model& model, const sim::State& initial) {
    Box box = bounds(model, initial);
    if (box.is_empty()) {
        box = {{-1, -1, -1}, {1, 1, 1}};
    }
    const Vec3 center = 0.5 * (box.low + box.high);
    const double half_size = (0.5 + plane_margin) * norm(box.high - box.low);
    std::vector<DrawnPlane> planes(model.bodies.parts.size());
    for (std::size_t p = 0; p < planes.size(); ++p) {
        const body::Part& part = model.bodies.parts[p];
        if (!model.shapes.is_half_space(part.shape)) {
            continue;
        }
        const geometry::ConvexView view = model.shapes.view(part.shape);
        const Vec3 n = view.normal(0);
        const Vec3 seen = world_to_part(part, pose_of(initial, part.body), center);
        const Vec3 foot = seen - (dot(n, seen) - view.offset[0]) * n;
        const auto [s, t] = tangents(n);
        planes[p].corners = {foot - half_size * (s + t), foot + half_size * (s - t), foot + half_size * (s + t),
                             foot - half_size * (s - t)};
    }
    return planes;
}

PolyData draw_bodies(const sim::Model& model, const sim::State& initial, const sim::State& state,
                     std::span<const DrawnPlane> planes, std::span<const Vec3> contact_force) {
    const body::BodySet& bodies = model.bodies;
    PolyData data;
    std::vector<std::int32_t> body_of_cell;
    for (std::size_t p = 0; p < bodies.parts.size(); ++p) {
        const body::Part& part = bodies.parts[p];
        const int count = append_part(model, part, pose_of(state, part.body), planes[p], data);
        body_of_cell.insert(body_of_cell.end(), static_cast<std::size_t>(count), part.body.value);
    }
    const auto id = [](std::size_t body) { return BodyId{static_cast<std::int32_t>(body)}; };
    const auto displacement = [&](std::size_t b) { return state.bodies.position[b] - initial.bodies.position[b]; };
    const CellValues cells(body_of_cell);
    data.add_cell_array("body", body_of_cell);
    data.add_cell_array("material",
                        cells.scalars<std::int32_t>([&](std::size_t b) { return bodies.material[b].value; }));
    data.add_cell_array("is_free", cells.scalars<std::int32_t>([&](std::size_t b) {
        return body::is_free(bodies, id(b), state.time) ? 1 : 0;
    }));
    data.add_cell_array("velocity", cells.vectors([&](std::size_t b) { return state.bodies.velocity[b]; }), 3);
    data.add_cell_array("speed", cells.scalars<float>([&](std::size_t b) { return norm(state.bodies.velocity[b]); }));
    data.add_cell_array(
        "angular_velocity",
        cells.vectors([&](std::size_t b) { return body::angular_velocity(bodies, state.bodies, id(b)); }), 3);
    data.add_cell_array("displacement", cells.vectors(displacement), 3);
    data.add_cell_array("distance", cells.scalars<float>([&](std::size_t b) { return norm(displacement(b)); }));
    const std::span<const ShownField> fields = sim::shown_fields(model);
    for (std::size_t f = 0; f < fields.size(); ++f) {
        const std::vector<double> values = sim::shown_values(model, state, f);
        data.add_cell_array(std::string(fields[f].name) + " [" + std::string(fields[f].unit) + "]",
                            cells.scalars<float>([&](std::size_t b) { return values[b]; }));
    }
    add_poses(state, data);
    if (contact_force.size() == state.bodies.position.size()) {
        data.add_cell_array("contact_force", cells.vectors([&](std::size_t b) { return contact_force[b]; }), 3);
    }
    return data;
}

PolyData draw_contacts(std::span<const contact::ShownContact> contacts) {
    PolyData data;
    data.is_point_cloud = true;
    std::vector<std::int32_t> body_a, body_b, is_sliding;
    std::vector<float> force, normal_force, shear_force, overlap, area;
    for (const contact::ShownContact& contact : contacts) {
        data.points.push_back(contact.point);
        body_a.push_back(contact.a.value);
        body_b.push_back(contact.b.value);
        is_sliding.push_back(contact.is_sliding ? 1 : 0);
        force.insert(force.end(), {static_cast<float>(contact.force.x), static_cast<float>(contact.force.y),
                                   static_cast<float>(contact.force.z)});
        normal_force.push_back(static_cast<float>(contact.normal_force));
        shear_force.push_back(static_cast<float>(contact.shear_force));
        overlap.push_back(static_cast<float>(contact.overlap));
        area.push_back(static_cast<float>(contact.area));
    }
    data.add_point_array("body_a", body_a);
    data.add_point_array("body_b", body_b);
    data.add_point_array("is_sliding", is_sliding);
    data.add_point_array("force", force, 3);
    data.add_point_array("normal_force", normal_force);
    data.add_point_array("shear_force", shear_force);
    data.add_point_array("overlap", overlap);
    data.add_point_array("area", area);
    return data;
}

void write_bodies_csv(const std::filesystem::path& path, const sim::Model& model, const sim::State& initial,
                      const sim::State& state, std::span<const Vec3> contact_force) {
    const std::string mass = sim::unit_in("kg", model.bodies.is_planar);
    const std::string force = sim::unit_in("N", model.bodies.is_planar);
    const std::array<CsvColumn, 27> columns{{{"time", "s"},
                                             {"body", "-"},
                                             {"name", "-"},
                                             {"mass", mass},
                                             {"position.x", "m"},
                                             {"position.y", "m"},
                                             {"position.z", "m"},
                                             {"orientation.w", "-"},
                                             {"orientation.x", "-"},
                                             {"orientation.y", "-"},
                                             {"orientation.z", "-"},
                                             {"velocity.x", "m/s"},
                                             {"velocity.y", "m/s"},
                                             {"velocity.z", "m/s"},
                                             {"angular_velocity.x", "rad/s"},
                                             {"angular_velocity.y", "rad/s"},
                                             {"angular_velocity.z", "rad/s"},
                                             {"displacement.x", "m"},
                                             {"displacement.y", "m"},
                                             {"displacement.z", "m"},
                                             {"rotation_vector.x", "rad"},
                                             {"rotation_vector.y", "rad"},
                                             {"rotation_vector.z", "rad"},
                                             {"contact_force.x", force},
                                             {"contact_force.y", force},
                                             {"contact_force.z", force},
                                             {"is_free", "-"}}};
    const bool has_force = contact_force.size() == state.bodies.position.size();
    AtomicFile file(path);
    file.write(csv_heading(columns) + '\n');
    for (std::int32_t i = 0; i < model.bodies.size(); ++i) {
        const auto b = static_cast<std::size_t>(i);
        const Vec3 x = state.bodies.position[b], v = state.bodies.velocity[b];
        const Vec3 w = body::angular_velocity(model.bodies, state.bodies, BodyId{i});
        const Vec3 u = x - initial.bodies.position[b];
        const Quat q = state.bodies.orientation[b];
        const Vec3 turn = to_rotation_vector(q * conjugate(initial.bodies.orientation[b]));
        const Vec3 f = has_force ? contact_force[b] : Vec3{NAN, NAN, NAN};
        const bool is_free = body::is_free(model.bodies, BodyId{i}, state.time);
        const std::array<double, 2> head{state.time, static_cast<double>(i)};
        const std::array<double, 24> rest{model.bodies.mass[b],
                                          x.x,
                                          x.y,
                                          x.z,
                                          q.w,
                                          q.x,
                                          q.y,
                                          q.z,
                                          v.x,
                                          v.y,
                                          v.z,
                                          w.x,
                                          w.y,
                                          w.z,
                                          u.x,
                                          u.y,
                                          u.z,
                                          turn.x,
                                          turn.y,
                                          turn.z,
                                          f.x,
                                          f.y,
                                          f.z,
                                          is_free ? 1.0 : 0.0};
        file.write(csv_row(head) + ',' + csv_text(model.bodies.name(BodyId{i})) + ',' + csv_row(rest) + '\n');
    }
    file.commit();
}

}  // namespace riprap::io
