// SPDX-License-Identifier: Apache-2.0
#pragma once

// The traversal of neighbours, as everybody calls it:
//
//     sweep(continuity, reach, {fluid.position, {component(fluid.velocity, 0), ...}},   // targets
//           {walls.position, {component(walls.velocity, 0), ..., field(walls.volume)}}, // candidates
//           {sink(rate)}, scratch.fluid_walls);
//
// adds what every candidate does to each target. The definition is in sweep_kernel.hpp, which only files of kernels
// include: each instantiates the sweeps of its own pair physics with RIPRAP_INSTANTIATE_SWEEP, and is listed in
// fluid/CMakeLists.txt for its flags.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "riprap/fluid/particle/sweep/domain.hpp"
#include "riprap/fluid/particle/sweep/pair_physics.hpp"

namespace riprap::fluid {

/// One number per particle, every `stride`-th of an array of either kind. Fast sweeps round it to float: what enters a
/// difference, such as density, is better given as the departure from its value at rest.
struct FieldView {
    const double* data{nullptr};
    std::int64_t stride{1};
    const float* narrow{nullptr};  ///< the numbers, where they are floats
    // Every `factor_stride`-th of these multiplies them, of the same kind; nullptr: 1.
    const double* factor{nullptr};
    const float* narrow_factor{nullptr};
    std::int64_t factor_stride{1};

    RIPRAP_HD double operator[](std::int64_t i) const {
        const double number = narrow != nullptr ? static_cast<double>(narrow[i * stride]) : data[i * stride];
        return narrow_factor != nullptr ? static_cast<double>(narrow_factor[i * factor_stride] * narrow[i * stride])
               : factor != nullptr      ? factor[i * factor_stride] * number
                                        : number;
    }
    /// Writes them for four particles that follow each other, as floats.
    void copy_four(std::int64_t first, float* four) const {
        for (std::int64_t member = 0; member < 4; ++member) {
            const std::int64_t i = first + member;
            four[member] = narrow != nullptr ? narrow[i * stride] : static_cast<float>((*this)[i]);
        }
        for (std::int64_t member = 0; narrow_factor != nullptr && member < 4; ++member) {
            four[member] *= narrow_factor[(first + member) * factor_stride];
        }
    }
};
inline FieldView field(std::span<const double> values) { return {values.data(), 1}; }
inline FieldView component(std::span<const Vec3> values, int axis) {
    return {values.empty() ? nullptr : &values[0].x + axis, 3};
}

/// Where one sum per particle is added: doubles, or floats that are rounded each time something was added.
struct FieldSink {
    double* data{nullptr};
    std::int64_t stride{1};
    bool is_fresh{false};  ///< the sum takes the place of what is there, whatever that is, as if it were zero
    float* narrow{nullptr};

    RIPRAP_HD double get(std::int64_t i) const {
        return narrow != nullptr ? static_cast<double>(narrow[i * stride]) : data[i * stride];
    }
    RIPRAP_HD void set(std::int64_t i, double sum) const {
        if (narrow != nullptr) {
            narrow[i * stride] = static_cast<float>(sum);
        } else {
            data[i * stride] = sum;
        }
    }
};
inline FieldSink sink(std::span<double> values) { return {values.data(), 1}; }
inline FieldSink sink_component(std::span<Vec3> values, int axis) {
    return {values.empty() ? nullptr : &values[0].x + axis, 3};
}
/// The same sinks, for sums that take the place of what is there.
template <std::size_t Count>
std::array<FieldSink, Count> fresh(std::array<FieldSink, Count> sinks) {
    for (FieldSink& each : sinks) {
        each.is_fresh = true;
    }
    return sinks;
}

/// Particles as one side of a sweep: places [m] and the numbers that the pair physics reads, in its order.
template <int FieldCount>
struct SweepSide {
    std::span<const Vec3> position;
    std::array<FieldView, static_cast<std::size_t>(FieldCount)> fields;
};

/// Parts one after the other.
template <class T, std::size_t... Counts>
std::array<T, (Counts + ...)> joined(const std::array<T, Counts>&... parts) {
    std::array<T, (Counts + ...)> all;
    std::size_t next = 0;
    const auto append = [&](const auto& part) {
        for (const T& one : part) {
            all[next++] = one;
        }
    };
    (append(parts), ...);
    return all;
}

inline std::array<FieldView, 1> fields_of(std::span<const double> values) { return {field(values)}; }
inline std::array<FieldView, 3> fields_of(std::span<const Vec3> values) {
    return {component(values, 0), component(values, 1), component(values, 2)};
}
template <std::size_t Count>
std::array<FieldView, Count> fields_of(const std::array<FieldView, Count>& views) {
    return views;
}
inline std::array<FieldSink, 1> sinks_of(std::span<double> sums) { return {sink(sums)}; }
inline std::array<FieldSink, 3> sinks_of(std::span<Vec3> sums) {
    return {sink_component(sums, 0), sink_component(sums, 1), sink_component(sums, 2)};
}
template <std::size_t Count>
std::array<FieldSink, Count> sinks_of(std::vector<std::array<double, Count>>& sums) {
    std::array<FieldSink, Count> all;
    for (std::size_t k = 0; k < Count; ++k) {
        all[k] = {sums.empty() ? nullptr : sums[0].data() + k, static_cast<std::int64_t>(Count)};
    }
    return all;
}

/// All numbers of columns, one column after the other: of vectors their three components.
template <class... Columns>
auto fields(const Columns&... columns) {
    return joined(fields_of(columns)...);
}
template <class... Columns>
auto sinks(Columns&&... columns) {
    return joined(sinks_of(columns)...);
}
/// One side of a sweep, with the numbers of these columns.
template <class... Columns>
auto side(std::span<const Vec3> position, const Columns&... columns) {
    const auto all = fields(columns...);
    return SweepSide<static_cast<int>(all.size())>{position, all};
}
inline SweepSide<0> side(std::span<const Vec3> position) { return {position, {}}; }

/// Reach of pairs and their space.
struct SweepReach {
    double support_radius;  ///< 2 h [m]: no pair acts at or beyond it
    Domain domain;          ///< for its dimension and its periods; particles may be outside
};

struct SweepScratchData;
class PlacedParticles;

/// Which particles are near which: Scratch. One for each pair of sets of particles (fluid with fluid, fluid with walls,
/// walls with fluid), the same one for all sweeps over that pair. Losing it costs time and changes no bit.
class SweepScratch {
 public:
    SweepScratch();
    ~SweepScratch();
    SweepScratch(SweepScratch&&) noexcept;
    SweepScratch& operator=(SweepScratch&&) noexcept;
    /// One for another pair of sets, whose sweeps never run at the same time as those of `other`: what both need only
    /// while they run is there once.
    static SweepScratch sharing_buffers(SweepScratch& other);
    /// One between sets whose places SweepLists keeps, with those buffers.
    SweepScratch(const std::shared_ptr<PlacedParticles>& targets, const std::shared_ptr<PlacedParticles>& candidates,
                 SweepScratch* buffers);
    SweepScratchData& data() { return *data_; }
    std::size_t bytes() const;

 private:
    std::unique_ptr<SweepScratchData> data_;
};

/// Adds to each target's sums what all candidates do to it:
///
///     sums[k][i] += sum over j of pair_k(target i, candidate j),
///
/// in the order of the candidates. Targets and candidates may be the same particles; a particle meets itself too. The
/// bits depend on the particles and their order alone: not on `scratch`, not on the number of threads.
/// @throws CaseError  where a period is shorter than two support radii
template <PairPhysics Pair>
void sweep(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& targets,
           const SweepSide<Pair::candidate_fields>& candidates,
           const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, SweepScratch& scratch);

/// Meets every pair of one particle of `a` and one of `b` once and adds what each does to the other:
///
///     sums_a[k][i] += sum over j of exchange_k(i, j),     sums_b[k][j] += sum over i of what comes back.
///
/// As sweep() both ways, at little more than half the work, and pair by pair in balance to the last bit of a float.
template <MutualPhysics Pair>
void exchange(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& a,
              const SweepSide<Pair::candidate_fields>& b,
              const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums_a,
              const std::array<FieldSink, static_cast<std::size_t>(Pair::back_sums)>& sums_b, SweepScratch& scratch);

/// The same among the particles of one set; a particle meets itself too, once.
template <MutualPhysics Pair>
void exchange_within(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& particles,
                     const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, SweepScratch& scratch);

}  // namespace riprap::fluid
