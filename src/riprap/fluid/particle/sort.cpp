// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sort.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "riprap/core/error.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/sweep/cell_grid.hpp"

namespace riprap::fluid {

namespace {

constexpr int bits_per_axis = 21;  ///< 2^21 steps along each axis; three axes fit into 63 bits

/// Place of a lattice point on Hilbert's curve through 2^bits points per axis, by undoing the turns of the curve from
/// the coarsest cube to the finest [Skilling2004].
std::uint64_t place_on_curve(std::array<std::uint32_t, 3> x, int dimension) {
    const auto n = static_cast<std::size_t>(dimension);
    for (std::uint32_t bit = 1U << (bits_per_axis - 1); bit > 1; bit >>= 1) {
        const std::uint32_t below = bit - 1;
        for (std::size_t axis = 0; axis < n; ++axis) {
            if ((x[axis] & bit) != 0) {
                x[0] ^= below;
            } else {
                const std::uint32_t swap = (x[0] ^ x[axis]) & below;
                x[0] ^= swap;
                x[axis] ^= swap;
            }
        }
    }
    for (std::size_t axis = 1; axis < n; ++axis) {
        x[axis] ^= x[axis - 1];
    }
    std::uint32_t flip = 0;
    for (std::uint32_t bit = 1U << (bits_per_axis - 1); bit > 1; bit >>= 1) {
        if ((x[n - 1] & bit) != 0) {
            flip ^= bit - 1;
        }
    }
    std::uint64_t key = 0;
    for (int b = bits_per_axis - 1; b >= 0; --b) {
        for (std::size_t axis = 0; axis < n; ++axis) {
            key = (key << 1) | (((x[axis] ^ flip) >> b) & 1U);
        }
    }
    return key;
}

template <class T>
void permute(std::vector<T>& values, const std::vector<std::uint32_t>& order) {
    std::vector<T> sorted(values.size());
    parallel::for_each(static_cast<std::int64_t>(values.size()), [&](std::int64_t i) {
        const auto k = static_cast<std::size_t>(i);
        sorted[k] = values[order[k]];
    });
    values.swap(sorted);
}

/// Permutes the fields.
struct Permute {
    const std::vector<std::uint32_t>& order;

    template <class T>
    void operator()(std::string_view, std::vector<T>& values) const {
        if (values.empty()) {
            return;  // a field that this scheme has not
        }
        if (values.size() != order.size()) {
            throw InternalError("a field of the fluid is not as long as there are particles");
        }
        permute(values, order);
    }
    void operator()(std::string_view, double&) const {}
    void operator()(std::string_view, std::int64_t&) const {}
    void operator()(std::string_view, std::uint64_t&) const {}
};

}  // namespace

std::vector<std::uint32_t> order_by_place(std::span<const Vec3> points, const Domain& domain, double spacing) {
    const Box box = box_of(points);
    const double most = static_cast<double>((1U << bits_per_axis) - 1);
    double step = 0.5 * spacing;  // finer than particles lie apart, coarse enough for few passes of the sort
    for (int axis = 0; axis < domain.dimension; ++axis) {
        step = std::max(step, (box.high[axis] - box.low[axis]) / most);
    }
    std::vector<std::uint64_t> keys(points.size()), key_buffer;
    std::vector<std::uint32_t> order(points.size()), order_buffer;
    parallel::for_each(static_cast<std::int64_t>(points.size()), [&](std::int64_t i) {
        const auto k = static_cast<std::size_t>(i);
        std::array<std::uint32_t, 3> lattice{};
        for (int axis = 0; is_finite(points[k]) && axis < domain.dimension; ++axis) {
            lattice[static_cast<std::size_t>(axis)] =
                static_cast<std::uint32_t>(std::min(most, (points[k][axis] - box.low[axis]) / step + 0.5));
        }
        keys[k] = place_on_curve(lattice, domain.dimension);
        order[k] = static_cast<std::uint32_t>(i);
    });
    parallel::sort_by_key(keys, order, key_buffer, order_buffer);
    return order;
}

void sort_by_place(ParticleState& state, const Domain& domain, double spacing) {
    const std::vector<std::uint32_t> order = order_by_place(state.position, domain, spacing);
    ParticleState::visit_fields(state, Permute{order});
    state.flow.stamp = ~state.flow.stamp;  // what is kept of the geometry has the old order
}

}  // namespace riprap::fluid
