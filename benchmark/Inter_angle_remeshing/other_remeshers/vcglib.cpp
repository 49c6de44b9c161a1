// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "remeshers.h"

#include <CGAL/Real_timer.h>

#include <vcg/complex/complex.h>

#include <vcg/complex/algorithms/clean.h>
#include <vcg/complex/algorithms/isotropic_remeshing.h>

#include <vector>

namespace {

class Vcg_vertex;
class Vcg_edge;
class Vcg_face;
struct Vcg_types : vcg::UsedTypes<vcg::Use<Vcg_vertex>::AsVertexType, vcg::Use<Vcg_edge>::AsEdgeType,
                                  vcg::Use<Vcg_face>::AsFaceType> {};
class Vcg_vertex : public vcg::Vertex<Vcg_types, vcg::vertex::Coord3d, vcg::vertex::Normal3d, vcg::vertex::VFAdj,
                                      vcg::vertex::Qualityd, vcg::vertex::BitFlags, vcg::vertex::Mark> {};
class Vcg_face : public vcg::Face<Vcg_types, vcg::face::Mark, vcg::face::VertexRef, vcg::face::VFAdj, vcg::face::FFAdj,
                                  vcg::face::Normal3d, vcg::face::Qualityd, vcg::face::BitFlags> {};
class Vcg_edge : public vcg::Edge<Vcg_types> {};
class Vcg_mesh : public vcg::tri::TriMesh<std::vector<Vcg_vertex>, std::vector<Vcg_face>, std::vector<Vcg_edge>> {};

} // namespace

Timed_soup remesh_by_vcglib(const Triangle_soup& input, double length)
{
  Vcg_mesh mesh, original;
  for (Vcg_mesh* m : {&mesh, &original}) {
    using Allocator = vcg::tri::Allocator<Vcg_mesh>;
    Allocator::AddVertices(*m, input.points.size());
    for (std::size_t i = 0; i < input.points.size(); ++i)
      m->vert[i].P() = vcg::Point3d(input.points[i][0], input.points[i][1], input.points[i][2]);
    for (const auto& t : input.triangles) Allocator::AddFace(*m, t[0], t[1], t[2]);
  }
  using Remeshing = vcg::tri::IsotropicRemeshing<Vcg_mesh>;
  Remeshing::Params parameters;
  parameters.SetTargetLen(length);
  parameters.SetFeatureAngleDeg(30);
  parameters.iter = 10;

  Timed_soup result;
  CGAL::Real_timer timer;
  timer.start();
  for (Vcg_mesh* m : {&mesh, &original}) {
    vcg::tri::UpdateNormal<Vcg_mesh>::PerVertexNormalizedPerFaceNormalized(*m);
    vcg::tri::UpdateBounding<Vcg_mesh>::Box(*m);
  }
  vcg::tri::UpdateTopology<Vcg_mesh>::FaceFace(mesh);
  parameters.maxSurfDist = original.bbox.Diag() / 100;
  Remeshing::Do(mesh, original, parameters);
  result.seconds = timer.time();

  vcg::tri::Allocator<Vcg_mesh>::CompactEveryVector(mesh);
  for (const Vcg_vertex& v : mesh.vert) result.soup.points.push_back({v.cP()[0], v.cP()[1], v.cP()[2]});
  for (const Vcg_face& f : mesh.face)
    result.soup.triangles.push_back({vcg::tri::Index(mesh, f.cV(0)), vcg::tri::Index(mesh, f.cV(1)), vcg::tri::Index(mesh, f.cV(2))});
  return result;
}
