// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "riprap/core/parallel_host.hpp"
#include "riprap/core/vec3.hpp"
#include "riprap/fluid/particle/sweep/sweep.hpp"

namespace riprap::fluid {

/// N numbers for each particle where loops run: pointers to floats, or to doubles where `wide` is there.
template <std::size_t N>
struct NumbersView {
    double* wide{nullptr};
    float* narrow{nullptr};

    RIPRAP_HD double get(std::size_t i, std::size_t k) const {
        return wide != nullptr ? wide[N * i + k] : static_cast<double>(narrow[N * i + k]);
    }
    RIPRAP_HD void set(std::size_t i, std::size_t k, double a) const {
        if (wide != nullptr) {
            wide[N * i + k] = a;
        } else {
            narrow[N * i + k] = static_cast<float>(a);
        }
    }
    /// The only number of a particle.
    RIPRAP_HD double operator[](std::size_t i) const requires(N == 1) { return get(i, 0); }
    RIPRAP_HD void set(std::size_t i, double a) const requires(N == 1) { set(i, 0, a); }
    /// All numbers of a particle.
    RIPRAP_HD std::array<double, N> all(std::size_t i) const {
        std::array<double, N> numbers;
        for (std::size_t k = 0; k < N; ++k) {
            numbers[k] = get(i, k);
        }
        return numbers;
    }
    RIPRAP_HD void set_all(std::size_t i, const std::array<double, N>& numbers) const {
        for (std::size_t k = 0; k < N; ++k) {
            set(i, k, numbers[k]);
        }
    }
    RIPRAP_HD void set_vector(std::size_t i, const Vec3& a) const requires(N == 3) { set_all(i, {a.x, a.y, a.z}); }
    RIPRAP_HD Vec3 vector(std::size_t i) const requires(N == 3) { return {get(i, 0), get(i, 1), get(i, 2)}; }

    /// Number k of each particle, for sweeps to read or to add to.
    FieldView view(std::size_t k = 0) const {
        return {wide == nullptr ? nullptr : wide + k, static_cast<std::int64_t>(N),
                narrow == nullptr ? nullptr : narrow + k};
    }
    FieldSink sink(std::size_t k = 0) const {
        return {wide == nullptr ? nullptr : wide + k, static_cast<std::int64_t>(N), false,
                narrow == nullptr ? nullptr : narrow + k};
    }
};
/// All numbers of each particle, for sweeps.
template <std::size_t N>
std::array<FieldView, N> fields_of(const NumbersView<N>& numbers) {
    std::array<FieldView, N> all;
    for (std::size_t k = 0; k < N; ++k) {
        all[k] = numbers.view(k);
    }
    return all;
}
template <std::size_t N>
std::array<FieldSink, N> sinks_of(const NumbersView<N>& numbers) {
    std::array<FieldSink, N> all;
    for (std::size_t k = 0; k < N; ++k) {
        all[k] = numbers.sink(k);
    }
    return all;
}

/// Gives all particles the same numbers.
template <std::size_t N>
struct FillNumbers {
    NumbersView<N> numbers;
    std::array<double, N> same;
    RIPRAP_HD void operator()(std::int64_t i) const { numbers.set_all(static_cast<std::size_t>(i), same); }
};

/// N numbers for each particle: floats, which are as exact as the sums of fast sweeps, or doubles for those of plain
/// ones, in memory of the host or of a device.
template <std::size_t N, class Where = parallel::Host>
class Numbers {
    static constexpr bool is_here = std::is_same_v<Where, parallel::Host>;

 public:
    void resize(std::size_t count, bool is_wide) {
        wide_.resize(is_wide ? N * count : 0);
        narrow_.resize(is_wide ? 0 : N * count);
    }
    /// Gives all particles the same numbers.
    void fill(std::size_t count, bool is_wide, const std::array<double, N>& numbers) {
        resize(count, is_wide);
        Where::for_each(static_cast<std::int64_t>(count), FillNumbers<N>{columns(), numbers});
    }
    std::size_t size() const { return (wide_.size() + narrow_.size()) / N; }
    /// The numbers as loops over particles read and write them: a view, through which all may be written.
    NumbersView<N> columns() const {
        return {wide_.empty() ? nullptr : const_cast<double*>(wide_.data()), const_cast<float*>(narrow_.data())};
    }

    // One at a time, on the host.
    double get(std::size_t i, std::size_t k) const requires(is_here) { return columns().get(i, k); }
    double operator[](std::size_t i) const requires(is_here&& N == 1) { return get(i, 0); }
    std::array<double, N> all(std::size_t i) const requires(is_here) { return columns().all(i); }
    Vec3 vector(std::size_t i) const requires(is_here&& N == 3) { return columns().vector(i); }
    void set(std::size_t i, std::size_t k, double a) requires(is_here) { columns().set(i, k, a); }
    void set(std::size_t i, double a) requires(is_here&& N == 1) { columns().set(i, 0, a); }
    void set_vector(std::size_t i, const Vec3& a) requires(is_here&& N == 3) { columns().set_vector(i, a); }

    /// Number k of each particle, for sweeps to read. Where there are numbers of one particle only, all have those.
    FieldView view(std::size_t k = 0) const {
        FieldView view = columns().view(k);
        view.stride = size() == 1 ? 0 : view.stride;
        return view;
    }
    std::size_t bytes() const { return wide_.capacity() * sizeof(double) + narrow_.capacity() * sizeof(float); }

 private:
    typename Where::template Array<double> wide_;
    typename Where::template Array<float> narrow_;
};

template <std::size_t N, class Where>
std::array<FieldView, N> fields_of(const Numbers<N, Where>& numbers) {
    std::array<FieldView, N> all;
    for (std::size_t k = 0; k < N; ++k) {
        all[k] = numbers.view(k);
    }
    return all;
}
template <std::size_t N, class Where>
std::array<FieldSink, N> sinks_of(const Numbers<N, Where>& numbers) {
    return sinks_of(numbers.columns());
}
/// Numbers times one for each particle.
template <std::size_t N, class Where>
std::array<FieldView, N> products(std::array<FieldView, N> numbers, const Numbers<1, Where>& factor) {
    const FieldView by = factor.view();
    for (FieldView& each : numbers) {
        each.factor = by.data;
        each.narrow_factor = by.narrow;
        each.factor_stride = by.stride;
    }
    return numbers;
}

/// Memory for numbers of each particle that stages of a step lend one another. A stage names what it needs and takes
/// the places of what no stage reads any more, so that each name has one meaning.
template <class Where>
class StageMemory {
 public:
    /// Makes room, whatever is in it.
    /// @param places  of each particle [-]
    void resize(std::size_t count, bool is_wide, std::size_t places) {
        count_ = count;
        is_wide_ = is_wide;
        wide_.resize(is_wide ? places * count : 0);
        narrow_.resize(is_wide ? 0 : places * count);
    }
    /// Lends N places of each particle from this one on.
    template <std::size_t N>
    NumbersView<N> lend(std::size_t place) {
        const std::size_t begin = count_ * place;
        return {is_wide_ ? wide_.data() + begin : nullptr, is_wide_ ? nullptr : narrow_.data() + begin};
    }
    std::size_t bytes() const { return wide_.capacity() * sizeof(double) + narrow_.capacity() * sizeof(float); }

 private:
    typename Where::template Array<double> wide_;
    typename Where::template Array<float> narrow_;
    std::size_t count_{0};
    bool is_wide_{false};
};

}  // namespace riprap::fluid
