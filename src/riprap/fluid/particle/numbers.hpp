// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "riprap/core/bytes.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/vec3.hpp"
#include "riprap/fluid/particle/sweep.hpp"

namespace riprap::fluid {

/// N numbers for each particle: floats, which are as exact as the sums of fast sweeps, or doubles for those of plain
/// ones.
template <std::size_t N>
class Numbers {
 public:
    void resize(std::size_t count, bool is_wide) {
        is_wide_ = is_wide;
        wide_.resize(is_wide ? N * count : 0);
        narrow_.resize(is_wide ? 0 : N * count);
    }
    /// Gives all particles the same numbers.
    void fill(std::size_t count, bool is_wide, const std::array<double, N>& numbers) {
        resize(count, is_wide);
        parallel::for_each(static_cast<std::int64_t>(count),
                           [&](std::int64_t i) { set_all(static_cast<std::size_t>(i), numbers); });
    }
    std::size_t size() const { return (wide_.size() + narrow_.size()) / N; }
    void swap(Numbers& other) noexcept {
        wide_.swap(other.wide_);
        narrow_.swap(other.narrow_);
        std::swap(is_wide_, other.is_wide_);
    }

    double get(std::size_t i, std::size_t k) const {
        return is_wide_ ? wide_[N * i + k] : static_cast<double>(narrow_[N * i + k]);
    }
    void set(std::size_t i, std::size_t k, double a) {
        if (is_wide_) {
            wide_[N * i + k] = a;
        } else {
            narrow_[N * i + k] = static_cast<float>(a);
        }
    }
    /// The only number of a particle.
    double operator[](std::size_t i) const requires(N == 1) { return get(i, 0); }
    void set(std::size_t i, double a) requires(N == 1) { set(i, 0, a); }
    /// All numbers of a particle.
    std::array<double, N> all(std::size_t i) const {
        std::array<double, N> numbers;
        for (std::size_t k = 0; k < N; ++k) {
            numbers[k] = get(i, k);
        }
        return numbers;
    }
    void set_all(std::size_t i, const std::array<double, N>& numbers) {
        for (std::size_t k = 0; k < N; ++k) {
            set(i, k, numbers[k]);
        }
    }
    void set_vector(std::size_t i, const Vec3& a) requires(N == 3) { set_all(i, {a.x, a.y, a.z}); }
    /// Three of them from number k on.
    Vec3 vector(std::size_t i, std::size_t k = 0) const requires(N >= 3) {
        return {get(i, k), get(i, k + 1), get(i, k + 2)};
    }

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
    FieldView times(std::size_t k, const Numbers<1>& factor) const {
        FieldView product = view(k);
        const FieldView by = factor.view();
        product.factor = by.data;
        product.narrow_factor = by.narrow;
        return product;
    }
    std::size_t bytes() const { return bytes_of(wide_, narrow_); }

 private:
    bool is_wide_{false};
    std::vector<double> wide_;
    std::vector<float> narrow_;
};

}  // namespace riprap::fluid
