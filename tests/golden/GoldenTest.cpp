// The shipped scenes look as they did: every pixel shows the object that it showed, in the colour that it
// had. A picture that is to look different is blessed with scripts/bless_golden.sh.

#include "tests/golden/GoldenPicture.h"
#include "tests/golden/GoldenViews.h"
#include "tests/golden/PinnedRenderer.h"
#include "tests/render/Support.h"

namespace coherency::golden {
namespace {

class Golden : public DrawingTest, public testing::WithParamInterface<std::string> {};

TEST_P(Golden, PicturesAreAsTheyWereBlessed) {
  const GlName pinned = pinnedRenderer();
  const GlName current = currentRenderer();
  if (!comparable(current, pinned))
    GTEST_SKIP() << "this is " << current.text() << ", the golden pictures are of " << pinned.text()
                 << "; LIBGL_ALWAYS_SOFTWARE=1 LP_NATIVE_VECTOR_WIDTH=128 makes it so where Mesa is";
  const std::unique_ptr<Scene> scene = makeScene(GetParam());
  Renderer renderer(*scene, kWidth, kHeight, kSettings);
  for (const GoldenView& view : goldenViews()) {
    if (view.scene != GetParam()) continue;
    const GoldenPicture actual = draw(renderer, *scene, view);
    const GoldenPicture expected = read(COHERENCY_GOLDEN "/pictures", view.name);
    const Difference found = difference(actual, expected);
    if (found.matches()) continue;
    writeDifference(actual, expected, COHERENCY_GOLDEN_FAILURES, view.name);
    ADD_FAILURE() << view.name << ": " << found.text() << ". Actual, expected and difference are in "
                  << COHERENCY_GOLDEN_FAILURES << "; drawn with " << current.text() << ", blessed with "
                  << pinned.text();
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(goldenScenes()),
                         [](const auto& scene) { return scene.param.substr(0, scene.param.find(':')); });

}  // namespace
}  // namespace coherency::golden
