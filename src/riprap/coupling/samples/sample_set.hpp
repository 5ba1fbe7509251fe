// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "riprap/core/error.hpp"
#include "riprap/core/ids.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/vec3.hpp"
#include "riprap/coupling/samples/column.hpp"

namespace riprap::coupling {

/// Points of the solids that a fluid feels and that carry its loads back: the only place where both sides meet. Made
/// once from the shapes, in the order of the bodies; what they are attached to moves them and takes their loads by the
/// transpose of the same map (rigid: force and torque; deformable: T(x)^T f), so power is conserved.
struct SampleSet {
    Column<BodyId> body;
    PlaceColumn anchor;                ///< place in the body frame [m]
    Column<Vec3> normal;               ///< outward, body frame [-]
    Column<double> depth;              ///< below the surface, positive inside [m]
    Column<double> volume;             ///< [m^3]; in 2D [m^2]
    Column<std::uint8_t> is_slippery;  ///< free slip
    /// Lies in so many still bodies that no way is along the faces of all of them: three in space, two in a plane.
    Column<std::uint8_t> is_in_vertex;

    std::int64_t size() const { return static_cast<std::int64_t>(anchor.size()); }
    /// Calls work(column) with each column.
    template <class Work>
    void for_each_column(const Work& work) {
        work(body);
        work(anchor);
        work(normal);
        work(depth);
        work(volume);
        work(is_slippery);
        work(is_in_vertex);
    }
    /// Makes it small, once it is complete: most of its values are those of other samples too.
    void pack() {
        for_each_column([](auto& column) { column.pack(); });
    }
    std::size_t bytes() const {
        return body.bytes() + anchor.bytes() + normal.bytes() + depth.bytes() + volume.bytes() + is_slippery.bytes() +
               is_in_vertex.bytes();
    }
};

/// All samples of a set or those of some numbers, in rising order: a look at them, without a copy. Entry i is what
/// callers count by; number(i) is its place in the set. The set and the numbers have to outlive it.
class SampleView {
 public:
    SampleView() = default;  ///< of none
    SampleView(const SampleSet& all)
        : all_(&all), size_(all.size()), is_whole_(true) {}  // NOLINT(google-explicit-constructor): a set is a view
    SampleView(SampleSet&&) = delete;
    SampleView(const SampleSet& all, std::span<const std::int32_t> numbers)
        : all_(&all), numbers_(numbers), size_(static_cast<std::int64_t>(numbers.size())) {
        RIPRAP_ASSERT(std::is_sorted(numbers.begin(), numbers.end()), "numbers of samples");
    }
    SampleView(SampleSet&&, std::span<const std::int32_t>) = delete;

    std::int64_t size() const { return size_; }
    std::size_t number(std::size_t i) const { return is_whole_ ? i : at(numbers_[i]); }
    BodyId body(std::size_t i) const { return all_->body[number(i)]; }
    Vec3 anchor(std::size_t i) const { return all_->anchor[number(i)]; }
    Vec3 normal(std::size_t i) const { return all_->normal[number(i)]; }
    double depth(std::size_t i) const { return all_->depth[number(i)]; }
    double volume(std::size_t i) const { return all_->volume[number(i)]; }
    std::uint8_t is_slippery(std::size_t i) const { return all_->is_slippery[number(i)]; }
    std::uint8_t is_in_vertex(std::size_t i) const { return all_->is_in_vertex[number(i)]; }
    /// The first entry whose body is `wanted` or a later one; samples are in the order of the bodies.
    std::size_t begin_of(BodyId wanted) const {
        std::size_t low = 0, high = at(size_);
        while (low < high) {
            const std::size_t middle = low + (high - low) / 2;
            if (body(middle) < wanted) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

 private:
    const SampleSet* all_{nullptr};
    std::span<const std::int32_t> numbers_;
    std::int64_t size_{0};
    bool is_whole_{false};
};

}  // namespace riprap::coupling
