// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/case/body_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "riprap/core/index.hpp"
#include "riprap/scene/text/suggest.hpp"

namespace riprap::scene {

NameAnswer answer_to_name(const body::BodySet& bodies, std::string_view name) {
    const std::size_t bracket = name.find('[');
    const std::string entry(name.substr(0, bracket));
    std::int32_t first = -1, last = -1;  // numbers of the bodies of this entry, where it has many
    bool is_one = false;
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        if (bodies.names[at(bodies.name_id[at(b)])] == entry) {
            const std::int32_t number = bodies.name_index[at(b)];
            is_one = is_one || number < 0;
            first = first < 0 ? number : std::min(first, number);
            last = std::max(last, number);
        }
    }
    const bool has_number = bracket != std::string_view::npos;
    if (last >= 0) {
        return {
            has_number ? fmt::format("there is no body '{}'", name) : fmt::format("there are many bodies '{}'", name),
            first == last ? fmt::format("'{}[{}]'", entry, first)
                          : fmt::format("'{0}[{1}]' to '{0}[{2}]'", entry, first, last)};
    }
    const std::string meant = is_one ? entry : nearest(name, bodies.names);
    return {fmt::format("there is no body '{}'", name),
            meant.empty() ? "a name of [[body]], or NAME[17]" : fmt::format("did you mean '{}'?", meant)};
}

}  // namespace riprap::scene
