#include "common/world/Furniture.h"

#include "common/body/Assemble.h"
#include "common/body/Palette.h"
#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

constexpr std::uint32_t kOak = 0xB98D5E;
constexpr std::uint32_t kPaleOak = 0xD2B084;
constexpr std::uint32_t kWhiteBoard = 0xE8E4DB;
constexpr std::uint32_t kSteel = 0x5B6166;

}  // namespace

Table::Table() : VRObject("table") {
  constexpr double kTop = 0.028;
  assembleBox(*this, top_, "table top", paint(kPaleOak, 0.12), {kWidth, kTop, kDepth},
              {0.0, kHeight - kTop / 2, 0.0});
  assembleBox(*this, edge_, "table frame", paint(kSteel, 0.3), {kWidth - 0.08, 0.03, kDepth - 0.08},
              {0.0, kHeight - kTop - 0.015, 0.0});
  assembleBox(*this, apron_, "table apron", paint(kOak, 0.1), {kWidth - 0.16, 0.22, 0.018},
              {0.0, kHeight - kTop - 0.14, -kDepth / 2 + 0.07});
  const double leg_height = kHeight - kTop - 0.03;
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    const double x = (i % 2 == 0 ? -1.0 : 1.0) * (kWidth / 2 - 0.07);
    const double z = (i / 2 == 0 ? -1.0 : 1.0) * (kDepth / 2 - 0.07);
    assembleBox(*this, legs_[i], "table leg", paint(kSteel, 0.3), {0.045, leg_height, 0.045},
                {x, leg_height / 2, z});
  }
}

Desk::Desk() : VRObject("desk") {
  constexpr double kTop = 0.03;
  constexpr double kUnder = kHeight - kTop;
  assembleBox(*this, top_, "desk top", paint(kOak, 0.15), {1.5, kTop, 0.68}, {0.0, kHeight - kTop / 2, 0.0});
  assembleBox(*this, side_, "desk side", paint(kWhiteBoard), {0.03, kUnder, 0.62}, {-0.70, kUnder / 2, 0.0});
  assembleBox(*this, back_, "desk back", paint(kWhiteBoard), {0.99, 0.35, 0.02},
              {-0.19, kUnder - 0.175, -0.28});
  assembleBox(*this, drawers_, "desk drawers", paint(kWhiteBoard), {0.42, kUnder, 0.60},
              {0.51, kUnder / 2, 0.0});
  for (std::size_t i = 0; i < fronts_.size(); ++i) {
    const double y = kUnder - 0.13 - 0.21 * static_cast<double>(i);
    assembleBox(*this, fronts_[i], "desk drawer front", paint(0xF2EFE8, 0.1), {0.39, 0.19, 0.016},
                {0.51, y, 0.308});
    assembleBox(*this, grips_[i], "desk drawer grip", paint(kSteel, 0.4), {0.12, 0.014, 0.02},
                {0.51, y + 0.05, 0.324});
  }
}

Bookshelf::Bookshelf() : VRObject("bookshelf") {
  buildCase();
  buildBooks();
}

void Bookshelf::buildCase() {
  const Material wood = paint(kOak, 0.1);
  for (std::size_t i = 0; i < sides_.size(); ++i)
    assembleBox(*this, sides_[i], "shelf side", wood, {0.025, 2.0, 0.30},
                {i == 0 ? -0.5875 : 0.5875, 1.0, 0.0});
  for (std::size_t i = 0; i < boards_.size(); ++i)
    assembleBox(*this, boards_[i], "shelf board", wood, {1.15, 0.025, 0.29},
                {0.0, 0.07 + 0.475 * static_cast<double>(i), 0.0});
  assembleBox(*this, back_, "shelf back", paint(0x8F6A44), {1.15, 1.99, 0.012}, {0.0, 1.0, -0.143});
}

/// Rows from the second board up; the sizes follow a short cycle that does not fit the row's length, so no
/// two rows look alike.
void Bookshelf::buildBooks() {
  constexpr std::array<std::uint32_t, 7> kCovers = {0x8C3B3B, 0x3E6A86, 0xD3B46A, 0x4F7A5A,
                                                    0xE3DCCB, 0x6B4C78, 0xB96A3E};
  constexpr std::array<double, 5> kThick = {0.034, 0.048, 0.028, 0.041, 0.055};
  constexpr std::array<double, 4> kTall = {0.27, 0.31, 0.24, 0.29};
  double x = -0.54;
  std::size_t row = 0;
  for (std::size_t i = 0; i < books_.size(); ++i) {
    if (i % 12 == 0) x = row % 2 == 0 ? -0.545 : -0.02, ++row;
    const double thick = kThick[i % kThick.size()];
    const double tall = kTall[i % kTall.size()];
    const double floor = 0.0825 + 0.475 * static_cast<double>(row);
    const double deep = 0.19 + 0.012 * static_cast<double>(i % 3);
    assembleBox(*this, books_[i], "book", paint(kCovers[(i * 3) % kCovers.size()], 0.05), {thick, tall, deep},
                {x + thick / 2, floor + tall / 2, 0.13 - deep / 2});
    x += thick + 0.0015;
  }
  vase_.setTapered(0.075, 0.045, 0.24, 14);
  assemble(*this, vase_, "vase", paint(0x4E8A8B, 0.5), {0.33, 0.5575 + 0.12, 0.02});
  assembleBox(*this, file_box_, "file box", paint(0xA7B4B0), {0.40, 0.26, 0.24},
              {-0.30, 1.0325 + 0.13, 0.01});
}

Cabinet::Cabinet() : VRObject("cabinet") {
  assembleBox(*this, plinth_, "cabinet plinth", paint(kSteel), {1.14, 0.07, 0.38}, {0.0, 0.035, -0.01});
  assembleBox(*this, body_, "cabinet body", paint(0xCFC9BD), {1.2, kHeight - 0.095, 0.42},
              {0.0, 0.07 + (kHeight - 0.095) / 2, 0.0});
  assembleBox(*this, top_, "cabinet top", paint(kOak, 0.15), {1.22, 0.025, 0.44},
              {0.0, kHeight - 0.0125, 0.0});
  for (std::size_t i = 0; i < doors_.size(); ++i) {
    const double side = i == 0 ? -1.0 : 1.0;
    assembleBox(*this, doors_[i], "cabinet door", paint(0x7F9A94, 0.1), {0.585, 0.70, 0.018},
                {side * 0.2975, 0.445, 0.219});
    knobs_[i].setSize(0.014, 0.025, 12);
    assemble(*this, knobs_[i], "cabinet knob", paint(palette::kMetal, 0.6), {side * 0.05, 0.50, 0.24});
    knobs_[i].setOrientation(TransformMatrix::rotationX(kTurn / 4));
  }
}

}  // namespace coherency
