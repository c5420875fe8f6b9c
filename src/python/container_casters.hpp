#pragma once

// Containers of values become tuples and read-only mappings: they are copies, and a change that
// would be lost is an error. Any sequence or mapping is taken. An empty path is None.

#include <pybind11/pybind11.h>

#include <filesystem>
#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace pybind11::detail {

template <class T>
struct type_caster<std::vector<T>> {
  using Element = make_caster<T>;
  PYBIND11_TYPE_CASTER(std::vector<T>, const_name("Tuple[") + Element::name + const_name(", ...]"));

  bool load(handle source, bool convert) {
    if (isinstance<str>(source) || isinstance<bytes>(source) || !isinstance<sequence>(source))
      return false;
    value.clear();
    for (const handle item : reinterpret_borrow<sequence>(source)) {
      Element element;
      if (item.is_none() || !element.load(item, convert)) return false;
      value.push_back(cast_op<const T&>(element));
    }
    return true;
  }

  static handle cast(const std::vector<T>& items, return_value_policy, handle) {
    tuple result(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
      object item =
          reinterpret_steal<object>(Element::cast(items[i], return_value_policy::copy, handle()));
      if (!item) return {};
      PyTuple_SET_ITEM(result.ptr(), static_cast<ssize_t>(i), item.release().ptr());
    }
    return result.release();
  }
};

template <class Key, class T>
struct type_caster<std::map<Key, T>> {
  using Map = std::map<Key, T>;
  PYBIND11_TYPE_CASTER(Map, const_name("Mapping[") + make_caster<Key>::name + const_name(", ") +
                                make_caster<T>::name + const_name("]"));

  bool load(handle source, bool convert) {
    if (!PyMapping_Check(source.ptr()) || !hasattr(source, "items")) return false;
    value.clear();
    for (const handle item : source.attr("items")()) {
      const auto pair = reinterpret_borrow<tuple>(item);
      make_caster<Key> key;
      make_caster<T> mapped;
      if (!key.load(pair[0], convert) || !mapped.load(pair[1], convert)) return false;
      value.emplace(cast_op<const Key&>(key), cast_op<const T&>(mapped));
    }
    return true;
  }

  static handle cast(const Map& map, return_value_policy, handle) {
    dict result;
    for (const auto& [key, mapped] : map) result[pybind11::cast(key)] = pybind11::cast(mapped);
    return PyDictProxy_New(result.ptr());
  }
};

template <class T>
struct type_caster<std::optional<T>> {
  PYBIND11_TYPE_CASTER(std::optional<T>,
                       const_name("Optional[") + make_caster<T>::name + const_name("]"));

  bool load(handle source, bool convert) {
    value.reset();
    if (source.is_none()) return true;
    make_caster<T> held;
    if (!held.load(source, convert)) return false;
    value.emplace(cast_op<const T&>(held));
    return true;
  }

  static handle cast(const std::optional<T>& held, return_value_policy, handle) {
    if (!held) return none().release();
    return make_caster<T>::cast(*held, return_value_policy::copy, handle());
  }
};

template <>
struct type_caster<std::filesystem::path> {
  PYBIND11_TYPE_CASTER(std::filesystem::path, const_name("Path"));

  bool load(handle source, bool) {
    value.clear();
    if (source.is_none()) return true;
    const object text = reinterpret_steal<object>(PyOS_FSPath(source.ptr()));
    if (!text) {
      PyErr_Clear();
      return false;
    }
    const object bytes = isinstance<str>(text)
                             ? reinterpret_steal<object>(PyUnicode_EncodeFSDefault(text.ptr()))
                             : text;
    if (!bytes) throw error_already_set();
    value = bytes.cast<std::string>();
    return true;
  }

  static handle cast(const std::filesystem::path& path, return_value_policy, handle) {
    if (path.empty()) return none().release();
    const object text = reinterpret_steal<object>(PyUnicode_DecodeFSDefault(path.native().c_str()));
    return module_::import("pathlib").attr("Path")(text).release();
  }
};

template <class... Ts>
struct type_caster<std::variant<Ts...>> {
  using Variant = std::variant<Ts...>;
  PYBIND11_TYPE_CASTER(Variant,
                       const_name("Union[") + concat(make_caster<Ts>::name...) + const_name("]"));

  bool load(handle source, bool convert) {
    return !source.is_none() && (load_as<Ts>(source, convert) || ...);
  }

  static handle cast(const Variant& held, return_value_policy, handle) {
    return std::visit(
        [](const auto& one) { return pybind11::cast(one, return_value_policy::copy).release(); },
        held);
  }

 private:
  template <class T>
  bool load_as(handle source, bool convert) {
    make_caster<T> caster;
    if (!caster.load(source, convert)) return false;
    value = cast_op<const T&>(caster);
    return true;
  }
};

}  // namespace pybind11::detail
