#pragma once

#include <optional>

#include "common/world/WorldModel.h"

namespace coherency {

/// Where a vehicle begins, and where it works if it drives.
struct VehiclePlaces {
  BasePose start;
  std::optional<BasePose> workplace;
};

/// Throws std::invalid_argument naming both where things of two members of a scene stand in each other, a
/// movable in the floor or in what drives, or a vehicle would begin or work in something or in the other that
/// begins there. `robot` counts only where the model has one.
void checkPlaces(const WorldModel& model, const VehiclePlaces& master, const VehiclePlaces& robot);

/// Whether a vehicle can stand there: in no wall, furniture or closed door; movables may be in its way.
bool standsFree(const BasePose& base, const VehicleModel& vehicle, const WorldModel& model);

/// What a movable takes up when its centre is there; the pose's heading turns it.
SolidBox boxOf(const MovableModel& movable, const BasePose& centre);
/// Whether a vehicle begins in it.
bool begins(const WorldModel& model, const SolidBox& box);

}  // namespace coherency
