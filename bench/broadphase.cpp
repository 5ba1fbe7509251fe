// SPDX-License-Identifier: Apache-2.0
//
// How long the search for candidate pairs takes against the number of bodies: MultilevelGrid, one uniform grid for all
// sizes, and brute force. Every scene is searched by all three where that is affordable, and the pair counts must
// agree.
//
//     bench_broadphase [threads]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "riprap/contact/broadphase/brute_force.hpp"
#include "riprap/contact/broadphase/multilevel_grid.hpp"
#include "riprap/contact/broadphase/pair_cache.hpp"
#include "riprap/contact/broadphase/single_grid.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/timer.hpp"

namespace {

using namespace riprap;
using namespace riprap::contact;

struct Bodies {
    std::vector<Vec3> center;
    std::vector<double> radius;
    std::vector<std::int32_t> body;
    std::vector<std::uint8_t> is_mobile;
    PartBounds bounds() const { return {center, radius, body, is_mobile}; }
};

/// A mix of two sizes: radius 1 and 0.1 [m], with a share of big ones.
struct Mix {
    const char* name;
    double big_share;         ///< by number [-]
    double sphere_fraction;   ///< volume of bounding spheres over volume of the box, at `full_count` or always [-]
    std::int32_t full_count;  ///< > 0: the box stays that of so many bodies, density grows with n
    double big_radius;        ///< [m]; the small one is a tenth
};

Bodies scatter(const Mix& mix, std::int32_t count) {
    const double small_radius = 0.1 * mix.big_radius;
    const auto volume_of = [&](double n) {
        const double per_body =
            mix.big_share * std::pow(mix.big_radius, 3) + (1 - mix.big_share) * std::pow(small_radius, 3);
        return n * 4.0 / 3.0 * M_PI * per_body / mix.sphere_fraction;
    };
    const double side = std::cbrt(volume_of(mix.full_count > 0 ? mix.full_count : count));
    std::mt19937_64 engine(static_cast<std::uint64_t>(count));
    std::uniform_real_distribution<double> coordinate(0, side);
    Bodies bodies;
    const auto big_count = static_cast<std::int32_t>(std::lround(mix.big_share * count));
    for (std::int32_t i = 0; i < count; ++i) {
        // Big ones evenly among the numbers, as in a scene read from a file.
        const bool is_big =
            static_cast<std::int64_t>(i + 1) * big_count / count > static_cast<std::int64_t>(i) * big_count / count;
        const double x = coordinate(engine), y = coordinate(engine), z = coordinate(engine);
        bodies.center.push_back({x, y, z});
        bodies.radius.push_back(is_big ? mix.big_radius : small_radius);
        bodies.body.push_back(i);
        bodies.is_mobile.push_back(1);
    }
    return bodies;
}

/// Seconds that pass: of this process's own work on one thread, which other programs on the machine do not disturb,
/// and on the wall with more.
double now() {
    if (parallel::thread_count() == 1) {
        return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    }
    static const Timer timer;
    return timer.seconds();
}

/// Median time of one call [s], over at least `least_calls` and 0.3 s; the first call, which grows buffers, is not
/// counted.
double median_seconds(const std::function<void()>& call, std::size_t least_calls = 5) {
    call();
    std::vector<double> times;
    for (const double start = now(); times.size() < least_calls || now() - start < 0.3;) {
        const double before = now();
        call();
        times.push_back(now() - before);
    }
    std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
    return times[times.size() / 2];
}

/// Slope of log t against log n by least squares.
double log_log_slope(const std::vector<double>& n, const std::vector<double>& t) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < n.size(); ++i) {
        const double x = std::log(n[i]), y = std::log(t[i]);
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    const auto m = static_cast<double>(n.size());
    return (m * sxy - sx * sy) / (m * sxx - sx * sx);
}

constexpr double skin = 0.01;  // [m], a tenth of the small radius

void check(const char* method, std::size_t found, std::size_t expected) {
    if (found != expected) {
        std::fprintf(stderr, "%s finds %zu pairs instead of %zu\n", method, found, expected);
        std::exit(1);
    }
}

void measure(const Mix& mix, const std::vector<std::int32_t>& counts) {
    std::printf("\n%s\n%8s %10s %12s %12s %12s %10s %10s\n", mix.name, "n", "pairs/n", "multilevel", "single grid",
                "brute force", "/single", "/brute");
    std::vector<double> n, t;
    for (const std::int32_t count : counts) {
        const Bodies bodies = scatter(mix, count);
        MultilevelGrid multilevel;
        std::vector<PartPair> pairs, others;
        const double time = median_seconds([&] { multilevel.find_pairs(bodies.bounds(), {}, skin, 2, pairs); });
        SingleGrid single;
        const double single_time = median_seconds([&] { single.find_pairs(bodies.bounds(), skin, others); }, 1);
        check("single grid", others.size(), pairs.size());
        double brute_time = 0;
        if (count <= 10'000) {
            brute_time = median_seconds([&] { others = find_pairs_brute_force(bodies.bounds(), {}, skin); }, 1);
            check("brute force", others.size(), pairs.size());
        }
        const double scale = 1e9 / count;
        std::printf("%8d %10.2f %9.0f ns %9.0f ns %9.0f ns %9.1fx %9.1fx\n", count,
                    static_cast<double>(pairs.size()) / count, time * scale, single_time * scale, brute_time * scale,
                    single_time / time, brute_time / time);
        n.push_back(count);
        t.push_back(time);
    }
    std::printf("log-log slope of the multi-level grid: %.3f\n", log_log_slope(n, t));
}

/// A dense pile as a step sees it: mostly a check of displacements, rarely a search.
void measure_cache(std::int32_t count) {
    const Bodies bodies = scatter({"", 1, 0.9, 0, 1}, count);
    PairCache cache;
    const double check_time = median_seconds([&] { cache.update(bodies.bounds(), {}, {.skin = 0.1}); });
    std::vector<double> widths{0.1, 0.1000001};
    std::size_t turn = 0;
    const double search_time = median_seconds([&] { cache.update(bodies.bounds(), {}, {.skin = widths[turn++ % 2]}); });
    std::printf("\npair cache, %d equal bodies in a dense pile, %.1f pairs a body\n", count,
                static_cast<double>(cache.pairs().size()) / count);
    std::printf("check %.1f ns a body, search and links %.0f ns a body, %.0f bytes a body\n", check_time * 1e9 / count,
                search_time * 1e9 / count, static_cast<double>(cache.bytes()) / count);
}

}  // namespace

int main(int argc, char** argv) {
    parallel::set_thread_count(argc > 1 ? std::atoi(argv[1]) : 1);
    std::printf("times per body and search, %d threads\n", parallel::thread_count());
    const std::vector<std::int32_t> decades{1000, 2000, 5000, 10'000, 20'000, 50'000, 100'000};
    measure({"10 % big by number, constant density", 0.1, 0.5, 0, 1}, decades);
    measure({"equal volumes of big and small, constant density", 1.0 / 1001, 0.9, 0, 1}, decades);
    measure({"10 % big by number, fixed box: density grows with n", 0.1, 0.5, 100'000, 1}, decades);
    measure({"cubes of 1.0 and 0.1, 10 % big: the published timing", 0.1, 0.5, 0, 0.8660254037844386},
            {1000, 2000, 3000, 4000, 5000, 6000});
    measure_cache(10'000);
    measure_cache(100'000);
}
