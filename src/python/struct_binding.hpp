#pragma once

// A plain struct as a Python class: attributes of the same names, a constructor by keywords, a
// repr of what differs from the defaults, replace(), and pickling (which copy uses too).

#include <pybind11/pybind11.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "array_casters.hpp"
#include "container_casters.hpp"
#include "wristwise/error.hpp"

namespace wristwise::python {

/// Whether attributes can be assigned. What stands in tuples is frozen: a copy that could be
/// written to would lose what is written.
enum class Access { frozen, writable };

/// One attribute, its struct behind a pointer.
struct Field {
  std::string name;
  py::object get;  ///< the function behind the property
  std::function<void(void* self, py::handle value)> set;
  bool required = false;  ///< has no default
};
using Fields = std::vector<Field>;

/// Assigns what the keywords say. @throws TypeError for an unknown or a missing one
void assign_keywords(const std::string& type, const Fields& fields, void* self,
                     const py::kwargs& keywords, bool partial);
/// "Type(name=value, ...)" with the attributes that differ from those of `defaults`.
std::string struct_text(const std::string& type, const Fields& fields, py::handle self,
                        py::handle defaults);
py::dict struct_state(const Fields& fields, py::handle self);
void restore_state(const std::string& type, const Fields& fields, void* self,
                   const py::dict& state);
/// inspect.Signature for help() and editors.
py::object keyword_signature(const Fields& fields);
[[noreturn]] void fail_type(const std::string& where, py::handle value,
                            const std::string& expected);

template <class M>
inline constexpr bool kIsObject =
    std::is_base_of_v<py::detail::type_caster_generic, py::detail::make_caster<M>>;
template <class M>
inline constexpr bool kIsObject<std::shared_ptr<M>> = false;  // None is null

/// @param where the attribute, for messages
template <class M>
M converted(py::handle value, const std::string& where, const std::string& expected) {
  try {
    py::detail::make_caster<M> caster;
    if ((kIsObject<M> && value.is_none()) || !caster.load(value, true))
      fail_type(where, value, expected);
    if constexpr (std::is_same_v<M, double>)
      if (std::isnan(static_cast<double>(caster))) throw BadArray{"NaN", "a number"};
    return py::detail::cast_op<const M&>(caster);
  } catch (const BadArray& bad) {
    throw InvalidInput(where, bad.problem, bad.expected);
  }
}

template <class T>
class StructBinding {
 public:
  using Class = py::class_<T>;

  StructBinding(py::handle scope, const char* name, const char* doc, Access access)
      : class_(scope, name, doc), name_(name), access_(access) {}

  template <class M>
  StructBinding& field(const char* name, M T::*member, const char* doc) {
    return field(
        name, [member](T& self) -> M& { return self.*member; },
        [member](T& self, M value) { self.*member = std::move(value); }, doc);
  }

  /// An attribute with a type of its own on the side of Python.
  template <class Get, class Set>
  StructBinding& field(const char* name, const Get& get, const Set& set, const char* doc) {
    return add<Get, Set>(name, get, set, &Set::operator(), doc);
  }

  /// The attribute before this has no default.
  StructBinding& required() {
    fields_->back().required = true;
    return *this;
  }

  /// What the constructor and replace() throw InvalidInput by.
  StructBinding& checked(std::function<void(const T&)> check) {
    check_ = std::move(check);
    return *this;
  }

  /// Adds constructor, repr, replace and pickling.
  Class done(bool constructible = true) {
    const auto fields = fields_;
    const std::string name = name_;
    if (constructible) {
      class_.def(py::init([fields, name, check = check_](const py::kwargs& keywords) {
                   T value{};
                   assign_keywords(name, *fields, &value, keywords, false);
                   if (check) check(value);
                   return value;
                 }),
                 "By keywords; what is left out has its default.");
      class_.def(
          "replace",
          [fields, name, check = check_](const T& self, const py::kwargs& changes) {
            T copy = self;
            assign_keywords(name, *fields, &copy, changes, true);
            if (check) check(copy);
            return copy;
          },
          "A copy with the attributes that are given changed.");
      class_.attr("__signature__") = keyword_signature(*fields);
    }
    class_.def("__repr__", [fields, name](py::handle self) {
      return struct_text(name, *fields, self, py::cast(with_defaults()));
    });
    class_.def(py::pickle([fields](py::handle self) { return struct_state(*fields, self); },
                          [fields, name](const py::dict& state) {
                            T value{};
                            restore_state(name, *fields, &value, state);
                            return value;
                          }));
    return class_;
  }

  Class& python_class() { return class_; }

 private:
  template <class Get, class Set, class M>
  StructBinding& add(const char* name, const Get& get, const Set& set, void (Set::*)(T&, M) const,
                     const char* doc) {
    const std::string where = name_ + "." + name;
    const py::cpp_function getter(get, py::is_method(class_),
                                  py::return_value_policy::reference_internal);
    const std::string expected = type_text(getter);
    const auto assign = [set, where, expected](T& self, py::handle value) {
      set(self, converted<M>(value, where, expected));
    };
    fields_->push_back({name, getter, [assign](void* self, py::handle value) {
                          assign(*static_cast<T*>(self), value);
                        }});
    if (access_ == Access::writable)
      class_.def_property(name, getter, py::cpp_function(assign, py::is_method(class_)), doc);
    else
      class_.def_property_readonly(name, getter, doc);
    return *this;
  }

  /// Some structs leave members without a default, which GCC sees where this is inlined.
  [[gnu::noinline]] static T with_defaults() { return T{}; }

  /// What the getter's docstring says behind the arrow.
  static std::string type_text(const py::cpp_function& getter) {
    const std::string signature = py::str(getter.attr("__doc__"));
    return signature.substr(signature.find("-> ") + 3,
                            signature.find('\n') - signature.find("-> ") - 3);
  }

  Class class_;
  std::string name_;
  Access access_;
  std::function<void(const T&)> check_;
  std::shared_ptr<Fields> fields_ = std::make_shared<Fields>();
};

}  // namespace wristwise::python
