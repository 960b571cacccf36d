#pragma once

#include <cstdint>

namespace coherency {

class VRObject;

/// What can become of an object that concerns whoever made something of it.
enum class ObjectChange : std::uint8_t {
  Moved,         ///< has another transform, relative to its parent
  Reshaped,      ///< shows other faces
  Repainted,     ///< shows them in another material
  Restructured,  ///< has a member more or one less, which may have died
  Died,          ///< is about to let go of its members; object() is null from then on
};

enum class Watched : std::uint8_t { Everything, AllButMoves };

/// Hears of each change of one object at once, from the setter that makes it: geometry compilation (paper,
/// section III.C.1) thereby knows what is no longer as it was compiled. To write what was there already is no
/// change, and what a setter refuses is none.
///
/// A change is the object's own: when it moves, its members are not told. Any number may watch an object,
/// which may be const, as being watched is no part of its state; to watch allocates nothing, and an object
/// that nobody watches pays one comparison. Watch and object may die in either order, and an object that
/// leaves its tree is still watched. One thread at a time may use a tree and its watches.
class ObjectWatch {
 public:
  explicit ObjectWatch(const VRObject& object, Watched what = Watched::Everything);
  virtual ~ObjectWatch();
  ObjectWatch(const ObjectWatch&) = delete;
  ObjectWatch& operator=(const ObjectWatch&) = delete;

  /// Null when it has died.
  const VRObject* object() const { return object_; }

  /// Asked before the object moves; to throw refuses it, and the object stays where it is. As it stands here
  /// it refuses what is declared Fixed (Mobility.h), with std::logic_error naming the object's path.
  virtual void mayMove() const;
  /// Told when the change is made. Takes note and acts later: nothing in here may change objects or watches.
  virtual void changed(ObjectChange change) noexcept = 0;

 private:
  friend class VRObject;
  bool hears(ObjectChange change) const {
    return change != ObjectChange::Moved || what_ == Watched::Everything;
  }

  const VRObject* object_;
  ObjectWatch* next_;  ///< that watches the same object
  Watched what_;
};

}  // namespace coherency
