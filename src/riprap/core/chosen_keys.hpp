// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "riprap/core/chosen.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/key.hpp"

namespace riprap::key {

/// A word that chooses a law, and the keys of all laws of the list, each read with the word of its law. A key of one
/// law cannot be that of another: a value given once would reach only one of them.
/// @param question  what is chosen, without a full stop; the help of the laws follows
template <class S, class... Laws>
KeyList<S> chosen(Chosen<Laws...> S::*member, std::string_view name, std::string_view question) {
    using List = Chosen<Laws...>;
    static const std::string help = [&] {
        std::string text(question);
        std::string_view before = ". ";
        ((text.append(before).append(Laws::word).append(": ").append(Laws::help), before = "; "), ...);
        return text + ".";
    }();
    KeyList<S> list{{{.name = name, .help = help, .kind = KeyKind::choice, .words = {Laws::word...}},
                     [member](const S& s) -> KeyValue { return std::string(List::words[(s.*member).index()]); },
                     [member](S& s, const KeyValue& value) {
                         const auto word =
                             std::find(std::begin(List::words), std::end(List::words), std::get<std::string>(value));
                         (s.*member).choose(static_cast<std::size_t>(word - std::begin(List::words)));
                     }}};
    const auto add_keys_of = [&]<class Law>(const Law* /*law*/) {
        if constexpr (requires { Law::keys(); }) {
            for (const BoundKey<Law>& key : Law::keys().read_with(name, {Law::word})) {
                if (std::any_of(list.begin(), list.end(),
                                [&key](const BoundKey<S>& other) { return other.row.name == key.row.name; })) {
                    throw InternalError("two laws of '" + std::string(name) + "' have a key '" +
                                        std::string(key.row.name) + "'");
                }
                list.add({key.row, [member, get = key.get](const S& s) { return get((s.*member).template get<Law>()); },
                          [member, set = key.set](S& s, const KeyValue& value) {
                              set((s.*member).template get<Law>(), value);
                          }});
            }
        }
    };
    (add_keys_of(static_cast<const Laws*>(nullptr)), ...);
    return list;
}

}  // namespace riprap::key
