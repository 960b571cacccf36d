#include "render_client/draw/LampSets.h"

#include "render_client/compile/Parallel.h"

namespace coherency {

void LampSets::update() {
  const std::vector<MovingRoot>& roots = scene_.movingRoots();
  changed_.clear();
  changed_.reserve(roots.size());
  sets_.resize(roots.size());
  if (choice_.lampCount() == 0) return;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const Coord3 place = scene_.place(roots[i]);
    if (i == places_.size())
      places_.push_back(place);
    else if (places_[i] == place)
      continue;
    places_[i] = place;
    changed_.push_back(i);
  }
  parallelFor(changed_.size(), [&](std::size_t i) { sets_[changed_[i]] = choice_.at(places_[changed_[i]]); });
}

}  // namespace coherency
