// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "../../fuzz/surface_fuzz.hpp"
#include "geometry/sample_surfaces.hpp"
#include "riprap/geometry/polyhedra/random_bits.hpp"
#include "riprap/geometry/surface/obj.hpp"
#include "riprap/geometry/surface/stl.hpp"

namespace riprap::geometry {
namespace {

/// Deterministic damage: bytes flipped, ranges cut, repeated or swapped with words that readers know.
std::string mutated(std::string bytes, std::uint64_t seed) {
    static const std::vector<std::string> words{
        "nan",      "-inf", "1e308", "1e-320",  " facet ",    "endloop", "\n",
        "solid",    "/",    "-1",    "f 1 2 3", "9999999999", "v ",      std::string(1, '\0'),
        "\xff\xff", "0",    "0.5",   "\\\n"};
    auto draw = [&, n = std::uint64_t{0}](std::size_t below) mutable {
        return below == 0 ? 0 : static_cast<std::size_t>(mix_bits(seed, n++) % below);
    };
    for (std::size_t changes = 1 + draw(6); changes > 0; --changes) {
        const std::size_t at = draw(bytes.size() + 1), length = draw(std::min<std::size_t>(60, bytes.size() - at + 1));
        switch (draw(5)) {
            case 0:
                if (at < bytes.size()) {
                    bytes[at] = static_cast<char>(draw(256));
                }
                break;
            case 1:
                bytes.erase(at, length);
                break;
            case 2:
                bytes.insert(at, bytes.substr(at, length));
                break;
            case 3:
                bytes.insert(at, words[draw(words.size())]);
                break;
            default:
                bytes.replace(at, length, words[draw(words.size())]);
        }
    }
    return bytes;
}

template <class Read>
void damage_and_read(const std::vector<std::string>& samples, const Read& read) {
    constexpr std::uint64_t runs = 20'000;
    for (std::uint64_t run = 0; run < runs; ++run) {
        const std::string bytes = mutated(samples[run % samples.size()], run);
        ASSERT_NO_THROW(read_and_audit(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), read))
            << "run " << run;
    }
}

TEST(SurfaceMutations, DamagedStlFilesAreRefusedOrAuditedNeverWorse) {
    const std::vector<Polyhedron> boxes{sample_box({0, 0, 0}, {1, 2, 3}), sample_box({1, 0, 0}, {2, 2, 3})};
    damage_and_read(
        {sample_bytes("tetrahedron.stl"), sample_bytes("bad_numbers.stl"), binary_stl(sample_surface(boxes))},
        read_stl);
}

TEST(SurfaceMutations, DamagedObjFilesAreRefusedOrAuditedNeverWorse) {
    damage_and_read({sample_bytes("two_bodies.obj"), sample_bytes("bad_faces.obj")}, read_obj);
}

}  // namespace
}  // namespace riprap::geometry
