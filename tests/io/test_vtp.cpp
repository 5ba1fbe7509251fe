// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <random>

#include "io/temporary_folder.hpp"
#include "io/vtk_reader.hpp"
#include "riprap/coupling/particle_walls/particle_method.hpp"
#include "riprap/fluid/particle/state_equation.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/io/fluid_frame.hpp"
#include "riprap/io/vtk_data.hpp"
#include "riprap/io/vtp.hpp"

namespace riprap::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::span<const unsigned char> as_bytes(const std::string& text) {
    return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

TEST(VtkData, Base64AgreesWithItsDefinition) {
    EXPECT_EQ(encode_base64(as_bytes("")), "");
    EXPECT_EQ(encode_base64(as_bytes("f")), "Zg==");
    EXPECT_EQ(encode_base64(as_bytes("fo")), "Zm8=");
    EXPECT_EQ(encode_base64(as_bytes("foobar")), "Zm9vYmFy");
}

TEST(VtkData, Base64ComesBackForEveryLengthAndRefusesOtherText) {
    std::mt19937 random(1);
    for (std::size_t length = 0; length < 70; ++length) {
        std::string bytes(length, '\0');
        for (char& c : bytes) {
            c = static_cast<char>(random());
        }
        EXPECT_EQ(decode_base64(encode_base64(as_bytes(bytes))), bytes);
    }
    EXPECT_THROW(decode_base64("Zg="), FileError);
    EXPECT_THROW(decode_base64("Z!=="), FileError);
    EXPECT_THROW(decode_base64("Zg==Zg=="), FileError);
}

TEST(VtkData, Base64OfPiecesIsThatOfTheWhole) {
    std::mt19937 random(2);
    std::string bytes(50, '\0');
    for (char& c : bytes) {
        c = static_cast<char>(random());
    }
    for (std::size_t first = 0; first <= 7; ++first) {
        for (std::size_t second = 0; second <= 7; ++second) {
            std::string text;
            const TextSink put = [&text](std::string_view piece) { text += piece; };
            Base64Text pieces(put);
            pieces.add(as_bytes(bytes).first(first));
            pieces.add(as_bytes(bytes).subspan(first, second));
            pieces.add(as_bytes(bytes).subspan(first + second));
            pieces.finish();
            EXPECT_EQ(text, encode_base64(as_bytes(bytes))) << first << ' ' << second;
        }
    }
}

TEST(VtkData, AnArrayOfSeveralBlocksComesBack) {
    for (const std::size_t count : {0UL, 1UL, 65'536UL, 65'537UL, 200'000UL}) {  // 65 536 floats fill one block
        std::vector<float> values(count);
        std::iota(values.begin(), values.end(), 0.5F);
        EXPECT_EQ(vtk_reader::array<float>(vtk_array("v", values), "v"), values) << count;
    }
}

PolyData square_and_triangle() {
    PolyData data;
    data.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
    data.connectivity = {0, 1, 2, 3, 0, 1, 4};
    data.offsets = {4, 7};
    data.add_cell_array("speed", std::array{1.0F, 2.0F});
    data.add_point_array("tag", std::array<std::int32_t, 5>{1, 2, 3, 4, 5});
    return data;
}

TEST(Vtp, PolygonsComeBackWithTheirArraysAndTime) {
    const TemporaryFolder folder;
    write_vtp(folder / "a.vtp", square_and_triangle(), 0.1);
    const std::string xml = read_file(folder / "a.vtp", 1U << 20U);
    const std::string piece = vtk_reader::tag(xml, "<Piece");
    EXPECT_EQ(vtk_reader::attribute(piece, "NumberOfPoints"), "5");
    EXPECT_EQ(vtk_reader::attribute(piece, "NumberOfPolys"), "2");
    EXPECT_EQ(vtk_reader::attribute(piece, "NumberOfVerts"), "0");
    EXPECT_EQ(vtk_reader::attribute(vtk_reader::tag(xml, "<VTKFile"), "header_type"), "UInt64");
    EXPECT_THAT(vtk_reader::array<std::int32_t>(xml, "connectivity"), ElementsAre(0, 1, 2, 3, 0, 1, 4));
    EXPECT_THAT(vtk_reader::array<std::int32_t>(xml, "offsets"), ElementsAre(4, 7));
    EXPECT_THAT(vtk_reader::array<float>(xml, "speed"), ElementsAre(1.0F, 2.0F));
    EXPECT_THAT(vtk_reader::array<std::int32_t>(xml, "tag"), ElementsAre(1, 2, 3, 4, 5));
    const auto points = vtk_reader::array<double>(xml, "Points");
    ASSERT_EQ(points.size(), 15U);
    EXPECT_EQ(points[14], 1.0);
    EXPECT_THAT(xml, HasSubstr("format=\"ascii\">0.1<"));
}

TEST(Vtp, AnAppendedLayoutIsNeverUsed) {
    const TemporaryFolder folder;
    write_vtp(folder / "a.vtp", square_and_triangle(), 0);
    EXPECT_EQ(read_file(folder / "a.vtp", 1U << 20U).find("ppended"), std::string::npos);
}

TEST(Vtp, ACloudOfPointsHasOneVertexCellPerPoint) {
    const TemporaryFolder folder;
    PolyData data;
    data.is_point_cloud = true;
    data.points = {{1, 2, 3}, {4, 5, 6}};
    write_vtp(folder / "a.vtp", data, 0);
    const std::string xml = read_file(folder / "a.vtp", 1U << 20U);
    EXPECT_EQ(vtk_reader::attribute(vtk_reader::tag(xml, "<Piece"), "NumberOfVerts"), "2");
    EXPECT_THAT(vtk_reader::array<std::int32_t>(xml, "connectivity"), ElementsAre(0, 1));
    EXPECT_THAT(vtk_reader::array<std::int32_t>(xml, "offsets"), ElementsAre(1, 2));
}

fluid::ShownFluid shown(const fluid::SphSettings& settings, const fluid::ParticleState& particles) {
    coupling::ParticleFluid water;
    water.scheme = settings;
    const geometry::ShapeSet shapes;
    const body::BodySet bodies;
    const body::Gravity gravity;
    const coupling::FluidScene scene{shapes, bodies, gravity};
    return coupling::ParticleMethod::shown({scene, water, particles, {}});
}

TEST(Vtp, WaterIsACloudOfItsParticlesWithTheirPressure) {
    const TemporaryFolder folder;
    fluid::SphSettings settings;
    settings.sound_speed = 20;
    settings.state_equation = fluid::StateEquation::linear;
    fluid::ParticleState particles;
    particles.position = {{1, 2, 3}, {4, 5, 6}};
    particles.velocity = {{3, 0, 4}, {0, 0, 0}};
    particles.density = {1010, 1000};
    particles.id = {7, 3};
    write_fluid(folder / "a.vtp", shown(settings, particles), 0);
    const std::string xml = read_file(folder / "a.vtp", 1U << 20U);
    EXPECT_THAT(vtk_reader::array<std::int32_t>(xml, "id"), ElementsAre(7, 3));
    EXPECT_THAT(vtk_reader::array<float>(xml, "speed"), ElementsAre(5, 0));
    EXPECT_THAT(vtk_reader::array<float>(xml, "pressure"), ElementsAre(4000, 0));  // c^2 (rho - rho_0)
}

// More particles than fill a block of any array, so that pieces meet within threes of base64.
TEST(Vtp, WaterPutPieceByPieceIsTheSameTextAsOfAFrameBuiltFirst) {
    fluid::SphSettings settings;
    settings.spacing = 0.25;
    settings.sound_speed = 20;
    settings.state_equation = fluid::StateEquation::linear;
    fluid::ParticleState particles;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(-1, 1);
    for (int i = 0; i < 70'001; ++i) {
        particles.add({share(random), share(random), share(random)}, {share(random), share(random), share(random)},
                      1000 + share(random), i);
    }
    PolyData data;
    data.is_point_cloud = true;
    data.points = particles.position;
    data.add_field_array("spacing", std::array{settings.spacing});
    std::vector<float> velocity, speed, density, pressure;
    for (std::size_t i = 0; i < particles.position.size(); ++i) {
        const Vec3& v = particles.velocity[i];
        velocity.insert(velocity.end(), {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
        speed.push_back(static_cast<float>(norm(v)));
        density.push_back(static_cast<float>(particles.density[i]));
        pressure.push_back(static_cast<float>(pressure_of(settings, particles.density[i])));
    }
    data.add_point_array("id", particles.id);
    data.add_point_array("velocity", velocity, 3);
    data.add_point_array("speed", speed);
    data.add_point_array("density", density);
    data.add_point_array("pressure", pressure);
    std::string text;
    put_fluid([&text](std::string_view piece) { text += piece; }, shown(settings, particles), 0.125);
    EXPECT_TRUE(text == encode_vtp(data, 0.125));
    EXPECT_EQ(vtk_reader::array<float>(text, "velocity"), velocity);
}

TEST(Pvd, EveryFrameIsListedWithItsTime) {
    const TemporaryFolder folder;
    write_pvd(folder / "out.pvd", std::array{PvdFrame{0, "frames/a.vtp"}, PvdFrame{0.25, "frames/b.vtp", 1}});
    const std::string xml = read_file(folder / "out.pvd", 1U << 20U);
    EXPECT_THAT(xml, HasSubstr("timestep=\"0\" part=\"0\" file=\"frames/a.vtp\""));
    EXPECT_THAT(xml, HasSubstr("timestep=\"0.25\" part=\"1\" file=\"frames/b.vtp\""));
}

}  // namespace
}  // namespace riprap::io
