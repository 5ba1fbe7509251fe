// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/hydrostatic/joint_cover.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"

namespace riprap::coupling {

namespace {

using Panel = HydrostaticFluid::Panel;

/// Keeps the part of a convex polygon with low <= axis . x <= high.
std::vector<Vec3> slice(const std::vector<Vec3>& polygon, const Vec3& axis, double low, double high) {
    std::vector<Vec3> kept = polygon;
    for (const double side : {1.0, -1.0}) {
        const double bound = side > 0 ? high : -low;
        std::vector<Vec3> next;
        for (std::size_t i = 0; i < kept.size(); ++i) {
            const Vec3 &a = kept[i], &b = kept[(i + 1) % kept.size()];
            const double da = bound - side * dot(axis, a), db = bound - side * dot(axis, b);
            if (da >= 0) {
                next.push_back(a);
            }
            if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
                next.push_back(a + (da / (da - db)) * (b - a));
            }
        }
        kept = std::move(next);
    }
    return kept;
}

/// Cuts a polygon across `axis` into strips of equal width, none wider than `size`.
std::vector<std::vector<Vec3>> strips(const std::vector<Vec3>& polygon, const Vec3& axis, double size) {
    double low = dot(axis, polygon[0]), high = low;
    for (const Vec3& x : polygon) {
        low = std::min(low, dot(axis, x));
        high = std::max(high, dot(axis, x));
    }
    const double count = std::isfinite(size) ? std::ceil((high - low) / size - 1e-9) : 1;
    if (count <= 1) {
        return {polygon};
    }
    std::vector<std::vector<Vec3>> found;
    for (double k = 0; k < count; ++k) {
        const double width = (high - low) / count;
        std::vector<Vec3> strip = slice(polygon, axis, low + k * width, low + (k + 1) * width);
        if (strip.size() > 2) {
            found.push_back(std::move(strip));
        }
    }
    return found;
}

void add_face(std::int32_t body, const std::vector<Vec3>& face, const Vec3& normal, double size, bool is_planar,
              std::vector<Panel>& panels) {
    const Vec3 along = normalized(face[1] - face[0]), across = cross(normal, along);
    for (const std::vector<Vec3>& strip : strips(face, along, is_planar && std::abs(along.z) > 0.5 ? HUGE_VAL : size)) {
        for (const std::vector<Vec3>& piece :
             strips(strip, across, is_planar && std::abs(across.z) > 0.5 ? HUGE_VAL : size)) {
            panels.push_back({body, piece, normal});
        }
    }
}

/// Tells whether a point lies in some other body that keeps water off.
bool is_covered(const FluidScene& scene, const HydrostaticSettings& settings, const body::Motion& motion,
                std::int32_t body, const Vec3& x) {
    for (const body::Part& part : scene.bodies.parts) {
        if (part.body.value == body || settings.passes(at(part.body.value))) {
            continue;
        }
        const Pose& pose = motion.pose[at(part.body.value)];
        const Vec3 in_body = rotate(conjugate(pose.orientation), x - pose.position);
        const Vec3 in_part = rotate(conjugate(part.local.orientation), in_body - part.local.position);
        if (geometry::contains(scene.shapes.view(part.shape), in_part)) {
            return true;
        }
    }
    return false;
}

/// Returns how far a point is from the nearest basin, sideways [m].
double from_water(const HydrostaticSettings& settings, const Vec3& x) {
    double least = std::numeric_limits<double>::infinity();
    for (const HydrostaticSettings::Basin& basin : settings.basins) {
        Vec3 out{};
        for (int axis = 0; axis < (settings.is_planar ? 2 : 3); ++axis) {
            out[axis] = std::max({0.0, basin.low[axis] - x[axis], x[axis] - basin.high[axis]});
        }
        least = std::min(least, norm(out - dot(out, settings.up) * settings.up));
    }
    return least;
}

Vec3 middle_of(const body::Motion& motion, const Panel& panel) {
    Vec3 middle{};
    for (const Vec3& corner : panel.corner) {
        middle += corner / static_cast<double>(panel.corner.size());
    }
    return motion.pose[at(panel.body)].position + arm_of(motion, at(panel.body), middle);
}

}  // namespace

std::vector<Panel> cut_faces(const FluidScene& scene, const HydrostaticSettings& settings, double size) {
    std::vector<Panel> panels;
    for (const body::Part& part : scene.bodies.parts) {
        if (scene.shapes.is_half_space(part.shape) || settings.passes(at(part.body.value))) {
            continue;
        }
        const double panel = may_move(scene.bodies, at(part.body.value)) ? size : HUGE_VAL;
        const geometry::ConvexView shape = scene.shapes.view(part.shape);
        for (std::int32_t j = 0; j < shape.face_count; ++j) {
            if (shape.is_internal[j] != 0) {
                continue;
            }
            std::vector<Vec3> face;
            for (std::int32_t k = shape.face_start[j]; k < shape.face_start[j + 1]; ++k) {
                face.push_back(part.local.position +
                               rotate(part.local.orientation, shape.vertex(shape.face_vertex[k])));
            }
            add_face(part.body.value, face, rotate(part.local.orientation, shape.normal(j)), panel,
                     scene.bodies.is_planar, panels);
        }
    }
    return panels;
}

bool lies_on_another(const FluidScene& scene, const HydrostaticSettings& settings, const body::Motion& motion,
                     const Panel& panel) {
    const Vec3 outward = rotate(motion.pose[at(panel.body)].orientation, panel.normal);
    return is_covered(scene, settings, motion, panel.body,
                      middle_of(motion, panel) + (lies_on_share * settings.spacing) * outward);
}

std::vector<double> joint_shares(const FluidScene& scene, const HydrostaticSettings& settings,
                                 const body::Motion& motion, const std::vector<Panel>& panels) {
    std::vector<double> distance(panels.size(), -1);  // of covered panels from the water
    parallel::for_each_uneven(static_cast<std::int64_t>(panels.size()), 16, [&](std::int64_t index) {
        const Panel& panel = panels[at(index)];
        if (may_move(scene.bodies, at(panel.body)) && lies_on_another(scene, settings, motion, panel)) {
            distance[at(index)] = from_water(settings, middle_of(motion, panel));
        }
    });
    std::vector<double> farthest(motion.pose.size(), 0);
    for (std::size_t i = 0; i < panels.size(); ++i) {
        farthest[at(panels[i].body)] = std::max(farthest[at(panels[i].body)], distance[i]);
    }
    std::vector<double> share(panels.size(), 1);
    for (std::size_t i = 0; i < panels.size(); ++i) {
        if (distance[i] >= 0) {
            const double length = farthest[at(panels[i].body)] + 0.5 * settings.spacing;
            share[i] = settings.uplift == Uplift::linear ? std::max(0.0, 1 - distance[i] / length) : 0.0;
        }
    }
    return share;
}

}  // namespace riprap::coupling
