// SPDX-License-Identifier: Apache-2.0
#include "refusal.hpp"
#include "riprap/geometry/dda_files/dda_files.hpp"

// Reads bytes as a geometry and as an analysis of the 2D-DDA family.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace riprap;
    read_or_refuse(data, size, [](std::string_view text) {
        const geometry::DdaGeometry geometry = geometry::read_dda_geometry(text, "fuzz");
        if (!(geometry.snap >= 0) || geometry.notes.empty()) {
            std::abort();
        }
    });
    read_or_refuse(data, size, [](std::string_view text) {
        const geometry::DdaAnalysis analysis = geometry::read_dda_analysis(text, "fuzz");
        if (!(analysis.time_step >= 0) || analysis.step_count < 0) {
            std::abort();
        }
    });
    return 0;
}
