// SPDX-License-Identifier: Apache-2.0
#include <numeric>
#include <random>

#include "checks.hpp"
#include "riprap/core/parallel_device.hpp"
#include "riprap/core/vec3.hpp"

namespace selftest {
namespace {

using riprap::Vec3;
namespace parallel = riprap::parallel;
using parallel::device::DeviceArray;

/// out[i] = a unit vector and its cross product with a neighbour: square roots, divisions, products and sums.
struct Directions {
    const Vec3* in;
    Vec3* out;
    std::int64_t n;
    RIPRAP_HD void operator()(std::int64_t i) const {
        const Vec3 a = riprap::normalized(in[i]);
        out[i] = a * 0.1 + riprap::cross(a, in[(i + 1) % n]);
    }
};

struct Entry {
    const Vec3* values;
    RIPRAP_HD Vec3 operator()(std::int64_t i) const { return values[i]; }
};
struct Smallest {
    RIPRAP_HD Vec3 operator()(const Vec3& a, const Vec3& b) const { return riprap::min(a, b); }
};

std::vector<Vec3> random_vectors(std::size_t count) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    std::vector<Vec3> values(count);
    for (Vec3& v : values) {
        const double scale = std::ldexp(1.0, static_cast<int>(random() % 60) - 30);
        v = scale * Vec3{coordinate(random), coordinate(random), coordinate(random)};
    }
    return values;
}

bool check_loops_and_sums(std::int64_t n) {
    const std::vector<Vec3> input = random_vectors(static_cast<std::size_t>(n));
    std::vector<Vec3> host(input.size());
    parallel::for_each(n, Directions{input.data(), host.data(), n});
    const DeviceArray<Vec3> device_input{std::span<const Vec3>(input)};
    DeviceArray<Vec3> device(input.size());
    parallel::device::for_each(n, Directions{device_input.data(), device.data(), n});

    char name[64];
    std::snprintf(name, sizeof name, "for_each over %lld vectors", static_cast<long long>(n));
    bool ok = same_bits(name, host, device.download());

    const Vec3 largest{1e300, 1e300, 1e300};
    std::snprintf(name, sizeof name, "sum of %lld vectors", static_cast<long long>(n));
    ok &= same_bits<Vec3>(name, {parallel::sum(n, Entry{input.data()})},
                          {parallel::device::sum(n, Entry{device_input.data()})});
    std::snprintf(name, sizeof name, "reduce, smallest of %lld vectors", static_cast<long long>(n));
    ok &= same_bits<Vec3>(name, {parallel::reduce(n, largest, Entry{input.data()}, Smallest{})},
                          {parallel::device::reduce(n, largest, Entry{device_input.data()}, Smallest{})});
    return ok;
}

bool check_scan(std::size_t n) {
    std::mt19937_64 random(12);
    std::vector<std::int32_t> host(n);
    for (std::int32_t& value : host) {
        value = static_cast<std::int32_t>(random() % 100) - 20;
    }
    DeviceArray<std::int32_t> device{std::span<const std::int32_t>(host)};
    std::vector<std::int32_t> totals(2);
    totals[1] = parallel::device::exclusive_scan(device, device);
    totals[0] = parallel::exclusive_scan<std::int32_t>(host, host);
    bool ok = same_bits("exclusive_scan in place", host, device.download());
    ok &= same_bits<std::int32_t>("exclusive_scan, total", {totals[0]}, {totals[1]});
    return ok;
}

bool check_sort(std::size_t n) {
    std::mt19937_64 random(13);
    std::vector<std::uint64_t> keys(n), scratch_keys;
    std::vector<std::uint32_t> values(n), scratch_values;
    for (std::uint64_t& key : keys) {
        key = random() % 5000 | (random() % 7) << 58;  // many ties: only a stable sort gives one answer
    }
    std::iota(values.begin(), values.end(), 0U);
    DeviceArray<std::uint64_t> device_keys{std::span<const std::uint64_t>(keys)};
    DeviceArray<std::uint32_t> device_values{std::span<const std::uint32_t>(values)};
    parallel::sort_by_key(keys, values, scratch_keys, scratch_values);
    parallel::device::sort_by_key(device_keys, device_values);
    bool ok = same_bits("sort_by_key, keys", keys, device_keys.download());
    ok &= same_bits("sort_by_key, values of equal keys in their old order", values, device_values.download());
    return ok;
}

}  // namespace

bool check_parallel() {
    bool ok = true;
    for (const std::int64_t n : {std::int64_t{1}, parallel::reduce_block, std::int64_t{1'000'003}}) {
        ok &= check_loops_and_sums(n);
    }
    ok &= check_scan(1'000'003);
    ok &= check_sort(1'000'003);
    return ok;
}

}  // namespace selftest
