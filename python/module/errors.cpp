// SPDX-License-Identifier: Apache-2.0
#include "errors.hpp"

#include <array>
#include <exception>
#include <filesystem>
#include <utility>

#include "riprap/core/error.hpp"

namespace riprap::python {

namespace py = pybind11;

namespace {

/// A message of the library in the words of Python: it names options of the command line.
py::str said_in_python(std::string text) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 9> words{{
        {"--out writes elsewhere", "another `out` writes elsewhere"},
        {"another folder with --out", "another folder as `out`"},
        {"--force", "force=True"},
        {"--resume", "resume=True"},
        {"`riprap resume`", "resume=True"},
        {"write --set ", "write "},
        {"--set ", "override "},
        {"`riprap list`", "riprap.list()"},
        {"--out", "`out`"},
    }};
    for (const auto& [from, to] : words) {
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
            text.replace(at, from.size(), to);
        }
    }
    return {text};
}

void raise(const char* name, const py::object& argument) {
    const py::object type = py::module_::import("riprap.errors").attr(name);
    PyErr_SetObject(type.ptr(), type(argument).ptr());
}

void raise_case_error(const CaseError& error) {
    const py::object problem = py::module_::import("riprap.errors").attr("Problem");
    py::list problems;
    for (const Diagnostic& one : error.problems()) {
        problems.append(problem(said_in_python(one.place.file), one.place.line, one.place.column,
                                said_in_python(one.message), said_in_python(one.allowed)));
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
        raise("CheckpointError", said_in_python(error.what()));
    } catch (const FileError& error) {
        raise("FileError", said_in_python(error.what()));
    } catch (const std::filesystem::filesystem_error& error) {
        raise("FileError", said_in_python(error.what()));
    } catch (const NumericalError& error) {
        raise("NumericalError", said_in_python(error.what()));
    } catch (const InternalError& error) {
        raise("InternalError", said_in_python(error.what()));
    }
}

}  // namespace

void register_errors() {
    py::register_exception_translator([](std::exception_ptr failure) { translate(std::move(failure)); });
}

}  // namespace riprap::python
