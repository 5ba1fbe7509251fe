// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/glb.hpp"

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

namespace riprap::view {

namespace {

using Json = nlohmann::ordered_json;

constexpr int array_buffer = 34962, element_buffer = 34963;  // of a buffer view
constexpr int of_floats = 5126, of_indices = 5125;           // components of an accessor

/// Colours of the page, linear as glTF wants them.
constexpr std::array<std::array<double, 3>, 6> stone{{{0.485, 0.397, 0.263},
                                                      {0.275, 0.381, 0.479},
                                                      {0.552, 0.275, 0.144},
                                                      {0.292, 0.392, 0.188},
                                                      {0.392, 0.275, 0.434},
                                                      {0.584, 0.468, 0.112}}};
constexpr std::array<double, 3> fixed{0.323, 0.323, 0.305};

class Writer {
 public:
    Writer() {
        json_ = {{"asset", {{"version", "2.0"}, {"generator", "Riprap"}}}, {"scene", 0}};
        add_material("water", {0.03, 0.2, 0.4}, 0.75);
    }

    void add_water(const WaterMesh& water) {
        std::vector<std::uint32_t> indices;
        for (const auto& t : water.triangles) {
            for (const std::int32_t i : t) {
                indices.push_back(static_cast<std::uint32_t>(i));
            }
        }
        nodes_.push_back({{"name", "water"}, {"mesh", add_mesh(water.points, water.normals, indices, 0)}});
    }

    void add_body(const PlacedBody& body) {
        const int material = material_of(body);
        const auto [known, is_new] = mesh_of_.try_emplace({body.shape_index, material}, 0);
        if (is_new) {
            known->second = add_shape(*body.shape, material);
        }
        const Quat& q = body.orientation;
        nodes_.push_back({{"name", body.name},
                          {"mesh", known->second},
                          {"translation", {body.position.x, body.position.y, body.position.z}},
                          {"rotation", {q.x, q.y, q.z, q.w}}});
    }

    std::string finish(const Vec3& gravity) {
        Json children = Json::array();
        for (std::size_t k = 0; k < nodes_.size(); ++k) {
            children.push_back(k);
        }
        nodes_.push_back({{"name", "scene"}, {"children", children}, {"rotation", upright(gravity)}});
        json_["scenes"] = {{{"nodes", {nodes_.size() - 1}}}};
        json_["nodes"] = nodes_;
        json_["meshes"] = meshes_;
        json_["materials"] = materials_;
        json_["accessors"] = accessors_;
        json_["bufferViews"] = views_;
        json_["buffers"] = {{{"byteLength", bytes_.size()}}};
        return container(json_.dump(-1, ' ', false, Json::error_handler_t::replace));
    }

 private:
    /// The turn that takes "against gravity" to +y, as x, y, z, w; only along an axis.
    static Json upright(const Vec3& gravity) {
        const double half = std::sqrt(0.5);
        if (std::fabs(gravity.z) >= std::fabs(gravity.y) && gravity.z != 0) {
            return {gravity.z < 0 ? -half : half, 0, 0, half};
        }
        return gravity.y > 0 ? Json{1, 0, 0, 0} : Json{0, 0, 0, 1};
    }

    int add_material(const std::string& name, const std::array<double, 3>& colour, double opacity) {
        Json material{{"name", name},
                      {"pbrMetallicRoughness",
                       {{"baseColorFactor", {colour[0], colour[1], colour[2], opacity}},
                        {"metallicFactor", 0},
                        {"roughnessFactor", opacity < 1 ? 0.1 : 0.9}}}};
        if (opacity < 1) {
            material["alphaMode"] = "BLEND";
            material["doubleSided"] = true;
        }
        materials_.push_back(std::move(material));
        return static_cast<int>(materials_.size()) - 1;
    }

    int material_of(const PlacedBody& body) {
        const int key = body.is_free ? body.material : -1;
        const auto [known, is_new] = material_.try_emplace(key, 0);
        if (is_new) {
            known->second = key < 0 ? add_material("fixed or driven", fixed, 1)
                                    : add_material("material " + std::to_string(key + 1),
                                                   stone[static_cast<std::size_t>(key) % stone.size()], 1);
        }
        return known->second;
    }

    /// Faces are flat: no corner is shared.
    int add_shape(const DrawnShape& shape, int material) {
        std::vector<Vec3> points, normals;
        std::vector<std::uint32_t> indices;
        for (const auto& face : shape.faces) {
            const auto corner = [&](std::size_t k) { return shape.corners[static_cast<std::size_t>(face[k])]; };
            Vec3 normal{};
            for (std::size_t k = 2; k < face.size(); ++k) {
                normal += cross(corner(k - 1) - corner(0), corner(k) - corner(0));
            }
            normal = norm(normal) > 0 ? normal / norm(normal) : Vec3{0, 0, 1};
            const auto first = static_cast<std::uint32_t>(points.size());
            for (std::size_t k = 0; k < face.size(); ++k) {
                points.push_back(corner(k));
                normals.push_back(normal);
            }
            for (std::uint32_t k = 2; k < face.size(); ++k) {
                indices.insert(indices.end(), {first, first + k - 1, first + k});
            }
        }
        return add_mesh(points, normals, indices, material);
    }

    int add_mesh(const std::vector<Vec3>& points, const std::vector<Vec3>& normals,
                 const std::vector<std::uint32_t>& indices, int material) {
        const int position = add_vectors(points, true), normal = add_vectors(normals, false);
        std::string bytes(reinterpret_cast<const char*>(indices.data()), 4 * indices.size());
        const int list = add_accessor(bytes, element_buffer, of_indices, "SCALAR", indices.size());
        meshes_.push_back({{"primitives",
                            {{{"attributes", {{"POSITION", position}, {"NORMAL", normal}}},
                              {"indices", list},
                              {"material", material}}}}});
        return static_cast<int>(meshes_.size()) - 1;
    }

    int add_vectors(const std::vector<Vec3>& vectors, bool has_bounds) {
        std::string bytes;
        std::array<float, 3> low{1e38F, 1e38F, 1e38F}, high{-1e38F, -1e38F, -1e38F};
        for (const Vec3& v : vectors) {
            for (int axis = 0; axis < 3; ++axis) {
                const auto value = static_cast<float>(v[axis]);
                const auto k = static_cast<std::size_t>(axis);
                low[k] = std::fmin(low[k], value);
                high[k] = std::fmax(high[k], value);
                bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
            }
        }
        const int accessor = add_accessor(bytes, array_buffer, of_floats, "VEC3", vectors.size());
        if (has_bounds) {
            accessors_.back()["min"] = low;
            accessors_.back()["max"] = high;
        }
        return accessor;
    }

    int add_accessor(const std::string& bytes, int target, int component, const char* type, std::size_t count) {
        views_.push_back(
            {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}, {"target", target}});
        bytes_ += bytes;  // words of four bytes: always aligned
        accessors_.push_back(
            {{"bufferView", views_.size() - 1}, {"componentType", component}, {"count", count}, {"type", type}});
        return static_cast<int>(accessors_.size()) - 1;
    }

    std::string container(std::string text) const {
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string file;
        const auto word = [&file](std::size_t value) {
            const auto narrow = static_cast<std::uint32_t>(value);
            file.append(reinterpret_cast<const char*>(&narrow), sizeof narrow);
        };
        word(0x46546C67);  // "glTF"
        word(2);
        word(12 + 8 + text.size() + 8 + bytes_.size());
        word(text.size());
        word(0x4E4F534A);  // "JSON"
        file += text;
        word(bytes_.size());
        word(0x004E4942);  // "BIN"
        return file + bytes_;
    }

    Json json_, nodes_ = Json::array(), meshes_ = Json::array(), materials_ = Json::array(), accessors_ = Json::array(),
                views_ = Json::array();
    std::string bytes_;
    std::map<std::pair<std::size_t, int>, int> mesh_of_;  ///< by shape and material
    std::map<int, int> material_;
};

}  // namespace

std::string glb_of(const WaterMesh& water, const std::vector<PlacedBody>& bodies, const Vec3& gravity) {
    Writer writer;
    if (!water.triangles.empty()) {
        writer.add_water(water);
    }
    for (const PlacedBody& body : bodies) {
        writer.add_body(body);
    }
    return writer.finish(gravity);
}

}  // namespace riprap::view
