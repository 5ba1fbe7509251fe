// SPDX-License-Identifier: Apache-2.0
#pragma once

// Bodies over time: every shape once, in the frame of its body, and a pose per body and frame in double precision, so
// that the page can print what bodies.csv says.

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "riprap/core/quat.hpp"
#include "riprap/io/vtp_reader.hpp"

namespace riprap::view {

/// A body as it is drawn: polygons over corners, about the centre of mass.
struct DrawnShape {
    std::vector<Vec3> corners;                     ///< [m]
    std::vector<std::vector<std::int32_t>> faces;  ///< corners of every polygon, counter-clockwise seen from outside
};

/// Bodies as all frames of a run share them.
struct DrawnBodies {
    std::vector<DrawnShape> shapes;             ///< each once, however many bodies have it
    std::vector<std::int32_t> shape, material;  ///< of each body
    std::vector<std::size_t> first_face;        ///< of each body, among the polygons of a frame
    std::vector<std::string> shown;             ///< "NAME [UNIT]" of the fields that the solid method shows
    std::size_t body_count() const { return shape.size(); }
};

/// Values per body and frame: position (3) and orientation (w, x, y, z).
inline constexpr std::size_t pose_values = 7;
/// Velocity (3), angular velocity (3), contact force (3), whether it is free.
inline constexpr std::size_t motion_values = 10;

/// Bodies of one frame.
struct BodyFrame {
    std::vector<double> pose;
    std::vector<float> motion;  ///< the contact force is NaN where it is not known
    std::vector<float> shown;   ///< per body the values of the shown fields
};

/// Takes the shapes from a frame. @throws FileError
DrawnBodies read_shapes(const io::VtpFile& frame);

/// @throws FileError when the frame has other bodies
BodyFrame read_body_frame(const io::VtpFile& frame, const DrawnBodies& bodies);

/// Contacts of one frame, a row each: point (3) [m], force on the first body (3) [N], overlap [m], bodies a and b,
/// whether it slides.
inline constexpr std::size_t contact_values = 10;
std::vector<float> read_contacts(const io::VtpFile& frame);

/// Frames of one group as a packed piece: rows are frames of equal length.
template <class T>
std::string pack_rows(std::span<const std::vector<T>> frames);

}  // namespace riprap::view
