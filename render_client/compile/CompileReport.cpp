#include "render_client/compile/CompileReport.h"

#include <cmath>

#include <fmt/format.h>

namespace coherency {
namespace {

constexpr double kReach = 0.5;  // m, from the eye to the hand

std::string line(const char* what, const CompileReport::Objects& objects, const std::string& why = {}) {
  return fmt::format("{:<16}{:>9} objects {:>9} polygons{}\n", what, objects.count, objects.polygons,
                     why.empty() ? "" : ": " + why);
}

std::string leftOut(const CompileReport& report) {
  std::string text;
  if (report.without_faces > 0)
    text += fmt::format("{:<16}{:>9} objects: they only group others\n", "left out", report.without_faces);
  if (report.without_area.count > 0)
    text += line("left out", report.without_area, "their faces have no area");
  if (report.flat.count > 0) text += line("left out", report.flat, "their transform squashes them flat");
  return text;
}

std::string objectLines(const CompileReport& report) {
  std::string text =
      line("fixed", report.fixed,
           fmt::format("{} declared Fixed, the others' moves are noticed", report.declared_fixed));
  text += line("moving", report.declared_moving, "declared Moving, or part of what is");
  if (report.found_to_move.count > 0)
    text += line("found to move", report.found_to_move, "not declared, but moved; declare them Moving");
  for (const std::string& path : report.found) text += "                " + path + "\n";
  return text + leftOut(report);
}

std::string surfaceLine(const char* what, const CompileReport::Surfaces& surfaces, const char* in) {
  if (surfaces.blocks == 0) return {};
  return fmt::format("{:<16}{:>9} {:<7} {:>9} triangles {:>9} vertices\n", what, surfaces.blocks, in,
                     surfaces.triangles, surfaces.vertices);
}

}  // namespace

double CompileReport::positionError(double distance) const {
  const double r = largest_radius;
  return std::ldexp(3.0 * r + (r + distance) + distance, -24);
}

std::string describe(const CompileReport& report) {
  std::string text = objectLines(report);
  text += surfaceLine("lit at vertices", report.lit, "blocks") +
          surfaceLine("lit by lightmap", report.mapped, "blocks") +
          surfaceLine("moving", report.moving, "wholes");
  text += fmt::format(
      "{:<16}{} triangles of what is fixed cut into {}, until it is right between vertices to {:g} "
      "of white times m\n",
      "light", report.triangles_before, report.triangles_cut, report.tolerance);
  text += report.charts == 0
              ? fmt::format("{:<16}none: no flat surface had to be cut for its light\n", "lightmap")
              : fmt::format("{:<16}{} x {} texels for {} surfaces\n", "lightmap", report.lightmap_width,
                            report.lightmap_height, report.charts);
  text += fmt::format("{:<16}{}\n", "lamps", report.lamps);
  if (report.triangles_coarser > 0)
    text += fmt::format("{:<16}{} triangles more, over the same vertices, for what is far away\n", "detail",
                        report.triangles_coarser);
  text += fmt::format("{:<16}{} that hide what is outside of them\n", "enclosures", report.enclosures);
  text += fmt::format("{:<16}{:.2f} MiB on the GPU, {} bytes an object\n", "geometry",
                      static_cast<double>(report.bytes) / (1 << 20),
                      report.objects() == 0 ? 0 : report.bytes / report.objects());
  text +=
      fmt::format("{:<16}{:.6f} mm at most, {} m from the eye (blocks reach {:.1f} m from their origins)\n",
                  "position error", 1e3 * report.positionError(kReach), kReach, report.largest_radius);
  return text;
}

}  // namespace coherency
