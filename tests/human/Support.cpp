#include "tests/human/Support.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "common/motion/SampleGate.h"
#include "common/scene/FaceSet.h"

namespace coherency::human {

Rig rigOf(const std::string& name) {
  Rig rig;
  const double size = name == "small" ? 0.85 : name == "large" ? 1.12 : 1.0;
  for (const RigField& field : rigFields())
    if (field.name != "neck_back" && field.name != "robot_scale" && !field.name.starts_with("shoulder_tilt"))
      rig.*field.value *= size;
  rig.name = name;
  validate(rig);
  return rig;
}

MotionSample sampleOf(const Rig& rig, const std::array<double, kDofCount>& si) {
  SampleGate gate(neutralPosture(rig));
  MasterReading reading;
  reading.si = si;
  const MotionSample sample = gate.admit(reading, 1, 1);
  EXPECT_EQ(sample.valid, kAllDofs);
  return sample;
}

MotionSample randomSample(const Rig& rig, unsigned seed) {
  std::mt19937_64 engine(seed);
  const auto within = [&engine](double min, double max) {
    return min + (max - min) * static_cast<double>(engine() >> 11) * 0x1.0p-53;
  };
  auto si = neutralPosture(rig);
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const DofInfo& dof = dofTable()[i];
    const double middle = (dof.min + dof.max) / 2;
    const double half = (dof.max - dof.min) / 2;
    if (dof.kind == DofKind::Length) si[i] += within(-0.2, 0.2);
    if (dof.kind == DofKind::Angle) si[i] = middle + 0.75 * half * within(-1.0, 1.0);
    if (dof.kind == DofKind::Ratio) si[i] = within(dof.min, dof.max);
  }
  return sampleOf(rig, si);
}

std::array<double, kDofCount> neutralBut(const Rig& rig, Dof dof) {
  auto si = neutralPosture(rig);
  si[index(dof)] += info(dof).kind == DofKind::Ratio ? 0.5 : 0.1;
  return si;
}

Drawn drawn(const VRObject& root) {
  Drawn all;
  forEachObject(root, TransformMatrix{}, [&](const VRObject& object, const TransformMatrix& t_root_object) {
    if (object.faces() == nullptr) return;
    for (const Coord3& v : object.faces()->vertices) all[&object].push_back(t_root_object.point(v));
  });
  return all;
}

double farthestMove(const VRObject& root, const Drawn& before, const std::string& words) {
  double farthest = 0.0;
  for (const auto& [object, vertices] : drawn(root))
    for (std::size_t i = 0; i < vertices.size() && object->path().find(words) != std::string::npos; ++i)
      farthest = std::max(farthest, norm(vertices[i] - before.at(object)[i]));
  return farthest;
}

std::vector<Face> facesOf(const VRObject& root) {
  std::vector<Face> all;
  forEachObject(root, TransformMatrix{}, [&](const VRObject& object, const TransformMatrix& t_root_object) {
    if (object.faces() == nullptr) return;
    for (const auto& indices : object.faces()->faces) {
      Face face{&object, {}, {}};
      for (const std::uint32_t i : indices)
        face.corners.push_back(t_root_object.point(object.faces()->vertices[i]));
      for (std::size_t i = 0; i < face.corners.size(); ++i)
        face.normal += cross(face.corners[i] - face.corners[0],
                             face.corners[(i + 1) % face.corners.size()] - face.corners[0]);
      face.normal = normalized(face.normal);
      all.push_back(std::move(face));
    }
  });
  return all;
}

namespace {

/// How far outside all discs that are as high as it; below 0 within one.
double outside(const std::vector<FootprintDisc>& discs, const Coord3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const FootprintDisc& disc : discs)
    if (point.y >= disc.low - 1e-9 && point.y <= disc.high)
      least = std::min(least, std::hypot(point.x - disc.x, point.z - disc.z) - disc.radius);
  return least;
}

}  // namespace

void expectWithin(const std::vector<FootprintDisc>& discs, const VRObject& root,
                  const std::vector<std::string>& without) {
  double tallest = 0.0;
  for (const FootprintDisc& disc : discs) tallest = std::max(tallest, disc.high);
  for (const auto& [object, vertices] : drawn(root)) {
    const std::string path = object->path();
    if (std::any_of(without.begin(), without.end(),
                    [&](const std::string& words) { return path.find(words) != std::string::npos; }))
      continue;
    double farthest = -1.0;
    for (const Coord3& v : vertices)
      if (v.y <= tallest) farthest = std::max(farthest, outside(discs, v));
    EXPECT_LE(farthest, 0.05) << path;
  }
}

}  // namespace coherency::human
