// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/narrowphase/common_plane.hpp"

#include <chrono>
#include <cmath>

#include "riprap/contact/narrowphase/common_plane_contacts.hpp"
#include "riprap/core/index.hpp"
#include "riprap/geometry/convex_hull.hpp"
#include "riprap/geometry/random_bits.hpp"
#include "riprap/geometry/shapes.hpp"
#include "riprap/validation/mikola/cases.hpp"

namespace riprap::validation::mikola {

namespace {

/// Numbers in [-1, 1), the same on every machine.
class Dice {
 public:
    double operator()() { return 2 * geometry::unit_interval(geometry::mix_bits(2013, count_++)) - 1; }
    Vec3 point() { return {(*this)(), (*this)(), (*this)()}; }

 private:
    std::uint64_t count_{0};
};

/// A shape that is placed anew for every pair.
struct Shape {
    geometry::Polyhedron polyhedron;
    contact::HullTopology topology;
    std::vector<Vec3> vertices, normals;
    Vec3 centre;

    explicit Shape(const geometry::Polyhedron& shape)
        : polyhedron(shape),
          topology(contact::hull_topology(shape)),
          vertices(shape.vertices),
          normals(shape.faces.size()) {}

    contact::PlacedHull place(const Pose& pose) {
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            vertices[v] = to_world(pose, polyhedron.vertices[v]);
        }
        contact::place_normals(topology, vertices, normals);
        centre = pose.position;
        return {&topology, vertices, normals, centre, 0};
    }
};

std::vector<Shape> make_shapes() {
    std::vector<Shape> shapes;
    for (std::uint64_t k = 0; k < 200; ++k) {
        shapes.emplace_back(k % 4 == 0 ? geometry::box({1.0, 0.3 + 0.01 * static_cast<double>(k % 50), 0.7})
                                       : geometry::random_hull(k, 4 + static_cast<int>(k % 17), 0.7).value());
    }
    return shapes;
}

/// Seconds that `work` takes.
template <class Work>
double seconds_of(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

void common_plane(const CaseSetting& setting, CaseReport& report) {
    std::vector<Shape> shapes = make_shapes(), others = make_shapes();
    const int pair_count = setting.is_full ? 1'000'000 : 20'000;
    Dice dice;
    int wrong_fast[2]{}, wrong[2]{}, count[2]{}, fallbacks = 0;
    double time_fast = 0, time_exact = 0;
    for (int k = 0; k < pair_count; ++k) {
        const auto place = [&](std::vector<Shape>& from, const Vec3& at_point) {
            const auto number = static_cast<std::int64_t>(0.5 * (dice() + 1) * static_cast<double>(from.size()));
            return from[at(number)].place({at_point, from_rotation_vector(3.0 * dice.point())});
        };
        const contact::PlacedHull a = place(shapes, {}), b = place(others, 1.1 * dice.point());
        contact::CommonPlane fast{}, exact{};
        time_fast += seconds_of([&] { fast = common_plane_fast(a, b, {}); });
        time_exact += seconds_of([&] { exact = common_plane_exact(a, b); });
        const contact::CommonPlane used = contact::common_plane(a, b, {}, 10);
        const int overlaps = exact.gap <= 0 ? 1 : 0;
        ++count[overlaps];
        wrong_fast[overlaps] += std::abs(fast.gap - exact.gap) > 1e-12 ? 1 : 0;
        // A face of each may tie; the plane then lies halfway and its gap a little below.
        const bool is_tie = used.feature.kind == contact::PlaneKind::faces && exact.gap - used.gap < 1e-5;
        wrong[overlaps] += std::abs(used.gap - exact.gap) > 1e-12 && !is_tie ? 1 : 0;
        fallbacks += used.is_fallback ? 1 : 0;
    }
    const auto share = [](int part, int whole) { return 100.0 * part / whole; };
    report.judge({"pairs apart whose plane differs from the exact one by more than 1e-12 m", "-", {}, 0, {}}, wrong[0],
                 0, 0);
    report.judge({"overlapping pairs whose plane differs", "-", {}, 0, {}}, wrong[1], 0, 0);
    report.state({"random pairs", "-", {}}, pair_count);
    report.state({"overlapping pairs", "%", {}}, share(count[1], pair_count));
    report.state({"fast plane before the fall-back, differs: pairs apart", "%", {}}, share(wrong_fast[0], count[0]));
    report.state({"fast plane before the fall-back, differs: overlapping pairs", "%",
                  "a local optimum of the overlap; a pair with a plane of the last step starts beside the right one"},
                 share(wrong_fast[1], count[1]));
    report.state({"pairs that fell back on the exact search", "%", {}}, share(fallbacks, pair_count));
    report.state({"time of the exact search over that of the fast one", "-", {}}, time_exact / time_fast);
}

}  // namespace riprap::validation::mikola
