#include "common/world/Scene.h"

#include <stdexcept>

#include "common/world/Laboratory.h"
#include "common/world/Targets.h"

namespace coherency {

namespace {

template <class Kind>
std::unique_ptr<Scene> make(const Rig& rig) {
  return std::make_unique<Kind>(rig);
}

struct Entry {
  const char* name;
  std::unique_ptr<Scene> (*make)(const Rig&);
};
constexpr Entry kScenes[] = {
    {"laboratory", make<Laboratory>},
    {"targets", make<Targets>},
};

}  // namespace

Scene::Scene(std::string name, const Rig& rig, HumanShown shown)
    : VRObject(std::move(name)), human_(rig, shown) {
  addMember(&human_);
}

void Scene::apply(const WorldState& state, const MotionSample& sample) {
  human_.setTransform(coherency::transform(state.base));
  human_.setSample(sample);
}

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const Entry& entry : kScenes) names.emplace_back(entry.name);
  return names;
}

std::unique_ptr<Scene> makeScene(std::string_view name, const Rig& rig) {
  for (const Entry& entry : kScenes)
    if (name == entry.name) return entry.make(rig);
  std::string known;
  for (const Entry& entry : kScenes) known += (known.empty() ? "'" : ", '") + std::string(entry.name) + "'";
  throw std::invalid_argument("no scene '" + std::string(name) + "'; there are " + known);
}

}  // namespace coherency
