#include "struct_binding.hpp"

#include <algorithm>

namespace wristwise::python {

namespace {

constexpr py::ssize_t kLongArray = 16;  // numbers, above which a repr gives the shape alone
constexpr std::size_t kLongTuple = 4;

std::string value_text(const py::object& value) {
  if (py::isinstance<py::array>(value)) {
    const py::array array = py::reinterpret_borrow<py::array>(value);
    if (array.size() > kLongArray)
      return "<array " + py::repr(array.attr("shape")).cast<std::string>() + ">";
    return py::repr(array.attr("tolist")());
  }
  if (py::isinstance<py::tuple>(value) && py::len(value) > kLongTuple &&
      !py::isinstance<py::str>(py::reinterpret_borrow<py::tuple>(value)[0])) {
    const py::object first = py::reinterpret_borrow<py::tuple>(value)[0];
    return "<" + std::to_string(py::len(value)) + " " +
           py::type::of(first).attr("__qualname__").cast<std::string>() + ">";
  }
  return py::repr(value);
}

const Field* find(const Fields& fields, const std::string& name) {
  const auto found = std::find_if(fields.begin(), fields.end(),
                                  [&](const Field& field) { return field.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

/// What pickle can take: a mapping proxy it can't.
py::object plain(const py::object& value) {
  return Py_TYPE(value.ptr()) == &PyDictProxy_Type ? py::object(py::dict(value)) : value;
}

[[noreturn]] void fail_unknown(const std::string& type, const Fields& fields,
                               const std::string& name) {
  py::list names;
  for (const Field& field : fields) names.append(field.name);
  const py::list close = py::module_::import("difflib").attr("get_close_matches")(name, names, 1);
  const std::string hint = close.empty() ? "expected one of " + py::repr(names).cast<std::string>()
                                         : "did you mean '" + close[0].cast<std::string>() + "'?";
  throw py::type_error(type + " has no attribute '" + name + "'; " + hint);
}

}  // namespace

void fail_type(const std::string& where, py::handle value, const std::string& expected) {
  std::string text = py::repr(value);
  if (text.size() > 80) text = text.substr(0, 77) + "...";
  throw py::type_error(where + ": " + text + "; expected " + expected);
}

void assign_keywords(const std::string& type, const Fields& fields, void* self,
                     const py::kwargs& keywords, bool partial) {
  for (const auto& [key, value] : keywords) {
    const std::string name = py::str(key);
    const Field* field = find(fields, name);
    if (field == nullptr) fail_unknown(type, fields, name);
    field->set(self, value);
  }
  if (partial) return;
  for (const Field& field : fields)
    if (field.required && !keywords.contains(field.name))
      throw py::type_error(type + ": '" + field.name + "' is missing");
}

std::string struct_text(const std::string& type, const Fields& fields, py::handle self,
                        py::handle defaults) {
  std::string text;
  for (const Field& field : fields) {
    const std::string value = value_text(field.get(self));
    if (!field.required && value == value_text(field.get(defaults))) continue;
    text += (text.empty() ? "" : ", ") + field.name + "=" + value;
  }
  return type + "(" + text + ")";
}

py::dict struct_state(const Fields& fields, py::handle self) {
  py::dict state;
  for (const Field& field : fields) state[py::str(field.name)] = plain(field.get(self));
  return state;
}

void restore_state(const std::string& type, const Fields& fields, void* self,
                   const py::dict& state) {
  assign_keywords(type, fields, self, py::reinterpret_borrow<py::kwargs>(state), true);
}

py::object keyword_signature(const Fields& fields) {
  const py::module_ inspect = py::module_::import("inspect");
  const py::object keyword_only = inspect.attr("Parameter").attr("KEYWORD_ONLY");
  py::list parameters;
  for (const Field& field : fields) {
    const py::object fallback =
        field.required ? inspect.attr("Parameter").attr("empty") : py::object(py::ellipsis());
    parameters.append(
        inspect.attr("Parameter")(field.name, keyword_only, py::arg("default") = fallback));
  }
  return inspect.attr("Signature")(parameters);
}

}  // namespace wristwise::python
