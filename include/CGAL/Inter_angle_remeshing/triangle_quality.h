// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_TRIANGLE_QUALITY_H
#define CGAL_INTER_ANGLE_REMESHING_TRIANGLE_QUALITY_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/exceptions.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
 * \ingroup PkgInterAngleRemeshingRef
 *
 * @brief tells how close the triangles of a mesh come to equilateral ones. All angles are in degrees.
 *
 * A *degenerate face* is one whose corners lie on a line, or coincide. Its angles are undefined or meaningless:
 * they are left out of the mean and of the histogram. In the extremes the face counts as 0 and 180 degrees,
 * so that a mesh with such a face cannot pass for a good one.
 *
 * A default constructed object describes no face at all: every member is zero.
 */
struct Inter_angle_statistics
{
  /// the width of a bin of `histogram`, in degrees
  static constexpr double bin_width = 5;

  /// the valence of the vertices of a tiling with equilateral triangles
  static constexpr std::size_t regular_valence = 6;

  /// the number of faces looked at, degenerate ones included
  std::size_t number_of_faces = 0;

  /// the number of faces without an area
  std::size_t number_of_degenerate_faces = 0;

  /// the smallest angle; 0 where there is no face, or a degenerate one
  double minimum_angle = 0;

  /// the largest angle; 0 where there is no face, 180 where there is a degenerate one
  double maximum_angle = 0;

  /// \f$ \theta_{avg} = 60 - \frac{1}{n} \sum_i |\theta_i - 60| \f$ over the angles of the faces that are not
  /// degenerate: 60 for equilateral triangles and smaller for all others; 0 where there is no such face
  double average = 0;

  /// the number of *forced* faces, which no remesher can mend that keeps curves, that is the border and the edges of
  /// `edge_is_constrained_map`: faces with a corner of less than 60 degrees between two edges on curves, and faces with an
  /// edge on a curve between two of its corners (ends, junctions, turns of 45 degrees and more) that is less than half as
  /// long as their other two edges
  std::size_t number_of_forced_faces = 0;

  /// the smallest angle of the faces that are not forced; as `minimum_angle` where there is no such face
  double minimum_unforced_angle = 0;

  /// the largest angle of the faces that are not forced
  double maximum_unforced_angle = 0;

  /// `average` of the faces that are not forced
  double unforced_average = 0;

  /// how many angles lie in [0, 5), [5, 10), ..., [175, 180]; an angle that equals a bound but for rounding may be
  /// counted on either side of it
  std::array<std::size_t, 36> histogram = {};

  /// `valence_histogram[k]` vertices have valence `k`, for `k` up to the largest that occurs (empty if there is none).
  /// Counted are *interior* vertices: those around which every face exists and is in the range.
  std::vector<std::size_t> valence_histogram;

  /// returns the number of interior vertices. Complexity: linear in the largest valence.
  std::size_t number_of_interior_vertices() const
  {
    std::size_t count = 0;
    for(const std::size_t bin : valence_histogram)
      count += bin;
    return count;
  }

  /// returns the number of interior vertices of valence 6.
  std::size_t number_of_regular_vertices() const
  {
    return regular_valence < valence_histogram.size() ? valence_histogram[regular_valence] : 0;
  }

  /// returns the part of the interior vertices that has valence 6, in [0, 1]; 0 where there is no interior vertex.
  double regular_vertices() const
  {
    const std::size_t all = number_of_interior_vertices();
    return all == 0 ? 0. : static_cast<double>(number_of_regular_vertices()) / static_cast<double>(all);
  }

  /// returns `regular_vertices()` in percent.
  double percentage_of_regular_vertices() const { return 100 * regular_vertices(); }
};

namespace internal {
namespace measures {

using Coordinates = std::array<double, 3>;
using Triangle_coordinates = std::array<Coordinates, 3>;

// The refusals have to hold in release builds, too, where CGAL's macros are empty.
[[noreturn]] inline void refuse(const std::string& condition, const std::string& message, const char* file, int line)
{
  throw CGAL::Precondition_exception("CGAL", condition, file, line, message);
}

template <class Halfedge, class TriangleMesh>
bool bounds_triangle(const Halfedge h, const TriangleMesh& tmesh)
{
  const Halfedge second = next(h, tmesh), third = next(second, tmesh);
  return second != h && third != h && next(third, tmesh) == h;
}

template <class Point>
Coordinates double_coordinates(const Point& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

inline bool is_finite(const Coordinates& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

// The corners of the face `f`, of which the user learns `ordinal` (its place in `range_name`) if it is refused.
template <class Face, class TriangleMesh, class VertexPointMap>
Triangle_coordinates checked_triangle(const Face f, const std::size_t ordinal, const std::string& range_name,
                                      const TriangleMesh& tmesh, const VertexPointMap& vpm)
{
  const auto describe = [&]() { return "face number " + std::to_string(ordinal) + " of " + range_name; };

  auto h = halfedge(f, tmesh);
  if(!bounds_triangle(h, tmesh))
    refuse("is_triangle(halfedge(f, tmesh), tmesh)", describe() + " is not a triangle", __FILE__, __LINE__);

  Triangle_coordinates corners;
  for(Coordinates& corner : corners)
  {
    corner = double_coordinates(get(vpm, target(h, tmesh)));
    if(!is_finite(corner))
      refuse("is_finite(get(vpm, target(h, tmesh)))",
             describe() + " has a corner with a coordinate that is not a finite number", __FILE__, __LINE__);
    h = next(h, tmesh);
  }
  return corners;
}

inline double dot_product(const Coordinates& u, const Coordinates& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

inline Coordinates cross_product(const Coordinates& u, const Coordinates& v)
{
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// Half the vector from `a` to `b`: the difference of any two finite numbers, halved, is finite.
inline Coordinates half_difference(const Coordinates& a, const Coordinates& b)
{
  return {.5 * b[0] - .5 * a[0], .5 * b[1] - .5 * a[1], .5 * b[2] - .5 * a[2]};
}

// The edges of a triangle, edge i opposite of corner i, scaled by a power of two (that is, without rounding) such that
// the largest component is about 1: angles stay the same, and fourth powers of lengths neither overflow nor vanish.
inline Triangle_coordinates normalized_edges(const Triangle_coordinates& corners)
{
  Triangle_coordinates edges = {half_difference(corners[1], corners[2]),
                                half_difference(corners[2], corners[0]),
                                half_difference(corners[0], corners[1])};
  double largest = 0;
  for(const Coordinates& edge : edges)
    for(const double component : edge)
      largest = (std::max)(largest, std::abs(component));

  // 2^1000 lifts even the smallest denormal number far enough; a larger factor would not be finite.
  constexpr int smallest_exponent = -1000;
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double factor = std::ldexp(1., -(std::max)(exponent, smallest_exponent));
  for(Coordinates& edge : edges)
    for(double& component : edge)
      component *= factor;
  return edges;
}

// Twice the area of the triangle with these edges. The two shorter edges lose the fewest digits.
inline double doubled_area(const Triangle_coordinates& edges)
{
  std::size_t longest = 0;
  for(std::size_t i = 1; i < 3; ++i)
    if(dot_product(edges[i], edges[i]) > dot_product(edges[longest], edges[longest]))
      longest = i;
  const Coordinates normal = cross_product(edges[(longest + 1) % 3], edges[(longest + 2) % 3]);
  return std::hypot(normal[0], normal[1], normal[2]); // squares could vanish
}

// Sums up faces; divides at the end.
class Angle_accumulator
{
  static constexpr double degrees_per_radian = 57.295779513082320877;
  static constexpr double ideal_angle = 60;

  Inter_angle_statistics statistics; // the counts; the angles are entered in the result only
  double smallest = 180;
  double largest = 0;
  double deviation = 0; // the sum of |angle - 60|

public:
  void add(const Triangle_coordinates& corners)
  {
    ++statistics.number_of_faces;
    const Triangle_coordinates edges = normalized_edges(corners);
    const double cross = doubled_area(edges);
    if(cross == 0)
      add_degenerate();
    else
      for(std::size_t i = 0; i < 3; ++i)
        add_angle(corner_angle(edges[(i + 1) % 3], edges[(i + 2) % 3], cross));
  }

  void add_interior_vertex(const std::size_t valence)
  {
    std::vector<std::size_t>& bins = statistics.valence_histogram;
    if(bins.size() <= valence)
      bins.resize(valence + 1, 0);
    ++bins[valence];
  }

  Inter_angle_statistics result() const
  {
    Inter_angle_statistics copy = statistics;
    if(copy.number_of_faces > 0)
    {
      copy.minimum_angle = smallest;
      copy.maximum_angle = largest;
    }
    const std::size_t number_of_angles = 3 * (copy.number_of_faces - copy.number_of_degenerate_faces);
    if(number_of_angles > 0)
      copy.average = ideal_angle - deviation / static_cast<double>(number_of_angles);
    return copy;
  }

private:
  // The edges follow one another around the triangle: one of the two points towards their common corner, hence the
  // sign. atan2 is accurate at every angle, unlike acos, which loses half of the digits near 0 and 180 degrees.
  static double corner_angle(const Coordinates& u, const Coordinates& v, const double cross)
  {
    return std::atan2(cross, -dot_product(u, v)) * degrees_per_radian;
  }

  void add_degenerate()
  {
    ++statistics.number_of_degenerate_faces;
    smallest = 0;
    largest = 180;
  }

  void add_angle(const double angle)
  {
    smallest = (std::min)(smallest, angle);
    largest = (std::max)(largest, angle);
    deviation += std::abs(angle - ideal_angle);
    const std::size_t bin = static_cast<std::size_t>(angle / Inter_angle_statistics::bin_width);
    ++statistics.histogram[(std::min)(bin, statistics.histogram.size() - 1)];
  }
};

// The valence of the target of `h`, or 0 if a face around it is missing or not `is_in_range`.
template <class Halfedge, class TriangleMesh, class IsInRange>
std::size_t interior_valence(const Halfedge h, const TriangleMesh& tmesh, const IsInRange& is_in_range)
{
  std::size_t valence = 0;
  for(const Halfedge around : CGAL::halfedges_around_target(h, tmesh))
  {
    if(CGAL::is_border(around, tmesh) || !is_in_range(face(around, tmesh)))
      return 0;
    ++valence;
  }
  return valence;
}

// The cosine of the angle between two vectors; 1 where one of them has no length.
inline double cosine(const Coordinates& u, const Coordinates& v)
{
  const double product = std::sqrt(dot_product(u, u)) * std::sqrt(dot_product(v, v));
  return product > 0 ? dot_product(u, v) / product : 1.;
}

// Whether the target of `h` is a corner of curves: not between two edges on curves that turn by less than 45 degrees.
template <class Halfedge, class TriangleMesh, class VertexPointMap, class IsOnCurve>
bool is_corner_of_curves(const Halfedge h, const TriangleMesh& tmesh, const VertexPointMap& vpm, const IsOnCurve& is_on_curve)
{
  constexpr double corner_cosine = -.7071067811865476;
  const Coordinates here = double_coordinates(get(vpm, target(h, tmesh)));
  std::vector<Coordinates> arms;
  for(const Halfedge around : CGAL::halfedges_around_target(h, tmesh))
    if(is_on_curve(around))
      arms.push_back(half_difference(here, double_coordinates(get(vpm, source(around, tmesh)))));
  return arms.size() != 2 || cosine(arms[0], arms[1]) > corner_cosine;
}

template <class Halfedge, class TriangleMesh, class VertexPointMap, class IsOnCurve>
bool is_forced(const Halfedge h0, const Triangle_coordinates& corners, const TriangleMesh& tmesh, const VertexPointMap& vpm,
               const IsOnCurve& is_on_curve)
{
  const Triangle_coordinates edges = normalized_edges(corners);
  Halfedge h = h0; // towards corner i, opposite of corner i + 1
  for(std::size_t i = 0; i < 3; ++i, h = next(h, tmesh))
  {
    if(!is_on_curve(h))
      continue;
    const Coordinates &own = edges[(i + 1) % 3], &u = edges[i], &v = edges[(i + 2) % 3];
    if(-cosine(own, v) > .5 && is_on_curve(next(h, tmesh)))
      return true;
    if(4 * dot_product(own, own) < (std::min)(dot_product(u, u), dot_product(v, v)) &&
       is_corner_of_curves(h, tmesh, vpm, is_on_curve) && is_corner_of_curves(opposite(h, tmesh), tmesh, vpm, is_on_curve))
      return true;
  }
  return false;
}

template <class FaceRange, class TriangleMesh, class NamedParameters, class IsInRange>
Inter_angle_statistics inter_angle_statistics(const FaceRange& face_range, const TriangleMesh& tmesh,
                                              const NamedParameters& np, const IsInRange& is_in_range)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    get_const_property_map(CGAL::vertex_point, tmesh));
  const auto ecm = get_parameter(np, internal_np::edge_is_constrained);
  const auto is_on_curve = [&](const auto h) {
    if(CGAL::is_border_edge(h, tmesh))
      return true;
    if constexpr(std::is_same<std::decay_t<decltype(ecm)>, internal_np::Param_not_found>::value)
      return false;
    else
      return bool(get(ecm, edge(h, tmesh)));
  };
  Angle_accumulator accumulator, unforced;
  std::size_t ordinal = 0;
  for(const auto f : face_range)
  {
    const Triangle_coordinates corners = checked_triangle(f, ordinal++, "the range", tmesh, vpm);
    accumulator.add(corners);
    if(!is_forced(halfedge(f, tmesh), corners, tmesh, vpm, is_on_curve))
      unforced.add(corners);

    // An interior vertex has one halfedge that stands for it, and the face of that is in the range: counted once.
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, tmesh), tmesh))
      if(halfedge(target(h, tmesh), tmesh) == h)
        if(const std::size_t valence = interior_valence(h, tmesh, is_in_range))
          accumulator.add_interior_vertex(valence);
  }
  Inter_angle_statistics result = accumulator.result();
  const Inter_angle_statistics rest = unforced.result();
  const bool is_any_left = rest.number_of_faces > 0;
  result.number_of_forced_faces = result.number_of_faces - rest.number_of_faces;
  result.minimum_unforced_angle = is_any_left ? rest.minimum_angle : result.minimum_angle;
  result.maximum_unforced_angle = is_any_left ? rest.maximum_angle : result.maximum_angle;
  result.unforced_average = is_any_left ? rest.average : result.average;
  return result;
}

} // namespace measures
} // namespace internal

/*!
 * \ingroup PkgInterAngleRemeshingRef
 *
 * @brief measures the angles of a range of triangles, and the valences of the vertices inside of it.
 *
 * The mean is the one of Zheng and Lv, *Isotropic Remeshing with Inter-Angle Optimization*, ICIG 2025. Every angle is
 * computed by `atan2()` from scaled coordinates, with an absolute error of some 10<sup>-14</sup> degrees at any size of
 * the triangle and for needles as well.
 *
 * @tparam FaceRange a range of `boost::graph_traits<TriangleMesh>::%face_descriptor`, model of `ConstRange`
 * @tparam TriangleMesh a model of `FaceListGraph` whose face descriptors are `Hashable`
 * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param face_range the faces to measure, each one once
 * @param tmesh the mesh that has these faces
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a `Point_3` of any kernel
 *                    as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{edges that are curves beside the border; tells which faces are forced}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{no edge is}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @return the statistics, all zero for an empty range
 *
 * @throw CGAL::Precondition_exception if a face is not a triangle, or has a coordinate that is not finite as a
 *        `double`; the message names the face by its place in the range, counted from 0. Release builds check this,
 *        too.
 *
 * Complexity: linear in the number of faces of the range, in time and memory.
 */
template <class FaceRange, class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Inter_angle_statistics inter_angle_statistics(const FaceRange& face_range, const TriangleMesh& tmesh,
                                              const CGAL_NP_CLASS& np = parameters::default_values())
{
  using Face = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  const std::unordered_set<Face> members(std::begin(face_range), std::end(face_range));
  const auto is_in_range = [&members](const Face f) { return members.count(f) != 0; };
  return internal::measures::inter_angle_statistics(face_range, tmesh, np, is_in_range);
}

/*!
 * \ingroup PkgInterAngleRemeshingRef
 *
 * @brief measures the angles of all faces of a mesh, and the valences of the vertices that are not on its border.
 *
 * Same as the function above with `faces(tmesh)`, but without any additional memory.
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Inter_angle_statistics inter_angle_statistics(const TriangleMesh& tmesh,
                                              const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::measures::inter_angle_statistics(faces(tmesh), tmesh, np, [](const auto&) { return true; });
}

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_TRIANGLE_QUALITY_H
