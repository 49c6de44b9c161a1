// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_H

#include <CGAL/Inter_angle_remeshing/internal/Mls_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/Reference_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/projection.h>
#include <CGAL/Inter_angle_remeshing/internal/refuse.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// A target length that varies over the surface.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// What a sizing field, or a function of the position, says about the length; refused where that is none.
inline double checked_length(double length, const Vector3& place)
{
  if (!(length > 0) || !std::isfinite(length))
    refuse(REMESHING, "the sizing field is " + std::to_string(length) + " at (" + std::to_string(place.x) + ", " +
                      std::to_string(place.y) + ", " + std::to_string(place.z) + "); it must be finite and positive");
  return length;
}

// The lengths are given as parts of the length of reference, with which uniform triangles over the range would be as many
// as with the field. The field is linear on the input's faces, or a function of the position.
class Sizing
{
  using Index = Remeshing_mesh::Index;
  using Function = std::function<double(const Vector3&)>;

public:
  // Uniform.
  Sizing() = default;
  // `lengths` by input vertex, in the units of the mesh, which is the input; the function is in the user's.
  Sizing(const Remeshing_mesh& mesh, const std::vector<double>& lengths, Function function)
    : function_(std::move(function)), unit_(mesh.unit())
  {
    double area = 0, count = 0;
    parts_.resize(mesh.number_of_face_slots());
    for (Index f = 0; f < Index(mesh.number_of_face_slots()); ++f) {
      const auto& t = mesh.face_record(f);
      std::array<double, 3> corner;
      for (int k = 0; k < 3; ++k) corner[k] = lengths[mesh.input(t.vertex[k])];
      const double doubled_area =
        length(triangle_cross(mesh.position(t.vertex[0]), mesh.position(t.vertex[1]), mesh.position(t.vertex[2])));
      area += doubled_area;
      for (int k = 0; k < 3; ++k) {      // the rule of the midpoints
        const double l = 0.5 * (corner[k] + corner[(k + 1) % 3]);
        count += doubled_area / (3 * l * l);
        parts_[t.source][k] = float(corner[k]);
      }
    }
    reference_length_ = count > 0 ? std::sqrt(area / count) : lengths.front();
    for (auto& corners : parts_)
      for (float& part : corners) part = float(double(part) / reference_length_);
  }

  bool is_uniform() const { return parts_.empty(); }
  double reference_length() const { return reference_length_; }

  // The mean over the input's face `source`.
  double part_of_face(Index source) const
  {
    return is_uniform() ? 1. : (double(parts_[source][0]) + double(parts_[source][1]) + double(parts_[source][2])) / 3;
  }

  // Looks vertices up on the projector's surface, if its faces are those of the input, which the mesh still is.
  void attach(const Projection& projection, const Remeshing_mesh& mesh)
  {
    if (is_uniform() || function_) return;
    if (projection.face_of_source == nullptr) {
      input_ = std::make_shared<Reference_surface>(mesh);
      return;
    }
    surface_ = projection.surface;
    factor_ = projection.factor;
    source_.assign(surface_->number_of_faces(), 0);
    for (Index s = 0; s < Index(parts_.size()); ++s) source_[projection.face_of(s)] = s;
  }

  // At vertex v of the mesh.
  double part_at(const Remeshing_mesh& mesh, Index v) const
  {
    const Vector3& p = mesh.position(v);
    if (function_) {
      const Vector3 place = unit_ * p;
      return checked_length(function_(place), place) / (unit_ * reference_length_);
    }
    Index f = mesh.hint(v);
    if (surface_ != nullptr) {
      const Point_on_triangle c = surface_->closest_point_near(factor_ * p, f);
      return on_face(*surface_, f, source_[f], c);
    }
    input_->locate(p, f);
    return on_face(*input_, f, input_->face_record(f).source, closest_point_on_face(*input_, p, f));
  }

private:
  double on_face(const Reference_surface& surface, Index f, Index source, const Point_on_triangle& place) const
  {
    const auto& v = surface.face_record(f).vertex;
    const std::array<double, 3> b = barycentric(place, surface.position(v[0]), surface.position(v[1]), surface.position(v[2]));
    const auto& part = parts_[source];
    return b[0] * double(part[0]) + b[1] * double(part[1]) + b[2] * double(part[2]);
  }

  std::vector<std::array<float, 3>> parts_;           // by input face, at its corners
  Function function_;
  double reference_length_ = 0, unit_ = 1;
  const Reference_surface* surface_ = nullptr;        // the projector's, a copy of the input
  double factor_ = 1;                                 // from the mesh's units to the surface's
  std::vector<Index> source_;                         // the input's faces by those of the surface
  std::shared_ptr<const Reference_surface> input_;    // where the projector knows another surface, or none
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_H
