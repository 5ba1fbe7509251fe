// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/bytes.hpp"
#include "riprap/core/vec3.hpp"

namespace riprap::fluid {

/// A vector for each of many particles, of which most are zero: only blocks of particles with another one take room.
class SparseVectors {
 public:
    /// Particles that share their room, and that only one thread at a time may add to.
    static constexpr std::int64_t block_size = 64;

    SparseVectors() = default;
    explicit SparseVectors(std::size_t count) { reset(count); }

    /// Makes all zero.
    void reset(std::size_t count) {
        constexpr auto block = static_cast<std::size_t>(block_size);
        blocks_.resize((count + block - 1) / block);
        for (std::vector<Vec3>& each : blocks_) {
            if (!each.empty()) {
                std::vector<Vec3>().swap(each);  // = {} would keep the room
            }
        }
    }
    Vec3 operator[](std::size_t i) const {
        const std::size_t block = i / block_size;
        return block >= blocks_.size() || blocks_[block].empty() ? Vec3{} : blocks_[block][i % block_size];
    }
    void add(std::size_t i, const Vec3& a) {
        std::vector<Vec3>& block = blocks_[i / block_size];
        if (block.empty()) {
            block.resize(block_size);
        }
        block[i % block_size] += a;
    }
    /// Calls f(number of the block, its vectors) for every block that has room.
    template <class F>
    void for_each_block(const F& f) const {
        for (std::size_t block = 0; block < blocks_.size(); ++block) {
            if (!blocks_[block].empty()) {
                f(block, std::span<const Vec3>(blocks_[block]));
            }
        }
    }
    std::size_t bytes() const { return bytes_of(blocks_); }

 private:
    std::vector<std::vector<Vec3>> blocks_;
};

}  // namespace riprap::fluid
