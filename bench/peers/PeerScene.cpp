#include "bench/peers/PeerScene.h"

#include <fstream>
#include <stdexcept>
#include <type_traits>

namespace coherency {
namespace {

/// Calls visit() for each of the scene's parts, in the order they have in the file.
void forEachPart(auto& scene, auto&& visit) {
  visit(scene.lit.objects);
  visit(scene.lit.vertices);
  visit(scene.lit.indices);
  visit(scene.mapped.objects);
  visit(scene.mapped.vertices);
  visit(scene.mapped.indices);
  visit(scene.lightmap);
  visit(scene.lightmap_size);
  visit(scene.moving);
  visit(scene.moving_vertices);
  visit(scene.moving_indices);
  visit(scene.lamp_sets);
  visit(scene.views);
  visit(scene.ambient);
  visit(scene.lamp_count);
  visit(scene.on_the_way);
}

void write(std::ostream& out, const auto* data, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<std::remove_reference_t<decltype(*data)>>);
  out.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(count * sizeof(*data)));
}

void read(std::istream& in, auto* data, std::size_t count) {
  in.read(reinterpret_cast<char*>(data), static_cast<std::streamsize>(count * sizeof(*data)));
}

}  // namespace

void writePeerScene(const PeerScene& scene, const std::filesystem::path& path) {
  std::ofstream out(path, std::ios::binary);
  forEachPart(scene, [&]<class Part>(const Part& part) {
    if constexpr (requires { part.size(); }) {
      const std::uint64_t count = part.size();
      write(out, &count, 1);
      write(out, part.data(), part.size());
    } else {
      write(out, &part, 1);
    }
  });
  out.close();
  if (!out) throw std::runtime_error(path.string() + ": cannot be written");
}

PeerScene readPeerScene(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  PeerScene scene;
  const std::uint64_t size = std::filesystem::exists(path) ? std::filesystem::file_size(path) : 0;
  forEachPart(scene, [&]<class Part>(Part& part) {
    if constexpr (requires { part.size(); }) {
      std::uint64_t count = 0;
      read(in, &count, 1);
      if (!in || count > size) throw std::runtime_error(path.string() + ": no scene of peer_export");
      part.resize(count);
      read(in, part.data(), count);
    } else {
      read(in, &part, 1);
    }
  });
  if (!in || in.peek() != std::ifstream::traits_type::eof())
    throw std::runtime_error(path.string() + ": no scene of this build's peer_export");
  return scene;
}

}  // namespace coherency
