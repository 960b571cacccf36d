#pragma once

#include <deque>
#include <unordered_set>

#include "common/scene/ObjectWatch.h"
#include "common/scene/VRObject.h"

namespace coherency {

using ObjectSet = std::unordered_set<const VRObject*>;

/// Hears what becomes of the objects a scene was compiled of (ObjectWatch.h), and keeps it until the next
/// frame asks. To hear allocates nothing, and to ask costs a comparison, however many objects there are. It
/// does not hear of attributes: they count when the scene is compiled again.
class SceneWatch {
 public:
  explicit SceneWatch(const VRObject& root) : root_(&root) {}
  SceneWatch(const SceneWatch&) = delete;
  SceneWatch& operator=(const SceneWatch&) = delete;

  /// An object that stands as it was compiled: what is declared Fixed refuses to be moved from now on.
  void addFixed(const VRObject& object) { watches_.emplace_back(object, *this, Kind::Fixed); }
  /// One that moves, or is part of what does: only its shape and its members were compiled. `found`: it is
  /// not declared Moving, but has been moved.
  void addMoving(const VRObject& object, bool found) {
    watches_.emplace_back(object, *this, found ? Kind::FoundToMove : Kind::Moving);
  }

  /// Whether more has changed than what was compiled can follow.
  bool isStale() const { return stale_; }
  /// Null when it has died. `root` is to be among those that were added.
  const VRObject* root() const { return root_; }
  /// Of those that live, what moved although it was compiled as fixed, now or before.
  ObjectSet foundToMove() const;
  /// Calls repainted(object) for the fixed ones that have had another material since the last call.
  template <class Repainted>
  void takeRepainted(const Repainted& repainted) {
    for (Watch* watch; (watch = repainted_) != nullptr;) {
      repainted_ = watch->next_repainted;
      watch->is_repainted = false;
      if (watch->object() != nullptr) repainted(*watch->object());
    }
  }

 private:
  enum class Kind : std::uint8_t { Fixed, Moving, FoundToMove };

  struct Watch : ObjectWatch {
    Watch(const VRObject& object, SceneWatch& scene, Kind kind);
    void changed(ObjectChange change) noexcept override;

    Kind kind;
    bool is_repainted = false;
    bool has_light;  ///< was compiled with: what shines by itself altogether needs none
    SceneWatch& scene;
    Watch* next_repainted = nullptr;
  };

  void noteRepainted(Watch& watch) noexcept;

  const VRObject* root_;
  std::deque<Watch> watches_;
  Watch* repainted_ = nullptr;  ///< the first of a list
  bool stale_ = false;
};

}  // namespace coherency
