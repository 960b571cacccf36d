#include "common/objects/Storage.h"

#include <utility>

#include "common/body/Palette.h"
#include "common/math/FixedPoint.h"
#include "common/objects/Finish.h"
#include "common/scene/Senses.h"

namespace coherency {

namespace {

constexpr double kBoard = 0.025;      // thickness of a shelf's boards
constexpr double kRow = 0.475;        // from one board to the next
constexpr double kFirstBoard = 0.07;  // middle of the lowest

double topOfBoard(int board) {
  return kFirstBoard + kRow * board + kBoard / 2;
}

}  // namespace

Bookshelf::Bookshelf() : VRObject("bookshelf") {
  Solids solids;
  buildCase(solids);
  buildBooks(solids);
  attach(std::move(solids));
  attach(finish::wood());
}

void Bookshelf::buildCase(Solids& solids) {
  constexpr double kInner = kWidth - 2 * kBoard;
  std::vector<Cuboid> boards;
  for (const double side : {-1.0, 1.0})
    boards.push_back(
        {{kBoard, kHeight, kDepth}, {side * (kWidth - kBoard) / 2, kHeight / 2, 0.0}, kNoBottom});
  for (int i = 0; i < 5; ++i)
    boards.push_back(
        {{kInner, kBoard, kDepth - 0.012}, {0.0, kFirstBoard + kRow * i, 0.0}, kNoLeft | kNoRight});
  assembleBoxes(*this, case_, "shelf case", paint(finish::kOak, 0.1), boards);
  assembleBoxes(*this, back_, "shelf back", paint(finish::kWalnut),
                {{{kInner, kHeight - 0.01, 0.012},
                  {0.0, kHeight / 2, -kDepth / 2 + 0.007},
                  kNoLeft | kNoRight | kNoBottom}});
  solids.boxes.push_back({{0.0, kHeight / 2, -kDepth / 2 + 0.007}, {kWidth, kHeight, 0.014}});
  for (const Cuboid& board : boards) solids.boxes.push_back({board.centre, board.size});
}

/// Runs of books along the boards; their sizes follow short cycles that do not fit a run's length, so no two
/// runs look alike.
void Bookshelf::buildBooks(Solids& solids) {
  constexpr std::array<std::uint32_t, 7> kCovers = {0x8C3B3B, 0x3E6A86, 0xD3B46A, 0x4F7A5A,
                                                    0xE3DCCB, 0x6B4C78, 0xB96A3E};
  constexpr std::array<double, 5> kThick = {0.038, 0.053, 0.032, 0.046, 0.060};
  constexpr std::array<double, 4> kTall = {0.27, 0.31, 0.24, 0.29};
  struct Run {
    int board;
    double from;
    int count;
  };
  constexpr std::array<Run, 5> kRuns = {
      {{0, -0.10, 12}, {1, -0.54, 13}, {2, -0.02, 11}, {3, -0.55, 9}, {3, 0.22, 6}}};
  std::array<Faces, kCovers.size()> books;
  std::size_t i = 0;
  for (const Run& run : kRuns) {
    double x = run.from;
    for (int n = 0; n < run.count; ++n, ++i) {
      const double thick = kThick[i % kThick.size()];
      const double tall = kTall[i % kTall.size()];
      const double deep = 0.19 + 0.012 * static_cast<double>(i % 3);
      books[(i * 3) % books.size()].add(
          Cuboid{{thick, tall, deep},
                 {x + thick / 2, topOfBoard(run.board) + tall / 2, 0.125 - deep / 2},
                 kNoBottom | kNoBack});
      x += thick + 0.0015;
    }
    constexpr double kTop = 0.27;  // as high as most of them are
    solids.boxes.push_back(
        {{(run.from + x) / 2, topOfBoard(run.board) + kTop / 2, 0.03}, {x - run.from, kTop, 0.19}});
  }
  for (std::size_t c = 0; c < books.size(); ++c)
    assembleFaces(*this, books_[c], "books", paint(kCovers[c], 0.05), books[c]);
  vase_.setTapered(0.075, 0.045, 0.24, 14);
  assemble(*this, vase_, "vase", paint(0x4E8A8B, 0.5), {0.36, topOfBoard(1) + 0.12, 0.02});
  solids.boxes.push_back({{0.36, topOfBoard(1) + 0.12, 0.02}, {0.14, 0.24, 0.14}});
  std::vector<Cuboid> files;
  for (const double file : {-0.47, -0.36, -0.25})
    files.push_back({{0.10, 0.32, 0.24}, {file, topOfBoard(0) + 0.16, 0.01}, kNoBottom | kNoBack});
  files.push_back({{0.38, 0.22, 0.24}, {-0.32, topOfBoard(2) + 0.11, 0.01}, kNoBottom | kNoBack});
  assembleBoxes(*this, file_boxes_, "file boxes", paint(0xA7B4B0), files);
  for (const Cuboid& file : files) solids.boxes.push_back({file.centre, file.size});
}

Cabinet::Cabinet() : VRObject("cabinet") {
  constexpr double kPlinth = 0.07;
  constexpr double kTop = 0.025;
  const std::vector<Cuboid> body = {
      {{1.2, kHeight - kPlinth - kTop, 0.42}, {0.0, (kHeight + kPlinth - kTop) / 2, 0.0}, kNoTop | kNoBack}};
  assembleBoxes(*this, plinth_, "cabinet plinth", paint(finish::kSteel),
                {{{1.14, kPlinth, 0.38}, {0.0, kPlinth / 2, -0.01}, kNoTop | kNoBottom | kNoBack}});
  assembleBoxes(*this, body_, "cabinet body", paint(0xCFC9BD), body);
  assembleBoxes(*this, top_, "cabinet top", paint(finish::kOak, 0.15),
                {{{kWidth, kTop, kDepth}, {0.0, kHeight - kTop / 2, 0.0}}});
  std::vector<Cuboid> doors;
  for (const double side : {-1.0, 1.0})
    doors.push_back({{0.585, 0.70, 0.018}, {side * 0.2975, 0.445, 0.219}, kNoBack});
  assembleBoxes(*this, doors_, "cabinet doors", paint(0x7F9A94, 0.1), doors);
  for (std::size_t i = 0; i < knobs_.size(); ++i) {
    knobs_[i].setSize(0.014, 0.025, 12);
    assemble(*this, knobs_[i], "cabinet knob", paint(palette::kMetal, 0.6),
             {i == 0 ? -0.05 : 0.05, 0.50, 0.24});
    knobs_[i].setOrientation(TransformMatrix::rotationX(kTurn / 4));
  }
  attach(Solids{{{{0.0, kHeight / 2, 0.0}, {kWidth, kHeight, kDepth}}}});
  attach(finish::wood());
}

Rack::Rack() : VRObject("rack") {
  assembleBoxes(*this, case_, "rack case", paint(0x3C4347, 0.2),
                {{{kWidth, kHeight, kDepth}, {0.0, kHeight / 2, 0.0}, kNoBottom}});
  buildUnits();
  attach(Solids{{{{0.0, kHeight / 2, 0.01}, {kWidth, kHeight, kDepth + 0.02}}}});
  attach(finish::steel());
  attach(SoundSource{"a rack's fans hum", 46.0});
}

/// Front plates of unequal height; slots for air on some, lamps on all, and a small screen at a sitting eye's
/// height.
void Rack::buildUnits() {
  constexpr std::array<double, 9> kHeights = {0.18, 0.09, 0.13, 0.18, 0.09, 0.22, 0.13, 0.18, 0.27};
  constexpr double kFront = kDepth / 2;
  constexpr double kPlate = 0.012;
  Faces units;
  Faces slots;
  Faces lamps;
  double y = 0.14;
  for (std::size_t i = 0; i < kHeights.size(); ++i) {
    const double high = kHeights[i] - 0.012;
    const double middle = y + kHeights[i] / 2;
    units.add(Cuboid{{0.50, high, kPlate}, {0.0, middle, kFront + kPlate / 2}, kNoBack});
    const double z = kFront + kPlate + 0.0015;
    for (int lamp = 0; lamp < 3; ++lamp)
      lamps.addSheet({0.14 + 0.03 * lamp, 0.152 + 0.03 * lamp, middle - 0.006, middle + 0.006}, z);
    if (i % 2 == 1)
      for (int slot = 0; slot < 6; ++slot) {
        const double x = -0.20 + 0.05 * slot;
        slots.addSheet({x, x + 0.03, middle - 0.3 * high, middle + 0.3 * high}, z);
      }
    y += kHeights[i];
  }
  assembleFaces(*this, units_, "rack units", paint(0x6A7479, 0.3), units);
  assembleFaces(*this, slots_, "rack slots", paint(0x22282B), slots);
  assembleFaces(*this, lamps_, "rack lamps", glow(0x6FE39A), lamps);
  Faces screen;
  screen.addSheet({-0.20, 0.06, 1.40, 1.54}, kFront + kPlate + 0.003);
  assembleFaces(*this, screen_, "rack screen", glow(0x2C5F7A), screen);
}

CoatStand::CoatStand() : VRObject("coat stand") {
  foot_.setTapered(0.20, 0.16, 0.03, 20);
  assemble(*this, foot_, "coat stand foot", paint(finish::kWalnut, 0.2), {0.0, 0.015, 0.0});
  pole_.setSize(0.018, 1.75, 10);
  assemble(*this, pole_, "coat stand pole", paint(finish::kWalnut, 0.2), {0.0, 0.9, 0.0});
  assembleBoxes(*this, hooks_, "coat stand hooks", paint(finish::kStainless, 0.5),
                {{{0.24, 0.016, 0.016}, {0.0, 1.70, 0.0}}, {{0.016, 0.016, 0.24}, {0.0, 1.62, 0.0}}});
  coat_.setSections(
      {{0.62, 0.085, 0.19, 0.0}, {1.10, 0.075, 0.15, 0.0}, {1.45, 0.06, 0.16, 0.0}, {1.58, 0.03, 0.06, 0.0}},
      {Loft::Along::Y, 10, 2.6, 0.0, 0.02});
  assemble(*this, coat_, "coat", paint(0x4A5A6A), {0.0, 0.0, 0.10});
  attach(Solids{{{{0.0, 0.88, 0.0}, {0.40, 1.76, 0.40}}}});
  attach(finish::wood());
}

}  // namespace coherency
