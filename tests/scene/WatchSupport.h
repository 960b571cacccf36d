#pragma once

#include <utility>
#include <vector>

#include "common/scene/ObjectWatch.h"
#include "common/scene/VRObject.h"

namespace coherency {

using Changes = std::vector<ObjectChange>;

/// Writes down what it hears.
class Recorder : public ObjectWatch {
 public:
  using ObjectWatch::ObjectWatch;

  void changed(ObjectChange change) noexcept override {
    heard_.push_back(change);
    if (change == ObjectChange::Moved) seen_ = object()->transform();
  }
  /// What was heard since this was last asked.
  Changes heard() { return std::exchange(heard_, {}); }
  const TransformMatrix& seen() const { return seen_; }  ///< the object's, when it was last told of a move

 private:
  Changes heard_;
  TransformMatrix seen_;
};

}  // namespace coherency
