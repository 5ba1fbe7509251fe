// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "riprap/core/bytes.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/vec3.hpp"

namespace riprap::coupling {

/// Visits the entries of a list by their numbers.
template <class List>
class EntryIterator {
 public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = typename List::value_type;
    using difference_type = std::ptrdiff_t;
    using pointer = const value_type*;
    using reference = value_type;

    EntryIterator(const List& list, std::size_t entry) : list_(&list), entry_(entry) {}
    value_type operator*() const { return (*list_)[entry_]; }
    EntryIterator& operator++() {
        ++entry_;
        return *this;
    }
    EntryIterator operator++(int) {
        EntryIterator before = *this;
        ++entry_;
        return before;
    }
    bool operator==(const EntryIterator& other) const { return entry_ == other.entry_; }

 private:
    const List* list_;
    std::size_t entry_;
};

/// A list that is packed once it is complete: where few of its values differ, each of those is kept once, and entries
/// name it by one byte or two, or not at all where it is the only one. Values come back bit by bit as they were given.
template <class T>
class Column {
    static_assert(std::is_trivially_copyable_v<T>);

 public:
    using value_type = T;
    using const_iterator = EntryIterator<Column>;

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T operator[](std::size_t i) const {
        switch (named_by_) {
            case Name::place:
                return values_[i];
            case Name::byte:
                return values_[bytes_[i]];
            case Name::pair:
                return values_[pairs_[i]];
            case Name::nothing:
                break;
        }
        return values_[0];
    }
    const_iterator begin() const { return {*this, 0}; }
    const_iterator end() const { return {*this, size()}; }

    void reserve(std::size_t count) { values_.reserve(count); }
    void push_back(const T& value) {
        unpack();
        values_.push_back(value);
        ++size_;
    }
    void set(std::size_t i, const T& value) {
        unpack();
        values_[i] = value;
    }
    void resize(std::size_t count) {
        unpack();
        values_.resize(count);
        size_ = count;
    }
    void clear() { *this = {}; }

    void pack() {
        unpack();
        std::vector<T> different;
        std::vector<std::uint16_t> numbers;
        if (!number_values(different, numbers)) {
            values_.shrink_to_fit();
            return;
        }
        if (different.size() == 1) {
            named_by_ = Name::nothing;
        } else if (different.size() <= 0x100) {
            bytes_.assign(numbers.begin(), numbers.end());
            named_by_ = Name::byte;
        } else {
            pairs_ = std::move(numbers);
            named_by_ = Name::pair;
        }
        different.shrink_to_fit();
        values_ = std::move(different);
    }
    std::size_t bytes() const { return bytes_of(values_, bytes_, pairs_); }
    friend bool operator==(const Column& a, const Column& b) {
        return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin());
    }

 private:
    enum class Name : std::uint8_t { place, byte, pair, nothing };  ///< place: entries are the values

    void unpack() {
        if (named_by_ != Name::place) {
            values_ = std::vector<T>(begin(), end());
            std::vector<std::uint8_t>().swap(bytes_);
            std::vector<std::uint16_t>().swap(pairs_);
            named_by_ = Name::place;
        }
    }

    /// Lists the different values in the order of their first entries; false where numbers would save no room.
    bool number_values(std::vector<T>& different, std::vector<std::uint16_t>& numbers) const {
        // Where half of the values differ, names hardly save more than they cost in time.
        const std::size_t most = sizeof(T) == 1 ? 1 : std::min<std::size_t>(0x10000, values_.size() / 2);
        std::unordered_map<std::uint64_t, std::vector<std::uint16_t>> with_bits;
        numbers.reserve(values_.size());
        for (const T& value : values_) {
            if (!numbers.empty() && is_same(value, different[numbers.back()])) {
                numbers.push_back(numbers.back());
                continue;
            }
            std::vector<std::uint16_t>& alike = with_bits[bits_of(value)];
            std::size_t k = 0;
            while (k < alike.size() && !is_same(value, different[alike[k]])) {
                ++k;
            }
            if (k == alike.size()) {
                if (different.size() == most) {
                    return false;
                }
                alike.push_back(static_cast<std::uint16_t>(different.size()));
                different.push_back(value);
            }
            numbers.push_back(alike[k]);
        }
        return !different.empty();
    }
    static bool is_same(const T& a, const T& b) { return std::memcmp(&a, &b, sizeof(T)) == 0; }
    static std::uint64_t bits_of(const T& value) {
        std::uint64_t bits = 0;
        for (std::size_t at = 0; at < sizeof(T); at += sizeof bits) {
            std::uint64_t part = 0;
            std::memcpy(&part, reinterpret_cast<const char*>(&value) + at, std::min(sizeof bits, sizeof(T) - at));
            bits = bits * 0x9E3779B97F4A7C15U + part;
        }
        return bits;
    }

    std::size_t size_{0};
    Name named_by_{Name::place};
    std::vector<T> values_;  ///< of the entries, or the different ones
    std::vector<std::uint8_t> bytes_;
    std::vector<std::uint16_t> pairs_;
};

/// Places, axis by axis: those of a lattice, or of layers below faces along the axes, share coordinates.
class PlaceColumn {
 public:
    using value_type = Vec3;
    using const_iterator = EntryIterator<PlaceColumn>;

    std::size_t size() const { return x_.size(); }
    bool empty() const { return size() == 0; }
    Vec3 operator[](std::size_t i) const { return {x_[i], y_[i], z_[i]}; }
    const_iterator begin() const { return {*this, 0}; }
    const_iterator end() const { return {*this, size()}; }
    void reserve(std::size_t count) {
        for (Column<double>* axis : {&x_, &y_, &z_}) {
            axis->reserve(count);
        }
    }
    void push_back(const Vec3& place) {
        x_.push_back(place.x);
        y_.push_back(place.y);
        z_.push_back(place.z);
    }
    void pack() {
        for (Column<double>* axis : {&x_, &y_, &z_}) {
            axis->pack();
        }
    }
    std::size_t bytes() const { return x_.bytes() + y_.bytes() + z_.bytes(); }
    friend bool operator==(const PlaceColumn& a, const PlaceColumn& b) = default;

 private:
    Column<double> x_, y_, z_;
};

}  // namespace riprap::coupling
