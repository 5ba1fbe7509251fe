// SPDX-License-Identifier: Apache-2.0
#include "errors.hpp"

#include <exception>
#include <filesystem>

#include "riprap/core/error.hpp"

namespace riprap::python {

namespace py = pybind11;

namespace {

void raise(const char* name, const py::object& argument) {
    const py::object type = py::module_::import("riprap.errors").attr(name);
    PyErr_SetObject(type.ptr(), type(argument).ptr());
}

void raise_case_error(const CaseError& error) {
    const py::object problem = py::module_::import("riprap.errors").attr("Problem");
    py::list problems;
    for (const Diagnostic& one : error.problems()) {
        problems.append(problem(one.place.file, one.place.line, one.place.column, one.message, one.allowed));
    }
    raise("CaseError", problems);
}

void translate(std::exception_ptr failure) {
    try {
        if (failure) {
            std::rethrow_exception(failure);
        }
    } catch (const CaseError& error) {
        raise_case_error(error);
    } catch (const CheckpointError& error) {
        raise("CheckpointError", py::str(error.what()));
    } catch (const FileError& error) {
        raise("FileError", py::str(error.what()));
    } catch (const std::filesystem::filesystem_error& error) {
        raise("FileError", py::str(error.what()));
    } catch (const NumericalError& error) {
        raise("NumericalError", py::str(error.what()));
    } catch (const InternalError& error) {
        raise("InternalError", py::str(error.what()));
    }
}

}  // namespace

void register_errors() {
    py::register_exception_translator([](std::exception_ptr failure) { translate(std::move(failure)); });
}

}  // namespace riprap::python
