// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/scratch.hpp"

#include "riprap/core/bytes.hpp"

namespace riprap::fluid::grid {

namespace {
template <class T>
std::size_t bytes_of_faces(const std::array<std::vector<T>, 3>& faces) {
    return bytes_of(faces[0], faces[1], faces[2]);
}
}  // namespace

std::size_t Room::bytes() const { return bytes_of(capacity, capacity_before) + bytes_of_faces(area); }
std::size_t StepStart::bytes() const {
    return bytes_of(fraction) + bytes_of_faces(carrier) + bytes_of_faces(pore_velocity);
}
std::size_t Transport::bytes() const {
    return bytes_of(colour, plane.number, plane.row_begin, plane.plane) + bytes_of_faces(flux) +
           bytes_of_faces(water_flux);
}
std::size_t Inertia::bytes() const { return bytes_of(mass, mass_before) + bytes_of_faces(mass_flux); }
std::size_t Stress::bytes() const { return bytes_of(viscosity, eddy_viscosity, curvature); }
std::size_t Projection::bytes() const {
    return bytes_of_faces(predicted) + bytes_of_faces(conductance.face) + solver.bytes();
}

std::size_t GridScratch::bytes() const {
    return bytes_of(medium.porosity, medium.linear, medium.quadratic, medium.added_mass, medium.grain_size, open.volume,
                    open.displacement) +
           bytes_of_faces(open.area) + bytes_of_faces(open.body_velocity) + bytes_of_faces(open.wall_distance) +
           room.bytes() + start.bytes() + moved.bytes() + inertia.bytes() + stress.bytes() + projection.bytes();
}

}  // namespace riprap::fluid::grid
