#include "common/objects/Boards.h"

#include "common/body/Palette.h"
#include "common/objects/Finish.h"

namespace coherency {

Whiteboard::Whiteboard() : VRObject("whiteboard") {
  constexpr double kSurface = 0.016;
  Faces frame = pictureFrame(Outline::centred(1.78, 1.08), 0.03, 0.022);
  frame.add(Cuboid{{0.7, 0.015, 0.08}, {0.0, -0.5775, 0.04}, kNoBack});
  assembleFaces(*this, frame_, "whiteboard frame", paint(palette::kMetal, 0.4), frame);
  assembleSheet(*this, surface_, "whiteboard surface", paint(0xF7F7F4, 0.3), Outline::centred(1.78, 1.08),
                kSurface - 0.001);
  struct Stroke {
    double x, y, width, height, turn;
    std::size_t colour;
  };
  constexpr std::array<std::uint32_t, 4> kColours = {0x2E5E8C, 0x33383C, 0xB3473C, 0x4B7F55};
  constexpr std::array<Stroke, 13> kStrokes = {{{-0.55, 0.38, 0.50, 0.020, 0.0, 0},
                                                {-0.60, 0.30, 0.36, 0.012, 0.0, 0},
                                                {-0.57, 0.24, 0.42, 0.012, 0.0, 0},
                                                {0.30, -0.30, 0.80, 0.012, 0.0, 1},
                                                {-0.10, 0.04, 0.012, 0.68, 0.0, 1},
                                                {0.10, -0.12, 0.40, 0.014, 0.55, 2},
                                                {0.45, 0.085, 0.45, 0.014, 0.47, 2},
                                                {0.28, -0.20, 0.72, 0.010, 0.12, 3},
                                                {-0.52, -0.02, 0.30, 0.010, 0.0, 1},
                                                {-0.52, -0.26, 0.30, 0.010, 0.0, 1},
                                                {-0.67, -0.14, 0.010, 0.23, 0.0, 1},
                                                {-0.37, -0.14, 0.010, 0.23, 0.0, 1},
                                                {-0.23, -0.14, 0.24, 0.010, 0.0, 3}}};
  std::array<Faces, kColours.size()> strokes;
  double z = kSurface;  // each a little nearer than the one before: where they cross, the later one shows
  for (const Stroke& s : kStrokes) {
    strokes[s.colour].addStroke({s.x, s.y, z}, s.width, s.height, s.turn);
    z += 0.0006;
  }
  for (std::size_t c = 0; c < strokes.size(); ++c)
    assembleFaces(*this, strokes_[c], "whiteboard strokes", paint(kColours[c]), strokes[c]);
  assembleBoxes(*this, pen_, "whiteboard pen", paint(0xB3473C, 0.3),
                {{{0.13, 0.018, 0.018}, {0.1, -0.561, 0.05}, kNoBottom}});
}

NoticeBoard::NoticeBoard() : VRObject("notice board") {
  const Outline board = Outline::centred(kWidth - 0.08, kHeight - 0.08);
  assembleFaces(*this, frame_, "notice board frame", paint(finish::kOak, 0.1),
                pictureFrame(board, 0.04, 0.025));
  assembleSheet(*this, cork_, "notice board cork", paint(0xB58B62), board, 0.017);
  struct Paper {
    double x, y, width, height, turn;
    std::size_t colour;
  };
  constexpr std::array<std::uint32_t, 3> kColours = {finish::kPaper, 0xF2D98A, 0xA9CBD6};
  constexpr std::array<Paper, 9> kPapers = {{{-0.54, 0.16, 0.21, 0.297, 0.02, 0},
                                             {-0.28, 0.20, 0.21, 0.297, -0.03, 0},
                                             {-0.50, -0.22, 0.297, 0.21, 0.0, 2},
                                             {-0.17, -0.20, 0.21, 0.297, 0.04, 0},
                                             {0.02, 0.22, 0.15, 0.15, -0.05, 1},
                                             {0.30, 0.10, 0.30, 0.42, 0.0, 2},
                                             {0.16, -0.28, 0.21, 0.148, 0.03, 1},
                                             {0.57, 0.18, 0.21, 0.297, 0.02, 0},
                                             {0.55, -0.22, 0.21, 0.297, -0.04, 0}}};
  std::array<Faces, kColours.size()> papers;
  Faces text;
  Faces pins;
  for (const Paper& p : kPapers) {
    papers[p.colour].addStroke({p.x, p.y, 0.019}, p.width, p.height, p.turn);
    for (int line = 0; line < 3; ++line)
      text.addStroke({p.x - 0.02 * (line % 2), p.y + (0.22 - 0.20 * line) * p.height, 0.0205},
                     (line == 0 ? 0.5 : 0.75 - 0.05 * line) * p.width, line == 0 ? 0.014 : 0.007, p.turn);
    pins.addStroke({p.x, p.y + 0.44 * p.height, 0.023}, 0.014, 0.014, 0.7);
  }
  for (std::size_t c = 0; c < papers.size(); ++c)
    assembleFaces(*this, papers_[c], "notices", paint(kColours[c]), papers[c]);
  assembleFaces(*this, text_, "notices' text", paint(0x4A4E52), text);
  assembleFaces(*this, pins_, "notices' pins", paint(finish::kRed, 0.4), pins);
}

Poster::Poster(std::uint32_t colour) : VRObject("poster") {
  assembleFaces(*this, frame_, "poster frame", paint(0x3A3532, 0.2),
                pictureFrame(Outline::centred(0.65, 0.91), 0.025, 0.022));
  assembleSheet(*this, paper_, "poster paper", paint(0xEFE7D6), Outline::centred(0.65, 0.91), 0.014);
  assembleSheet(*this, band_, "poster band", paint(colour), {-0.325, 0.325, -0.095, 0.365}, 0.0155);
  Faces whites;
  Faces pupils;
  for (const double eye : {-0.12, 0.12}) {
    whites.addDisc({eye, 0.135, 0.017}, 0.105, 24);
    pupils.addDisc({eye + 0.015, 0.135, 0.0185}, 0.045, 18);
  }
  assembleFaces(*this, whites_, "poster eyes", paint(0xF3E3B8), whites);
  assembleFaces(*this, pupils_, "poster pupils", paint(finish::kRust), pupils);
  Faces text;
  text.addStroke({0.0, -0.20, 0.0155}, 0.46, 0.040);
  text.addStroke({0.0, -0.265, 0.0155}, 0.34, 0.016);
  text.addStroke({0.0, -0.33, 0.0155}, 0.40, 0.016);
  assembleFaces(*this, text_, "poster text", paint(0x3A3532), text);
}

WallScreen::WallScreen() : VRObject("wall screen") {
  const Outline picture = Outline::centred(1.60, 0.90);
  Faces shell = pictureFrame(picture, 0.02, 0.05);
  assembleFaces(*this, case_, "wall screen case", paint(finish::kBlack, 0.4), shell);
  assembleSheet(*this, picture_, "wall screen picture", glow(0x17384A), picture, 0.044);
  Faces bars;
  for (int i = 0; i < 9; ++i) {  // elapsed times of nine conditions
    const double height = 0.20 + 0.05 * ((i * 4) % 7);
    bars.addSheet({-0.62 + 0.145 * i, -0.54 + 0.145 * i, -0.30, -0.30 + height}, 0.0455);
  }
  assembleFaces(*this, bars_, "wall screen bars", glow(0xE2A458), bars);
  Faces axes;
  axes.addStroke({0.0, -0.306, 0.0455}, 1.40, 0.010);
  axes.addStroke({-0.695, -0.02, 0.0455}, 0.010, 0.56);
  axes.addStroke({-0.32, 0.34, 0.0455}, 0.72, 0.035);
  assembleFaces(*this, axes_, "wall screen axes", glow(0xCFE3EA), axes);
  attach(finish::glass());
}

}  // namespace coherency
