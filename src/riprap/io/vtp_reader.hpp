// SPDX-License-Identifier: Apache-2.0
#pragma once

// Reads back what vtp.hpp writes: PolyData with inline base64 arrays, zlib-compressed in blocks. A file that is cut,
// damaged, or of another layout is a FileError that says so; nothing is allocated on the word of a header.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/core/vec3.hpp"

namespace riprap::io {

/// The part of a VTP file that an array stands in.
enum class VtpSection { field, points, polygons, point_data, cell_data };

/// One frame. Arrays are decoded when they are asked for.
class VtpFile {
 public:
    /// Takes the text of a file; `name` is for messages. @throws FileError when it is not a whole file of ours
    VtpFile(std::string text, std::string name);

    double time() const { return time_; }  ///< TimeValue [s]
    std::size_t point_count() const { return point_count_; }
    std::size_t polygon_count() const { return polygon_count_; }
    bool has(VtpSection section, std::string_view array) const;
    /// Names of the arrays of a section, in the order of the file.
    std::vector<std::string> names(VtpSection section) const;

    /// The values of an array, all components in one row. Float32, Float64, Int32, Int64 and UInt8 are converted.
    /// `expected` is the number of values that there must be. @throws FileError
    std::vector<double> numbers(VtpSection section, std::string_view array, std::optional<std::size_t> expected) const;
    std::vector<float> floats(VtpSection section, std::string_view array, std::optional<std::size_t> expected) const;
    std::vector<std::int32_t> integers(VtpSection section, std::string_view array,
                                       std::optional<std::size_t> expected) const;
    std::vector<Vec3> points() const;  ///< [m]

 private:
    std::string_view section(VtpSection section) const;
    template <class T>
    std::vector<T> values(VtpSection section, std::string_view array, std::optional<std::size_t> expected) const;
    [[noreturn]] void refuse(const std::string& why) const;

    std::string text_, name_;
    double time_{0};
    std::size_t point_count_{0}, polygon_count_{0};
};

/// @throws FileError
VtpFile read_vtp(const std::filesystem::path& path);

/// One line of a PVD file.
struct PvdEntry {
    double time{0};    ///< [s]
    std::string file;  ///< relative to the PVD file
};

/// The frames a PVD file lists. @throws FileError when it is not one
std::vector<PvdEntry> read_pvd(const std::filesystem::path& path);

}  // namespace riprap::io
