#include "tests/golden/GoldenPicture.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <unordered_map>

#include "render_client/present/Png.h"

namespace coherency::golden {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

/// Its bits go to the channels in turn, from the highest down, so that numbers near to one another look
/// different.
Rgb idColour(std::size_t number) {
  Rgb colour{};
  for (std::size_t bit = 0; bit < 24; ++bit)
    if ((number >> bit & 1U) != 0U)
      colour[bit % 3] = static_cast<std::uint8_t>(colour[bit % 3] | (0x80U >> bit / 3));
  return colour;
}

Rgb pixel(const Image& image, std::size_t i) {
  return {image.rgb[3 * i], image.rgb[3 * i + 1], image.rgb[3 * i + 2]};
}

std::size_t pixelCount(const Image& image) {
  return image.rgb.size() / 3;
}

/// By what an object in the tree is called.
std::unordered_map<const VRObject*, std::string> names(const VRObject& root) {
  std::unordered_map<std::string, int> met;
  std::unordered_map<const VRObject*, std::string> called;
  forEachObject(root, {}, [&](const VRObject& object, const TransformMatrix&) {
    const std::string path = object.path();
    const int number = ++met[path];
    called[&object] = number == 1 ? path : path + " #" + std::to_string(number);
  });
  return called;
}

/// The name of what shows in each pixel; empty: nothing.
std::vector<std::string> shown(const GoldenPicture& picture) {
  std::map<Rgb, std::string> by_colour{{idColour(0), {}}};
  for (std::size_t i = 0; i < picture.objects.size(); ++i) by_colour[idColour(i + 1)] = picture.objects[i];
  std::vector<std::string> all;
  for (std::size_t i = 0; i < pixelCount(picture.ids); ++i) {
    const auto found = by_colour.find(pixel(picture.ids, i));
    all.push_back(found == by_colour.end() ? "a colour of no object" : found->second);
  }
  return all;
}

std::string orNothing(const std::string& object) {
  return object.empty() ? "nothing" : object;
}

bool sameSize(const GoldenPicture& a, const GoldenPicture& b) {
  return a.colour.width == b.colour.width && a.colour.height == b.colour.height &&
         a.ids.width == b.ids.width && a.ids.height == b.ids.height;
}

}  // namespace

GoldenPicture goldenPicture(const Image& colour, const IdImage& ids, const VRObject& root) {
  GoldenPicture picture{colour, {ids.width, ids.height, {}}, {}};
  const auto called = names(root);
  std::unordered_map<std::uint32_t, std::size_t> numbers{{0U, 0U}};
  for (const std::uint32_t id : ids.ids) {
    const auto [number, is_new] = numbers.emplace(id, picture.objects.size() + 1);
    if (is_new) picture.objects.push_back(called.at(ids.objects[id - 1]));
    const Rgb as_colour = idColour(number->second);
    picture.ids.rgb.insert(picture.ids.rgb.end(), as_colour.begin(), as_colour.end());
  }
  return picture;
}

void write(const GoldenPicture& picture, const std::filesystem::path& folder, const std::string& name) {
  writePng(folder / (name + ".png"), picture.colour);
  writePng(folder / (name + "_ids.png"), picture.ids);
  const std::filesystem::path list = folder / (name + "_ids.txt");
  std::ofstream out(list);
  for (const std::string& object : picture.objects) out << object << '\n';
  if (!out.flush()) throw std::runtime_error(list.string() + ": cannot be written");
}

GoldenPicture read(const std::filesystem::path& folder, const std::string& name) {
  GoldenPicture picture{readPng(folder / (name + ".png")), readPng(folder / (name + "_ids.png")), {}};
  const std::filesystem::path list = folder / (name + "_ids.txt");
  std::ifstream in(list);
  if (!in) throw std::runtime_error(list.string() + ": cannot be read");
  for (std::string object; std::getline(in, object);) picture.objects.push_back(object);
  return picture;
}

Difference difference(const GoldenPicture& actual, const GoldenPicture& expected) {
  if (!sameSize(actual, expected)) return {pixelCount(actual.ids), "pictures of different sizes", 1.0, 255};
  Difference found;
  const std::vector<std::string> in_actual = shown(actual);
  const std::vector<std::string> in_expected = shown(expected);
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < pixelCount(actual.colour); ++i) {
    if (in_actual[i] != in_expected[i] && found.ids++ == 0)
      found.first_id = orNothing(in_actual[i]) + " in place of " + orNothing(in_expected[i]);
    int off = 0;
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
      off = std::max(off, std::abs(actual.colour.rgb[c] - expected.colour.rgb[c]));
    beyond += off > Difference::kTolerance ? 1U : 0U;
    found.most = std::max(found.most, off);
  }
  found.colours = static_cast<double>(beyond) / static_cast<double>(pixelCount(actual.colour));
  return found;
}

std::string Difference::text() const {
  std::array<char, 160> colour{};
  std::snprintf(colour.data(), colour.size(),
                "%.3f %% of the colours are off by more than %d/255, by %d at most", 100.0 * colours,
                kTolerance, most);
  return std::to_string(ids) + " pixels show another object" +
         (ids == 0 ? "" : " (first: " + first_id + ")") + "; " + colour.data();
}

void writeDifference(const GoldenPicture& actual, const GoldenPicture& expected,
                     const std::filesystem::path& folder, const std::string& name) {
  std::filesystem::create_directories(folder);
  write(actual, folder, name + "_actual");
  write(expected, folder, name + "_expected");
  if (!sameSize(actual, expected)) return;
  constexpr int kTimes = 16;
  Image image = actual.colour;
  const std::vector<std::string> in_actual = shown(actual);
  const std::vector<std::string> in_expected = shown(expected);
  for (std::size_t c = 0; c < image.rgb.size(); ++c) {
    const int off = std::abs(actual.colour.rgb[c] - expected.colour.rgb[c]);
    image.rgb[c] =
        static_cast<std::uint8_t>(in_actual[c / 3] != in_expected[c / 3] ? 255 : std::min(kTimes * off, 255));
  }
  writePng(folder / (name + "_difference.png"), image);
}

}  // namespace coherency::golden
