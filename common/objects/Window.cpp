#include "common/objects/Window.h"

#include "common/body/Palette.h"
#include "common/objects/Finish.h"

namespace coherency {

Window::Window(const Outline& o) : VRObject("window") {
  constexpr double kFrame = 0.055;
  constexpr double kFront = -0.10;
  constexpr double kBack = -0.16;
  constexpr double kBar = 0.045;
  constexpr double kBarDepth = 0.05;
  constexpr double kBarMiddle = (kFront + kBack) / 2;
  const Material white = paint(0xF1EEE7, 0.15);
  const Outline light = o.inset(kFrame);
  Faces frame;
  frame.addFrame(o, kFront, light, kFront);
  frame.mirror(kBarMiddle);
  frame.addFrame(light, kFront, light, kBack);
  assembleFaces(*this, frame_, "window frame", white, frame);

  // A mullion in the middle, and a transom on either side of it under the top lights.
  const double x = (o.left + o.right) / 2;
  const double transom = light.top - 0.28 * light.height();
  const double half = (light.width() - kBar) / 2;
  std::vector<Cuboid> bars = {
      {{kBar, light.height(), kBarDepth}, light.middle(kBarMiddle), kNoBottom | kNoTop}};
  for (const double side : {-1.0, 1.0})
    bars.push_back({{half, kBar, kBarDepth - 0.01},
                    {x + side * (kBar + half) / 2, transom, kBarMiddle},
                    kNoLeft | kNoRight});
  assembleBoxes(*this, bars_, "window bars", white, bars);

  const double z = kBarMiddle + kBarDepth / 2;
  const double y = (light.bottom + transom) / 2;
  Faces handle;
  handle.addSheet({x - 0.012, x + 0.012, y - 0.05, y + 0.03}, z + 0.002);
  handle.add(Cuboid{{0.014, 0.11, 0.018}, {x, y - 0.04, z + 0.030}, kNoBack});
  assembleFaces(*this, handle_, "window handle", paint(palette::kMetal, 0.6), handle);
  attach(finish::glass());
}

WindowSill::WindowSill(const Outline& o) : VRObject("window sill") {
  constexpr double kProud = 0.06;
  constexpr double kInside = 0.10;  // as far as the window's frame
  assembleBoxes(
      *this, board_, "sill board", paint(0xDDD5C8, 0.2),
      {{{o.width() + 0.08, 0.03, kProud}, {(o.left + o.right) / 2, o.bottom - 0.012, kProud / 2}, kNoBack},
       {{o.width(), 0.003, kInside},
        {(o.left + o.right) / 2, o.bottom + 0.0015, -kInside / 2},
        kNoBack | kNoBottom | kNoLeft | kNoRight | kNoFront}});
}

}  // namespace coherency
