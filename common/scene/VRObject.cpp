#include "common/scene/VRObject.h"

#include <algorithm>
#include <stdexcept>

#include "common/scene/FaceSet.h"

namespace coherency {
namespace {

/// T_object_world of what carries `object`; says whose ancestors were at fault.
TransformMatrix inverseOfParent(const VRObject& object) {
  if (object.parent() == nullptr) return {};
  try {
    return object.parent()->globalTransform().inverse();
  } catch (const std::domain_error& error) {
    throw std::domain_error("VRObject '" + object.path() +
                            "': no local transform gives the global one asked for, as the parent's cannot be "
                            "inverted: " +
                            error.what());
  }
}

}  // namespace

VRObject::~VRObject() {
  tell(ObjectChange::Died);
  for (ObjectWatch* watch = watches_; watch != nullptr; watch = watch->next_) watch->object_ = nullptr;
  for (VRObject* member : members()) member->parent_ = nullptr;
  if (parent_ != nullptr) parent_->removeMember(this);
}

void VRObject::addMember(VRObject* member) {
  const auto refuse = [this](const std::string& why) {
    throw std::invalid_argument("VRObject '" + path() + "': " + why);
  };
  if (member == nullptr) refuse("addMember was given a null pointer");
  if (member->parent_ != nullptr)
    refuse("'" + member->name() + "' is already a member of '" + member->parent_->path() +
           "'; remove it there first");
  for (const VRObject* above = this; above != nullptr; above = above->parent_)
    if (above == member) refuse("adding '" + member->name() + "' would make it a part of itself (a cycle)");
  members_.push_back(member);
  member->parent_ = this;
  tell(ObjectChange::Restructured);
}

void VRObject::removeMember(VRObject* member) {
  if (member == nullptr || member->parent_ != this)
    throw std::invalid_argument(
        "VRObject '" + path() + "': removeMember was given " +
        (member == nullptr ? "a null pointer" : "'" + member->name() + "', which is not its member"));
  member->parent_ = nullptr;
  // From both ends: data members die in reverse order of their construction, a vector's elements in its
  // order.
  std::size_t first = gone_;
  std::size_t last = members_.size() - 1;
  while (members_[first] != member && members_[last] != member) ++first, --last;
  const std::size_t at = members_[first] == member ? first : last;
  if (at != gone_) {
    members_.erase(members_.begin() + static_cast<std::ptrdiff_t>(at));
  } else if (++gone_ > members_.size() / 2) {
    members_.erase(members_.begin(), members_.begin() + static_cast<std::ptrdiff_t>(gone_));
    gone_ = 0;
  }
  tell(ObjectChange::Restructured);
}

void VRObject::tell(ObjectChange change) const noexcept {
  for (ObjectWatch* watch = watches_; watch != nullptr; watch = watch->next_)
    if (watch->hears(change)) watch->changed(change);
}

void VRObject::assign(const TransformMatrix& t_parent_this) {
  if (watches_ == nullptr || t_parent_this == transform()) return VRFrame::assign(t_parent_this);
  for (const ObjectWatch* watch = watches_; watch != nullptr; watch = watch->next_)
    if (watch->hears(ObjectChange::Moved)) watch->mayMove();
  VRFrame::assign(t_parent_this);
  tell(ObjectChange::Moved);
}

std::string VRObject::path() const {
  std::vector<const VRObject*> upwards;
  for (const VRObject* object = this; object != nullptr; object = object->parent_) upwards.push_back(object);
  std::reverse(upwards.begin(), upwards.end());
  std::string text;
  for (const VRObject* object : upwards) {
    if (!text.empty()) text += '/';
    text += object->name_.empty() ? "?" : object->name_;
  }
  return text;
}

TransformMatrix VRObject::globalTransform() const {
  TransformMatrix t = transform();
  for (const VRObject* above = parent_; above != nullptr; above = above->parent_) t = above->transform() * t;
  return t;
}

void VRObject::setGlobalTransform(const TransformMatrix& t_world_this) {
  setTransform(inverseOfParent(*this) * t_world_this);
}

void VRObject::setGlobalPosition(const Coord3& position) {
  setPosition(inverseOfParent(*this).point(position));
}

void VRObject::setGlobalOrientation(const TransformMatrix& linear) {
  setOrientation(inverseOfParent(*this).linear() * linear.linear());
}

std::size_t VRObject::polygonCount() const {
  std::size_t count = 0;
  forEachObject(*this, {}, [&count](const VRObject& object, const TransformMatrix&) {
    if (object.faces() != nullptr) count += object.faces()->faces.size();
  });
  return count;
}

}  // namespace coherency
