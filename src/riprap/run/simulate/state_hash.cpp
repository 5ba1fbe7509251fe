// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/simulate/state_hash.hpp"

#define XXH_INLINE_ALL
#ifdef __AVX512F__
#define XXH_VECTOR 1  // SSE2: in those of AVX-512 GCC 12 warns of numbers that are not set
#endif
#include <xxhash.h>

#include <memory>

#include "riprap/core/fields.hpp"

namespace riprap::run {

std::uint64_t xxh3_of(const sim::State& state) {
    const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> stream(XXH3_createState(), XXH3_freeState);
    XXH3_64bits_reset(stream.get());
    sim::State::visit_fields(state, [&](std::string_view name, const auto& field) {
        XXH3_64bits_update(stream.get(), name.data(), name.size());
        using Field = std::remove_cvref_t<decltype(field)>;
        if constexpr (is_field_array<Field>) {
            const std::uint64_t count = field.size();
            XXH3_64bits_update(stream.get(), &count, sizeof count);
            XXH3_64bits_update(stream.get(), field.data(), field.size() * sizeof(typename Field::value_type));
        } else {
            XXH3_64bits_update(stream.get(), &field, sizeof field);
        }
    });
    return XXH3_64bits_digest(stream.get());
}

}  // namespace riprap::run
