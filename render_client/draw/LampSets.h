#pragma once

#include <vector>

#include "render_client/draw/LampChoice.h"

namespace coherency {

/// The lamps of everything that moves: a set for each of the scene's movingRoots(), chosen for where that is
/// and for nothing else, so that a thing looks the same whoever looks at it and from wherever. Choosing costs
/// some hundred rays: it is done for what has moved, and what rests costs a comparison.
class LampSets {
 public:
  LampSets(const Illumination& illumination, const CompiledScene& scene)
      : choice_(illumination, scene), scene_(scene) {}

  /// Chooses for what is no longer where it was at the last call; at the first call for all.
  void update();
  /// As of the last update(), by root.
  const std::vector<ChosenLamps>& sets() const { return sets_; }
  /// The roots for which the last update() chose, ascending.
  const std::vector<std::size_t>& changed() const { return changed_; }

 private:
  LampChoice choice_;
  const CompiledScene& scene_;
  std::vector<Coord3> places_;
  std::vector<ChosenLamps> sets_;
  std::vector<std::size_t> changed_;
};

}  // namespace coherency
