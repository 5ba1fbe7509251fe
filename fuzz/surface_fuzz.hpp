// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "riprap/geometry/surface/surface.hpp"
#include "riprap/geometry/surface/surface_audit.hpp"

namespace riprap::geometry {

/// Reads bytes as a surface and audits what comes out. A reader may refuse with a CaseError that has at least one
/// problem; an audit answers with parts of positive volume or with problems. Anything else ends the program.
template <class Read>
void read_and_audit(const std::uint8_t* data, std::size_t size, const Read& read) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        const Surface surface = read(bytes, "fuzz", 0.5);
        for (const bool is_repairing : {false, true}) {
            SurfaceAuditOptions options;
            options.fix_orientation = options.drop_collapsed = options.is_one_body = is_repairing;
            const SurfaceAudit audit = audit_surface(surface, options);
            if (audit.parts.empty() == audit.problems.empty()) {
                std::abort();
            }
            for (const SurfacePart& part : audit.parts) {
                if (!(part.volume > 0.0)) {
                    std::abort();
                }
            }
        }
    } catch (const CaseError& error) {
        if (error.problems().empty()) {
            std::abort();
        }
    }
}

}  // namespace riprap::geometry
