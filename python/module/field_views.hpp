// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <vector>

#include "riprap/core/fields.hpp"

namespace riprap::python {

/// Hands out fields of a State as NumPy arrays on the very memory of the field: read-only, no copy. A step may move or
/// free that memory, so before one the memory of every field that somebody still holds an array of is left to those
/// arrays, and the State goes on with a copy. An array therefore shows, for as long as it is held, the moment at which
/// it was asked for; arrays that are not held cost nothing.
class FieldViews {
 public:
    /// @param owner  the Python object whose life keeps `field` in place
    template <class T>
    pybind11::array view(std::vector<T>& field, const pybind11::object& owner);

    /// Called with the interpreter's lock before anything that changes the State, or ends it. No value of it changes.
    void let_go();

 private:
    struct Slot {
        virtual ~Slot() = default;
        virtual void let_go() = 0;
    };
    /// Memory that a field has left behind; empty as long as the State has it.
    template <class T>
    struct Kept {
        std::vector<T> values;
        pybind11::object owner;  ///< the simulation, as long as it has the memory
    };
    template <class T>
    struct SlotOf final : Slot {
        std::vector<T>* field{nullptr};
        std::weak_ptr<Kept<T>> kept;
        void let_go() override {
            if (const auto held = kept.lock()) {
                std::vector<T> copy = *field;  // may run out of memory: then nothing has changed
                held->values = std::move(*field);
                *field = std::move(copy);
                held->owner = pybind11::none();  // no longer needed to keep the memory
            }
        }
    };
    /// Keeps the data of an array alive.
    template <class T>
    struct Anchor {
        std::shared_ptr<Kept<T>> kept;
    };

    std::vector<std::unique_ptr<Slot>> slots_;
};

template <class T>
pybind11::array FieldViews::view(std::vector<T>& field, const pybind11::object& owner) {
    namespace py = pybind11;
    using Number = std::conditional_t<FieldTraits<T>::type == FieldType::float64, double, T>;
    constexpr int components = FieldTraits<T>::components;
    static_assert(sizeof(T) == components * sizeof(Number));

    SlotOf<T>* slot = nullptr;
    for (const auto& one : slots_) {
        auto* candidate = dynamic_cast<SlotOf<T>*>(one.get());
        slot = candidate != nullptr && candidate->field == &field ? candidate : slot;
    }
    if (slot == nullptr) {
        auto fresh = std::make_unique<SlotOf<T>>();
        fresh->field = &field;
        slot = fresh.get();
        slots_.push_back(std::move(fresh));
    }
    std::shared_ptr<Kept<T>> kept = slot->kept.lock();
    if (kept == nullptr) {
        kept = std::make_shared<Kept<T>>();
        kept->owner = owner;
        slot->kept = kept;
    }
    auto anchor = std::make_unique<Anchor<T>>(Anchor<T>{std::move(kept)});
    const py::capsule base(anchor.get(), [](void* raw) { delete static_cast<Anchor<T>*>(raw); });
    anchor.release();  // NOLINT(bugprone-unused-return-value): the capsule has it
    std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(field.size())};
    if (components > 1) {
        shape.push_back(components);
    }
    py::array array(py::dtype::of<Number>(), shape, {}, field.data(), base);
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

inline void FieldViews::let_go() {
    for (const auto& slot : slots_) {
        slot->let_go();
    }
    slots_.clear();
}

}  // namespace riprap::python
