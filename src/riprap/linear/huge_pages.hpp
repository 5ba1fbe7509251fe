// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace riprap::linear {

/// Asks the system to back memory that nobody has written yet by pages of 2 MiB, where it knows them: a stream through
/// a large array then waits for fewer addresses. Does nothing for less than two such pages.
void advise_huge_pages(void* begin, std::size_t bytes);

/// Gives arrays that begin with a line of the cache: no block of a multiple of eight numbers lies across one more line
/// than it fills.
template <class T>
struct LineAllocator {
    using value_type = T;
    static constexpr std::align_val_t line{64};

    LineAllocator() = default;
    template <class U>
    LineAllocator(const LineAllocator<U>&) {}  // NOLINT(google-explicit-constructor): rebinding

    T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), line)); }
    void deallocate(T* p, std::size_t) { ::operator delete(p, line); }
    friend bool operator==(const LineAllocator&, const LineAllocator&) { return true; }
};
/// An array that is streamed through.
template <class T>
using StreamVector = std::vector<T, LineAllocator<T>>;

/// Makes room for `size` entries, on huge pages where none are there yet; what the array held is lost then.
template <class T>
void make_room(std::size_t size, StreamVector<T>& array) {
    if (array.capacity() < size) {
        array = {};
        array.reserve(size);
        advise_huge_pages(array.data(), size * sizeof(T));
    }
}

}  // namespace riprap::linear
