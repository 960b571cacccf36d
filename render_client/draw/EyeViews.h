#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "common/config/HmdProfile.h"
#include "common/world/Scene.h"
#include "render_client/draw/EyeView.h"

namespace coherency {

/// Which eyes' pictures a client draws.
enum class EyeChoice : std::uint8_t { Left, Right, Both, Mono };
/// "left", "right", "both" or "mono"; anything else is a mistake of the caller's (asserted).
EyeChoice eyeChoice(std::string_view name);
/// m, at the operator's size.
inline constexpr double kNearestToScreen = 0.1;

constexpr int eyeCount(EyeChoice choice) {
  return choice == EyeChoice::Both ? 2 : 1;
}

/// Whether any of those eyes looks through a lens. The view from between the eyes is for monitors: it has
/// none.
bool hasLens(const HmdProfile& hmd, EyeChoice eyes);

/// T_world_vehicle of what one drives in that mode.
TransformMatrix vehicle(const Scene& scene, Mode mode);
/// Of the one that stays behind; none where the scene has but one.
std::optional<TransformMatrix> otherVehicle(const Scene& scene, Mode mode);

/// The views of the eyes of whom the operator is as the scene now stands (eq. 5), each `width` x `height`
/// pixels; both eyes stand side by side, the left one on the left. `views` is refilled, not reallocated.
///
/// Where the display is a screen, it stands before the seat, as large for a robot as its head is; it is as
/// wide as the profile has it, and as high as the picture's shape makes it. An eye that comes nearer to the
/// screen's plane than kNearestToScreen, or behind it, is taken to be as far before it.
void eyeViews(const Scene& scene, Mode mode, const HmdProfile& hmd, EyeChoice choice, int width, int height,
              std::vector<EyeView>& views);

}  // namespace coherency
