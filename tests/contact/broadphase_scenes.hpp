// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scenes of bounding spheres and plane-bounded giants for the tests of the broadphase.

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "riprap/contact/broadphase/broadphase.hpp"

namespace riprap::contact::testing {

/// Parts with storage of their own.
struct Spheres {
    std::vector<Vec3> center;
    std::vector<double> radius;
    std::vector<std::int32_t> body;
    std::vector<std::uint8_t> is_mobile;

    void add(const Vec3& c, double r, bool mobile = true) {
        center.push_back(c);
        radius.push_back(r);
        body.push_back(static_cast<std::int32_t>(body.size()));
        is_mobile.push_back(mobile ? 1 : 0);
    }
    std::int32_t size() const { return static_cast<std::int32_t>(center.size()); }
    PartBounds bounds() const { return {center, radius, body, is_mobile}; }
};

class Random {
 public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    Vec3 in_cube(double half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
    Vec3 direction() {
        Vec3 v = in_cube(1);
        while (norm_squared(v) > 1 || norm_squared(v) < 1e-3) {
            v = in_cube(1);
        }
        return normalized(v);
    }

 private:
    std::mt19937_64 engine_;
};

/// Radii spread evenly in their logarithm over [smallest, ratio * smallest], in a cube.
inline Spheres graded_cloud(int count, double smallest, double ratio, double half, std::uint64_t seed) {
    Random random(seed);
    Spheres spheres;
    for (int i = 0; i < count; ++i) {
        const Vec3 center = random.in_cube(half);
        spheres.add(center, smallest * std::pow(ratio, random.uniform(0, 1)));
    }
    return spheres;
}

/// Planes of a box [m] or a half-space, as far as the broadphase reads a shape.
class PlaneShape {
 public:
    static PlaneShape box(const Vec3& half) {
        PlaneShape shape;
        for (int axis = 0; axis < 3; ++axis) {
            for (const double sign : {-1.0, 1.0}) {
                Vec3 normal{};
                normal[axis] = sign;
                shape.add_face(normal, half[axis]);
            }
        }
        shape.radius_ = norm(half);
        return shape;
    }
    static PlaneShape half_space(const Vec3& normal, double offset) {
        PlaneShape shape;
        shape.add_face(normal, offset);
        shape.radius_ = std::numeric_limits<double>::infinity();
        return shape;
    }
    geometry::ConvexView view() const {
        geometry::ConvexView v{};
        v.face_count = static_cast<std::int32_t>(offset_.size());
        v.normal_x = x_.data();
        v.normal_y = y_.data();
        v.normal_z = z_.data();
        v.offset = offset_.data();
        v.circumradius = radius_;
        return v;
    }
    double radius() const { return radius_; }

 private:
    void add_face(const Vec3& normal, double offset) {
        x_.push_back(normal.x);
        y_.push_back(normal.y);
        z_.push_back(normal.z);
        offset_.push_back(offset);
    }
    std::vector<double> x_, y_, z_, offset_;
    double radius_{0};
};

}  // namespace riprap::contact::testing
