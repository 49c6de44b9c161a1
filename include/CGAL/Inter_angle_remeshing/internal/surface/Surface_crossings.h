// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_SURFACE_CROSSINGS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_SURFACE_CROSSINGS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/Point_grid.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/closest_point_on_triangle.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/crossing_faces.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/surface_walk.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The faces of these pairs, each once, in order.
inline std::vector<Remeshing_mesh::Index> faces_of(const std::vector<std::pair<Remeshing_mesh::Index, Remeshing_mesh::Index>>& pairs)
{
  std::vector<Remeshing_mesh::Index> result;
  for (const auto& [f, g] : pairs) result.insert(result.end(), {f, g});
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// Where the surface crosses itself: a mesh of it may, too. Corners of its faces that do, and points of large ones near the crossing, in units
// of the mesh.
class Surface_crossings
{
  using Index = Remeshing_mesh::Index;

  // Where the surface crosses itself within so many target lengths, or edges of its own, faces may cross. Places that are this near
  // to each other, of which a surface finer than the target has any number, are one.
  static constexpr double SAME_PLACE = 1.5, ONE_PLACE = 0.1;
  // What a surface whose edges are shorter than the target by this factor crosses is small.
  static constexpr double COARSE = 1.5;

public:
  // Nowhere if there is noise: it makes faces cross each other, but what is under it does not cross itself.
  template <class ConcurrencyTag>
  static Surface_crossings find(const Remeshing_context& context)
  {
    if (!context.projector.has_faces() || context.noise > 0) return Surface_crossings(context, 0);
    const Reference_surface& surface = *context.projector.surface;
    const double factor = context.projector.factor;
    double sum = 0;
    for (Index f = 0; f < Index(surface.number_of_faces()); ++f) sum += mean_edge_length(surface, f);
    Surface_crossings result(context, sum / (double(surface.number_of_faces()) * factor));
    const std::vector<std::pair<Index, Index>> pairs = crossing_faces<ConcurrencyTag>(surface);
    const auto add = [&](const Vector3& on_surface) {
      const Vector3 p = (1 / factor) * on_surface;
      if (!result.places_.has_near(p, ONE_PLACE * context.target_length)) result.places_.insert(p);
    };
    for (const Index f : faces_of(pairs))
      for (const Index v : surface.face_record(f).vertex) add(surface.position(v));
    for (const auto& [f, g] : pairs)
      for (const auto& [face, other] : {std::pair(f, g), std::pair(g, f)})
        for_each_place_between_corners(surface, face, other, factor * result.edge_length_, add);
    return result;
  }

  // Whether the surface crosses itself near face f of the mesh.
  bool are_near(const Remeshing_context& context, Index f) const
  {
    const auto& v = context.mesh.face_record(f).vertex;
    return std::any_of(v, v + 3, [&](Index u) { return are_near_vertex(context, u); });
  }
  bool are_near_vertex(const Remeshing_context& context, Index v) const
  {
    return places_.has_near(context.mesh.position(v), SAME_PLACE * (std::max)(edge_length_, context.length_at(v)));
  }

  // Beside edges of the target length.
  bool are_small(double target_length) const { return target_length >= COARSE * edge_length_; }

private:
  Surface_crossings(const Remeshing_context& context, double edge_length)
    : places_(SAME_PLACE * (std::max)(edge_length, context.largest_length())), edge_length_(edge_length)
  {}

  // Calls `add(point)` for points of a face that is large beside `spacing`, about so far from each other, which are as near to the other
  // face.
  template <class Add>
  static void for_each_place_between_corners(const Reference_surface& surface, Index face, Index other, double spacing, const Add& add)
  {
    constexpr double LARGE = 2;
    constexpr int MOST_PARTS = 64;                   // of an edge
    const auto &v = surface.face_record(face).vertex, &w = surface.face_record(other).vertex;
    const Vector3 &a = surface.position(v[0]), &b = surface.position(v[1]), &c = surface.position(v[2]);
    const double longest = std::sqrt((std::max)({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)}));
    if (!(longest > LARGE * spacing)) return;
    const int parts = longest < MOST_PARTS * spacing ? int(std::ceil(longest / spacing)) : MOST_PARTS;
    for (int i = 0; i <= parts; ++i)
      for (int j = 0; i + j <= parts; ++j) {
        const Vector3 p = a + (double(i) / parts) * (b - a) + (double(j) / parts) * (c - a);
        const Vector3 q = closest_point_on_triangle(p, surface.position(w[0]), surface.position(w[1]), surface.position(w[2])).point;
        if (squared_distance(p, q) <= spacing * spacing) add(p);
      }
  }

  Point_grid places_;
  double edge_length_;                   // the mean of the surface: what is bent over its faces crosses that far elsewhere
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_SURFACE_CROSSINGS_H
