#pragma once

#include <any>
#include <typeindex>
#include <typeinfo>
#include <utility>
#include <vector>

namespace coherency {

/// What an object has beside frame and faces: values of any type, at most one of each, found by whoever knows
/// the type (paper, section III: "attributes other than those used in image generation"). A new sense is a
/// new struct and its consumer; nothing here knows either. Types must be copyable.
class Attributes {
 public:
  /// Replaces the value of the same type, if there is one.
  template <class T>
  void attach(T value) {
    if (T* there = find<T>(); there != nullptr) {
      *there = std::move(value);
      return;
    }
    values_.emplace_back(typeid(T), std::move(value));
  }

  /// Null where there is none. Good until the next attach().
  template <class T>
  T* find() {
    for (auto& [type, value] : values_)
      if (type == typeid(T)) return std::any_cast<T>(&value);
    return nullptr;
  }
  template <class T>
  const T* find() const {
    return const_cast<Attributes*>(this)->find<T>();
  }

 private:
  std::vector<std::pair<std::type_index, std::any>> values_;
};

}  // namespace coherency
