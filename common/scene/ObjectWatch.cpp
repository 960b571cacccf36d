#include "common/scene/ObjectWatch.h"

#include <stdexcept>

#include "common/scene/Mobility.h"
#include "common/scene/VRObject.h"

namespace coherency {

ObjectWatch::ObjectWatch(const VRObject& object, Watched what)
    : object_(&object), next_(object.watches_), what_(what) {
  object.watches_ = this;
}

ObjectWatch::~ObjectWatch() {
  if (object_ == nullptr) return;
  ObjectWatch** link = &object_->watches_;
  while (*link != this) link = &(*link)->next_;
  *link = next_;
}

void ObjectWatch::mayMove() const {
  if (mobility(*object_) != Mobility::Fixed) return;
  throw std::logic_error("VRObject '" + object_->path() +
                         "': declared Fixed, and cannot be moved while something made of it is in use; "
                         "leave it undeclared, or declare it Moving");
}

}  // namespace coherency
