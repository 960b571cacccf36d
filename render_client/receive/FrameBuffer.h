#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "common/sync/Clock.h"
#include "common/wire/Packets.h"

namespace coherency {

/// A frame, when it first came, and when the newest sample that it was predicted from was taken.
struct ReceivedFrame {
  std::uint64_t session_id = 0;
  FrameState state;
  ClientTime arrived;
  ServerTime sampled;
};

/// The frames that have come, in whatever order, each once: of the newest kRemembered numbers.
class FrameBuffer {
 public:
  static constexpr std::uint64_t kRemembered = 128;
  static constexpr std::uint64_t kMostNumber = std::uint64_t{1} << 62;  ///< no session lasts so long

  /// False: it is here already, too old, or beyond kMostNumber.
  bool add(const ReceivedFrame& frame);
  void clear();
  /// 0: none yet.
  std::uint64_t newest() const { return newest_; }

  /// What to draw after frame `after`. Of each `stride` numbers that follow each other (0 to stride - 1 and
  /// so on) the first that is here may be drawn; of these the first that can still be seen in its time, if
  /// its picture is begun now (its photons are not before `earliest`), else the newest. The one before it is
  /// drawn late where a picture takes so little that the one in time still will be: eyes that show a frame
  /// some milliseconds apart disagree for these, eyes of which one leaves it out for a whole frame.
  std::optional<ReceivedFrame> next(std::uint64_t after, std::uint64_t stride, ServerTime earliest,
                                    std::int64_t draw_ns) const;
  /// Those that might have been drawn between two that were.
  std::vector<ReceivedFrame> between(std::uint64_t after, std::uint64_t before, std::uint64_t stride) const;

  /// From now on the first frame of each of these numbers or after it is kept, and of no others.
  void keepFirstFrom(const std::vector<std::uint64_t>& numbers);
  /// The one that was kept, however long ago it came; none where nothing so late has come.
  std::optional<ReceivedFrame> firstFrom(std::uint64_t number) const;

 private:
  const ReceivedFrame* find(std::uint64_t number) const;
  const ReceivedFrame* firstOf(std::uint64_t group, std::uint64_t stride) const;
  std::uint64_t oldest() const { return newest_ > kRemembered ? newest_ - kRemembered : 0; }

  std::array<std::optional<ReceivedFrame>, kRemembered> frames_;  ///< by number modulo kRemembered
  std::map<std::uint64_t, std::optional<ReceivedFrame>> kept_;    ///< by the first number that will do
  std::uint64_t newest_ = 0;
};

}  // namespace coherency
