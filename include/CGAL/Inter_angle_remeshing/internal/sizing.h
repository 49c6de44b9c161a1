// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_H

#include <CGAL/Inter_angle_remeshing/internal/Input_locator.h>
#include <CGAL/Inter_angle_remeshing/internal/refuse.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
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
    refuse(REMESHING, "the sizing field is " + to_text(length) + " at (" + to_text(place.x) + ", " +
                      to_text(place.y) + ", " + to_text(place.z) + "); it must be finite and positive");
  return length;
}

// No length needs to be longer, in units of lengths: the extent of the flat mesh is under 1.
constexpr double LONGEST_LENGTH = 4;
// More faces cannot be indexed.
constexpr double MAXIMUM_NUMBER_OF_FACES = double((std::numeric_limits<Remeshing_mesh::Index>::max)() / 4) / 1.5;

[[noreturn]] inline void refuse_too_small_field()
{
  refuse(REMESHING, "the sizing field is so small that more than " + to_text(MAXIMUM_NUMBER_OF_FACES) +
                    " faces were needed, which cannot be indexed");
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
  // `lengths` by vertex of the mesh, which is the input, in units of `length_unit`; the function is in the user's.
  Sizing(const Remeshing_mesh& mesh, const std::vector<double>& lengths, double length_unit, Function function)
    : function_(std::move(function)), unit_(mesh.unit()), length_unit_(length_unit)
  {
    double area = 0, count = 0;
    parts_.resize(mesh.number_of_face_slots());
    for (Index f = 0; f < Index(mesh.number_of_face_slots()); ++f) {
      const auto& t = mesh.face_record(f);
      std::array<double, 3> corner;
      for (int k = 0; k < 3; ++k) corner[k] = lengths[mesh.input(t.vertex[k])];
      const double doubled_area = length(mesh.cross_product(f));
      area += doubled_area;
      for (int k = 0; k < 3; ++k) {      // the rule of the midpoints
        const double l = 0.5 * (corner[k] + corner[(k + 1) % 3]);
        count += doubled_area / (3 * l * l);
        parts_[t.source][k] = float(corner[k]);
      }
    }
    reference_length_ = count > 0 ? std::sqrt(area / count) : lengths.front();
    if (!(reference_length_ > 0)) refuse_too_small_field();
    for (auto& corners : parts_)
      for (float& part : corners) part = float(double(part) / reference_length_);
  }

  bool is_uniform() const { return parts_.empty(); }
  // In units of lengths.
  double reference_length() const { return reference_length_; }

  // The mean over the input's face `source`.
  double part_of_face(Index source) const
  {
    return is_uniform() ? 1. : (double(parts_[source][0]) + double(parts_[source][1]) + double(parts_[source][2])) / 3;
  }

  // Whether vertices must be looked up on the input.
  bool needs_places() const { return !is_uniform() && !function_; }

  // At vertex v of the mesh; the locator may be missing where places are not needed.
  double part_at(const Remeshing_mesh& mesh, Index v, const Input_locator* locator) const
  {
    if (function_) {
      const Vector3 place = unit_ * mesh.position(v);
      return (std::min)(LONGEST_LENGTH, checked_length(function_(place), place) / length_unit_) / reference_length_;
    }
    const Input_place place = locator->place_of_vertex(mesh, v);
    const auto& corner = parts_[place.source];
    return place.coordinates[0] * double(corner[0]) + place.coordinates[1] * double(corner[1]) +
           place.coordinates[2] * double(corner[2]);
  }

private:
  std::vector<std::array<float, 3>> parts_;           // by input face, at its corners
  Function function_;
  double reference_length_ = 0, unit_ = 1, length_unit_ = 1;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_H
