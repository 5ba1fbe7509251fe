// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "riprap/fluid/particle/sweep/cluster_list.hpp"
#include "riprap/fluid/particle/sweep/sweep.hpp"

namespace riprap::fluid {

/// Buffers for the threads of a sweep to borrow.
class BufferPool {
 public:
    using Buffer = std::vector<float>;
    std::unique_ptr<Buffer> take();
    void give(std::unique_ptr<Buffer> buffer);
    std::size_t bytes() const;  ///< of buffers that were given back

 private:
    mutable std::mutex mutex_;
    std::vector<std::unique_ptr<Buffer>> free_;
};

/// Fields of the candidates that some patches name.
struct PackedFields {
    std::vector<float> fields;         ///< [place of the block][cluster][field][member]
    std::vector<std::int32_t> blocks;  ///< in the order of their places
    std::vector<std::int32_t> place;   ///< of every block of candidates, or -1
};

/// Buffers that a sweep needs only while it runs: sweeps that follow each other may share them.
struct SweepBuffers {
    PackedFields packed;
    std::vector<float> patch_sums;         ///< of some patches' candidates: [patch][place][sum][member]
    std::vector<std::size_t> patch_begin;  ///< of each of those patches there
    BufferPool records;
};

/// Makes room for `count` numbers and none beyond them, whatever they are.
inline void make_room(std::vector<float>& numbers, std::size_t count) {
    if (numbers.size() < count) {
        std::vector<float>().swap(numbers);
        numbers.resize(count);
    }
}

struct SweepScratchData {
    SweepScratchData() = default;
    explicit SweepScratchData(ClusterList lists) : list(std::move(lists)) {}
    ClusterList list;
    std::shared_ptr<SweepBuffers> buffers{std::make_shared<SweepBuffers>()};
    bool owns_buffers{true};  ///< and counts their bytes
};

}  // namespace riprap::fluid
