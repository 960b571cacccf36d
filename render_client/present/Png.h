#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "render_client/draw/Image.h"

namespace coherency {

/// Keyword and text of PNG tEXt chunks. Keywords are Latin-1 of 1 to 79 characters.
using PngText = std::vector<std::pair<std::string, std::string>>;

/// Writes an 8-bit RGB picture marked as sRGB. Throws std::runtime_error naming the file and the reason,
/// after removing what was written.
void writePng(const std::filesystem::path& path, const Image& image, const PngText& text = {});

/// Reads any PNG as 8-bit RGB (transparency is dropped); `text`, if given, receives its text chunks. Throws
/// std::runtime_error naming the file and the reason.
Image readPng(const std::filesystem::path& path, PngText* text = nullptr);

}  // namespace coherency
