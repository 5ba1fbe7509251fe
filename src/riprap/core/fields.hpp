// SPDX-License-Identifier: Apache-2.0
#pragma once

// State of every method is one ordered list of named flat fields. A State type offers
//
//     template <class Self, class Visit> static void visit_fields(Self& self, Visit&& visit);
//
// which calls visit(name, array) for each std::vector of scalars, Vec3, Quat or integers, in a fixed order,
// and visit(name, value) for each scalar. Hash, checkpoint, NaN scan and comparison are loops over that list,
// so a new method cannot forget one of them.

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "riprap/core/quat.hpp"
#include "riprap/core/sym3.hpp"

namespace riprap {

/// State of a method that has no fields of its own.
struct NoFields {
    template <class Self, class Visit>
    static void visit_fields(Self& /*self*/, Visit&& /*visit*/) {}
};

/// Type of the entries of a field.
enum class FieldType : std::uint8_t { float64 = 1, int32 = 2, int64 = 3, uint64 = 4, uint8 = 5 };

template <class T>
struct FieldTraits;
template <>
struct FieldTraits<double> {
    static constexpr FieldType type = FieldType::float64;
    static constexpr int components = 1;
};
template <>
struct FieldTraits<Vec3> {
    static constexpr FieldType type = FieldType::float64;
    static constexpr int components = 3;
};
template <>
struct FieldTraits<Quat> {
    static constexpr FieldType type = FieldType::float64;
    static constexpr int components = 4;
};
template <>
struct FieldTraits<Sym3> {
    static constexpr FieldType type = FieldType::float64;
    static constexpr int components = 6;
};
template <>
struct FieldTraits<std::int32_t> {
    static constexpr FieldType type = FieldType::int32;
    static constexpr int components = 1;
};
template <>
struct FieldTraits<std::int64_t> {
    static constexpr FieldType type = FieldType::int64;
    static constexpr int components = 1;
};
template <>
struct FieldTraits<std::uint64_t> {
    static constexpr FieldType type = FieldType::uint64;
    static constexpr int components = 1;
};
template <>
struct FieldTraits<std::uint8_t> {
    static constexpr FieldType type = FieldType::uint8;
    static constexpr int components = 1;
};

template <class T>
inline constexpr bool is_field_array = false;
template <class T>
inline constexpr bool is_field_array<std::vector<T>> = true;

/// 64-bit hash of bytes, order-sensitive: eight bytes at a time through a multiply-xorshift mixer.
class Hasher {
 public:
    void add(const void* data, std::size_t bytes) {
        const auto* p = static_cast<const unsigned char*>(data);
        while (bytes >= 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, p, 8);
            mix(word);
            p += 8;
            bytes -= 8;
        }
        if (bytes > 0) {
            std::uint64_t word = 0;
            std::memcpy(&word, p, bytes);
            mix(word ^ (static_cast<std::uint64_t>(bytes) << 56));
        }
    }
    std::uint64_t value() const { return value_; }

 private:
    void mix(std::uint64_t word) {
        value_ ^= word;
        value_ *= 0x9E3779B97F4A7C15ULL;
        value_ ^= value_ >> 29;
        value_ *= 0xBF58476D1CE4E5B9ULL;
        value_ ^= value_ >> 32;
    }
    std::uint64_t value_{0x52697072617000ULL};
};

/// Hash of every field, names and lengths included.
template <class State>
std::uint64_t hash_fields(const State& state) {
    Hasher hasher;
    State::visit_fields(state, [&hasher](std::string_view name, const auto& field) {
        hasher.add(name.data(), name.size());
        using Field = std::remove_cvref_t<decltype(field)>;
        if constexpr (is_field_array<Field>) {
            const std::uint64_t count = field.size();
            hasher.add(&count, sizeof count);
            hasher.add(field.data(), field.size() * sizeof(typename Field::value_type));
        } else {
            hasher.add(&field, sizeof field);
        }
    });
    return hasher.value();
}

/// Where the first non-finite number is; `name` empty when there is none.
struct NonFinite {
    std::string name;
    std::size_t entry{0};
};

template <class State>
NonFinite find_non_finite(const State& state) {
    NonFinite found;
    State::visit_fields(state, [&found](std::string_view name, const auto& field) {
        using Field = std::remove_cvref_t<decltype(field)>;
        const double* numbers = nullptr;
        std::size_t count = 0, components = 1;
        if constexpr (is_field_array<Field>) {
            using Entry = typename Field::value_type;
            if constexpr (FieldTraits<Entry>::type == FieldType::float64) {
                components = FieldTraits<Entry>::components;
                numbers = reinterpret_cast<const double*>(field.data());
                count = field.size() * components;
            }
        } else if constexpr (std::is_same_v<Field, double>) {
            numbers = &field;
            count = 1;
        }
        for (std::size_t i = 0; i < count && found.name.empty(); ++i) {
            if (!std::isfinite(numbers[i])) {
                found = {std::string(name), i / components};
            }
        }
    });
    return found;
}

}  // namespace riprap
