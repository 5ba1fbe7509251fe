// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/vtp_reader.hpp"
#include "refusal.hpp"
#include "riprap/io/vtp_surface.hpp"

// Reads bytes as a surface of another program, and as a frame of Riprap.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace riprap;
    read_or_refuse(data, size, [](std::string_view text) {
        const geometry::Surface surface = io::read_vtp_surface(text, "fuzz", 0.5);
        for (const std::int32_t corner : surface.face_vertex) {
            if (corner < 0 || static_cast<std::size_t>(corner) >= surface.vertices.size()) {
                std::abort();
            }
        }
    });
    try {
        const io::VtpFile frame(std::string(reinterpret_cast<const char*>(data), size), "fuzz");
        for (const io::VtpSection section : {io::VtpSection::point_data, io::VtpSection::cell_data}) {
            for (const std::string& name : frame.names(section)) {
                frame.has(section, name);
            }
        }
        frame.points();
    } catch (const FileError&) {
        // a refusal is an answer
    }
    return 0;
}
