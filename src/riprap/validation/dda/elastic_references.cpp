// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/dda/elastic_references.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "riprap/core/index.hpp"

namespace riprap::validation::dda {

using geometry::Vec2;

namespace {

/// Replaces the lower triangle of a symmetric matrix of n rows by its Cholesky factor.
void factorize(std::vector<double>& a, std::size_t n) {
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t i = j; i < n; ++i) {
            double sum = a[i * n + j];
            for (std::size_t k = 0; k < j; ++k) {
                sum -= a[i * n + k] * a[j * n + k];
            }
            if (i == j && !(sum > 0)) {
                throw std::runtime_error("a mesh that nothing holds");
            }
            a[i * n + j] = i == j ? std::sqrt(sum) : sum / a[j * n + j];
        }
    }
}

std::vector<double> solve(const std::vector<double>& factor, std::size_t n, std::vector<double> x) {
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            x[i] -= factor[i * n + k] * x[k];
        }
        x[i] /= factor[i * n + i];
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = i + 1; k < n; ++k) {
            x[i] -= factor[k * n + i] * x[k];
        }
        x[i] /= factor[i * n + i];
    }
    return x;
}

std::vector<double> times(const std::vector<double>& a, const std::vector<double>& x) {
    std::vector<double> y(x.size(), 0.0);
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t k = 0; k < x.size(); ++k) {
            y[i] += a[i * x.size() + k] * x[k];
        }
    }
    return y;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        sum += a[k] * b[k];
    }
    return sum;
}

}  // namespace

TriangleMesh::TriangleMesh(double youngs_modulus, double poisson_ratio, double density)
    : youngs_modulus_(youngs_modulus), poisson_ratio_(poisson_ratio), density_(density) {}

std::int32_t TriangleMesh::node_at(const Vec2& place) const {
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        if (norm(nodes_[k] - place) < 1e-9) {
            return static_cast<std::int32_t>(k);
        }
    }
    return -1;
}

std::int32_t TriangleMesh::find_or_add(const Vec2& place) {
    const std::int32_t found = node_at(place);
    if (found >= 0) {
        return found;
    }
    nodes_.push_back(place);
    is_held_.push_back(0);
    force_.resize(2 * nodes_.size(), 0.0);
    return static_cast<std::int32_t>(nodes_.size()) - 1;
}

void TriangleMesh::add(const std::array<Vec2, 3>& corners) {
    triangles_.push_back({find_or_add(corners[0]), find_or_add(corners[1]), find_or_add(corners[2])});
}

void TriangleMesh::hold(const Vec2& place) { is_held_[at(find_or_add(place))] = 1; }

void TriangleMesh::load(const Vec2& place, const Vec2& force) {
    const std::size_t node = at(find_or_add(place));
    force_[2 * node] += force.x;
    force_[2 * node + 1] += force.y;
}

void TriangleMesh::assemble(std::vector<double>& stiffness, std::vector<double>& mass) const {
    const std::size_t n = size();
    stiffness.assign(n * n, 0.0);
    mass.assign(n * n, 0.0);
    const double nu = poisson_ratio_, e = youngs_modulus_ / (1 - nu * nu);
    const double elastic[3][3] = {{e, nu * e, 0}, {nu * e, e, 0}, {0, 0, 0.5 * (1 - nu) * e}};
    for (const auto& triangle : triangles_) {
        const Vec2 p[3] = {nodes_[at(triangle[0])], nodes_[at(triangle[1])], nodes_[at(triangle[2])]};
        const double area = 0.5 * cross(p[1] - p[0], p[2] - p[0]);
        double strain[3][6] = {};  // exx, eyy, gxy of unit displacements
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 &q = p[(k + 1) % 3], &r = p[(k + 2) % 3];
            strain[0][2 * k] = strain[2][2 * k + 1] = (q.y - r.y) / (2 * area);
            strain[1][2 * k + 1] = strain[2][2 * k] = (r.x - q.x) / (2 * area);
        }
        for (std::size_t i = 0; i < 6; ++i) {
            for (std::size_t j = 0; j < 6; ++j) {
                const std::size_t place = (2 * at(triangle[i / 2]) + i % 2) * n + 2 * at(triangle[j / 2]) + j % 2;
                for (std::size_t s = 0; s < 3; ++s) {
                    for (std::size_t t = 0; t < 3; ++t) {
                        stiffness[place] += area * strain[s][i] * elastic[s][t] * strain[t][j];
                    }
                }
                mass[place] += i % 2 == j % 2 ? density_ * area / (i == j ? 6 : 12) : 0;
            }
        }
    }
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
        for (std::size_t d = 2 * node; is_held_[node] != 0 && d < 2 * node + 2; ++d) {
            for (std::size_t k = 0; k < n; ++k) {
                stiffness[d * n + k] = stiffness[k * n + d] = mass[d * n + k] = mass[k * n + d] = 0;
            }
            stiffness[d * n + d] = 1;
        }
    }
}

std::vector<double> TriangleMesh::deflect() const {
    std::vector<double> stiffness, mass;
    assemble(stiffness, mass);
    factorize(stiffness, size());
    return solve(stiffness, size(), force_);
}

double TriangleMesh::first_frequency() const {
    std::vector<double> stiffness, mass;
    assemble(stiffness, mass);
    factorize(stiffness, size());
    std::vector<double> x = solve(stiffness, size(), force_);
    double squared = 0;
    for (int k = 0; k < 50; ++k) {  // inverse iteration
        std::vector<double> right = times(mass, x);
        x = solve(stiffness, size(), right);
        squared = dot(x, right) / dot(x, times(mass, x));
        const double length = std::sqrt(dot(x, x));
        for (double& value : x) {
            value /= length;
        }
    }
    return std::sqrt(squared);
}

double rebound_of(const FlyingBar& bar, double time) {
    const std::size_t nodes = at(bar.elements) + 1;
    const double size = bar.length / bar.elements, mass = bar.density * bar.area * size;
    const double stiffness = bar.youngs_modulus * bar.area / size;
    std::vector<double> place(nodes, 0.0), speed(nodes, -bar.speed), force(nodes), diagonal(nodes), push(nodes);
    const double fastest = 2 * std::sqrt(std::max(stiffness, bar.wall_stiffness) / (mass / 6));
    const double dt = 0.1 / fastest;
    const auto steps = static_cast<std::int64_t>(time / dt);
    for (std::int64_t step = 0; step < steps; ++step) {
        for (std::size_t k = 0; k < nodes; ++k) {
            place[k] += dt * speed[k];
            force[k] = 0;
        }
        for (std::size_t k = 0; k + 1 < nodes; ++k) {
            const double pull = stiffness * (place[k + 1] - place[k]);
            force[k] += pull;
            force[k + 1] -= pull;
        }
        force[0] += bar.wall_stiffness * std::max(0.0, -place[0]);
        // M a = f, M with m/3 + m/3 on the diagonal and m/6 beside it
        const double beside = mass / 6;
        for (std::size_t k = 0; k < nodes; ++k) {
            diagonal[k] = mass / (k == 0 || k + 1 == nodes ? 3 : 1.5);
            push[k] = force[k];
            if (k > 0) {
                diagonal[k] -= beside * beside / diagonal[k - 1];
                push[k] -= beside / diagonal[k - 1] * push[k - 1];
            }
        }
        double next = 0;
        for (std::size_t k = nodes; k-- > 0;) {
            next = (push[k] - beside * next) / diagonal[k];
            speed[k] += dt * next;
        }
    }
    double momentum = 0;
    for (std::size_t k = 0; k + 1 < nodes; ++k) {
        momentum += 0.5 * (speed[k] + speed[k + 1]) / bar.elements;
    }
    return momentum / bar.speed;
}

}  // namespace riprap::validation::dda
