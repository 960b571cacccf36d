#pragma once

#include <deque>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "render_client/cull/DetailChoice.h"
#include "render_client/cull/Enclosures.h"
#include "render_client/cull/ViewPyramid.h"
#include "render_client/draw/DrawCommands.h"
#include "render_client/draw/EyeView.h"
#include "render_client/draw/GlObjects.h"
#include "render_client/draw/SceneBuffers.h"
#include "render_client/draw/ShaderSources.h"
#include "render_client/draw/StreamBuffer.h"
#include "render_client/draw/WorldBox.h"

namespace coherency {

/// Shadows of what moves, as under a wide lamp overhead, a little to one side (kShadowLean): they show how
/// high above a table a hand is. A map of heights as seen along that light, 3.2 m wide on the floor and up to
/// 4 m above it, that goes with the vehicle one drives, in steps of its texels, so that shadows neither crawl
/// nor jump; they fade towards its border. Where the scene's other vehicle is in view and stands beyond it, a
/// second tile of the same texture, if it has one, goes with that. Both see the same things along the same
/// light on the same lattice, so that it makes no difference from which of them a pixel has its shadow. A
/// tile in which nothing has moved is not drawn anew. Only what moves casts; what it casts on may move or
/// not.
class OverheadShadow {
 public:
  /// Throws std::runtime_error where the driver has no such resolution.
  static void check(const ShadowMapSize& size);
  /// Throws what check() throws. `moving_count`: of drawables.
  OverheadShadow(const ShadowMapSize& size, std::size_t moving_count);

  /// For the vehicles of a view. What casts is as coarse as it is drawn: it would be in the shadow of its own
  /// finer form.
  void update(const CompiledScene& scene, const EyeView& view, const ViewPyramids& views,
              const Enclosures& enclosures, const DetailChoice& detail);
  /// Draws the map, as last updated for.
  void draw(const CompiledScene& scene, const SceneBuffers& buffers);

  /// After update(): whether what never moves and is in the box may be in a shadow.
  bool reaches(const WorldBox& box) const;
  /// After update(): takes points in the world's axes from `eye` to the first tile: across it -1..1 twice,
  /// and height 0..1.
  glm::mat4 mappingFrom(const Coord3& eye) const;
  /// After update(): to be added to the same for the second tile; out of all tiles where there is none.
  glm::vec3 toSecondTile() const;
  /// What it takes, in words.
  std::string explain() const;
  void bindTexture() const { glBindTextureUnit(0, depth_.name()); }

 private:
  struct Caster {
    const Drawable* drawable;
    IndexRange range;
    bool operator==(const Caster&) const = default;
  };
  struct Casters {
    std::vector<Caster> drawables;
    std::vector<glm::mat4> map_from_mesh;
    bool operator==(const Casters&) const = default;
  };
  struct Tile {
    explicit Tile(std::size_t moving_count);
    void place(const Coord3& middle, double texel);
    WorldBox region() const;
    void add(const CompiledScene& scene, const Drawable& drawable, const IndexRange& range);

    Coord3 floor_middle;
    Coord3 map_middle;  ///< where what mappingFrom() gives is 0
    DrawCommands commands;
    StreamBuffer matrices;
    Casters casters;
    Casters drawn;  ///< what is in the texture
  };

  void placeTiles(const EyeView& view, const ViewPyramids& views);
  void chooseCasters(const CompiledScene& scene, const Enclosures& enclosures, const DetailChoice& detail);
  void drawTile(std::size_t number, const CompiledScene& scene);

  int resolution_;  ///< texels a side of a tile
  Texture depth_;
  Framebuffer frame_;
  Program program_;
  std::deque<Tile> tiles_;
  std::size_t tile_count_ = 1;  ///< in this frame
  struct Shading {
    WorldBox box;
    const Enclosures::Room* room;  ///< beyond whose walls it casts nothing; null where it is in none
  };
  std::vector<Shading> shading_;  ///< what casts into a tile
};

}  // namespace coherency
