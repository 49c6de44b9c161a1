// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_MESH_REGIONS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_MESH_REGIONS_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

// Small parts of a mesh, for passes that work on one place after the other.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Remembers which of n elements were met since the last start().
class Visit_marks
{
public:
  void start(std::size_t n)
  {
    if (mark_.size() < n) mark_.resize(n, 0);
    ++last_;
  }
  // Whether i is met for the first time.
  bool visit(std::size_t i) { return mark_[i] != last_ && (mark_[i] = last_, true); }

private:
  std::vector<unsigned> mark_;
  unsigned last_ = 0;
};

// The vertices within so many rings around `seeds`, and these, ring by ring.
inline std::vector<Remeshing_mesh::Index> ball(const Remeshing_mesh& mesh, const std::vector<Remeshing_mesh::Index>& seeds,
                                               int rings, Visit_marks& marks)
{
  using Index = Remeshing_mesh::Index;
  marks.start(mesh.number_of_vertex_slots());
  std::vector<Index> result;
  const auto add = [&](Index v) { if (marks.visit(std::size_t(v))) result.push_back(v); };
  for (const Index v : seeds) add(v);
  std::size_t begin = 0;
  for (int ring = 0; ring < rings; ++ring)
    for (const std::size_t end = result.size(); begin < end; ++begin) mesh.for_each_neighbor(result[begin], add);
  return result;
}

// The faces around these vertices, sorted.
inline std::vector<Remeshing_mesh::Index> faces_around(const Remeshing_mesh& mesh,
                                                       const std::vector<Remeshing_mesh::Index>& vertices, Visit_marks& marks)
{
  using Index = Remeshing_mesh::Index;
  marks.start(mesh.number_of_face_slots());
  std::vector<Index> result;
  for (const Index v : vertices)
    mesh.for_each_around(v, [&](Index h) { if (marks.visit(std::size_t(mesh.face(h)))) result.push_back(mesh.face(h)); });
  std::sort(result.begin(), result.end());
  return result;
}

// The faces that hang together with a face by edges for which `joins(h)` is true, from it on. `number`, by face, becomes their place among
// these; only faces whose number is negative are looked at.
template <class Joins>
std::vector<Remeshing_mesh::Index> component_of(const Remeshing_mesh& mesh, Remeshing_mesh::Index first,
                                                std::vector<Remeshing_mesh::Index>& number, const Joins& joins)
{
  using Index = Remeshing_mesh::Index;
  std::vector<Index> faces = {first};
  number[first] = 0;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (Index h = 4 * faces[i]; h < 4 * faces[i] + 3; ++h) {
      const Index o = mesh.opposite(h);
      if (o < 0 || number[o >> 2] >= 0 || !joins(h)) continue;
      number[o >> 2] = Index(faces.size());
      faces.push_back(o >> 2);
    }
  return faces;
}
// The same by any edge.
inline std::vector<Remeshing_mesh::Index> component_of(const Remeshing_mesh& mesh, Remeshing_mesh::Index first,
                                                       std::vector<Remeshing_mesh::Index>& number)
{
  return component_of(mesh, first, number, [](Remeshing_mesh::Index) { return true; });
}

// The ends of the edge of h and the vertices opposite to it.
inline std::vector<Remeshing_mesh::Index> ends_and_apexes(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  const Remeshing_mesh::Index side = h < 0 ? ~h : h, o = mesh.opposite(side);
  std::vector<Remeshing_mesh::Index> result = {mesh.origin(side), mesh.target(side), mesh.apex(side)};
  if (o >= 0) result.push_back(mesh.apex(o));
  return result;
}

// Centre, middles of the edges, and corners of a face.
constexpr double PLACES_ON_FACE[7][3] = {{1. / 3, 1. / 3, 1. / 3}, {.5, .5, 0}, {0, .5, .5}, {.5, 0, .5},
                                         {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
inline Vector3 point_on_face(const Remeshing_mesh& mesh, Remeshing_mesh::Index f, const double (&b)[3])
{
  const auto& v = mesh.face_record(f).vertex;
  return b[0] * mesh.position(v[0]) + b[1] * mesh.position(v[1]) + b[2] * mesh.position(v[2]);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_MESH_REGIONS_H
