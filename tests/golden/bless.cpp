// Makes the golden pictures anew, with the pinned renderer only, and says what changed. What is within the
// test's tolerance stays as it is.

#include <cstdio>
#include <exception>
#include <optional>

#include "render_client/present/Display.h"
#include "tests/golden/GoldenPicture.h"
#include "tests/golden/GoldenViews.h"
#include "tests/golden/PinnedRenderer.h"

namespace {

using namespace coherency;
using namespace coherency::golden;

constexpr const char* kFolder = COHERENCY_GOLDEN "/pictures";

void refuseOthers() {
  const GlName current = currentRenderer();
  const GlName pinned = pinnedRenderer();
  if (current == pinned) return;
  throw std::runtime_error(
      "this is " + current.text() + ", and the golden pictures are pinned to " + pinned.text() +
      "; to pin another, write its two names into tests/golden/renderer.txt and look at every "
      "picture that changes");
}

void bless(const GoldenView& view, const GoldenPicture& actual) {
  std::string change = "new";
  if (std::filesystem::exists(std::filesystem::path(kFolder) / (view.name + ".png"))) {
    const Difference found = difference(actual, read(kFolder, view.name));
    change = found.matches() ? "" : found.text();
  }
  std::printf("%s: %s\n", view.name.c_str(), change.empty() ? "as it was" : change.c_str());
  if (!change.empty()) write(actual, kFolder, view.name);
}

void blessAll() {
  const std::unique_ptr<Display> display = makeHeadlessDisplay({});
  refuseOthers();
  for (const std::string& name : goldenScenes()) {
    const std::unique_ptr<Scene> scene = makeScene(name);
    Renderer renderer(*scene, kWidth, kHeight, kSettings);
    for (const GoldenView& view : goldenViews())
      if (view.scene == name) bless(view, draw(renderer, *scene, view));
  }
}

}  // namespace

int main() {
  try {
    blessAll();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bless_golden: %s\n", error.what());
    return 1;
  }
  return 0;
}
