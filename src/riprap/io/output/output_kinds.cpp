// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/output/output_kinds.hpp"

namespace riprap::io {

KeyList<OutputChoices> output_keys() {
    KeyList<OutputChoices> keys;
    for_each_output({}, [&keys]<class Kind>(const Kind& /*kind*/) {
        keys = std::move(keys) + KeyList<OutputChoices>(Kind::keys());
    });
    return keys;
}

std::vector<std::string_view> output_files() {
    std::vector<std::string_view> files;
    for_each_output({}, [&files]<class Kind>(const Kind& /*kind*/) {
        files.insert(files.end(), Kind::files.begin(), Kind::files.end());
    });
    return files;
}

std::size_t output_table_count() {
    std::size_t count = 0;
    for_each_output({}, [&count]<class Kind>(const Kind& /*kind*/) { count += Kind::has_table ? 1 : 0; });
    return count;
}

}  // namespace riprap::io
