#include "common/objects/Outdoors.h"

#include <cmath>

#include "common/body/Palette.h"
#include "common/math/FixedPoint.h"
#include "common/objects/Finish.h"
#include "common/objects/Room.h"

namespace coherency {

namespace {

constexpr double kGround = Facade::kGround;
constexpr double kSky = 70.0;  // radius of the dome
constexpr Coord3 kMiddle{3.5, kGround, 0.0};

/// On a circle about the vertical through the building's middle; angles from +z towards +x.
Coord3 around(double radius, double y, double angle) {
  return kMiddle + Coord3{radius * std::sin(angle), y, radius * std::cos(angle)};
}

/// Seen from within: a silhouette whose height goes up and down with the direction.
Faces hills(double radius, double height, double phase) {
  constexpr int kSteps = 42;
  const auto top = [&](int i) {
    const double a = kTurn * i / kSteps;
    return height * (1.0 + 0.42 * std::sin(3.0 * a + phase) + 0.28 * std::sin(7.0 * a + 2.0 * phase) +
                     0.12 * std::sin(13.0 * a));
  };
  Faces faces;
  for (int i = 0; i < kSteps; ++i) {
    const double a = kTurn * i / kSteps;
    const double b = kTurn * (i + 1) / kSteps;
    faces.add({around(radius, 0.0, b), around(radius, 0.0, a), around(radius, top(i), a)});
    faces.add({around(radius, 0.0, b), around(radius, top(i), a), around(radius, top(i + 1), b)});
  }
  return faces;
}

/// Seen from within: the part of the dome between two elevations. The last ends in the zenith.
Faces skyBand(double from, double to) {
  constexpr int kSides = 16;
  const bool zenith = to >= kTurn / 4;
  Faces faces;
  for (int i = 0; i < kSides; ++i) {
    const double a = kTurn * i / kSides;
    const double b = kTurn * (i + 1) / kSides;
    const auto at = [](double elevation, double angle) {
      return around(kSky * std::cos(elevation), kSky * std::sin(elevation), angle);
    };
    if (zenith)
      faces.add({at(from, b), at(from, a), at(to, a)});
    else
      faces.add({at(from, b), at(from, a), at(to, a), at(to, b)});
  }
  return faces;
}

}  // namespace

Outdoors::Outdoors() : VRObject("outdoors") {
  buildGarden();
  buildHorizon();
  plantTrees();
}

void Outdoors::buildGarden() {
  constexpr int kSides = 24;
  std::vector<Coord3> rim;
  rim.reserve(kSides);
  for (int i = 0; i < kSides; ++i) rim.push_back(around(kSky, 0.0, kTurn * i / kSides));
  Faces lawn;
  lawn.add(rim);
  assembleFaces(*this, lawn_, "lawn", finish::daylit(0x9DB27F), lawn);

  // A strip along the walls, the court's path, and one that leads away from it.
  constexpr double kTop = kGround + 0.012;
  const auto strip = [](double left, double right, double from, double to) {
    return std::vector<Coord3>{{left, kTop, to}, {right, kTop, to}, {right, kTop, from}, {left, kTop, from}};
  };
  Faces gravel;
  gravel.add(strip(-4.6, 2.6, -4.0, -3.2));
  gravel.add(strip(2.6, 3.5, -9.6, -3.2));
  gravel.add(strip(-1.2, 0.2, -30.0, -4.0));
  gravel.add(strip(-9.0, -1.2, -10.4, -9.2));
  gravel.add(strip(4.2, 5.3, -40.0, -9.0));  // ahead of the corridor
  gravel.add(strip(11.9, 13.1, -20.0, 20.0));
  gravel.add(strip(-10.0, 11.9, 11.4, 12.6));
  assembleFaces(*this, gravel_, "gravel", finish::daylit(0xD6CBB4), gravel);
  assembleBoxes(*this, hedge_, "hedge", finish::daylit(0x66865A),
                {{{2.4, 0.9, 0.7}, {2.4, kGround + 0.45, -14.0}, kNoBottom},
                 {{2.4, 0.9, 0.7}, {7.1, kGround + 0.45, -14.0}, kNoBottom},
                 {{0.7, 0.9, 9.0}, {18.0, kGround + 0.45, 2.5}, kNoBottom},
                 {{9.0, 0.9, 0.7}, {-1.5, kGround + 0.45, 17.0}, kNoBottom}});
  assembleBoxes(*this, bench_, "garden bench", finish::daylit(0x9A7350),
                {{{1.6, 0.06, 0.45}, {-2.2, kGround + 0.45, -8.6}},
                 {{1.6, 0.30, 0.05}, {-2.2, kGround + 0.75, -8.85}},
                 {{0.08, 0.42, 0.40}, {-2.8, kGround + 0.21, -8.6}, kNoBottom | kNoTop},
                 {{0.08, 0.42, 0.40}, {-1.6, kGround + 0.21, -8.6}, kNoBottom | kNoTop}});
}

void Outdoors::buildHorizon() {
  assembleFaces(*this, near_hills_, "near hills", finish::daylit(0x8CA587), hills(58.0, 3.4, 0.4));
  assembleFaces(*this, far_hills_, "far hills", finish::daylit(0xA9BCC0), hills(64.0, 7.0, 2.1));
  // Pale at the horizon, deeper above; the bands grow towards the zenith, where one hardly sees them.
  const Coord3 low = linearColour(0xEAF1F2);
  const Coord3 high = linearColour(0x8FB8DE);
  for (std::size_t i = 0; i < kSkyBands; ++i) {
    const auto elevation = [](std::size_t band) {
      const double share = static_cast<double>(band) / kSkyBands;
      return kTurn / 4 * share * (0.45 + 0.55 * share);
    };
    const double share = static_cast<double>(i) / (kSkyBands - 1);
    const Material air{low + (high - low) * std::sqrt(share), 0.0, 1.0};
    assembleFaces(*this, sky_[i], "sky", air, skyBand(elevation(i), elevation(i + 1)));
  }
}

void Outdoors::plantTrees() {
  // In front of the laboratory and the corridor's end, before the office, and behind the meeting room.
  constexpr std::array<Coord3, kTrees> kPlaces = {{{-7.2, 0.0, -13.0},
                                                   {-3.4, 0.0, -16.5},
                                                   {1.6, 0.0, -11.0},
                                                   {7.6, 0.0, -17.0},
                                                   {16.2, 0.0, -4.6},
                                                   {15.6, 0.0, 5.4},
                                                   {-4.4, 0.0, 15.0},
                                                   {0.8, 0.0, 19.5},
                                                   {5.4, 0.0, 15.4}}};
  for (std::size_t i = 0; i < trees_.size(); ++i)
    put(*this, trees_[i], kPlaces[i] + Coord3{0.0, kGround, 0.0}, 1.3 * static_cast<double>(i));
}

}  // namespace coherency
