// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/narrowphase/separation.hpp"

#include "riprap/contact/narrowphase/lanes.hpp"

namespace riprap::contact {

namespace {

constexpr int attempt_limit = 12;

/// Largest d . x over the vertices, d in the body frame.
double reach(const geometry::ConvexView& view, const Vec3& d) {
    Lanes best = Lanes::load(view.vertex_x) * d.x + Lanes::load(view.vertex_y) * d.y + Lanes::load(view.vertex_z) * d.z;
    for (int i = geometry::shape_lanes; i < view.vertex_count; i += geometry::shape_lanes) {
        best = max(best, Lanes::load(view.vertex_x + i) * d.x + Lanes::load(view.vertex_y + i) * d.y +
                             Lanes::load(view.vertex_z + i) * d.z);
    }
    return largest(best);
}

/// Vertex farthest along d (world), in the world.
Vec3 support(const geometry::ConvexView& view, const Frame& frame, const Vec3& direction) {
    const Vec3 d = transpose_times(frame.axes, direction);
    int best = 0;
    double most = dot(view.vertex(0), d);
    for (int i = 1; i < view.vertex_count; ++i) {
        const double here = dot(view.vertex(i), d);
        best = here > most ? i : best;
        most = here > most ? here : most;
    }
    return frame.origin + frame.axes * view.vertex(best);
}

}  // namespace

double gap_along(const geometry::ConvexView& a, const Frame& frame_a, const geometry::ConvexView& b,
                 const Frame& frame_b, const Vec3& direction) {
    return dot(direction, frame_b.origin - frame_a.origin) - reach(a, transpose_times(frame_a.axes, direction)) -
           reach(b, -transpose_times(frame_b.axes, direction));
}

bool is_surely_apart(const geometry::ConvexView& a, const Frame& frame_a, const geometry::ConvexView& b,
                     const Frame& frame_b, const SeparatingCache& cache) {
    const double size = a.circumradius + b.circumradius;
    const double far = (1 + separation_margin) * size;
    if (norm_squared(frame_b.origin - frame_a.origin) > far * far) {
        return true;
    }
    const Vec3 direction = frame_a.axes * Vec3{cache.x, cache.y, cache.z};
    return (cache.x != 0 || cache.y != 0 || cache.z != 0) &&
           gap_along(a, frame_a, b, frame_b, direction) > separation_margin * size;
}

Vec3 find_separating_direction(const geometry::ConvexView& a, const Frame& frame_a, const geometry::ConvexView& b,
                               const Frame& frame_b, const Vec3& start) {
    Vec3 d = norm_squared(start) > 0 ? normalized(start) : Vec3{0, 0, 1};
    const double margin = separation_margin * (a.circumradius + b.circumradius);
    for (int attempt = 0; attempt < attempt_limit; ++attempt) {
        const Vec3 between = support(b, frame_b, -d) - support(a, frame_a, d);
        const double gap = dot(between, d);
        if (gap > margin) {
            return d;
        }
        const double length2 = norm_squared(between);
        if (length2 == 0) {
            return {};
        }
        d = normalized(d - (2 * gap / length2) * between);
    }
    return {};
}

}  // namespace riprap::contact
