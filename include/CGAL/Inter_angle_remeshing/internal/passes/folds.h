// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FOLDS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FOLDS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/mesh_regions.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/angle_bands.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/place_on_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/projection.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Faces that fold over their neighbors where the surface does not.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A face folds over its neighbor if the cosine between their normals is less; each tenth less counts as two degrees.
constexpr double FOLD_COSINE = -0.5, DEGREES_OF_FOLD = 20;
// Smallest cosine between the normals of a face and of the surface, or of its facet, under its centre: 60 degrees.
constexpr double LEAVING_COSINE = 0.5;

// Whether face f turns away from the surface. Beside a sharp crease of the surface neither of two faces does.
inline bool leaves_surface(const Remeshing_context& context, Remeshing_mesh::Index f)
{
  if (!context.projector.has_faces()) return true;
  const Remeshing_mesh& mesh = context.mesh;
  const auto& v = mesh.face_record(f).vertex;
  const Vector3 centre = (1. / 3) * (mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2]));
  const Place_on_surface nearest = place_on_surface(context, f, centre);
  const auto turns_away_from = [&, own = mesh.cross_product(f)](const Vector3& normal) {
    return !is_cosine_at_least(normal, own, LEAVING_COSINE);
  };
  return turns_away_from(context.projector.cross_product(nearest.facet)) &&
         turns_away_from(context.projector.normal_at(nearest.facet, nearest.point));
}

// By how much face f folds over one of its neighbors, in degrees, if by more than `known`, which is not negative; that, else.
// `leaves(face)` is leaves_surface().
template <class Leaves>
double fold_violation(const Remeshing_mesh& mesh, Remeshing_mesh::Index f, Leaves& leaves, double known)
{
  using Index = Remeshing_mesh::Index;
  const Vector3 n = mesh.cross_product(f);
  double result = known, least = FOLD_COSINE - known / DEGREES_OF_FOLD;
  for (Index h = 4 * f; h < 4 * f + 3; ++h) {
    if (mesh.is_on_curve_edge(h)) continue;
    const Index g = mesh.face(mesh.opposite(h));
    const Vector3 m = mesh.cross_product(g);
    const double product = dot(n, m);
    if (product >= 0) continue;
    const double cosine = product / std::sqrt(squared_length(n) * squared_length(m));
    if (!(cosine < least && (leaves(f) || leaves(g)))) continue;
    least = cosine;
    result = DEGREES_OF_FOLD * (FOLD_COSINE - least);
  }
  return result;
}

inline double fold_violation(const Remeshing_context& context, Remeshing_mesh::Index f, double known = 0)
{
  const auto leaves = [&](Remeshing_mesh::Index g) { return leaves_surface(context, g); };
  return fold_violation(context.mesh, f, leaves, known);
}

// What leaves_surface() says, each face asked for once.
class Leaving_faces
{
public:
  explicit Leaving_faces(const Remeshing_context& context)
    : context_(context)
  {}

  // The mesh has changed.
  void start()
  {
    known_.start(context_.mesh.number_of_face_slots());
    if (leaves_.size() < context_.mesh.number_of_face_slots()) leaves_.resize(context_.mesh.number_of_face_slots());
  }
  bool operator()(Remeshing_mesh::Index f)
  {
    if (known_.visit(std::size_t(f))) leaves_[f] = leaves_surface(context_, f);
    return leaves_[f] != 0;
  }

private:
  const Remeshing_context& context_;
  Visit_marks known_;
  std::vector<char> leaves_;
};

// How far face f is out of its band, or folded, in degrees; not positive where it is neither.
template <class Leaves>
double violation(const Remeshing_mesh& mesh, const Angle_bands& bands, Remeshing_mesh::Index f, Leaves& leaves)
{
  return fold_violation(mesh, f, leaves, angle_violation(mesh, bands, f));
}
inline double violation(const Remeshing_context& context, const Angle_bands& bands, Remeshing_mesh::Index f)
{
  return fold_violation(context, f, angle_violation(context.mesh, bands, f));
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FOLDS_H
