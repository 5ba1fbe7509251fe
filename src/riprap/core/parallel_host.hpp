// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/blocks.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"

namespace riprap::parallel {

/// Memory and loops of the host. Code that is written once for host and device takes such a struct as its parameter
/// `Where`; cuda::Device (parallel_cuda.hpp) is the other one. Functors are named, trivially copyable types with
/// RIPRAP_HD members that hold plain pointers; both give the same bits.
struct Host {
    template <class T>
    using Array = std::vector<T>;

    /// Copies numbers of the host to memory of where loops run; the array takes their size.
    template <class T>
    static void upload(std::span<const T> host, Array<T>& there) {
        there.assign(host.begin(), host.end());
    }
    /// Copies them back; the sizes have to agree.
    template <class T>
    static void download(const Array<T>& there, std::span<T> host) {
        RIPRAP_ASSERT(there.size() == host.size(), "entries into room for another number of them");
        std::copy(there.begin(), there.end(), host.begin());
    }
    /// See parallel::for_each.
    template <class F>
    static void for_each(std::int64_t n, const F& f) {
        parallel::for_each(n, f);
    }
    /// The same for entries of uneven cost.
    template <class F>
    static void for_each_uneven(std::int64_t n, const F& f) {
        constexpr std::int64_t grain = 256;
        parallel::for_each_uneven(n, grain, f);
    }
    /// See parallel::reduce.
    template <class T, class Map, class Fold>
    static T reduce(std::int64_t n, const T& identity, const Map& map, const Fold& fold) {
        return parallel::reduce(n, identity, map, fold);
    }
    /// See parallel::sum.
    template <class Map>
    static SumOf<Map> sum(const Blocks& blocks, const Map& map) {
        return parallel::sum(blocks, map);
    }
    /// See parallel::sort_by_key.
    static void sort_by_key(Array<std::uint64_t>& keys, Array<std::uint32_t>& values) {
        std::vector<std::uint64_t> scratch_keys;
        std::vector<std::uint32_t> scratch_values;
        parallel::sort_by_key(keys, values, scratch_keys, scratch_values);
    }
};

}  // namespace riprap::parallel
