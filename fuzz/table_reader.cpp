// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "refusal.hpp"
#include "riprap/geometry/text/number_table.hpp"

// Reads bytes as a table of numbers, with and without columns that are not read. What is read is finite, as wide as was
// asked for, and has a place in the text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace riprap;
    for (const bool may_have_more : {false, true}) {
        read_or_refuse(data, size, [may_have_more](std::string_view text) {
            geometry::TableForm form = geometry::table_of_places(1000);
            form.may_have_more = may_have_more;
            form.unit = [](std::size_t, std::string_view unit) {
                return geometry::UnitAnswer{unit == "m" || unit == "mm", true, unit == "mm" ? "metres" : ""};
            };
            const geometry::NumberTable table = geometry::read_number_table(text, "fuzz", form);
            bool is_sound = table.width == 3 && table.values.size() == 3 * table.row_count() &&
                            table.places.size() == table.values.size();
            for (std::size_t i = 0; i < table.row_count(); ++i) {
                for (std::size_t k = 0; k < 3; ++k) {
                    is_sound = is_sound && std::isfinite(table.at(i, k)) && table.place(i, k).column > 0;
                }
            }
            if (!is_sound) {
                std::abort();
            }
        });
    }
    return 0;
}
