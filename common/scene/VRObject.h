#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/scene/Attributes.h"
#include "common/scene/ObjectWatch.h"
#include "common/scene/VRFrame.h"

namespace coherency {

struct FaceSet;

/// A node of the world tree (paper, section III.B). Derive from it, hold primitives and other objects as data
/// members, and register them with addMember() in the constructor; moving an object moves its members.
/// Who has to know of changes, or to refuse a move, derives from ObjectWatch.
///
/// The tree does not own its nodes: they are data members of the classes that describe the world. An object
/// that dies leaves its parent and lets go of its members. Objects therefore neither copy nor move.
class VRObject : public VRFrame {
 public:
  explicit VRObject(std::string name = {}) : name_(std::move(name)) {}
  ~VRObject() override;
  VRObject(const VRObject&) = delete;
  VRObject& operator=(const VRObject&) = delete;

  /// Makes `member` a child of this object; its transform is then relative to this object.
  /// Throws std::invalid_argument when it is null, is this object or one above it (a cycle), or has a parent
  /// already.
  void addMember(VRObject* member);
  /// Throws std::invalid_argument when `member` is not a child of this object. Its local transform stays.
  void removeMember(VRObject* member);

  VRObject* parent() const { return parent_; }
  /// In the order of addition; good until the next addMember() or removeMember().
  std::span<VRObject* const> members() const { return std::span(members_).subspan(gone_); }
  const std::string& name() const { return name_; }
  void setName(std::string name) { name_ = std::move(name); }
  /// Names from the root down, joined by '/'; an unnamed object shows as '?'.
  std::string path() const;

  /// T_world_this: product of the transforms from the root down (eq. 4), rebuilt at each call and never
  /// stored.
  TransformMatrix globalTransform() const;
  Coord3 globalPosition() const { return globalTransform().origin(); }
  TransformMatrix globalOrientation() const { return globalTransform().linear(); }
  /// The same in global terms; the local transform becomes inverse(parent's global) * given.
  /// Throw std::domain_error when an ancestor's transform cannot be inverted.
  void setGlobalTransform(const TransformMatrix& t_world_this);
  void setGlobalPosition(const Coord3& position);
  void setGlobalOrientation(const TransformMatrix& linear);

  /// The faces this object itself shows, in its own frame; null for an object that only groups others.
  virtual const FaceSet* faces() const { return nullptr; }
  /// Polygons of this object and everything below it.
  std::size_t polygonCount() const;

  /// Gives the object an attribute of any type (Attributes.h), replacing one of the same type.
  template <class T>
  void attach(T value) {
    if (attributes_ == nullptr) attributes_ = std::make_unique<Attributes>();
    attributes_->attach(std::move(value));
  }
  /// The object's own attribute of this type; null where it has none.
  template <class T>
  const T* attribute() const {
    return attributes_ == nullptr ? nullptr : static_cast<const Attributes&>(*attributes_).find<T>();
  }

 protected:
  /// Tells who watches this object. For classes with faces of their own: Reshaped and Repainted, when done.
  void tell(ObjectChange change) const noexcept;
  void assign(const TransformMatrix& t_parent_this) override;

 private:
  friend class ObjectWatch;

  std::string name_;
  VRObject* parent_ = nullptr;
  std::vector<VRObject*> members_;
  std::size_t gone_ = 0;  ///< of members_, the first, which have left; so that many can do so one by one
  std::unique_ptr<Attributes> attributes_;  ///< most objects have none
  mutable ObjectWatch* watches_ = nullptr;  ///< the first of them
};

/// Calls visit(object, t_root_object) for `root` and everything below it, parents first, in the order of
/// addition; t_root_object starts from `t_root`. Iterative: a chain ten thousand deep is no matter.
template <class Visit>
void forEachObject(const VRObject& root, const TransformMatrix& t_root, Visit&& visit) {
  struct Pending {
    const VRObject* object;
    TransformMatrix t_root_object;
  };
  std::vector<Pending> stack{{&root, t_root}};
  while (!stack.empty()) {
    const Pending now = stack.back();
    stack.pop_back();
    visit(*now.object, now.t_root_object);
    const auto members = now.object->members();
    for (auto m = members.rbegin(); m != members.rend(); ++m)
      stack.push_back({*m, now.t_root_object * (*m)->transform()});
  }
}

}  // namespace coherency
