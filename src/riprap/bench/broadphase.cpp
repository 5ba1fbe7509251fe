// SPDX-License-Identifier: Apache-2.0
#include "riprap/bench/broadphase.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "riprap/bench/benches.hpp"
#include "riprap/bench/measure.hpp"
#include "riprap/contact/broadphase/brute_force.hpp"
#include "riprap/contact/broadphase/multilevel_grid.hpp"
#include "riprap/contact/broadphase/single_grid.hpp"
#include "riprap/core/error.hpp"
#include "riprap/geometry/polyhedra/random_bits.hpp"

namespace riprap::bench {

namespace {

struct Spheres {
    std::vector<Vec3> center;
    std::vector<double> radius;
    std::vector<std::int32_t> body;
    std::vector<std::uint8_t> is_mobile;
    contact::PartBounds bounds() const { return {center, radius, body, is_mobile}; }
};

constexpr double big_radius = 1, small_radius = 0.1;  // [m]
constexpr double skin = 0.01;                         // [m]

/// `count` bounding spheres thrown into a cube, every tenth one big; together they would fill half of it.
Spheres scatter(std::int32_t count) {
    const double mean_cube = (std::pow(big_radius, 3) + 9 * std::pow(small_radius, 3)) / 10;
    const double side = std::cbrt(count * 4.0 / 3.0 * std::numbers::pi * mean_cube / 0.5);
    const auto key = static_cast<std::uint64_t>(count);
    Spheres spheres;
    for (std::int32_t i = 0; i < count; ++i) {
        const auto draw = [&](int k) {
            return side * geometry::unit_interval(geometry::mix_bits(
                              key, 3 * static_cast<std::uint64_t>(i) + static_cast<std::uint64_t>(k)));
        };
        spheres.center.push_back({draw(0), draw(1), draw(2)});
        spheres.radius.push_back(i % 10 == 9 ? big_radius : small_radius);
        spheres.body.push_back(i);
        spheres.is_mobile.push_back(1);
    }
    return spheres;
}

void require_equal(std::size_t found, std::size_t expected, const char* method) {
    if (found != expected) {
        throw InternalError(fmt::format("{} finds {} pairs instead of {}", method, found, expected));
    }
}

/// Multi-level grid against one grid and brute force on the same spheres; the pair counts must agree.
void compare_searches(std::int32_t count, std::vector<Result>& results) {
    const Spheres spheres = scatter(count);
    std::vector<contact::PartPair> pairs, others;
    contact::MultilevelGrid levels;
    contact::SingleGrid single;
    const Timing ours = time_calls([&] { levels.find_pairs(spheres.bounds(), {}, skin, 2, pairs); });
    const Timing one_grid = time_calls([&] { single.find_pairs(spheres.bounds(), skin, others); }, {3, 0.2});
    require_equal(others.size(), pairs.size(), "the single grid");
    const Timing brute = time_calls([&] { others = find_pairs_brute_force(spheres.bounds(), {}, skin); }, {3, 0.2});
    require_equal(others.size(), pairs.size(), "brute force");
    const std::string note = fmt::format("{} bodies, {:.1f} pairs a body; {:.3g} ms a search, {}", count,
                                         static_cast<double>(pairs.size()) / count, 1e3 * ours.median, spread(ours));
    results.push_back({"broadphase.over_single_grid", 1, one_grid.median / ours.median, "-", note});
    results.push_back({"broadphase.over_brute_force", 1, brute.median / ours.median, "-", note});
}

}  // namespace

std::vector<double> search_times(Search search, std::span<const std::int32_t> counts) {
    std::vector<double> times;
    for (const std::int32_t count : counts) {
        const Spheres spheres = scatter(count);
        std::vector<contact::PartPair> pairs;
        contact::MultilevelGrid levels;
        contact::SingleGrid single;
        const auto find = [&] {
            if (search == Search::multilevel_grid) {
                levels.find_pairs(spheres.bounds(), {}, skin, 2, pairs);
            } else {
                single.find_pairs(spheres.bounds(), skin, pairs);
            }
        };
        times.push_back(time_calls(find).median);
    }
    return times;
}

double log_log_slope(std::span<const std::int32_t> counts, std::span<const double> times) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double x = std::log(counts[i]), y = std::log(times[i]);
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    const auto m = static_cast<double>(counts.size());
    return (m * sxy - sx * sy) / (m * sxx - sx * sx);
}

void broadphase_slope(const Setting& setting, std::vector<Result>& results) {
    for (const int threads : setting.thread_counts) {
        const ThreadScope scope(threads);
        constexpr std::array counts{1000, 2000, 5000, 10'000, 20'000, 50'000, 100'000};
        const std::vector<double> times = search_times(Search::multilevel_grid, counts);
        std::string each;
        for (std::size_t i = 0; i < counts.size(); ++i) {
            each += fmt::format("{}{}: {:.0f}", each.empty() ? "" : ", ", counts[i], 1e9 * times[i] / counts[i]);
        }
        results.push_back({"broadphase.slope", threads, log_log_slope(counts, times), "-",
                           "log of time against log of bodies, a tenth of them ten times the size of the others, "
                           "constant density; ns a body at " +
                               each});
    }
    const ThreadScope one(1);
    compare_searches(10'000, results);
}

}  // namespace riprap::bench
