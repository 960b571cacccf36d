#pragma once

#include <string>
#include <vector>

#include <osg/Group>
#include <osg/MatrixTransform>
#include <osg/Uniform>

#include "bench/peers/PeerScene.h"

namespace coherency {

/// How OpenSceneGraph keeps its vertices.
enum class OsgBuffers { Vbo, Vao, Lists };

/// A scene as a user of OpenSceneGraph would build it: a MatrixTransform in double and a Geometry for each
/// object, states shared as far as they can be.
struct OsgGraph {
  OsgGraph(const PeerScene& scene, OsgBuffers buffers);

  /// Lamps and the vertical are given in the eye's axes, as OpenGL's own lamps are.
  void setEye(const PeerScene& scene, const TransformMatrix& t_world_eye);

  osg::ref_ptr<osg::Group> root;
  std::vector<osg::ref_ptr<osg::MatrixTransform>> moving;  ///< in the scene's order

 private:
  struct Lamps {
    osg::ref_ptr<osg::Uniform> position_reach;
    osg::ref_ptr<osg::Uniform> colour;
  };

  void addLit(const PeerScene& scene, OsgBuffers buffers);
  void addMapped(const PeerScene& scene, OsgBuffers buffers);
  void addMoving(const PeerScene& scene, OsgBuffers buffers);
  osg::ref_ptr<osg::Group> lampGroup(const PeerScene::LampSet& set);

  osg::ref_ptr<osg::Uniform> up_;
  std::vector<Lamps> lamps_;
};

osg::Matrixd osgMatrix(const TransformMatrix& t);

}  // namespace coherency
