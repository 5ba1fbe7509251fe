// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace riprap {

/// One of a few laws, by its place in their list. A law is a struct with
///
///     static constexpr std::string_view word, help;   // as a case names it, and what it is in a few words
///     static KeyList<Law> keys();                     // of its numbers; absent where it has none
///
/// and with the code that uses those numbers. All laws keep their numbers, whichever is chosen. One line in the list
/// registers a law: `key::chosen` (core/chosen_keys.hpp) makes the words and keys of a case from the list.
template <class... Laws>
class Chosen {
 public:
    static constexpr std::size_t count = sizeof...(Laws);
    static constexpr std::string_view words[] = {Laws::word...};

    /// Chooses a law. @returns its numbers
    template <class Law>
    Law& choose() {
        index_ = place_of<Law>();
        return std::get<Law>(laws_);
    }
    /// Chooses by place in the list.
    void choose(std::size_t index) { index_ = index; }
    std::size_t index() const { return index_; }

    /// Numbers of a law, chosen or not.
    template <class Law>
    const Law& get() const {
        return std::get<Law>(laws_);
    }
    template <class Law>
    Law& get() {
        return std::get<Law>(laws_);
    }

    /// Calls work.template operator()<Law>(is_chosen) for every law, in the order of the list.
    template <class Work>
    void for_each(const Work& work) const {
        std::size_t place = 0;
        (work.template operator()<Laws>(place++ == index_), ...);
    }

    /// Returns work(law) of the law that is chosen.
    template <class Work>
    decltype(auto) visit(const Work& work) const {
        return visit_from<0>(work);
    }

 private:
    template <class Law>
    static constexpr std::size_t place_of() {
        std::size_t place = 0;
        static_cast<void>(((std::is_same_v<Law, Laws> || (++place, false)) || ...));
        return place;
    }
    template <std::size_t place, class Work>
    decltype(auto) visit_from(const Work& work) const {
        if constexpr (place + 1 < count) {
            if (index_ != place) {
                return visit_from<place + 1>(work);
            }
        }
        return work(std::get<place>(laws_));
    }

    std::tuple<Laws...> laws_{};
    std::size_t index_{0};
};

}  // namespace riprap
