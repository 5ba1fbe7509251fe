// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/seen_boxes.hpp"

#include <algorithm>

namespace riprap::view {

namespace {

constexpr double same_place = 1e-6;  // of the size of what is free
constexpr double near_share = 0.2;   // of the size of what is free: driven bodies are shown as far around it

/// Returns the box that a shape fills at a pose.
Box box_of(const DrawnShape& shape, const double* pose) {
    Box box;
    for (const Vec3& corner : shape.corners) {
        box.add(Vec3{pose[0], pose[1], pose[2]} + rotate({pose[3], pose[4], pose[5], pose[6]}, corner));
    }
    return box;
}

}  // namespace

void SeenBoxes::note(const BodyFrame& frame, const DrawnBodies& bodies) {
    const bool is_first = first_pose_.empty();
    if (is_first) {
        first_pose_ = frame.pose;
        paths_.resize(bodies.body_count());
    }
    for (std::size_t body = 0; body < bodies.body_count(); ++body) {
        const double* pose = &frame.pose[pose_values * body];
        const DrawnShape& shape = bodies.shapes[static_cast<std::size_t>(bodies.shape[body])];
        if (shape.faces.size() > 1) {  // a half-space is drawn as a square around the scene, and has no size
            const Box box = box_of(shape, pose);
            Path& path = paths_[body];
            path.all.add(box);
            path.start.add(is_first ? box : path.start);
            path.is_free = path.is_free || frame.motion[motion_values * body + 9] > 0;
            path.moves =
                path.moves || path.is_free || !std::equal(pose, pose + pose_values, &first_pose_[pose_values * body]);
        }
    }
}

void SeenBoxes::add_water(const Vec3& low, const Vec3& high) {
    water_.add(low);
    water_.add(high);
}

SeenBoxes::Found SeenBoxes::find() const {
    Found found;
    found.first.add(water_);
    std::size_t free = 0, away = 0;
    Box driven, driven_first;
    for (const Path& path : paths_) {
        driven_first.add(path.moves && !path.is_free ? path.start : Box());
        (path.is_free ? found.first : path.moves ? driven : found.fixed).add(path.is_free ? path.start : path.all);
        free += path.is_free ? 1 : 0;
    }
    const double reach = found.first.length();
    const auto flew_off = [&](const Path& path) { return !path.all.is_near(found.first, reach); };
    for (const Path& path : paths_) {
        away += path.is_free && flew_off(path) ? 1 : 0;
    }
    found.all.add(water_);
    for (const Path& path : paths_) {
        if (path.is_free) {
            found.all.add(flew_off(path) && 10 * away < free ? path.start : path.all);
        }
    }
    found.all.add(found.all.is_empty() ? driven : driven.within(found.all, near_share * found.all.length()));
    if (found.first.is_near(driven_first, same_place * reach)) {  // a drum
        found.all.add(driven_first);
    }
    return found;
}

}  // namespace riprap::view
