// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

namespace riprap {

/// Kinds of one thing that a case names by their words, each a struct. One line in the list registers a kind: rows,
/// help, checks and the reading are made by loops over it.
template <class... Kinds>
struct KindList {
    /// Any one of the kinds, or of others that a case has no word for.
    template <class... Others>
    using VariantWith = std::variant<Kinds..., Others...>;

    /// Calls work.template operator()<Kind>() for every kind, in the order of the list.
    template <class Work>
    static void for_each(const Work& work) {
        (work.template operator()<Kinds>(), ...);
    }
};

}  // namespace riprap
