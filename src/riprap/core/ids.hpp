// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>

namespace riprap {

/// An index that cannot be mistaken for another kind of index. `-1` means none.
template <class Tag>
struct Id {
    std::int32_t value{-1};
    constexpr auto operator<=>(const Id&) const = default;
    constexpr bool is_valid() const { return value >= 0; }
};

using BodyId = Id<struct BodyTag>;
using PartId = Id<struct PartTag>;
using ShapeId = Id<struct ShapeTag>;
using MaterialId = Id<struct MaterialTag>;

}  // namespace riprap
