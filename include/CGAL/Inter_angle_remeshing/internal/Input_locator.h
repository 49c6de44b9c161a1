// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_INPUT_LOCATOR_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_INPUT_LOCATOR_H

#include <CGAL/Inter_angle_remeshing/internal/Mls_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/Reference_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/projection.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

// Where on the input a point of the result is.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A point of the input: the number of a face, and the barycentric coordinates on it.
struct Input_place
{
  Remeshing_mesh::Index source;
  std::array<double, 3> coordinates;
};

// Walks from where the projector left a vertex, if the projector's faces are those of the input; else it has to search.
class Input_locator
{
  using Index = Remeshing_mesh::Index;

public:
  // The mesh still is the input.
  Input_locator(const Projection& projection, const Remeshing_mesh& mesh)
  {
    if (projection.face_of_source == nullptr) {
      copy_ = std::make_unique<Reference_surface>(mesh);
      surface_ = copy_.get();
      return;
    }
    surface_ = projection.surface;
    factor_ = projection.factor;
    face_of_source_ = projection.face_of_source;
  }

  Input_place place_of_vertex(const Remeshing_mesh& mesh, Index v) const { return place(mesh.position(v), mesh.hint(v)); }
  // Of the centroid of face f, in the patch of the face that it descends from.
  Input_place place_of_face(const Remeshing_mesh& mesh, Index f) const
  {
    const auto& record = mesh.face_record(f);
    Vector3 centroid;
    for (const Index v : record.vertex) centroid += (1. / 3) * mesh.position(v);
    return place(centroid, face_of_source_ == nullptr ? 0 : (*face_of_source_)[record.source]);
  }

private:
  Input_place place(const Vector3& p, Index f) const
  {
    Point_on_triangle closest;
    if (copy_ != nullptr) {
      copy_->locate(p, f);
      closest = closest_point_on_face(*copy_, p, f);
    } else
      closest = surface_->closest_point_near(factor_ * p, f);
    const auto& v = surface_->face_record(f).vertex;
    std::array<double, 3> b = barycentric(closest, surface_->position(v[0]), surface_->position(v[1]), surface_->position(v[2]));
    for (double& x : b) x = (std::max)(0., x);       // on needles they may be off by rounding
    const double sum = b[0] + b[1] + b[2];
    for (double& x : b) x /= sum;
    return {surface_->face_record(f).source, b};
  }

  const Reference_surface* surface_ = nullptr;
  double factor_ = 1;                                   // from the mesh's units to the surface's
  const std::vector<Index>* face_of_source_ = nullptr;  // the projector's
  std::unique_ptr<const Reference_surface> copy_;       // of the input, where the projector knows another surface, or none
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_INPUT_LOCATOR_H
