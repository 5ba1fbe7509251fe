// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/bench/benches.hpp"
#include "riprap/bench/measure.hpp"
#include "riprap/bench/spheres_scene.hpp"
#include "riprap/core/error.hpp"

namespace riprap::bench {

namespace {

using solid::sphere_dem::SphereWorld;

/// Bytes that a step has to move per sphere: pose, velocity and momentum read and written twice (224 B a time), its
/// record (96 B written, read once), loads and their rows (96 + 64 B); per contact key, spring and rows of its ends (8
/// + 2 x 32 + 8 B), a record (96 B) and two rows (2 x 64 B); per candidate its two numbers (8 B).
double bytes_per_step(double spheres, double contacts, double candidates) {
    return spheres * (2 * 224 + 2 * 96 + 96 + 64) + contacts * 304 + candidates * 8;
}

void step(SphereWorld& world, int count) {
    for (int k = 0; k < count; ++k) {
        const auto report = world.step(sphere_bed_dt);
        if (!report.problem.empty()) {
            throw InternalError("the bed of spheres: " + report.problem);
        }
    }
}

void measure_bed(const Setting& setting, const std::string& name, const SphereWorld& bed,
                 std::vector<Result>& results) {
    const auto spheres = static_cast<double>(bed.spheres.size());
    const int batch = std::max(2, static_cast<int>(2e6 / spheres));
    for (std::size_t t = 0; t < setting.thread_counts.size(); ++t) {
        const int threads = setting.thread_counts[t];
        SphereWorld world = bed;
        Timing timing;
        {
            const ThreadScope scope(threads);
            step(world, 3 * batch);
            timing = time_calls([&] { step(world, batch); }, {7, 1.0});
        }
        const double seconds = timing.median / batch, per_step = 1e9 * seconds / spheres;
        const auto contacts = static_cast<double>(world.contacts.contacts.size());
        const auto candidates = static_cast<double>(world.scratch.slots.count);
        std::string note;
        if (threads == 1) {
            note = fmt::format("{:.1f} ns scaled to the reference core; ", per_step * core_speed(setting.machine));
        }
        note += fmt::format("{:.0f} spheres, {:.2f} contacts and {:.2f} candidates a sphere, fastest {:.1g} m/s; ",
                            spheres, contacts / spheres, candidates / spheres, world.report.kick.max_speed);
        if (t < setting.machine.by_threads.size() && setting.machine.by_threads[t].triad > 0) {
            const double share =
                bytes_per_step(spheres, contacts, candidates) / seconds / setting.machine.by_threads[t].triad;
            note += fmt::format("{:.0f} % of the bandwidth; ", 100 * share);
        }
        results.push_back({name, threads, per_step, "ns", note + spread(timing)});
        if (threads > 1) {
            SphereWorld one = bed, many = bed;
            add_speedup(
                name, threads, [&] { step(one, batch); }, [&] { step(many, batch); }, results, 15);
        }
    }
}

}  // namespace

void spheres_10k(const Setting& setting, std::vector<Result>& results) {
    measure_bed(setting, "spheres.10k", sphere_bed(1, 1), results);
}
void spheres_100k(const Setting& setting, std::vector<Result>& results) {
    measure_bed(setting, "spheres.100k", sphere_bed(5, 2), results);
}

}  // namespace riprap::bench
