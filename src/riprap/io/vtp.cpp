// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/vtp.hpp"

#include <fmt/format.h>

#include <numeric>

#include "riprap/io/atomic_file.hpp"
#include "riprap/io/vtk_data.hpp"

namespace riprap::io {

namespace {

constexpr std::string_view file_head =
    "<?xml version=\"1.0\"?>\n"
    "<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\""
    " compressor=\"vtkZLibDataCompressor\">\n";

std::string cells(std::string_view kind, std::span<const std::int32_t> connectivity,
                  std::span<const std::int32_t> offsets) {
    return fmt::format("      <{0}>\n{1}{2}      </{0}>\n", kind, vtk_array("connectivity", connectivity),
                       vtk_array("offsets", offsets));
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

namespace {

/// Calls put(text) with the pieces of a frame in their order, so that the whole of it need not be in memory at once.
template <class Put>
void encode_pieces(const PolyData& data, double time, const Put& put) {
    const std::size_t point_count = data.points.size();
    put(fmt::format(file_head, "PolyData"));
    put("  <PolyData>\n    <FieldData>\n");
    put(fmt::format(
        "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n",
        time));
    put(data.field_arrays);
    put("    </FieldData>\n");
    put(
        fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" NumberOfStrips=\"0\""
                    " NumberOfPolys=\"{}\">\n",
                    point_count, data.is_point_cloud ? point_count : 0, data.offsets.size()));
    put("      <Points>\n");
    put(vtk_array("Points", data.points));
    put("      </Points>\n");
    if (data.is_point_cloud) {
        std::vector<std::int32_t> own(point_count), ends(point_count);
        std::iota(own.begin(), own.end(), 0);
        std::iota(ends.begin(), ends.end(), 1);
        put(cells("Verts", own, ends));
    } else {
        put(cells("Polys", data.connectivity, data.offsets));
    }
    put("      <PointData>\n");
    put(data.point_arrays);
    put("      </PointData>\n      <CellData>\n");
    put(data.cell_arrays);
    put("      </CellData>\n    </Piece>\n  </PolyData>\n</VTKFile>\n");
}

}  // namespace

std::string encode_vtp(const PolyData& data, double time) {
    std::string text;
    encode_pieces(data, time, [&text](std::string_view piece) { text += piece; });
    return text;
}

void write_vtp(const std::filesystem::path& path, const PolyData& data, double time) {
    AtomicFile file(path);
    encode_pieces(data, time, [&file](std::string_view piece) { file.write(piece); });
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
