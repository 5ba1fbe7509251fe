// SPDX-License-Identifier: Apache-2.0
// Times sums over neighbours, whole steps and contacts on the device, beside its bandwidth.
#include <thread>

#include "checks.hpp"
#include "riprap/core/parallel_device.hpp"
#include "riprap/fluid/particle/sweep/cell_sweep.hpp"
#include "riprap/fluid/sph/continuity.hpp"
#include "riprap/fluid/sph/device/device_sph.hpp"
#include "riprap/fluid/sph/momentum.hpp"
#include "riprap/fluid/sph/viscosity/artificial.hpp"
#include "seconds_of.hpp"
#include "some_tank.hpp"

namespace selftest {

namespace {

using namespace riprap::fluid;
using riprap::Vec3;
using riprap::parallel::device::Device;

struct CopyNumbers {
    const double* from;
    double* to;
    RIPRAP_HD void operator()(std::int64_t i) const { to[i] = from[i]; }
};

/// Bytes that the device copies in a second, read and written ones together.
double measured_bandwidth() {
    constexpr std::int64_t count = 1 << 26;
    Device::Array<double> from(count), to(count);
    const double seconds = seconds_of([&] { Device::for_each(count, CopyNumbers{from.data(), to.data()}); });
    return 2.0 * sizeof(double) * static_cast<double>(count) / seconds;
}

void report_sum(const char* name, std::size_t particles, double seconds, double bytes, double bandwidth) {
    std::printf("  %-28s %8.3f ms  %7.3f ns/particle  %5.1f %% of the bandwidth for what it must move\n", name,
                1e3 * seconds, 1e9 * seconds / static_cast<double>(particles), 100 * bytes / seconds / bandwidth);
}

template <class Pair>
void time_sum(const char* name, const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& side,
              CellPairs<Device>& pairs, double bandwidth) {
    const std::size_t n = side.position.size();
    Device::Array<float> sums(Pair::sums * n);
    std::array<FieldSink, Pair::sums> sinks;
    for (std::size_t k = 0; k < sinks.size(); ++k) {
        sinks[k] = {nullptr, Pair::sums, true, sums.data() + k};
    }
    const double seconds = seconds_of([&] { cell_sweep(pair, reach, side, side, sinks, pairs); });
    const double each = 16 + 24 + 4 + 4.0 * Pair::target_fields + 4.0 * Pair::sums;  // place, position, order
    report_sum(name, n, seconds, each * static_cast<double>(n), bandwidth);
}

void time_water(int count, double bandwidth) {
    Tank tank = some_tank(count);
    const std::size_t n = tank.water.position.size();
    const SphSettings& settings = tank.settings;
    const SweepReach reach{settings.support_radius(), settings.domain};
    const WendlandC2 kernel(settings.smoothing_length(), 3);
    Device::Array<Vec3> position, walls;
    Device::upload<Vec3>(tank.water.position, position);
    Device::upload<Vec3>(tank.walls.position, walls);
    Device::Array<float> numbers;
    Device::upload<float>(std::vector<float>(12 * n, 1.0F), numbers);
    CellLists<Device> lists;
    const Box box = box_of(tank.water.position), box_of_walls = box_of(tank.walls.position);
    std::printf("%zu particles of water, %zu of walls\n", n, tank.walls.position.size());
    const double placing = seconds_of([&] {
        lists.place(reach, box, {position.data(), n}, box_of_walls, {walls.data(), tank.walls.position.size()});
    });
    report_sum("cells", n + tank.walls.position.size(), placing,
               (24.0 + 16 + 12) * static_cast<double>(n + tank.walls.position.size()), bandwidth);
    SweepSide<5> five{{position.data(), n}, {}};
    SweepSide<12> twelve{{position.data(), n}, {}};
    for (std::size_t k = 0; k < twelve.fields.size(); ++k) {
        twelve.fields[k] = {nullptr, 12, numbers.data() + k};
        five.fields[k % 5] = twelve.fields[k];
    }
    time_sum("sums of density", Continuity{kernel, {0, 0, -9810}, 1e-8}, reach, five, lists.fluid_fluid, bandwidth);
    using Law = ArtificialViscosity::Pair;
    time_sum("sums of forces", Momentum<WendlandC2, Law>{kernel, {1, 1e-6, 1, 0}}, reach, twelve, lists.fluid_fluid,
             bandwidth);
    const auto scheme = make_device_scheme(settings);
    const double step = seconds_of([&] { tank.step(*scheme); });
    std::printf("  %-28s %8.3f ms  %7.3f ns/particle, copies to and from the host included\n", "whole step", 1e3 * step,
                1e9 * step / static_cast<double>(n));
}

}  // namespace

void time_kernels() {
    const double bandwidth = measured_bandwidth();
    riprap::parallel::set_thread_count(static_cast<int>(std::thread::hardware_concurrency()));
    std::printf("bandwidth: %.0f GB/s; %d threads of the host\n", 1e-9 * bandwidth, riprap::parallel::thread_count());
    for (const int count : {70, 128, 200}) {
        time_water(count, bandwidth);
    }
    time_contacts();
}

}  // namespace selftest
