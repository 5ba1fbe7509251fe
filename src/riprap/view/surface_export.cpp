// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/surface_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/io/vtp.hpp"
#include "riprap/view/glb.hpp"
#include "riprap/view/pack_bodies.hpp"
#include "riprap/view/read_run.hpp"
#include "riprap/view/water_mesh.hpp"

namespace riprap::view {

namespace {

namespace fs = std::filesystem;

/// The grid fluid writes its surface itself; particles are meshed.
WaterMesh read_water(const FrameFiles& files, bool is_planar) {
    if (files.water.empty()) {
        return {};
    }
    const io::VtpFile frame = io::read_vtp(files.water);
    if (!frame.has(io::VtpSection::field, "spacing")) {
        return {};
    }
    const std::vector<float> speed = frame.has(io::VtpSection::point_data, "speed")
                                         ? frame.floats(io::VtpSection::point_data, "speed", frame.point_count())
                                         : std::vector<float>(frame.point_count());
    return mesh_water(frame.points(), speed, frame.numbers(io::VtpSection::field, "spacing", 1)[0], is_planar);
}

void write_water_vtp(const fs::path& path, const WaterMesh& water, double time) {
    io::PolyData data;
    data.points = water.points;
    for (const auto& t : water.triangles) {
        data.connectivity.insert(data.connectivity.end(), t.begin(), t.end());
        data.offsets.push_back(static_cast<std::int32_t>(data.connectivity.size()));
    }
    data.add_point_array("speed", water.speed);
    std::vector<float> normals;
    for (const Vec3& n : water.normals) {
        normals.insert(normals.end(), {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)});
    }
    data.add_point_array("Normals", normals, 3);
    io::write_vtp(path, data, time);
}

template <class T>
void append(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string ply_header(std::size_t points, const char* properties, std::size_t faces) {
    return fmt::format(
        "ply\nformat binary_little_endian 1.0\ncomment metres\nelement vertex {}\nproperty float x\nproperty float y\n"
        "property float z\n{}element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        points, properties, faces);
}

void append_point(std::string& bytes, const Vec3& x) {
    for (int axis = 0; axis < 3; ++axis) {
        append(bytes, static_cast<float>(x[axis]));
    }
}

std::string ply_of(const WaterMesh& water) {
    std::string bytes = ply_header(water.points.size(),
                                   "property float nx\nproperty float ny\nproperty float nz\nproperty float speed\n",
                                   water.triangles.size());
    for (std::size_t i = 0; i < water.points.size(); ++i) {
        append_point(bytes, water.points[i]);
        append_point(bytes, water.normals[i]);
        append(bytes, water.speed[i]);
    }
    for (const auto& t : water.triangles) {
        append(bytes, std::uint8_t{3});
        for (const std::int32_t i : t) {
            append(bytes, i);
        }
    }
    return bytes;
}

std::string ply_of(const std::vector<PlacedBody>& bodies) {
    std::string points, faces;
    std::size_t point_count = 0, face_count = 0;
    for (const PlacedBody& body : bodies) {
        const auto first = static_cast<std::int32_t>(point_count);
        for (const Vec3& corner : body.shape->corners) {
            append_point(points, body.position + rotate(body.orientation, corner));
            ++point_count;
        }
        for (const auto& face : body.shape->faces) {
            for (std::size_t k = 2; k < face.size(); ++k) {  // polygons of blocks are convex
                append(faces, std::uint8_t{3});
                for (const std::int32_t i : {face[0], face[k - 1], face[k]}) {
                    append(faces, first + i);
                }
                ++face_count;
            }
        }
    }
    return ply_header(point_count, "", face_count) + points + faces;
}

/// Bodies of a frame that have a size.
std::vector<PlacedBody> place_bodies(const RecordedRun& run, const DrawnBodies& drawn, const BodyFrame& frame) {
    std::vector<PlacedBody> bodies;
    const bool has_names = run.body_names.size() == drawn.body_count();
    for (std::size_t body = 0; body < drawn.body_count(); ++body) {
        const auto shape = static_cast<std::size_t>(drawn.shape[body]);
        if (drawn.shapes[shape].faces.size() > 1) {
            const double* p = &frame.pose[pose_values * body];
            bodies.push_back({has_names ? run.body_names[body] : fmt::format("body {}", body),
                              shape,
                              &drawn.shapes[shape],
                              drawn.material[body],
                              {p[0], p[1], p[2]},
                              {p[3], p[4], p[5], p[6]},
                              frame.motion[motion_values * body + 9] > 0});
        }
    }
    return bodies;
}

std::size_t nearest_frame(const RecordedRun& run, double time) {
    const auto nearest =
        std::min_element(run.frames.begin(), run.frames.end(), [time](const FrameFiles& a, const FrameFiles& b) {
            return std::fabs(a.time - time) < std::fabs(b.time - time);
        });
    return static_cast<std::size_t>(nearest - run.frames.begin());
}

std::vector<std::size_t> chosen_frames(const RecordedRun& run, const SurfaceOptions& options) {
    const auto count = static_cast<int>(run.frames.size());
    if (options.time) {
        return {nearest_frame(run, *options.time)};
    }
    if (options.frame) {
        const int index = *options.frame < 0 ? count + *options.frame : *options.frame;
        if (index < 0 || index >= count) {
            throw FileError(fmt::format("there is no frame {}: the run has {}, from 0 to {}, or from -1 backwards",
                                        *options.frame, count, count - 1));
        }
        return {static_cast<std::size_t>(index)};
    }
    std::vector<std::size_t> all(run.frames.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
        all[k] = k;
    }
    return all;
}

}  // namespace

std::string export_surfaces(const SurfaceOptions& options) {
    const RecordedRun run = read_run(options.folder);
    if (run.frames.empty()) {
        throw FileError(fmt::format("'{}' has no frames", options.folder.string()));
    }
    const fs::path out = options.out.empty() ? options.folder / "surface" : options.out;
    io::make_folder(out);
    const auto wants = [&](const char* format) { return options.formats.count(format) > 0; };
    DrawnBodies drawn;
    std::vector<io::PvdFrame> listed;
    std::size_t files = 0;
    const auto write = [&](const std::string& name, const std::string& bytes) {
        io::write_file(out / name, bytes, io::Durability::later);
        ++files;
    };
    const std::vector<std::size_t> frames = chosen_frames(run, options);
    for (const std::size_t k : frames) {
        const FrameFiles& frame = run.frames[k];
        const WaterMesh water = read_water(frame, run.is_planar);
        std::vector<PlacedBody> bodies;
        if (!frame.bodies.empty()) {
            const io::VtpFile file = io::read_vtp(frame.bodies);
            drawn = drawn.shape.empty() ? read_shapes(file) : drawn;
            bodies = place_bodies(run, drawn, read_body_frame(file, drawn));
        }
        if (wants("vtp") && !water.triangles.empty()) {
            const std::string name = fmt::format("water_{:06}.vtp", k);
            write_water_vtp(out / name, water, frame.time);
            listed.push_back({frame.time, name, 0});
            ++files;
        }
        if (wants("ply") && !water.triangles.empty()) {
            write(fmt::format("water_{:06}.ply", k), ply_of(water));
        }
        if (wants("ply") && !bodies.empty()) {
            write(fmt::format("blocks_{:06}.ply", k), ply_of(bodies));
        }
        if (wants("glb")) {
            write(fmt::format("frame_{:06}.glb", k), glb_of(water, bodies, run.gravity));
        }
    }
    if (!listed.empty()) {
        io::write_pvd(out / "surface.pvd", listed);
    }
    return fmt::format("{}: {} files of {} frame{}, t = {:.6g} to {:.6g} s", out.string(), files, frames.size(),
                       frames.size() == 1 ? "" : "s", run.frames[frames.front()].time, run.frames[frames.back()].time);
}

}  // namespace riprap::view
