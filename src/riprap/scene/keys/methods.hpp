// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "riprap/scene/keys/bound_keys.hpp"
#include "riprap/sim/model.hpp"

namespace riprap::scene {

/// A method as the key table knows it.
struct Method {
    std::string_view word;
    std::string_view help;
    std::vector<Key> keys;
    std::vector<std::string_view> scene_keys;
};

/// The methods that a case may choose: the alternatives of a variant of their settings, the default first.
template <class Settings>
struct MethodList;
template <MethodSettings... S>
struct MethodList<std::variant<S...>> {
    using Settings = std::variant<S...>;

    static std::vector<Method> all() { return {method<S>()...}; }

    /// The settings of the method that the resolved `table` chooses, a problem for values that do not go together, and
    /// a warning for values that the method does not read beside others.
    /// @param header  "[solid]"
    static std::variant<S...> read(const Value& table, std::string_view header, std::vector<Diagnostic>& problems,
                                   std::vector<std::string>& warnings) {
        std::variant<S...> settings;
        const std::string& word = get_text(table, "method");
        ((word == S::method_name && (settings = read_one<S>(table, header, problems, warnings), true)) || ...);
        return settings;
    }

 private:
    template <class T>
    static Method method() {
        const MethodKeys<T> said = T::keys();
        return {T::method_name, said.help, rows_of(said.keys), said.scene_keys};
    }
    template <class T>
    static T read_one(const Value& table, std::string_view header, std::vector<Diagnostic>& problems,
                      std::vector<std::string>& warnings) {
        const MethodKeys<T> said = T::keys();
        T settings;
        read_keys(table, said.keys, settings);
        warn_of_unread_keys(table, header, filled_keys(said.keys, settings), warnings);
        if (said.check != nullptr) {
            for (const KeyProblem& problem : said.check(settings)) {
                const Value* given = table.find(problem.key);
                problems.push_back({given != nullptr ? given->place : table.place, problem.message, problem.allowed});
            }
        }
        return settings;
    }
};

using SolidMethods = MethodList<sim::SolidSettings>;
using FluidMethods = MethodList<sim::FluidChoices>;

// Keys that fill parts of the Model and are of no method alone.
KeyList<coupling::ParticleFluid> fluid_model_keys();
KeyList<sim::OutputSettings> output_keys();
KeyList<sim::TimeSettings> time_keys();

/// Adds the key "method" and the keys of all methods to a table. Methods share a row where it is the same for them.
/// @param question    help of "method"
/// @param scene_keys  rows that methods name in MethodKeys::scene_keys
Table with_methods(Table table, std::string_view question, const std::vector<Method>& methods,
                   const std::vector<Key>& scene_keys);

}  // namespace riprap::scene
