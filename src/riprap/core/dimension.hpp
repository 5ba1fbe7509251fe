// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap {

/// Powers of metre, kilogram, second and radian. The radian is kept apart from plain numbers so that "26 deg" cannot
/// be given where a coefficient is wanted.
struct Dimension {
    int length{0}, mass{0}, time{0}, angle{0};
    friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
    constexpr bool is_plain() const { return *this == Dimension{}; }
};

namespace dimension {
inline constexpr Dimension plain{};
inline constexpr Dimension length{1, 0, 0, 0};
inline constexpr Dimension area{2, 0, 0, 0};
inline constexpr Dimension time{0, 0, 1, 0};
inline constexpr Dimension frequency{0, 0, -1, 0};
inline constexpr Dimension angle{0, 0, 0, 1};
inline constexpr Dimension velocity{1, 0, -1, 0};
inline constexpr Dimension acceleration{1, 0, -2, 0};
inline constexpr Dimension angular_velocity{0, 0, -1, 1};
inline constexpr Dimension density{-3, 1, 0, 0};
inline constexpr Dimension force{1, 1, -2, 0};
inline constexpr Dimension pressure{-1, 1, -2, 0};
inline constexpr Dimension kinematic_viscosity{2, 0, -1, 0};
inline constexpr Dimension stiffness{0, 1, -2, 0};
}  // namespace dimension

}  // namespace riprap
