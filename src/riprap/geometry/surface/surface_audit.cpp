// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/surface/surface_audit.hpp"

#include <fmt/format.h>

#include <utility>

#include "riprap/geometry/surface/surface_mesh.hpp"

namespace riprap::geometry {

std::string coordinates(const Vec3& x) { return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", x.x, x.y, x.z); }

SurfaceAudit audit_surface(const Surface& surface, const SurfaceAuditOptions& options) {
    SurfaceAudit audit;
    audit.notes = surface.notes;
    ProblemList problems;
    SurfaceMesh mesh = weld_surface(surface, options, problems, audit.notes);
    std::vector<ConvexPart> parts;
    if (problems.is_empty()) {
        const ShellSet shells = find_shells(mesh, options, problems, audit.notes);
        if (shells.shells.size() > audit_parts) {
            problems.add(surface.file, fmt::format("{} separate shells", shells.shells.size()),
                         fmt::format("at most {}", audit_parts));
        }
        for (std::size_t shell = 0; shell < shells.shells.size() && problems.count() < ProblemList::cap; ++shell) {
            parts.push_back(make_convex_part(mesh, shells, shell, problems));
        }
    }
    if (problems.is_empty()) {
        check_part_contacts(parts, mesh, options, problems);
    }
    if (problems.is_empty()) {
        for (ConvexPart& part : parts) {
            audit.parts.push_back(std::move(part.part));
        }
    } else {
        audit.problems = problems.take();
    }
    return audit;
}

std::vector<Diagnostic> audit_closed_surface(const Surface& surface, const SurfaceAuditOptions& options,
                                             std::vector<Diagnostic>& notes) {
    notes = surface.notes;
    ProblemList problems;
    SurfaceMesh mesh = weld_surface(surface, options, problems, notes);
    if (problems.is_empty()) {
        find_shells(mesh, options, problems, notes);
    }
    return problems.take();
}

}  // namespace riprap::geometry
