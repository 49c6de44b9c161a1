// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_TARGET_OF_RUN_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_TARGET_OF_RUN_H

#include <CGAL/Inter_angle_remeshing/Face_count.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/numbers.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/referred.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/refuse.h>
#include <CGAL/Inter_angle_remeshing/internal/sizing/sizing.h>
#include <CGAL/Inter_angle_remeshing/target_edge_length.h>

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// What the argument `length` stands for: a number, a wanted number of faces, a sizing field, or a function of the position.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The target in the units of the flat mesh.
struct Target
{
  double length;             // with a field, that of reference
  std::size_t faces;         // 0: none are wanted
  Sizing sizing;
};

template <class Field, class Vertex, class TriangleMesh>
using Length_at_vertex =
  decltype(CGAL::to_double(std::declval<const Field&>().at(std::declval<Vertex>(), std::declval<TriangleMesh&>())));
template <class Field, class Vertex, class TriangleMesh, class = void>
struct Is_sizing_field : std::false_type {};
template <class Field, class Vertex, class TriangleMesh>
struct Is_sizing_field<Field, Vertex, TriangleMesh, std::void_t<Length_at_vertex<Field, Vertex, TriangleMesh>>> : std::true_type {};

template <class Function, class Point_3>
using Length_at_place = decltype(CGAL::to_double(std::declval<const Function&>()(std::declval<const Point_3&>())));
template <class Function, class Point_3, class = void>
struct Is_length_function : std::false_type {};
template <class Function, class Point_3>
struct Is_length_function<Function, Point_3, std::void_t<Length_at_place<Function, Point_3>>> : std::true_type {};

template <class Length>
struct Is_scaled_field : std::false_type {};
template <class SizingField>
struct Is_scaled_field<Scaled_sizing_field<SizingField>> : std::true_type {};

// The distance between doubles as large as the largest coordinate.
inline double resolution_of_coordinates(const Remeshing_mesh& mesh)
{
  double largest = 0;
  for (const Vector3& p : mesh.positions()) largest = (std::max)({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return std::numeric_limits<double>::epsilon() * largest;
}

// A length so small that the result could not be indexed is refused, as is what is no length, or one so near to the distance of coordinates
// that can be told apart that the points of an edge could not. Needles have edges to split, though hardly an area. `in_users_units` is what
// the user learns.
inline void check_length(double length, double in_users_units, double area, double total_edge_length, double resolution)
{
  constexpr double FEWEST_STEPS = 4;
  if (!(length >= 0) || !std::isfinite(length))
    refuse(REMESHING, "the target edge length is " + to_text(in_users_units) + "; it must be finite and not negative");
  const double faces = (std::max)(4 * area / (std::sqrt(3.) * length * length), total_edge_length / length);
  if (length > 0 && faces > MAXIMUM_NUMBER_OF_FACES)
    refuse(REMESHING, "the target edge length is " + to_text(in_users_units) + ", so small that about " + to_text(faces) +
                      " faces were needed; at most " + to_text(MAXIMUM_NUMBER_OF_FACES) + " can be indexed");
  if (length > 0 && length < FEWEST_STEPS * resolution)
    refuse(REMESHING, "the target edge length is " + to_text(in_users_units) + ", which is less than " + to_text(FEWEST_STEPS) +
                      " times the distance between numbers in double precision as large as the coordinates");
}

inline void check_face_count(const Face_count& count)
{
  if (count.value == 0) refuse(REMESHING, "the wanted number of faces is 0");
  if (double(count.value) > MAXIMUM_NUMBER_OF_FACES)
    refuse(REMESHING, "the wanted number of faces is " + to_text(double(count.value)) + "; at most " +
                      to_text(MAXIMUM_NUMBER_OF_FACES) + " can be indexed");
}

// The same where there is no mesh to compare with.
template <class Length>
void check_length_value(const Length& length)
{
  if constexpr (Is_number<Length>::value) check_length(number_to_double(length), number_to_double(length), 0, 0, 0);
  else if constexpr (std::is_same<Length, Face_count>::value) check_face_count(length);
  else if constexpr (Is_scaled_field<Length>::value) check_face_count(length.count);
  else (void)length;
}

// A positive number that its unit has made 0 or infinite, as near to it as a finite positive one is.
inline double in_range_of_double(double x)
{
  return (std::max)((std::numeric_limits<double>::min)(), (std::min)((std::numeric_limits<double>::max)(), x));
}

inline double length_for_faces(const Face_count& count, double area)
{
  check_face_count(count);
  if (!(area > 0))
    refuse(REMESHING, "no length makes Face_count(" + std::to_string(count.value) + ") of a range without an area");
  return length_for_face_count(area, count.value);
}

// The sizing that a field or a function of the position stands for; uniform, with its length, where a field is that. Of a field that is
// scaled only the ratios count: the longest of its lengths is their unit, and the target length is none.
template <class Field, class Exchange, class TriangleMesh, class VertexPointMap>
Target read_field(const Field& field, bool is_scaled, Exchange& exchange, TriangleMesh& tmesh, const VertexPointMap& vpm)
{
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  // Edges come out 5% shorter than their target length. A field says how long they are to be; for a number it is as it is in
  // Polygon_mesh_processing.
  constexpr double LENGTHENING = 1.04;
  const Remeshing_mesh& mesh = exchange.mesh();
  std::function<double(const Vector3&)> function;
  std::vector<double> lengths;
  lengths.reserve(exchange.input_vertices().size());
  for (const Vertex v : exchange.input_vertices()) {
    double l;
    if constexpr (Is_sizing_field<Field, Vertex, TriangleMesh>::value) l = exact_to_double(field.at(v, tmesh));
    else l = exact_to_double(field(Point_3(get(vpm, v))));
    lengths.push_back(checked_length(l, internal::to_vector3(get(vpm, v))));
  }
  const double unit = is_scaled ? *std::max_element(lengths.begin(), lengths.end()) : mesh.unit();
  for (double& l : lengths) l = (std::min)(LONGEST_LENGTH, l / unit);
  if constexpr (!Is_sizing_field<Field, Vertex, TriangleMesh>::value)
    function = [&field](const Vector3& p) { return exact_to_double(field(Point_3(p.x, p.y, p.z))); };
  else if (std::adjacent_find(lengths.begin(), lengths.end(), std::not_equal_to<double>()) == lengths.end())
    return {lengths.front(), 0, Sizing()};
  Sizing sizing(mesh, lengths, unit, std::move(function));
  const double reference = LENGTHENING * sizing.reference_length();
  return {reference, 0, std::move(sizing)};
}

// `length` must outlive the target.
template <class Length, class Exchange, class TriangleMesh, class VertexPointMap>
Target read_target(const Length& length, Exchange& exchange, TriangleMesh& tmesh, const VertexPointMap& vpm,
                   double total_edge_length)
{
  const Remeshing_mesh& mesh = exchange.mesh();
  const double range_area = area(mesh), resolution = resolution_of_coordinates(mesh);
  Target result{0, 0, Sizing()};
  if constexpr (std::is_same<Length, Face_count>::value)
    result = {length_for_faces(length, range_area), length.value, Sizing()};
  else if constexpr (Is_scaled_field<Length>::value) {
    result = read_field(referred(length.field), true, exchange, tmesh, vpm);
    result.faces = length.count.value;
    result.length = length_for_faces(length.count, range_area);
  } else if constexpr (Is_number<Length>::value) {
    const double wanted = number_to_double(length);
    result.length = wanted > 0 && std::isfinite(wanted) ? in_range_of_double(wanted / mesh.unit()) : wanted;
    check_length(result.length, wanted, range_area, total_edge_length, resolution);
    return result;
  } else
    result = read_field(referred(length), false, exchange, tmesh, vpm);
  check_length(result.length, mesh.unit() * result.length, range_area, total_edge_length, resolution);
  return result;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_TARGET_OF_RUN_H
