// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <random>

#include "checks.hpp"
#include "few_shapes.hpp"
#include "riprap/contact/narrowphase/distance_potential_plain.hpp"
#include "riprap/core/parallel_device.hpp"
#include "riprap/geometry/polyhedra/sharp_edges.hpp"
#include "seconds_of.hpp"

namespace selftest {
namespace {

using riprap::Vec3;
using riprap::contact::DistancePotentialOptions;
using riprap::contact::Frame;
using riprap::contact::NormalContact;
using riprap::geometry::ConvexView;
namespace parallel = riprap::parallel;
using parallel::device::DeviceArray;

/// The arrays of one shape on the device, and a view of them.
class DeviceShape {
 public:
    explicit DeviceShape(const FlatShape& s)
        : vertex_x_(to_device(s.vertex_x)),
          vertex_y_(to_device(s.vertex_y)),
          vertex_z_(to_device(s.vertex_z)),
          normal_x_(to_device(s.normal_x)),
          normal_y_(to_device(s.normal_y)),
          normal_z_(to_device(s.normal_z)),
          offset_(to_device(s.offset)),
          fdem_weight_(to_device(s.fdem_weight)),
          face_start_(to_device(s.face_start)),
          face_vertex_(to_device(s.face_vertex)),
          is_internal_(to_device(s.is_internal)) {}

    ConvexView view_like(const ConvexView& host) const {
        ConvexView view = host;
        view.vertex_x = vertex_x_.data();
        view.vertex_y = vertex_y_.data();
        view.vertex_z = vertex_z_.data();
        view.normal_x = normal_x_.data();
        view.normal_y = normal_y_.data();
        view.normal_z = normal_z_.data();
        view.offset = offset_.data();
        view.fdem_weight = fdem_weight_.data();
        view.face_start = face_start_.data();
        view.face_vertex = face_vertex_.data();
        view.is_internal = is_internal_.data();
        return view;
    }

 private:
    template <class T>
    static DeviceArray<T> to_device(const std::vector<T>& host) {
        return DeviceArray<T>{std::span<const T>(host)};
    }
    DeviceArray<double> vertex_x_, vertex_y_, vertex_z_, normal_x_, normal_y_, normal_z_, offset_, fdem_weight_;
    DeviceArray<std::int32_t> face_start_, face_vertex_;
    DeviceArray<std::uint8_t> is_internal_;
};

ConvexView host_view(const FlatShape& s) {
    ConvexView view{static_cast<std::int32_t>(s.vertex_x.size()),
                    static_cast<std::int32_t>(s.offset.size()),
                    s.vertex_x.data(),
                    s.vertex_y.data(),
                    s.vertex_z.data(),
                    s.normal_x.data(),
                    s.normal_y.data(),
                    s.normal_z.data(),
                    s.offset.data(),
                    s.fdem_weight.data(),
                    s.face_start.data(),
                    s.face_vertex.data(),
                    s.is_internal.data(),
                    s.inscribed_radius,
                    s.circumradius,
                    0,
                    false,
                    false,
                    false};
    view.is_planar = riprap::geometry::is_planar_prism(view);
    view.is_sharp = riprap::geometry::has_sharp_edges(view);
    return view;
}

/// Two shapes at two poses.
struct Placement {
    std::int32_t shape_a, shape_b;
    Frame frame_a, frame_b;
};

/// Bytes to compare: outcome and every number of the contact. No padding, so that bytes can be compared.
struct Result {
    std::int64_t outcome;
    NormalContact contact;
};

struct FindContact {
    const ConvexView* shapes;
    const Placement* placements;
    Result* results;
    DistancePotentialOptions options;

    RIPRAP_HD void operator()(std::int64_t i) const {
        const Placement& p = placements[i];
        Result result{};
        result.outcome = static_cast<std::int64_t>(riprap::contact::plain::find_contact<24>(
            shapes[p.shape_a], p.frame_a, 2e7, shapes[p.shape_b], p.frame_b, 3e7, options, result.contact));
        results[i] = result;
    }
};

std::vector<Placement> random_placements(std::size_t count, std::int32_t shape_count) {
    std::mt19937_64 random(21);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    const auto vector = [&](double size) {
        return size * Vec3{coordinate(random), coordinate(random), coordinate(random)};
    };
    std::vector<Placement> placements(count);
    for (std::size_t i = 0; i < count; ++i) {
        Placement& p = placements[i];
        p.shape_a = static_cast<std::int32_t>(random() % static_cast<std::uint64_t>(shape_count));
        p.shape_b = static_cast<std::int32_t>(random() % static_cast<std::uint64_t>(shape_count));
        // Every fourth pair keeps its axes: coplanar faces and parallel edges take other branches than general ones.
        const bool is_aligned = i % 4 == 0;
        const auto pose = [&](double spread) {
            return riprap::contact::to_frame(
                {vector(spread), is_aligned ? riprap::Quat{} : riprap::from_rotation_vector(vector(3))});
        };
        p.frame_a = pose(0.0);
        p.frame_b = pose(1.2);
    }
    return placements;
}

/// The shapes of few_shapes on both sides.
struct BothShapes {
    std::vector<FlatShape> shapes{few_shapes()};
    std::vector<std::unique_ptr<DeviceShape>> device_shapes;
    std::vector<ConvexView> views;
    DeviceArray<ConvexView> views_there;

    BothShapes() {
        std::vector<ConvexView> device_views;
        for (const FlatShape& shape : shapes) {
            device_shapes.push_back(std::make_unique<DeviceShape>(shape));
            views.push_back(host_view(shape));
            device_views.push_back(device_shapes.back()->view_like(views.back()));
        }
        views_there = DeviceArray<ConvexView>{std::span<const ConvexView>(device_views)};
    }
};

}  // namespace

void time_contacts() {
    const BothShapes both;
    const std::vector<Placement> placements = random_placements(200'000, static_cast<std::int32_t>(both.views.size()));
    const auto n = static_cast<std::int64_t>(placements.size());
    const DeviceArray<Placement> placements_there{std::span<const Placement>(placements)};
    DeviceArray<Result> results_there(placements.size());
    const double seconds = seconds_of([&] {
        parallel::device::for_each(n, FindContact{both.views_there.data(), placements_there.data(),
                                                  results_there.data(), DistancePotentialOptions{}});
    });
    std::printf("%lld pairs of blocks, half of them touching: %.3f ms, %.1f ns a pair\n", static_cast<long long>(n),
                1e3 * seconds, 1e9 * seconds / static_cast<double>(n));
}

bool check_contact() {
    const BothShapes both;
    const std::vector<ConvexView>& views = both.views;
    const DeviceArray<ConvexView>& views_there = both.views_there;
    const std::vector<Placement> placements = random_placements(20'000, static_cast<std::int32_t>(views.size()));
    const auto n = static_cast<std::int64_t>(placements.size());
    const DeviceArray<Placement> placements_there{std::span<const Placement>(placements)};
    DeviceArray<Result> results_there(placements.size());
    std::vector<Result> results(placements.size());

    bool ok = true;
    for (const auto potential : {riprap::contact::Potential::distance, riprap::contact::Potential::fdem}) {
        DistancePotentialOptions options;
        options.potential = potential;
        parallel::for_each(n, FindContact{views.data(), placements.data(), results.data(), options});
        parallel::device::for_each(
            n, FindContact{views_there.data(), placements_there.data(), results_there.data(), options});
        std::int64_t touching = 0, overflowing = 0;
        for (const Result& result : results) {
            touching += result.outcome == static_cast<std::int64_t>(riprap::contact::plain::Outcome::touching);
            overflowing += result.outcome == static_cast<std::int64_t>(riprap::contact::plain::Outcome::overflow);
        }
        ok &= touching > n / 4 && overflowing == 0;
        char name[120];
        std::snprintf(name, sizeof name, "%s potential, %lld pairs, %lld of them touching",
                      potential == riprap::contact::Potential::distance ? "distance" : "FDEM",
                      static_cast<long long>(n), static_cast<long long>(touching));
        ok &= same_bits(name, results, results_there.download());
    }
    return ok;
}

}  // namespace selftest
