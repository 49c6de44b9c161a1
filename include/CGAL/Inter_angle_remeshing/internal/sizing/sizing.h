// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_SIZING_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_SIZING_H

#include <CGAL/Inter_angle_remeshing/internal/arguments/refuse.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Input_locator.h>

#include <CGAL/number_utils.h>

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

// In units of lengths: far beyond the extent of the flat mesh, and what is left of it as a float, or squared, is finite.
constexpr double LONGEST_LENGTH = 1e15;
// More faces cannot be indexed.
constexpr double MAXIMUM_NUMBER_OF_FACES = double((std::numeric_limits<Remeshing_mesh::Index>::max)() / 4) / 1.5;

[[noreturn]] inline void refuse_too_small_field()
{
  refuse(REMESHING, "the sizing field is so small that more than " + to_text(MAXIMUM_NUMBER_OF_FACES) +
                    " faces were needed, which cannot be indexed");
}

// The lengths are given as parts of the length of reference, with which uniform triangles over the range would be as many
// as with the field. The field is linear on the input's faces, or a function of the position. A function is asked inside of faces, too:
// large ones know little of it at their corners.
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
    double count = 0;
    for (Index f = 0; f < Index(mesh.number_of_face_slots()); ++f) doubled_area_ += length(mesh.cross_product(f));
    for (Index f = 0; f < Index(mesh.number_of_face_slots()); ++f) {
      Corners corner;
      for (int k = 0; k < 3; ++k) {
        const Index v = mesh.face_record(f).vertex[k];
        corner[k] = {mesh.position(v), lengths[mesh.input(v)]};
      }
      const double doubled_area = length(mesh.cross_product(f));
      if (!(doubled_area > 0)) continue;
      count += integral(corner, doubled_area, function_ ? cuts_for(FEWEST_PIECES, doubled_area) : 0, cuts_for(MOST_PIECES, doubled_area));
    }
    reference_length_ = count > 0 ? std::sqrt(doubled_area_ / count) : lengths.front();
    if (!(reference_length_ > 0)) refuse_too_small_field();
    parts_.resize(mesh.number_of_face_slots());
    for (Index f = 0; f < Index(mesh.number_of_face_slots()); ++f) {
      const auto& t = mesh.face_record(f);
      for (int k = 0; k < 3; ++k) parts_[t.source][k] = float(lengths[mesh.input(t.vertex[k])] / reference_length_);
    }
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

  bool is_function() const { return bool(function_); }
  // Whether a function is asked inside of face f of the mesh.
  bool looks_inside(const Remeshing_mesh& mesh, Index f) const
  {
    return is_function() && cuts_for(MOST_PIECES, length(mesh.cross_product(f))) > 0;
  }
  // Of a function, at the corners of face f of the mesh and at the points inside that are asked: the shortest lengths.
  std::pair<double, double> shortest_parts(const Remeshing_mesh& mesh, Index f) const
  {
    Corners corner;
    for (int k = 0; k < 3; ++k) {
      const Vector3& p = mesh.position(mesh.face_record(f).vertex[k]);
      corner[k] = {p, length_by_function(p)};
    }
    const double doubled_area = length(mesh.cross_product(f)),
                 at_corners = (std::min)({corner[0].length, corner[1].length, corner[2].length}),
                 inside = least_inside(corner, cuts_for(FEWEST_PIECES, doubled_area), cuts_for(MOST_PIECES, doubled_area));
    return {at_corners / reference_length_, inside / reference_length_};
  }

  // At vertex v of the mesh; the locator may be missing where places are not needed.
  double part_at(const Remeshing_mesh& mesh, Index v, const Input_locator* locator) const
  {
    if (function_) return length_by_function(mesh.position(v)) / reference_length_;
    const Input_place place = locator->place_of_vertex(mesh, v);
    const auto& corner = parts_[place.source];
    return place.coordinates[0] * double(corner[0]) + place.coordinates[1] * double(corner[1]) +
           place.coordinates[2] * double(corner[2]);
  }

private:
  struct Corner
  {
    Vector3 point;
    double length;
  };
  using Corners = std::array<Corner, 3>;

  // Of about so many pieces of the same area, over the whole range, a function is asked about the corners; and of as many more as there are
  // with the second number, as long as the lengths at those of one differ by more than this factor.
  static constexpr double FEWEST_PIECES = 4096, MOST_PIECES = 1 << 18, EVEN = 1.5;

  // How often a face of the area is cut into four for so many pieces over the whole range; one without an area is not.
  int cuts_for(double pieces, double doubled_area) const
  {
    return doubled_area > 0 ? (std::max)(0, int(std::ceil(std::log2(pieces * doubled_area / doubled_area_) / 2))) : 0;
  }

  double length_by_function(const Vector3& p) const
  {
    const Vector3 place = unit_ * p;
    return (std::min)(LONGEST_LENGTH, checked_length(function_(place), place) / length_unit_);
  }
  double length_between(const Corner& a, const Corner& b, const Vector3& middle) const
  {
    return function_ ? length_by_function(middle) : 0.5 * (a.length + b.length);
  }

  // Calls `function(piece, cuts)` for the pieces of a face, each with the number of times that it was cut into four: at least `fewest_cuts`
  // times, and on to `most_cuts` where lengths are uneven.
  template <class Function>
  void for_each_piece(const Corners& corner, int fewest_cuts, int most_cuts, const Function& function, int cuts = 0) const
  {
    const auto [least, most] = std::minmax({corner[0].length, corner[1].length, corner[2].length});
    if (cuts >= fewest_cuts && (cuts >= most_cuts || most <= EVEN * least)) { function(corner, cuts); return; }
    Corners middle;
    for (int k = 0; k < 3; ++k) {
      const Corner &a = corner[k], &b = corner[(k + 1) % 3];
      const Vector3 p = 0.5 * (a.point + b.point);
      middle[k] = {p, length_between(a, b, p)};
    }
    for (int k = 0; k < 3; ++k)
      for_each_piece({corner[k], middle[k], middle[(k + 2) % 3]}, fewest_cuts, most_cuts, function, cuts + 1);
    for_each_piece(middle, fewest_cuts, most_cuts, function, cuts + 1);
  }

  // Twice the integral of the length to the power of -2, by the rule of the midpoints.
  double integral(const Corners& corner, double doubled_area, int fewest_cuts, int most_cuts) const
  {
    double sum = 0;
    for_each_piece(corner, fewest_cuts, most_cuts, [&](const Corners& piece, int cuts) {
      for (int k = 0; k < 3; ++k)
        sum += std::ldexp(doubled_area, -2 * cuts) / (3 * CGAL::square(0.5 * (piece[k].length + piece[(k + 1) % 3].length)));
    });
    return sum;
  }

  // The least length at the points that `integral()` asks about.
  double least_inside(const Corners& corner, int fewest_cuts, int most_cuts) const
  {
    double result = std::numeric_limits<double>::infinity();
    for_each_piece(corner, fewest_cuts, most_cuts, [&](const Corners& piece, int) {
      result = (std::min)({result, piece[0].length, piece[1].length, piece[2].length}); });
    return result;
  }

  std::vector<std::array<float, 3>> parts_;           // by input face, at its corners
  Function function_;
  double doubled_area_ = 0, reference_length_ = 0, unit_ = 1, length_unit_ = 1;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SIZING_SIZING_H
