// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/samples/near_samples.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/sweep/lanes.hpp"

namespace riprap::coupling {

namespace {

using Cell = std::array<std::int64_t, 3>;

/// Cells about the water, and whether there is water within two of them.
class WetCells {
 public:
    using Places = std::array<std::span<const Vec3>, 2>;

    WetCells(const Places& water, const fluid::Domain& domain, double reach) : domain_(domain) {
        span_box(water, reach);
        choose_cells(0.5 * reach, water[0].size() + water[1].size());
        wet_.assign(at(counts_[0] * counts_[1] * counts_[2]), 0);
        for (const std::span<const Vec3> places : water) {
            parallel::for_each(std::ssize(places), [&](std::int64_t i) {
                Cell cell{};
                if (is_finite(places[at(i)]) && find(places[at(i)], cell)) {
                    wet(cell);
                }
            });
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            spread(axis);
        }
    }

    bool has_water_near(const Vec3& x) const {
        Cell cell{};
        return find(x, cell) && wet_[entry(cell)] != 0;
    }

 private:
    struct Extent {
        Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    };
    static Extent join(const Extent& a, const Extent& b) { return {min(a.low, b.low), max(a.high, b.high)}; }

    /// Many threads may meet in one cell; they all write the same.
    void wet(const Cell& cell) {
        const std::atomic_ref<std::uint8_t> mark(wet_[entry(cell)]);
        if (mark.load(std::memory_order_relaxed) == 0) {  // a line that is only read stays in the caches of all
            mark.store(1, std::memory_order_relaxed);
        }
    }

    /// The water within the domain, with two reaches about it; along periodic axes the domain. Water that has left it
    /// ends the step soon after, and must not make cells without end before.
    void span_box(const Places& water, double reach) {
        Extent all;
        for (const std::span<const Vec3> places : water) {
            const auto extent_of = [&](std::int64_t i) {
                const Vec3& x = places[at(i)];
                return is_finite(x) ? Extent{x, x} : Extent{};
            };
            all = join(all, parallel::reduce(std::ssize(places), Extent{}, extent_of, join));
        }
        low_ = all.low;
        high_ = all.high;
        for (int axis = 0; axis < 3; ++axis) {
            if (axis >= domain_.dimension || !(low_[axis] <= high_[axis])) {
                low_[axis] = high_[axis] = 0;
            } else if (domain_.is_periodic[at(axis)]) {
                low_[axis] = domain_.low[axis];
                high_[axis] = domain_.high[axis];
            } else {
                low_[axis] = std::max(low_[axis], domain_.low[axis]) - 2 * reach;
                high_[axis] = std::min(high_[axis], domain_.high[axis]) + 2 * reach;
            }
        }
    }

    /// Cells of at least `side`, and not many more than there are particles: a few drops far apart must not fill the
    /// memory.
    void choose_cells(double side, std::size_t particles) {
        const double most = 1e5 + 64 * static_cast<double>(particles);
        for (;; side *= 1.5) {
            double all = 1;
            for (int axis = 0; axis < 3; ++axis) {
                const double count = std::max(1.0, std::floor((high_[axis] - low_[axis]) / side));
                counts_[at(axis)] = static_cast<std::int64_t>(std::min(count, 1e9));
                all *= count;
            }
            if (all <= most) {
                break;
            }
        }
        for (int axis = 0; axis < 3; ++axis) {
            const double width = (high_[axis] - low_[axis]) / static_cast<double>(counts_[at(axis)]);
            per_metre_[axis] = width > 0 ? 1 / width : 0;
        }
    }

    /// False where x lies outside all cells, which no water is near.
    bool find(const Vec3& x, Cell& cell) const {
        for (int axis = 0; axis < domain_.dimension; ++axis) {
            const std::int64_t count = counts_[at(axis)];
            const double place = std::floor((x[axis] - low_[axis]) * per_metre_[axis]);
            if (domain_.is_periodic[at(axis)]) {
                const auto turn = static_cast<double>(count);
                cell[at(axis)] =
                    std::min(count - 1, static_cast<std::int64_t>(place - turn * std::floor(place / turn)));
            } else if (place >= 0 && place < static_cast<double>(count)) {
                cell[at(axis)] = static_cast<std::int64_t>(place);
            } else {
                return false;
            }
        }
        return true;
    }

    std::size_t entry(const Cell& c) const { return at((c[2] * counts_[1] + c[1]) * counts_[0] + c[0]); }

    /// Every cell becomes wet that has a wet one up to two away along an axis.
    void spread(std::size_t axis) {
        const std::vector<std::uint8_t> before = wet_;
        const std::int64_t count = counts_[axis];
        const bool wraps = domain_.is_periodic[axis];
        Cell c{};
        for (c[2] = 0; c[2] < counts_[2]; ++c[2]) {
            for (c[1] = 0; c[1] < counts_[1]; ++c[1]) {
                for (c[0] = 0; c[0] < counts_[0]; ++c[0]) {
                    if (before[entry(c)] == 0) {
                        continue;
                    }
                    for (std::int64_t k = -2; k <= 2; ++k) {
                        Cell other = c;
                        const std::int64_t to = c[axis] + k;
                        other[axis] =
                            wraps ? ((to % count) + count) % count : std::clamp(to, std::int64_t{0}, count - 1);
                        wet_[entry(other)] = 1;
                    }
                }
            }
        }
    }

    const fluid::Domain& domain_;
    Vec3 low_{}, high_{}, per_metre_{};
    Cell counts_{1, 1, 1};
    std::vector<std::uint8_t> wet_;
};

}  // namespace

std::vector<std::int32_t> near_samples(const SampleSet& samples, const body::Motion& motion,
                                       std::span<const std::uint8_t> is_still, std::span<const Vec3> water,
                                       std::span<const Vec3> others, const fluid::Domain& domain, double reach,
                                       std::span<const std::uint8_t> is_far) {
    const WetCells cells({water, others}, domain, reach);
    std::vector<std::uint8_t> is_near(at(samples.size()));
    parallel::for_each(samples.size(), [&](std::int64_t index) {
        const auto i = at(index);
        const auto body = at(samples.body[i].value);
        const Pose& pose = motion.pose[body];
        if (!is_far.empty() && is_far[body] != 0) {
            return;
        }
        is_near[i] =
            is_still[body] == 0 || cells.has_water_near(pose.position + rotate(pose.orientation, samples.anchor[i]))
                ? 1
                : 0;
    });
    constexpr std::size_t four = fluid::cluster_size;
    std::vector<std::int32_t> numbers;
    numbers.reserve(at(std::ranges::count(is_near, 1)));
    for (std::size_t first = 0; first < is_near.size(); first += four) {
        const std::size_t end = std::min(is_near.size(), first + four);
        if (std::find(is_near.begin() + first, is_near.begin() + end, 1) != is_near.begin() + end) {
            for (std::size_t i = first; i < end; ++i) {
                numbers.push_back(static_cast<std::int32_t>(i));
            }
        }
    }
    return numbers;
}

std::vector<std::uint8_t> near_bodies(const SampleSet& samples, const body::Motion& motion,
                                      std::span<const std::uint8_t> asked, std::span<const Vec3> water,
                                      std::span<const Vec3> others, const fluid::Domain& domain, double reach) {
    const WetCells cells({water, others}, domain, reach);
    const SampleView all(samples);
    std::vector<std::uint8_t> is_near(asked.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(asked.size()), 16, [&](std::int64_t body) {
        if (asked[at(body)] == 0) {
            return;
        }
        const Pose& pose = motion.pose[at(body)];
        const auto number = static_cast<std::int32_t>(body);
        const std::size_t end = all.begin_of(BodyId{number + 1});
        for (std::size_t i = all.begin_of(BodyId{number}); i < end && is_near[at(body)] == 0; ++i) {
            is_near[at(body)] =
                cells.has_water_near(pose.position + rotate(pose.orientation, samples.anchor[i])) ? 1 : 0;
        }
    });
    return is_near;
}

}  // namespace riprap::coupling
