// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "riprap/core/parallel_host.hpp"
#include "riprap/core/vec3.hpp"
#include "riprap/fluid/particle/sweep.hpp"

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
    /// Three of them from number k on.
    RIPRAP_HD Vec3 vector(std::size_t i, std::size_t k = 0) const requires(N >= 3) {
        return {get(i, k), get(i, k + 1), get(i, k + 2)};
    }
};

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
    void swap(Numbers& other) noexcept {
        wide_.swap(other.wide_);
        narrow_.swap(other.narrow_);
    }
    /// The numbers as loops over particles read and write them: a view, through which all may be written.
    NumbersView<N> columns() const {
        return {wide_.empty() ? nullptr : const_cast<double*>(wide_.data()), const_cast<float*>(narrow_.data())};
    }

    // One at a time, on the host.
    double get(std::size_t i, std::size_t k) const requires(is_here) { return columns().get(i, k); }
    double operator[](std::size_t i) const requires(is_here&& N == 1) { return get(i, 0); }
    std::array<double, N> all(std::size_t i) const requires(is_here) { return columns().all(i); }
    Vec3 vector(std::size_t i, std::size_t k = 0) const requires(is_here&& N >= 3) { return columns().vector(i, k); }
    void set(std::size_t i, std::size_t k, double a) requires(is_here) { columns().set(i, k, a); }
    void set(std::size_t i, double a) requires(is_here&& N == 1) { columns().set(i, 0, a); }
    void set_vector(std::size_t i, const Vec3& a) requires(is_here&& N == 3) { columns().set_vector(i, a); }

    /// Number k of each particle, for sweeps to read or to add to. Where there are numbers of one particle only, all
    /// have those.
    FieldView view(std::size_t k = 0) const {
        return {wide_.empty() ? nullptr : wide_.data() + k, size() == 1 ? 0 : static_cast<std::int64_t>(N),
                narrow_.empty() ? nullptr : narrow_.data() + k};
    }
    FieldSink sink(std::size_t k = 0) {
        return {wide_.empty() ? nullptr : wide_.data() + k, N, false, narrow_.empty() ? nullptr : narrow_.data() + k};
    }
    /// The same number times one for each particle.
    FieldView times(std::size_t k, const Numbers<1, Where>& factor) const {
        FieldView product = view(k);
        const FieldView by = factor.view();
        product.factor = by.data;
        product.narrow_factor = by.narrow;
        return product;
    }
    std::size_t bytes() const { return wide_.capacity() * sizeof(double) + narrow_.capacity() * sizeof(float); }

 private:
    typename Where::template Array<double> wide_;
    typename Where::template Array<float> narrow_;
};

}  // namespace riprap::fluid
