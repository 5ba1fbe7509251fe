// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace riprap::geometry {

/// Looks at the last number of each row, in the order of a file, for a file that was cut while it was written: one
/// whose last number lost digits is read without a sign of that.
class CutEnd {
 public:
    /// @param number  the last of a row, as it is written
    void add(std::string_view number);
    /// True where the text ends without a line end, and the last number has fewer digits behind its point than all of
    /// the three rows or more before it have alike.
    bool is_cut(std::string_view text) const;

 private:
    std::size_t rows_{0}, digits_{0}, last_{0};
    bool are_alike_{true};  ///< all rows but the last
};

}  // namespace riprap::geometry
