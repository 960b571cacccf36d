#include "common/world/Snapshot.h"

#include <array>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "common/world/StateFields.h"

namespace coherency {

namespace {

constexpr std::array<std::byte, 4> kMagic = {std::byte{'C'}, std::byte{'O'}, std::byte{'H'}, std::byte{'S'}};

/// The integer that stands for a field.
template <class Field>
auto bitsOf(const Field& field) {
  if constexpr (std::is_same_v<Field, bool>)
    return static_cast<std::uint8_t>(field);
  else if constexpr (std::is_enum_v<Field>)
    return static_cast<std::underlying_type_t<Field>>(field);
  else
    return static_cast<std::make_unsigned_t<Field>>(field);
}

template <class Unsigned>
void append(std::vector<std::byte>& out, Unsigned bits) {
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
    out.push_back(static_cast<std::byte>(static_cast<std::uint64_t>(bits) >> (8 * i) & 0xFFU));
}

[[noreturn]] void refuse(const std::string& why) {
  throw std::runtime_error("world snapshot: " + why);
}

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

  std::uint64_t take(std::size_t size, const char* what) {
    if (rest_.size() < size) refuse(std::string("is cut short at '") + what + "'");
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i) bits |= std::to_integer<std::uint64_t>(rest_[i]) << (8 * i);
    rest_ = rest_.subspan(size);
    return bits;
  }
  std::size_t left() const { return rest_.size(); }

 private:
  std::span<const std::byte> rest_;
};

void checkCounts(const char* name, std::uint64_t value) {
  const std::string which = name;
  if ((which == "number of movables" && value > kMaxMovables) ||
      (which == "number of doors" && value > kMaxDoors))
    refuse(which + " is " + std::to_string(value) + ", more than a world has");
}

}  // namespace

std::vector<std::byte> snapshot(const WorldState& state) {
  std::vector<std::byte> bytes(kMagic.begin(), kMagic.end());
  append(bytes, kSnapshotLayout);
  forEachField(state, [&](const char*, const auto& field) { append(bytes, bitsOf(field)); });
  return bytes;
}

WorldState restore(std::span<const std::byte> bytes, const World& world) {
  Reader reader(bytes);
  for (const std::byte b : kMagic)
    if (reader.take(1, "COHS") != std::to_integer<std::uint64_t>(b))
      refuse("does not begin with COHS: it is none");
  const std::uint64_t layout = reader.take(2, "layout version");
  if (layout != kSnapshotLayout)
    refuse("has layout version " + std::to_string(layout) + ", this program reads " +
           std::to_string(kSnapshotLayout) + "; take it anew with this version");
  WorldState state;
  forEachField(state, [&](const char* name, auto& field) {
    using Field = std::remove_reference_t<decltype(field)>;
    const std::uint64_t bits = reader.take(sizeof(bitsOf(field)), name);
    if (std::is_same_v<Field, bool> && bits > 1)
      refuse(std::string("'") + name + "' is " + std::to_string(bits) + ", neither 0 nor 1");
    checkCounts(name, bits);
    field = static_cast<Field>(bits);
  });
  if (reader.left() != 0) refuse("goes on for " + std::to_string(reader.left()) + " bytes after its end");
  if (!isValid(state))
    refuse(
        "holds what no world can: a place beyond its end, or a speed, a door or an attitude that cannot be");
  if (!world.fits(state))
    refuse(
        "was taken of another world: of " + std::to_string(state.movables.size()) + " things to grasp and " +
        std::to_string(state.doors.size()) + " doors, or a robot, or faster than this one goes; this has " +
        std::to_string(world.model().movables.size()) + " and " + std::to_string(world.model().doors.size()) +
        (world.has(Mode::Robot) ? ", with" : ", without") + " a robot");
  return state;
}

}  // namespace coherency
