#include "bindings.h"

#include <specbake/core/error.h>

namespace py = pybind11;

namespace specbake::python {
namespace {

/// Exceptions live as long as the interpreter: nothing may take them down before.
struct Exceptions {
    py::handle base, argument, file, cancelled;
};

Exceptions& exceptions() {
    static Exceptions all;
    return all;
}

py::handle made(py::module_& module, const char* name, const py::tuple& bases, const char* text) {
    const std::string whole = std::string("specbake.") + name;
    PyObject* type =
        PyErr_NewExceptionWithDoc(whole.c_str(), text, bases.ptr(), py::dict().release().ptr());
    if (type == nullptr) throw py::error_already_set();
    module.attr(name) = py::handle(type);
    return type;
}

/// An OSError whose `filename` is the file and whose `strerror` the reason.
void raiseFileError(const FileError& error) {
    const std::string what = error.what();
    const std::string reason = what.substr(error.file().size() + 2);
    const py::object raised = py::reinterpret_borrow<py::object>(exceptions().file)(
        py::int_(0), py::str(reason), py::str(error.file()));
    PyErr_SetObject(exceptions().file.ptr(), raised.ptr());
}

void translate(std::exception_ptr thrown) {
    try {
        if (thrown) std::rethrow_exception(thrown);
    } catch (const FileError& error) {
        raiseFileError(error);
    } catch (const ArgumentError& error) {
        PyErr_SetString(exceptions().argument.ptr(), error.what());
    } catch (const Cancelled& error) {
        PyErr_SetString(exceptions().cancelled.ptr(), error.what());
    } catch (const Error& error) {
        PyErr_SetString(exceptions().base.ptr(), error.what());
    }
}

}  // namespace

void addErrors(py::module_& module) {
    Exceptions& e = exceptions();
    e.base = made(module, "Error", py::make_tuple(py::handle(PyExc_Exception)),
                  "The base of everything that specbake raises.");
    e.argument = made(module, "ArgumentError", py::make_tuple(e.base, py::handle(PyExc_ValueError)),
                      "An argument outside its documented range.");
    e.file = made(module, "FileError", py::make_tuple(e.base, py::handle(PyExc_OSError)),
                  "A file that cannot be read, written or understood: `filename` and `strerror` "
                  "say which and why.");
    e.cancelled = made(module, "Cancelled", py::make_tuple(e.base), "Work that was stopped.");
    py::register_exception_translator(&translate);
}

}  // namespace specbake::python
