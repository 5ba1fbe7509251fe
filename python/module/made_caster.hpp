// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

namespace riprap::python {

/// Lets functions have only objects that a constructor of this module has made: of one that came from `T.__new__(T)`
/// pybind11 would hand out memory that nobody has filled. Such an object is no argument for any function: TypeError.
template <class T>
struct MadeCaster : pybind11::detail::type_caster_base<T> {
    bool load(pybind11::handle source, bool is_converting) {
        const pybind11::handle type = pybind11::detail::get_type_handle(typeid(T), false);
        if (type && pybind11::isinstance(source, type)) {
            auto* const object = reinterpret_cast<pybind11::detail::instance*>(source.ptr());
            if (!object->get_value_and_holder(pybind11::detail::get_type_info(typeid(T))).holder_constructed()) {
                return false;
            }
        }
        return pybind11::detail::type_caster_base<T>::load(source, is_converting);
    }
};

}  // namespace riprap::python
