// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace riprap::geometry {

/// One cache line and one AVX-512 register [bytes].
inline constexpr std::size_t array_alignment = 64;

/// std::allocator whose blocks begin on a multiple of array_alignment.
template <class T>
struct AlignedAllocator {
    using value_type = T;

    AlignedAllocator() = default;
    template <class U>
    AlignedAllocator(const AlignedAllocator<U>&) {}  // NOLINT(google-explicit-constructor): rebinding

    T* allocate(std::size_t n) {
        return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{array_alignment}));
    }
    void deallocate(T* p, std::size_t) { ::operator delete (p, std::align_val_t{array_alignment}); }
    friend bool operator==(const AlignedAllocator&, const AlignedAllocator&) { return true; }
};

template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

}  // namespace riprap::geometry
