#include "common/body/HeadShape.h"

#include <algorithm>
#include <cmath>

#include "common/body/Assemble.h"
#include "common/body/Palette.h"

namespace coherency {

namespace {

std::vector<Loft::Section> scaled(std::vector<Loft::Section> sections, double k) {
  for (auto& s : sections) s = {s.at * k, s.a * k, s.b * k, s.centre_a * k, s.centre_b * k};
  return sections;
}

}  // namespace

double headScale(const Rig& rig) {
  return std::max({0.8, rig.eye_forward / 0.085, rig.eye_distance / 0.074, std::abs(rig.eye_up) / 0.045});
}

HeadShape::HeadShape(const Rig& rig) : VRObject("head shape") {
  buildSkull(rig);
  buildFace(rig);
}

void HeadShape::buildSkull(const Rig& rig) {
  const double k = headScale(rig);
  skull_.setSections(scaled({{-0.112, 0.046, 0.034, -0.054},
                             {-0.085, 0.071, 0.052, -0.034},
                             {-0.040, 0.095, 0.067, -0.013},
                             {0.010, 0.106, 0.074, -0.003},
                             {0.055, 0.106, 0.076, 0.000},
                             {0.092, 0.091, 0.068, 0.003}},
                            k),
                     {Loft::Along::Y, 20, 2.2, 0.010 * k, 0.035 * k});
  assemble(*this, skull_, "skull", paint(palette::kSkin));
  // The hair stays behind the plane of the eyes, so that it cannot come into their view.
  hair_.setSections(scaled({{-0.055, 0.060, 0.060, 0.045},
                            {0.000, 0.082, 0.077, 0.032},
                            {0.050, 0.092, 0.0815, 0.024},
                            {0.095, 0.086, 0.075, 0.014}},
                           k),
                    {Loft::Along::Y, 20, 2.2, 0.015 * k, 0.042 * k});
  assemble(*this, hair_, "hair", paint(palette::kHair, 0.15));
  const double down = std::max(0.02, rig.neck_length);
  neck_.setSections({{-down - 0.01, 0.049, 0.050, rig.neck_back},
                     {-0.6 * down, 0.049, 0.050, rig.neck_back * 0.7},
                     {-0.25 * down, 0.051, 0.051, rig.neck_back * 0.4}},
                    {Loft::Along::Y, 14, 2.0, 0.0, 0.0});
  assemble(*this, neck_, "neck", paint(palette::kSkin));
}

/// What the head-mounted display leaves free; eyes and brows are behind it.
void HeadShape::buildFace(const Rig& rig) {
  const double k = headScale(rig);
  const Material skin = paint(palette::kSkin);
  nose_.setSize({0.012 * k, 0.018 * k, 0.013 * k}, 10);
  assemble(*this, nose_, "nose", skin, {0.0, rig.eye_up - 0.053 * k, -0.1035 * k});
  mouth_.setSize({0.024 * k, 0.0055 * k, 0.010 * k}, 10);
  assemble(*this, mouth_, "mouth", paint(0xB3706A), {0.0, -0.060 * k, -0.1005 * k});
  for (std::size_t i = 0; i < 2; ++i) {
    const double side = i == 0 ? -1.0 : 1.0;
    const std::string which = i == 0 ? "left " : "right ";
    ears_[i].setSize({0.013 * k, 0.031 * k, 0.018 * k}, 10);
    assemble(*this, ears_[i], which + "ear", skin, {side * 0.079 * k, 0.002, 0.002});
  }
}

}  // namespace coherency
