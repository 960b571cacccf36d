#include "bench/peers/OsgGraph.h"

#include <cstring>

#include <glm/gtc/type_ptr.hpp>
#include <osg/CullFace>
#include <osg/Geometry>
#include <osg/Program>
#include <osg/Texture2D>

#include "bench/peers/OsgShaders.h"

namespace coherency {
namespace {

osg::Vec4 vec4(const glm::vec3& v, float w = 0.0F) {
  return {v.x, v.y, v.z, w};
}

osg::ref_ptr<osg::Program> program(const std::string& vertex, const std::string& fragment) {
  osg::ref_ptr<osg::Program> made = new osg::Program;
  made->addShader(new osg::Shader(osg::Shader::VERTEX, vertex));
  made->addShader(new osg::Shader(osg::Shader::FRAGMENT, fragment));
  return made;
}

osg::ref_ptr<osg::Geometry> geometry(const auto& object, const auto* vertices,
                                     const std::vector<std::uint32_t>& all_indices, OsgBuffers buffers) {
  osg::ref_ptr<osg::Geometry> made = new osg::Geometry;
  osg::ref_ptr<osg::Vec3Array> positions = new osg::Vec3Array;
  for (std::uint32_t v = 0; v < object.vertex_count; ++v) {
    const float(&p)[3] = vertices[v].position;
    positions->push_back({p[0], p[1], p[2]});
  }
  made->setVertexArray(positions);
  const std::uint32_t* indices = &all_indices[object.range.first_index];
  if (object.vertex_count <= 65536)
    made->addPrimitiveSet(
        new osg::DrawElementsUShort(GL_TRIANGLES, indices, indices + object.range.index_count));
  else
    made->addPrimitiveSet(
        new osg::DrawElementsUInt(GL_TRIANGLES, indices, indices + object.range.index_count));
  made->setUseDisplayList(buffers == OsgBuffers::Lists);
  made->setUseVertexBufferObjects(buffers != OsgBuffers::Lists);
  made->setUseVertexArrayObject(buffers == OsgBuffers::Vao);
  return made;
}

osg::ref_ptr<osg::Group> fixedGroup(const ShaderVariant& variant) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  group->getOrCreateStateSet()->setAttributeAndModes(
      program(osgFixedVertexShader(variant), osgFragmentShader(variant)));
  return group;
}

osg::ref_ptr<osg::MatrixTransform> placed(osg::Geometry* shape, const Coord3& origin) {
  osg::ref_ptr<osg::MatrixTransform> place =
      new osg::MatrixTransform(osgMatrix(TransformMatrix::translation(origin)));
  place->setDataVariance(osg::Object::STATIC);
  place->addChild(shape);
  return place;
}

osg::ref_ptr<osg::Texture2D> lightmap(const PeerScene& scene) {
  osg::ref_ptr<osg::Image> image = new osg::Image;
  image->allocateImage(scene.lightmap_size.x, scene.lightmap_size.y, 1, GL_RGBA, GL_UNSIGNED_SHORT);
  image->setInternalTextureFormat(GL_RGBA16);
  std::memcpy(image->data(), scene.lightmap.data(), scene.lightmap.size() * sizeof(PackedLight));
  osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
  texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
  texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
  texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
  texture->setResizeNonPowerOfTwoHint(false);
  return texture;
}

}  // namespace

osg::Matrixd osgMatrix(const TransformMatrix& t) {
  return osg::Matrixd(glm::value_ptr(t.glm()));  // both keep columns together
}

OsgGraph::OsgGraph(const PeerScene& scene, OsgBuffers buffers)
    : root(new osg::Group), up_(new osg::Uniform("up", osg::Vec3())) {
  up_->setDataVariance(osg::Object::DYNAMIC);
  osg::StateSet* state = root->getOrCreateStateSet();
  state->setAttributeAndModes(new osg::CullFace(osg::CullFace::BACK));
  state->addUniform(up_);
  state->addUniform(new osg::Uniform("emission", 0.0F));
  state->addUniform(new osg::Uniform("from_above", vec4(glm::vec3(scene.ambient.sky.glm()))));
  state->addUniform(new osg::Uniform("from_below", vec4(glm::vec3(scene.ambient.ground.glm()))));
  addMoving(scene, buffers);
  addLit(scene, buffers);
  addMapped(scene, buffers);
}

void OsgGraph::addLit(const PeerScene& scene, OsgBuffers buffers) {
  osg::ref_ptr<osg::Group> group = fixedGroup({});
  for (const PeerScene::Fixed& object : scene.lit.objects) {
    const LitVertex* vertices = &scene.lit.vertices[object.range.first_vertex];
    osg::ref_ptr<osg::Geometry> shape = geometry(object, vertices, scene.lit.indices, buffers);
    osg::ref_ptr<osg::Vec4usArray> light = new osg::Vec4usArray;
    for (std::uint32_t v = 0; v < object.vertex_count; ++v) {
      const std::uint16_t(&share)[4] = vertices[v].light.share;
      light->push_back({share[0], share[1], share[2], share[3]});
    }
    light->setNormalize(true);
    shape->setColorArray(light, osg::Array::BIND_PER_VERTEX);
    group->addChild(placed(shape, object.origin));
  }
  root->addChild(group);
}

void OsgGraph::addMapped(const PeerScene& scene, OsgBuffers buffers) {
  if (scene.mapped.objects.empty()) return;
  osg::ref_ptr<osg::Group> group = fixedGroup({.light = LightSource::Lightmap});
  group->getStateSet()->setTextureAttribute(1, lightmap(scene));
  for (const PeerScene::Fixed& object : scene.mapped.objects) {
    const MappedVertex* vertices = &scene.mapped.vertices[object.range.first_vertex];
    osg::ref_ptr<osg::Geometry> shape = geometry(object, vertices, scene.mapped.indices, buffers);
    osg::ref_ptr<osg::Vec2Array> places = new osg::Vec2Array;
    osg::ref_ptr<osg::Vec4ubArray> material = new osg::Vec4ubArray;
    for (std::uint32_t v = 0; v < object.vertex_count; ++v) {
      const std::uint8_t(&share)[4] = vertices[v].material.share;
      places->push_back({vertices[v].place.u, vertices[v].place.v});
      material->push_back({share[0], share[1], share[2], share[3]});
    }
    material->setNormalize(true);
    shape->setTexCoordArray(0, places);
    shape->setColorArray(material, osg::Array::BIND_PER_VERTEX);
    group->addChild(placed(shape, object.origin));
  }
  root->addChild(group);
}

void OsgGraph::addMoving(const PeerScene& scene, OsgBuffers buffers) {
  osg::ref_ptr<osg::Group> all = new osg::Group;
  const ShaderVariant variant{LightSource::Lamps, scene.lamp_count, {}};
  all->getOrCreateStateSet()->setAttributeAndModes(
      program(osgMovingVertexShader(variant), osgFragmentShader(variant)));
  std::vector<osg::ref_ptr<osg::Group>> groups;
  for (const PeerScene::LampSet& set : scene.lamp_sets) {
    groups.push_back(lampGroup(set));
    all->addChild(groups.back());
  }
  for (const PeerScene::Moving& object : scene.moving) {
    const MeshVertex* vertices = &scene.moving_vertices[object.range.first_vertex];
    osg::ref_ptr<osg::Geometry> shape = geometry(object, vertices, scene.moving_indices, buffers);
    osg::ref_ptr<osg::Vec3Array> normals = new osg::Vec3Array;
    for (std::uint32_t v = 0; v < object.vertex_count; ++v) {
      const float(&n)[3] = vertices[v].normal;
      normals->push_back({n[0], n[1], n[2]});
    }
    shape->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
    osg::ref_ptr<osg::Vec4Array> colour = new osg::Vec4Array;
    colour->push_back(vec4(object.colour_gloss, object.colour_gloss.w));
    shape->setColorArray(colour, osg::Array::BIND_OVERALL);
    if (object.emission > 0.0F)
      shape->getOrCreateStateSet()->addUniform(new osg::Uniform("emission", object.emission));
    moving.emplace_back(new osg::MatrixTransform(osgMatrix(object.t_world_mesh)));
    moving.back()->setDataVariance(osg::Object::DYNAMIC);
    moving.back()->addChild(shape);
    groups[object.lamps]->addChild(moving.back());
  }
  root->addChild(all);
}

osg::ref_ptr<osg::Group> OsgGraph::lampGroup(const PeerScene::LampSet& set) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  osg::StateSet* state = group->getOrCreateStateSet();
  Lamps lamps{new osg::Uniform(osg::Uniform::FLOAT_VEC4, "position_reach", 4),
              new osg::Uniform(osg::Uniform::FLOAT_VEC4, "colour", 4)};
  lamps.position_reach->setDataVariance(osg::Object::DYNAMIC);  // or the optimiser makes one of all
  for (unsigned i = 0; i < 4; ++i) lamps.colour->setElement(i, vec4(set.lamps[i].colour));
  state->addUniform(lamps.position_reach);
  state->addUniform(lamps.colour);
  state->addUniform(new osg::Uniform("others", vec4(0.5F * set.others)));
  lamps_.push_back(lamps);
  return group;
}

void OsgGraph::setEye(const PeerScene& scene, const TransformMatrix& t_world_eye) {
  const TransformMatrix t_eye_world = t_world_eye.rigidInverse();
  const Coord3 up = t_eye_world.vector({0.0, 1.0, 0.0});
  up_->set(osg::Vec3(osg::Vec3d(up.x, up.y, up.z)));
  for (std::size_t s = 0; s < lamps_.size(); ++s)
    for (unsigned i = 0; i < 4; ++i) {
      const PeerScene::Lamp& lamp = scene.lamp_sets[s].lamps[i];
      lamps_[s].position_reach->setElement(
          i, vec4(glm::vec3(t_eye_world.point(lamp.position).glm()), lamp.reach));
    }
}

}  // namespace coherency
