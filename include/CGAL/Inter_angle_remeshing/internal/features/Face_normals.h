// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FACE_NORMALS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FACE_NORMALS_H

#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/cross_products.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

inline double cosine_of_degrees(double angle) { return std::cos(angle * (CGAL_PI / 180)); }

// The normals of the faces of a mesh, and the dihedral angles that they make.
class Face_normals
{
public:
  using Index = Remeshing_mesh::Index;

  explicit Face_normals(const Remeshing_mesh& mesh)
    : mesh_(mesh), normal_(mesh.number_of_face_slots()), doubled_area_(normal_.size())
  {
    const double altitude = altitude_by_rounding(mesh);
    for (Index f = 0; f < Index(normal_.size()); ++f) {
      doubled_area_[f] = float(internal::length(mesh.cross_product(f)));
      const Vector3 n = cross_product_of_surface(mesh, f, altitude);
      if (n != Vector3()) normal_[f] = internal::unit(n);
    }
    correct_folded_slivers();
  }

  const Remeshing_mesh& mesh() const { return mesh_; }

  // Unit, by face; zero where neither the face nor what it lies on has one.
  const std::vector<Vector3>& all() const { return normal_; }
  const Vector3& operator[](Index f) const { return normal_[f]; }
  void set(Index f, const Vector3& n) { normal_[f] = n; }

  const std::vector<float>& doubled_areas() const { return doubled_area_; }
  double doubled_area(Index f) const { return doubled_area_[f]; }

  // The cosine of the dihedral angle; 1 on the border and beside faces without a normal.
  double cosine(Index h) const
  {
    const Index o = mesh_.opposite(h);
    if (o < 0) return 1;
    const Vector3 &m = normal_[h >> 2], &n = normal_[o >> 2];
    return m == Vector3() || n == Vector3() ? 1. : dot(m, n);
  }
  // In degrees.
  double angle(Index h) const { return std::acos((std::max)(-1., (std::min)(1., cosine(h)))) * (180 / CGAL_PI); }

  // The same, less than 0 in a groove.
  double turn(Index h) const
  {
    return is_groove(mesh_, h, normal_[h >> 2], normal_[mesh_.opposite(h) >> 2]) ? -angle(h) : angle(h);
  }

  // Whether the face of h goes on in its plane over the edge of h.
  bool is_planar_at(Index h) const { return mesh_.opposite(h) >= 0 && cosine(h) > planar_cosine_; }
  // Whether these faces lie in planes of the same direction.
  bool are_parallel(Index f, Index g) const { return dot(normal_[f], normal_[g]) > planar_cosine_; }

  // Whether face f is not the only one in its plane.
  bool is_in_polygon(Index f) const { return is_planar_at(4 * f) || is_planar_at(4 * f + 1) || is_planar_at(4 * f + 2); }
  // The part of the area of such faces.
  double planar_share() const
  {
    double all = 0, of_polygons = 0;
    for (Index f = 0; f < Index(doubled_area_.size()); ++f) {
      all += doubled_area_[f];
      if (is_in_polygon(f)) of_polygons += doubled_area_[f];
    }
    return all > 0 ? of_polygons / all : 0.;
  }

private:
  static constexpr double PLANAR_ANGLE = 0.5, FOLD_ANGLE = 150;    // degrees
  static constexpr double SLIVER = 0.1;                            // altitude of a sliver, at most, over its longest edge
  // A sheet goes on beyond a thin face, by less than this angle, in degrees; it is one of more than so many faces, however small.
  static constexpr double SHEET_ANGLE = 40;
  static constexpr std::size_t LARGEST_SLIVER = 64;

  // Slivers that are folded onto a neighbor look as that one does.
  void correct_folded_slivers()
  {
    std::vector<std::pair<Index, Vector3>> corrected;
    for (Index f = 0; f < Index(normal_.size()); ++f)
      if (const Index h = longest_edge(mesh_, f); is_folded_sliver(f, h)) {
        const Index o = mesh_.opposite(h);
        corrected.emplace_back(f, o < 0 || is_folded_sliver(o >> 2, longest_edge(mesh_, o >> 2)) ? Vector3() : normal_[o >> 2]);
      }
    for (const auto& [f, n] : corrected) normal_[f] = n;
  }

  // Whether face f, of which h is the longest edge, is thin and lies on a neighbor: where it looks says nothing about the surface.
  bool is_folded_sliver(Index f, Index h) const
  {
    if (doubled_area_[f] > SLIVER * mesh_.squared_edge_length(h)) return false;
    const double folded = cosine_of_degrees(FOLD_ANGLE);
    return (cosine(4 * f) < folded || cosine(4 * f + 1) < folded || cosine(4 * f + 2) < folded) && !is_in_sheet(f);
  }

  // Whether face f and those that it goes on to are more than a sliver together: the side of a knife's edge.
  bool is_in_sheet(Index f) const
  {
    const double flat = cosine_of_degrees(SHEET_ANGLE);
    std::vector<Index> faces{f};
    double doubled_area = 0, longest = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      doubled_area += doubled_area_[faces[i]];
      longest = (std::max)(longest, mesh_.squared_edge_length(longest_edge(mesh_, faces[i])));
      if (doubled_area > SLIVER * longest || i == LARGEST_SLIVER) return true;
      for (Index h = 4 * faces[i]; h < 4 * faces[i] + 3; ++h)
        if (const Index o = mesh_.opposite(h); o >= 0 && normal_[o >> 2] != Vector3() && cosine(h) > flat &&
                                               std::find(faces.begin(), faces.end(), o >> 2) == faces.end())
          faces.push_back(o >> 2);
    }
    return false;
  }

  const Remeshing_mesh& mesh_;
  const double planar_cosine_ = cosine_of_degrees(PLANAR_ANGLE);
  std::vector<Vector3> normal_;
  std::vector<float> doubled_area_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_FACE_NORMALS_H
