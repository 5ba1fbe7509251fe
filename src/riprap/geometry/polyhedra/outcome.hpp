// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "riprap/core/error.hpp"

namespace riprap::geometry {

/// Reason why a shape was refused. The reader of the case file knows the place and makes a Diagnostic of it.
struct GeometryProblem {
    std::string message;  ///< what was found and why it is refused, with vertex and face numbers from 0
    std::string allowed;  ///< what is allowed, or the remedy; may be empty
    friend bool operator==(const GeometryProblem&, const GeometryProblem&) = default;
};

/// The answer of every function of this folder that may refuse its input: a value, or all problems found.
/// Nothing in this folder throws because of input; value() of a refusal is a broken promise of the caller.
///
///     const Outcome<Polyhedron> hull = convex_hull(points);
///     if (!hull) report(hull.problems());
///     else use(hull.value());
template <class T>
class Outcome {
 public:
    Outcome(T value) : content_(std::in_place_index<0>, std::move(value)) {}
    Outcome(std::vector<GeometryProblem> problems) : content_(std::in_place_index<1>, std::move(problems)) {}
    Outcome(GeometryProblem problem)
        : content_(std::in_place_index<1>, std::vector<GeometryProblem>{std::move(problem)}) {}

    bool has_value() const { return content_.index() == 0; }
    explicit operator bool() const { return has_value(); }

    const T& value() const& {
        require_value();
        return *std::get_if<0>(&content_);
    }
    T&& value() && {
        require_value();
        return std::move(*std::get_if<0>(&content_));
    }
    /// Empty when there is a value.
    std::vector<GeometryProblem> problems() const {
        return has_value() ? std::vector<GeometryProblem>{} : *std::get_if<1>(&content_);
    }

 private:
    void require_value() const {
        if (!has_value()) {
            const auto& problems = *std::get_if<1>(&content_);
            throw InternalError("value of a refused shape: " + (problems.empty() ? "" : problems.front().message));
        }
    }
    std::variant<T, std::vector<GeometryProblem>> content_;
};

}  // namespace riprap::geometry
