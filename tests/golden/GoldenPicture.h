#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/scene/VRObject.h"
#include "render_client/draw/IdImage.h"
#include "render_client/draw/Image.h"

namespace coherency::golden {

/// A picture, and which object shows in each of its pixels.
struct GoldenPicture {
  Image colour;
  Image ids;                         ///< idColour() of the object's number
  std::vector<std::string> objects;  ///< number 1 on, in the order in which they show; 0: none
};

/// Objects are called by their path in the tree below `root`; where several share it, with a number each.
GoldenPicture goldenPicture(const Image& colour, const IdImage& ids, const VRObject& root);

/// NAME.png, NAME_ids.png and, an object a line, NAME_ids.txt. Throw std::runtime_error naming the file.
void write(const GoldenPicture& picture, const std::filesystem::path& folder, const std::string& name);
GoldenPicture read(const std::filesystem::path& folder, const std::string& name);

/// How two pictures of one size differ.
struct Difference {
  static constexpr int kTolerance = 3;        ///< of 255, in any channel
  static constexpr double kExcepted = 0.002;  ///< share of the pixels that may differ by more

  std::size_t ids = 0;   ///< pixels that show another object
  std::string first_id;  ///< which, of the first of them
  double colours = 0.0;  ///< share of the pixels beyond the tolerance
  int most = 0;          ///< of 255
  bool matches() const { return ids == 0 && colours <= kExcepted; }
  std::string text() const;
};
Difference difference(const GoldenPicture& actual, const GoldenPicture& expected);

/// Writes both, as NAME_actual and NAME_expected, and NAME_difference.png: absolute, 16 times, white where
/// another object shows.
void writeDifference(const GoldenPicture& actual, const GoldenPicture& expected,
                     const std::filesystem::path& folder, const std::string& name);

}  // namespace coherency::golden
