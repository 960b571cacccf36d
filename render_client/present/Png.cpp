#include "render_client/present/Png.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <system_error>

#include <png.h>

namespace coherency {
namespace {

constexpr png_uint_32 kLargestSide = 32768;
constexpr std::uint64_t kMostPixels =
    1U << 27U;  ///< what a file claims is allocated before it is seen to be true

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

/// libpng calls this in place of longjmp; it is compiled with unwinding, so an exception may pass.
[[noreturn]] void onError(png_structp, png_const_charp message) {
  throw std::runtime_error(message);
}
void onWarning(png_structp, png_const_charp) {}

File open(const std::filesystem::path& path, const char* mode) {
  File file(std::fopen(path.c_str(), mode));
  if (!file) throw std::runtime_error(std::strerror(errno));
  return file;
}

struct Writer {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, onError, onWarning);
  png_infop info = png_create_info_struct(png);
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

struct Reader {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, onError, onWarning);
  png_infop info = png_create_info_struct(png);
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

void setText(Writer& writer, const PngText& text) {
  std::vector<png_text> chunks;
  for (const auto& [keyword, value] : text) {
    if (keyword.empty() || keyword.size() > 79)
      throw std::runtime_error("text keyword '" + keyword + "' must have 1 to 79 characters");
    png_text chunk{};
    chunk.compression = PNG_TEXT_COMPRESSION_NONE;
    chunk.key = const_cast<char*>(keyword.c_str());  // libpng copies, but its struct does not say so
    chunk.text = const_cast<char*>(value.c_str());
    chunk.text_length = value.size();
    chunks.push_back(chunk);
  }
  png_set_text(writer.png, writer.info, chunks.data(), static_cast<int>(chunks.size()));
}

void write(std::FILE* file, const Image& image, const PngText& text) {
  if (image.width < 1 || image.height < 1 ||
      image.rgb.size() != static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3)
    throw std::runtime_error("the picture's size and its bytes do not agree");
  Writer writer;
  png_init_io(writer.png, file);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
  setText(writer, text);
  png_set_compression_level(writer.png, 3);  // half the time of the default, some percent larger
  png_write_info(writer.png, writer.info);
  const auto row = static_cast<std::size_t>(image.width) * 3;
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y)
    png_write_row(writer.png, image.rgb.data() + y * row);
  png_write_end(writer.png, nullptr);
  if (std::fflush(file) != 0) throw std::runtime_error(std::strerror(errno));
}

void readText(const Reader& reader, PngText& text) {
  png_textp chunks = nullptr;
  int count = 0;
  png_get_text(reader.png, reader.info, &chunks, &count);
  for (int i = 0; i < count; ++i)
    text.emplace_back(chunks[i].key, chunks[i].text == nullptr ? "" : chunks[i].text);
}

Image read(std::FILE* file, PngText* text) {
  Reader reader;
  png_init_io(reader.png, file);
  png_set_user_limits(reader.png, kLargestSide, kLargestSide);
  png_read_info(reader.png, reader.info);
  const std::uint64_t pixels = std::uint64_t{png_get_image_width(reader.png, reader.info)} *
                               png_get_image_height(reader.png, reader.info);
  if (pixels > kMostPixels)
    throw std::runtime_error("it claims " + std::to_string(pixels) + " pixels; at most " +
                             std::to_string(kMostPixels) + " are read");
  png_set_expand(reader.png);
  png_set_scale_16(reader.png);
  png_set_strip_alpha(reader.png);
  png_set_gray_to_rgb(reader.png);
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  Image image{static_cast<int>(png_get_image_width(reader.png, reader.info)),
              static_cast<int>(png_get_image_height(reader.png, reader.info)),
              {}};
  const auto row = static_cast<std::size_t>(image.width) * 3;
  image.rgb.resize(row * static_cast<std::size_t>(image.height));
  std::vector<png_bytep> rows;
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y)
    rows.push_back(image.rgb.data() + y * row);
  png_read_image(reader.png, rows.data());
  png_read_end(reader.png, reader.info);
  if (text != nullptr) readText(reader, *text);
  return image;
}

}  // namespace

void writePng(const std::filesystem::path& path, const Image& image, const PngText& text) {
  bool opened = false;
  try {
    const File file = open(path, "wb");
    opened = true;
    write(file.get(), image, text);
  } catch (const std::runtime_error& error) {
    std::error_code ignored;
    if (opened && std::filesystem::is_regular_file(path, ignored)) std::filesystem::remove(path, ignored);
    throw std::runtime_error(path.string() + ": cannot be written: " + error.what());
  }
}

Image readPng(const std::filesystem::path& path, PngText* text) {
  try {
    return read(open(path, "rb").get(), text);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path.string() + ": cannot be read: " + error.what());
  }
}

}  // namespace coherency
