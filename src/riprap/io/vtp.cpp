// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/vtp.hpp"

#include <fmt/format.h>

#include <numeric>

#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/io/vtk_data.hpp"

namespace riprap::io {

namespace {

constexpr std::string_view file_head =
    "<?xml version=\"1.0\"?>\n"
    "<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\""
    " compressor=\"vtkZLibDataCompressor\">\n";

void put_head(const TextSink& put, std::string_view field_arrays, double time, std::size_t points, std::size_t vertices,
              std::size_t polygons) {
    put(fmt::format(file_head, "PolyData"));
    put("  <PolyData>\n    <FieldData>\n");
    put(fmt::format(
        "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n",
        time));
    put(field_arrays);
    put("    </FieldData>\n");
    put(
        fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" NumberOfStrips=\"0\""
                    " NumberOfPolys=\"{}\">\n",
                    points, vertices, polygons));
}

void put_points(const TextSink& put, std::span<const Vec3> points) {
    put("      <Points>\n");
    put_vtk_array(put, "Points", points);
    put("      </Points>\n");
}

void put_cells(const TextSink& put, std::string_view kind, std::span<const std::int32_t> connectivity,
               std::span<const std::int32_t> offsets) {
    put(fmt::format("      <{}>\n", kind));
    put_vtk_array(put, "connectivity", connectivity);
    put_vtk_array(put, "offsets", offsets);
    put(fmt::format("      </{}>\n", kind));
}

void put_point_data(const TextSink& put, const std::function<void()>& put_arrays, std::string_view cell_arrays) {
    put("      <PointData>\n");
    put_arrays();
    put("      </PointData>\n      <CellData>\n");
    put(cell_arrays);
    put("      </CellData>\n    </Piece>\n  </PolyData>\n</VTKFile>\n");
}

/// Puts the pieces of a frame in their order, so that the whole of it need not be in memory at once.
void put_frame(const PolyData& data, double time, const TextSink& put) {
    const auto put_arrays = [&] { put(data.point_arrays); };
    if (data.is_point_cloud) {
        RIPRAP_ASSERT(data.cell_arrays.empty(), "arrays on the cells of a cloud");
        put_point_cloud(put, data.points, data.field_arrays, time, put_arrays);
        return;
    }
    put_head(put, data.field_arrays, time, data.points.size(), 0, data.offsets.size());
    put_points(put, data.points);
    put_cells(put, "Polys", data.connectivity, data.offsets);
    put_point_data(put, put_arrays, data.cell_arrays);
}

}  // namespace

void PolyData::add_cell_array(std::string_view name, std::span<const float> values, int components) {
    cell_arrays += vtk_array(name, values, components);
}
void PolyData::add_cell_array(std::string_view name, std::span<const std::int32_t> values) {
    cell_arrays += vtk_array(name, values);
}
void PolyData::add_point_array(std::string_view name, std::span<const float> values, int components) {
    point_arrays += vtk_array(name, values, components);
}
void PolyData::add_point_array(std::string_view name, std::span<const std::int32_t> values) {
    point_arrays += vtk_array(name, values);
}

void PolyData::add_field_array(std::string_view name, std::span<const double> values, int components) {
    field_arrays += vtk_field_array(name, values, components);
}

void put_point_cloud(const TextSink& put, std::span<const Vec3> points, std::string_view field_arrays, double time,
                     const std::function<void()>& put_arrays) {
    put_head(put, field_arrays, time, points.size(), points.size(), 0);
    put_points(put, points);
    std::vector<std::int32_t> own(points.size()), ends(points.size());
    std::iota(own.begin(), own.end(), 0);
    std::iota(ends.begin(), ends.end(), 1);
    put_cells(put, "Verts", own, ends);
    put_point_data(put, put_arrays, "");
}

std::string encode_vtp(const PolyData& data, double time) {
    std::string text;
    put_frame(data, time, [&text](std::string_view piece) { text += piece; });
    return text;
}

void write_vtp(const std::filesystem::path& path, const PolyData& data, double time) {
    AtomicFile file(path);
    put_frame(data, time, [&file](std::string_view piece) { file.write(piece); });
    file.commit(Durability::later);
}

void write_pvd(const std::filesystem::path& path, std::span<const PvdFrame> frames) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        "  <Collection>\n";
    for (const PvdFrame& frame : frames) {
        text +=
            fmt::format("    <DataSet timestep=\"{}\" part=\"{}\" file=\"{}\"/>\n", frame.time, frame.part, frame.file);
    }
    text += "  </Collection>\n</VTKFile>\n";
    write_file(path, text, Durability::later);
}

}  // namespace riprap::io
