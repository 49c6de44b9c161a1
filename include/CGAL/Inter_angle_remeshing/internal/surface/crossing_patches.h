// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_CROSSING_PATCHES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_CROSSING_PATCHES_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Bounding_box.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Corner_table.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/crossing_faces.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

// Where a smooth surface over the faces of another one crosses itself, though these do not: it bulges, and what is close by, another
// sheet or another part, may lie within the bulge.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// For Crossing_finder: whether the patches over two faces that have no vertex in common cross each other. `Patches` has
// reference_surface(), point(f, b) for barycentric coordinates b, and height(f), how far at most that is from the face.
template <class Patches>
class Crossing_of_patches
{
  using Index = Corner_table::Index;
  using Triangle = std::array<Vector3, 3>;
  // What stands for a patch, and a box around it.
  struct Facets
  {
    std::vector<Triangle> triangles;
    Bounding_box box;
  };

  // Patches keep their distance: those that bulge so many times as much do not cross either.
  static constexpr double BULGE = 1.25;
  static constexpr int PARTS = 3;        // of each edge of a patch

public:
  explicit Crossing_of_patches(const Patches& patches)
    : patches_(patches)
  {}

  // How far a patch may lie beyond the box of its face.
  double growth(Index f) const { return BULGE * patches_.height(f); }

  bool operator()(Index f, Index g) const
  {
    const auto& surface = patches_.reference_surface();
    const double reach = growth(f) + growth(g);
    if (!(reach > 0) || number_of_shared_vertices(surface, f, g) > 0 || is_beyond(f, g, reach) || is_beyond(g, f, reach)) return false;
    const Facets a = facets(f), b = facets(g);
    return std::any_of(a.triangles.begin(), a.triangles.end(), [&](const Triangle& s) {
      return do_overlap(box_of(s), b.box) && std::any_of(b.triangles.begin(), b.triangles.end(), [&](const Triangle& t) {
        return do_cross(s, t); }); }) && !cross_each_other(surface, f, g);
  }

private:
  // Whether the corners of f are farther than this from the plane of g, on one side of it.
  bool is_beyond(Index f, Index g, double distance) const
  {
    const auto& surface = patches_.reference_surface();
    const Vector3& normal = surface.cross_product(g);
    const auto &a = surface.face_record(f).vertex, &b = surface.face_record(g).vertex;
    const double bound = distance * length(normal);
    const auto height = [&](Index v) { return dot(surface.position(v) - surface.position(b[0]), normal); };
    return std::all_of(a, a + 3, [&](Index v) { return height(v) > bound; }) ||
           std::all_of(a, a + 3, [&](Index v) { return height(v) < -bound; });
  }

  // Of the patch over f that bulges more.
  Facets facets(Index f) const
  {
    const auto& surface = patches_.reference_surface();
    const auto& v = surface.face_record(f).vertex;
    const Vector3 &p = surface.position(v[0]), &q = surface.position(v[1]), &r = surface.position(v[2]);
    if (!(growth(f) > 0)) return {{{p, q, r}}, Bounding_box(p, q, r)};
    const auto at = [&](int i, int j) {
      const double b = double(i) / PARTS, c = double(j) / PARTS, a = 1 - b - c;
      const Vector3 flat = a * p + b * q + c * r;
      return flat + BULGE * (patches_.point(f, {a, b, c}) - flat);
    };
    Facets result;
    result.triangles.reserve(PARTS * PARTS);
    for (int i = 0; i < PARTS; ++i)
      for (int j = 0; i + j < PARTS; ++j) {
        result.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 1 < PARTS) result.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    for (const Triangle& t : result.triangles) result.box += box_of(t);
    return result;
  }

  static Bounding_box box_of(const Triangle& t) { return {t[0], t[1], t[2]}; }

  static bool do_cross(const Triangle& a, const Triangle& b)
  {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    if (!do_overlap(box_of(a), box_of(b))) return false;
    const auto triangle = [](const Triangle& t) {
      return Kernel::Triangle_3({t[0].x, t[0].y, t[0].z}, {t[1].x, t[1].y, t[1].z}, {t[2].x, t[2].y, t[2].z}); };
    const Kernel::Triangle_3 s = triangle(a), t = triangle(b);
    return !s.is_degenerate() && !t.is_degenerate() && CGAL::do_intersect(s, t);
  }

  const Patches& patches_;
};

// The pairs of faces whose patches cross each other, the faces do not.
template <class Patches>
std::vector<std::pair<Corner_table::Index, Corner_table::Index>> crossing_patches(const Patches& patches)
{
  return crossing_faces<CGAL::Sequential_tag>(patches.reference_surface(), Crossing_of_patches<Patches>(patches));
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_CROSSING_PATCHES_H
