// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_CAD_PARTS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_CAD_PARTS_H

#include <CGAL/Inter_angle_remeshing/internal/features/Feature_detector.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/cross_products.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/mesh_regions.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

// A scene may hold a machine part beside something that has grown: all in all no CAD model, and the part's few edges go under among the
// others. Each of its components that is one on its own keeps its features, and its facets; one with smooth curves the former, and one with
// uneven facets the latter.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

struct Features_with_parts
{
  std::vector<Remeshing_mesh::Index> edges;      // one half-edge of each feature
  std::vector<Remeshing_mesh::Index> faces;      // of the components that are CAD models or uneven facets, where the mesh is neither
};

// Whether a part is large enough to be a CAD model on its own: a cube of less than twice the target length is a few faces, sharp or not.
inline bool is_large_part(const Remeshing_mesh& part, double target_length)
{
  constexpr double LEAST_AREA = 24;                // in squares of the target length
  return area(part) >= LEAST_AREA * target_length * target_length;
}

class Cad_parts
{
public:
  using Index = Remeshing_mesh::Index;

  explicit Cad_parts(const Remeshing_mesh& mesh)
    : mesh_(mesh), face_in_part_(mesh.number_of_face_slots(), -1), vertex_in_part_(mesh.number_of_vertex_slots(), -1)
  {}

  // Those of the components that are CAD models, or have smooth curves, or uneven facets, and are large enough; none where all faces hang
  // together.
  // `find(detector, lengths)` tells the features of one, the target lengths by face being `lengths`; details shorter than `length` or
  // than the edges of the component are none.
  template <class Find>
  Features_with_parts find(double length, const std::vector<double>& lengths, const Find& find)
  {
    Features_with_parts result;
    for (Index first = 0; first < Index(face_in_part_.size()); ++first) {
      if (face_in_part_[first] >= 0) continue;
      const std::vector<Index> faces = component_of(mesh_, first, face_in_part_);
      if (faces.size() == face_in_part_.size()) return {};
      const Remeshing_mesh part = mesh_of(faces);
      std::vector<double> lengths_in_part;
      for (const Index f : faces) lengths_in_part.push_back(lengths[f]);
      if (!is_large_part(part, *std::max_element(lengths_in_part.begin(), lengths_in_part.end()))) continue;
      Feature_detector detector(part, length);
      const Model_kind& kind = detector.kind();
      if (kind.is_cad() || kind.has_uneven_facets()) result.faces.insert(result.faces.end(), faces.begin(), faces.end());
      if (!kind.is_cad() && kind.smooth_curves().empty()) continue;
      for (const Index h : find(detector, lengths_in_part)) result.edges.push_back(4 * faces[h >> 2] + (h & 3));
    }
    return result;
  }

private:
  Index in_part(Index h) const { return 4 * face_in_part_[h >> 2] + (h & 3); }

  Remeshing_mesh mesh_of(const std::vector<Index>& faces)
  {
    Remeshing_mesh part;
    part.set_unit(mesh_.unit());
    part.resize_faces(faces.size());
    std::size_t vertices = 0;
    for (const Index f : faces) {
      part.face_record(face_in_part_[f]).source = face_in_part_[f];
      for (Index h = 4 * f; h < 4 * f + 3; ++h) {
        const Index v = mesh_.origin(h), o = mesh_.opposite(h);
        part.glue(in_part(h), o < 0 ? ~in_part(h) : in_part(o));
        if (vertex_in_part_[v] < 0) {
          vertex_in_part_[v] = Index(vertices++);
          part.resize_vertices(vertices);
          const Index u = vertex_in_part_[v];
          part.position(u) = mesh_.position(v);
          part.set_first(u, in_part(mesh_.first(v)));
          part.set_valence(u, mesh_.valence(v));
          part.add_marks(u, mesh_.marks(v));
        }
        part.set_origin(in_part(h), vertex_in_part_[v]);
      }
    }
    return part;
  }

  const Remeshing_mesh& mesh_;
  std::vector<Index> face_in_part_, vertex_in_part_;     // by face, by vertex: its number in its component; -1: not looked at yet
};

// What `find(detector, lengths)` finds in the mesh of the detector, and, where that is no CAD model, in each of its components that is
// one, or has smooth curves, alone, beside the former; the edges are sorted.
template <class Find>
Features_with_parts features_with_parts(const Remeshing_mesh& mesh, Feature_detector& detector, double length,
                                        const std::vector<double>& lengths, const Find& find)
{
  using Index = Remeshing_mesh::Index;
  std::vector<Index> edges = find(detector, lengths);
  Features_with_parts result;
  if (!detector.kind().is_cad()) result = Cad_parts(mesh).find(length, lengths, find);
  result.edges.insert(result.edges.end(), edges.begin(), edges.end());
  for (Index& h : result.edges) h = (std::min)(h, mesh.opposite(h));
  std::sort(result.edges.begin(), result.edges.end());
  result.edges.erase(std::unique(result.edges.begin(), result.edges.end()), result.edges.end());
  return result;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_CAD_PARTS_H
