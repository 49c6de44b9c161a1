// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_ANGLE_BANDS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_ANGLE_BANDS_H

#include <CGAL/Inter_angle_remeshing/Recipe.h>
#include <CGAL/Inter_angle_remeshing/Remeshing_report.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/arc_cosine.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/angle_energy.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

// The bands that the angles shall lie in: the one of the recipe, and a wider one for the faces that touch a curve.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Where a vertex is on a curve, the narrow band is out of reach as often as not, and to strive for it costs the other angles
// there half a degree on the average.
constexpr double LOWER_ANGLE_AT_CURVES = 33, UPPER_ANGLE_AT_CURVES = 103;
// The weight of large angles in the energy there. By cosines 140 degrees are five times as far out of that band as 20 are, and would count
// 25 times as much; but where strips are thin, some angles have to be small or large, and small ones are worse.
constexpr double WEIGHT_OF_LARGE_AT_CURVES = 0.2;
// What moves vertices heads for bands that are narrower by this: it comes near their ends, not quite to them.
constexpr double LOWER_MARGIN = 2, UPPER_MARGIN = 3;

struct Angle_bands
{
  Angle_band inside, at_curves;

  // The bands narrower by so many degrees at the lower and at the upper end.
  Angle_bands(const Recipe& recipe, double lower_margin = 0, double upper_margin = 0)
    : inside(narrowed(recipe.lower_angle, recipe.upper_angle, lower_margin, upper_margin)),
      at_curves(narrowed((std::min)(recipe.lower_angle, LOWER_ANGLE_AT_CURVES),
                         (std::max)(recipe.upper_angle, UPPER_ANGLE_AT_CURVES), lower_margin, upper_margin, WEIGHT_OF_LARGE_AT_CURVES))
  {}

  // That of the face with these corners.
  const Angle_band& of(const Remeshing_mesh& mesh, Remeshing_mesh::Index a, Remeshing_mesh::Index b, Remeshing_mesh::Index c) const
  {
    return mesh.is_on_curve(a) || mesh.is_on_curve(b) || mesh.is_on_curve(c) ? at_curves : inside;
  }

private:
  static Angle_band narrowed(double lower, double upper, double lower_margin, double upper_margin, double weight_of_large = 1)
  {
    return Angle_band((std::min)(60., lower + lower_margin), (std::max)(60., upper - upper_margin), weight_of_large);
  }
};

inline bool holds_band(const Remeshing_mesh& mesh, const Angle_bands& bands, Remeshing_mesh::Index f)
{
  const auto& v = mesh.face_record(f).vertex;
  return bands.of(mesh, v[0], v[1], v[2]).holds(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]));
}

// How far an angle of face f is out of its band, in degrees; 0 where none is. A small angle between two edges on curves counts
// only with `counts_forced`: it is the input's, and no remesher can change it. A large one can be divided.
inline double angle_violation(const Remeshing_mesh& mesh, const Angle_bands& bands, Remeshing_mesh::Index f,
                              bool counts_forced = false)
{
  if (holds_band(mesh, bands, f)) return 0;
  const auto& v = mesh.face_record(f).vertex;
  const Angle_band& band = bands.of(mesh, v[0], v[1], v[2]);
  double result = 0;
  for (int k = 0; k < 3; ++k) {
    const Remeshing_mesh::Index h = 4 * f + k;
    const bool may_be_forced = !counts_forced && mesh.is_on_curve_edge(h) && mesh.is_on_curve_edge(mesh.prev(h));
    const double angle = arc_cosine_in_degrees(
      corner_cosine(mesh.position(v[k]), mesh.position(v[(k + 1) % 3]), mesh.position(v[(k + 2) % 3])));
    result = (std::max)({result, may_be_forced ? 0. : band.lower() - angle, angle - band.upper()});
  }
  return result;
}

// Tells the report which faces are out of their band, and why.
inline void report_band(const Remeshing_mesh& mesh, const Angle_bands& bands, Remeshing_report& report)
{
  using Index = Remeshing_mesh::Index;
  constexpr std::size_t MOST_REPORTED = 1000;
  report.band_holds = true;
  std::vector<std::pair<double, Index>> out;
  for (Index f = 0; f < Index(mesh.number_of_face_slots()); ++f)
    if (mesh.is_face(f))
      if (const double v = angle_violation(mesh, bands, f, true); v > 0) out.emplace_back(-v, f);
  const auto reason = [&](Index f) {
    if (angle_violation(mesh, bands, f) <= 0) return Remeshing_report::Reason::input_corner;
    return mesh.touches_curve(f) ? Remeshing_report::Reason::border_or_feature : Remeshing_report::Reason::no_operation;
  };
  for (const auto& o : out)
    if (reason(o.second) != Remeshing_report::Reason::input_corner) { report.band_holds = false; break; }
  report.number_of_faces_out_of_band = out.size();
  const auto end = out.begin() + std::ptrdiff_t((std::min)(MOST_REPORTED, out.size()));
  std::partial_sort(out.begin(), end, out.end());
  for (auto o = out.begin(); o != end; ++o) {
    const auto& v = mesh.face_record(o->second).vertex;
    const Vector3 c = (mesh.unit() / 3) * (mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2]));
    report.faces_out_of_band.push_back({{c.x, c.y, c.z}, -o->first, reason(o->second)});
  }
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_ANGLE_BANDS_H
