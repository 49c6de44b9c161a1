// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_ARGUMENT_CHECK_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_ARGUMENT_CHECK_H

#include <CGAL/Inter_angle_remeshing/internal/arguments/named_parameters.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/numbers.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/run_with_projector.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/target_of_run.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

// Which types the arguments of isotropic_remeshing() may have. What does not fit is refused by one static_assert in words. All
// else that the compiler could say about it is kept away: the function goes on where IS_PASSED holds, and only there.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// --- meshes and ranges -----------------------------------------------------------------------------------------------

template <class TriangleMesh>
using Graph_of = boost::graph_traits<TriangleMesh>;

// What makes a mesh that can be written to. The functions are found by the mesh's namespace, and come first: what is no graph at
// all cannot be asked for its traits.
template <class TriangleMesh>
using Mutable_face_graph = std::void_t<
  decltype(add_vertex(std::declval<TriangleMesh&>())), decltype(add_face(std::declval<TriangleMesh&>())),
  typename Graph_of<TriangleMesh>::face_descriptor,
  decltype(set_next(std::declval<typename Graph_of<TriangleMesh>::halfedge_descriptor>(),
                    std::declval<typename Graph_of<TriangleMesh>::halfedge_descriptor>(), std::declval<TriangleMesh&>()))>;

template <class TriangleMesh, class = void>
struct Is_mutable_face_graph : std::false_type {};
template <class TriangleMesh>
struct Is_mutable_face_graph<TriangleMesh, Mutable_face_graph<TriangleMesh>>
  : std::bool_constant<!std::is_const<TriangleMesh>::value> {};

template <class TriangleMesh>
struct Mesh_check
{
  static constexpr bool IS_PASSED = Is_mutable_face_graph<TriangleMesh>::value;
  static_assert(IS_PASSED, "isotropic_remeshing(): the mesh must be a model of MutableFaceGraph that is not const. Is the header "
                           "CGAL/boost/graph/graph_traits_*.h of its type included? Of a part of a mesh, as Face_filtered_graph is, "
                           "hand over the mesh and the faces of the part: isotropic_remeshing(faces(part), length, mesh).");
};

// What stands in the place of the named parameters.
template <class Other>
struct Parameters_check
{
  static constexpr bool IS_PASSED = Is_named_parameters<Other>::value;
  static_assert(IS_PASSED, "isotropic_remeshing(): what follows the mesh must be named parameters, such as "
                           "CGAL::parameters::number_of_iterations(5), or those of CGAL::Inter_angle_remeshing::recipe(recipe).");
};

template <class Range, class Value, class = void>
struct Is_range_of : std::false_type {};
template <class Range, class Value>
struct Is_range_of<Range, Value, std::void_t<decltype(std::declval<const Range&>().begin() != std::declval<const Range&>().end())>>
  : std::is_convertible<decltype(*std::declval<const Range&>().begin()), Value> {};

// --- property maps -----------------------------------------------------------------------------------------------

template <class Map, class = void>
struct Is_property_map : std::false_type {};
template <class Map>
struct Is_property_map<Map, std::void_t<typename boost::property_traits<Map>::key_type,
                                        typename boost::property_traits<Map>::value_type>> : std::true_type {};

// A map that takes anything for a key has void for the type of its keys.
template <class Map, class Key>
constexpr bool has_key()
{
  if constexpr (Is_property_map<Map>::value) {
    using Own_key = typename boost::property_traits<Map>::key_type;
    return std::is_void<Own_key>::value || std::is_convertible<Key, Own_key>::value;
  } else return false;
}

// Integers and characters stand for bools.
template <class Map, class Key>
constexpr bool is_map_of_marks()
{
  if constexpr (std::is_same<Map, Not_given>::value) return true;
  else if constexpr (has_key<Map, Key>()) return std::is_integral<typename boost::property_traits<Map>::value_type>::value;
  else return false;
}

template <class Value, class = void>
struct Is_comparable : std::false_type {};
template <class Value>
struct Is_comparable<Value, std::void_t<decltype(bool(std::declval<const Value&>() == std::declval<const Value&>()))>>
  : std::is_copy_constructible<Value> {};

template <class Map, class Key>
constexpr bool is_map_of_patches()
{
  if constexpr (std::is_same<Map, Not_given>::value) return true;
  else if constexpr (has_key<Map, Key>()) return Is_comparable<typename boost::property_traits<Map>::value_type>::value;
  else return false;
}

template <class Point, class = void>
struct Has_coordinates : std::false_type {};
template <class Point>
struct Has_coordinates<Point, std::void_t<decltype(std::declval<const Point&>().x(), std::declval<const Point&>().y(),
                                                   std::declval<const Point&>().z())>>
  : std::is_constructible<Point, double, double, double> {};

template <class Map, class Key>
constexpr bool is_map_of_points()
{
  if constexpr (has_key<Map, Key>())
    return is_writable<Map>() && Has_coordinates<typename boost::property_traits<Map>::value_type>::value;
  else return false;
}

// --- functors ----------------------------------------------------------------------------------------------------

template <class Given, class Vertex>
constexpr bool is_rule()
{
  return std::is_same<Given, Not_given>::value || Is_choice<Given>::value ||
         std::is_invocable_r<bool, const Given&, const Run_profile<Vertex>&>::value;
}

// A functor may have a state that it changes.
template <class Given, class Vertex, class Points>
constexpr bool is_move_functor()
{
  using Functor = std::decay_t<Given>;
  if constexpr (std::is_same<Functor, Not_given>::value) return true;
  else if constexpr (is_map_of_points<Points, Vertex>()) {
    using Point = typename boost::property_traits<Points>::value_type;
    return std::is_copy_constructible<Functor>::value && std::is_invocable_r<bool, Functor&, Vertex, Point, Point>::value;
  } else return true;
}

// The last two can be asked only where there are points; where there are none, that is what is told.
template <class Given, class Vertex, class Points>
constexpr bool is_projector()
{
  using Functor = std::decay_t<decltype(referred(std::declval<const Given&>()))>;
  if constexpr (std::is_same<Functor, Not_given>::value || Has_reference_surface<Functor>::value) return true;
  else if constexpr (is_map_of_points<Points, Vertex>()) {
    using Point = typename boost::property_traits<Points>::value_type;
    return std::is_invocable_r<Point, const Functor&, const Point&>::value ||
           std::is_invocable_r<Point, const Functor&, Vertex>::value;
  } else return true;
}

template <class Field, class Vertex, class TriangleMesh, class Points>
constexpr bool is_field()
{
  if constexpr (Is_sizing_field<Field, Vertex, TriangleMesh>::value) return true;
  else if constexpr (is_map_of_points<Points, Vertex>())
    return Is_length_function<Field, typename boost::property_traits<Points>::value_type>::value;
  else return true;
}

template <class Length, class Vertex, class TriangleMesh, class Points>
constexpr bool is_length()
{
  if constexpr (std::is_same<Length, Face_count>::value || Is_number<Length>::value) return true;
  else if constexpr (Is_scaled_field<Length>::value)
    return is_field<std::decay_t<decltype(referred(std::declval<const Length&>().field))>, Vertex, TriangleMesh, Points>();
  else return is_field<std::decay_t<decltype(referred(std::declval<const Length&>()))>, Vertex, TriangleMesh, Points>();
}

// Every member that a visitor is called with.
template <class Visitor, class Mesh = const Remeshing_mesh&>
using Visitor_calls = decltype(
  std::declval<Visitor&>().start_iteration(0u, std::declval<Mesh>()),
  std::declval<Visitor&>().end_iteration(0u, std::declval<Mesh>()),
  std::declval<Visitor&>().start_pass(Pass(), std::declval<Mesh>()),
  std::declval<Visitor&>().end_pass(Pass(), std::declval<Mesh>(), std::size_t()),
  std::declval<Visitor&>().before_split(Mesh_halfedge(), std::declval<Mesh>()),
  std::declval<Visitor&>().after_split(Mesh_vertex(), std::declval<Mesh>()),
  std::declval<Visitor&>().before_collapse(Mesh_halfedge(), std::declval<Mesh>()),
  std::declval<Visitor&>().after_collapse(Mesh_vertex(), std::declval<Mesh>()),
  std::declval<Visitor&>().before_flip(Mesh_halfedge(), std::declval<Mesh>()),
  std::declval<Visitor&>().after_flip(Mesh_halfedge(), std::declval<Mesh>()),
  std::declval<Visitor&>().before_move(Mesh_vertex(), std::declval<Mesh>()),
  std::declval<Visitor&>().after_move(Mesh_vertex(), std::declval<Mesh>()));

template <class Visitor, class = void>
struct Is_visitor : std::false_type {};
template <class Visitor>
struct Is_visitor<Visitor, std::void_t<Visitor_calls<Visitor>>> : std::true_type {};
template <class Visitor>
struct Is_visitor<std::reference_wrapper<Visitor>, void> : Is_visitor<Visitor> {};
template <>
struct Is_visitor<Not_given, void> : std::true_type {};

// --- all of them -------------------------------------------------------------------------------------------------

template <class... Given>
constexpr bool are_bools() { return ((std::is_same<Given, Not_given>::value || Is_choice<Given>::value) && ...); }
template <class... Given>
constexpr bool are_counts()
{
  return ((std::is_same<Given, Not_given>::value || std::is_same<Given, bool>::value || Is_number<Given>::value) && ...);
}

template <class Angle>
constexpr bool is_angle()
{
  if constexpr (std::is_same<Angle, Not_given>::value) return true; else return Is_number<Angle>::value;
}

template <class Callback>
constexpr bool is_callback()
{
  return std::is_same<Callback, Not_given>::value || std::is_convertible<Callback, std::function<bool(double)>>::value;
}

template <class ConcurrencyTag>
constexpr bool is_concurrency_tag()
{
  return std::is_convertible<ConcurrencyTag, CGAL::Sequential_tag>::value ||
         std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value;
}

#ifdef CGAL_LINKED_WITH_TBB
constexpr bool HAS_THREADS = true;
#else
constexpr bool HAS_THREADS = false;
#endif

template <class ConcurrencyTag, class FaceRange, class Length, class TriangleMesh, class NamedParameters,
          bool IS_MESH = Mesh_check<TriangleMesh>::IS_PASSED>
struct Argument_check
{
  static constexpr bool IS_PASSED = false;
};

template <class ConcurrencyTag, class FaceRange, class Length, class TriangleMesh, class NamedParameters>
struct Argument_check<ConcurrencyTag, FaceRange, Length, TriangleMesh, NamedParameters, true>
{
private:
  using Vertex = typename Graph_of<TriangleMesh>::vertex_descriptor;
  using Edge = typename Graph_of<TriangleMesh>::edge_descriptor;
  using Face = typename Graph_of<TriangleMesh>::face_descriptor;

  template <class Tag>
  using Given = typename CGAL::internal_np::Get_param<typename NamedParameters::base, Tag>::type;

  using Given_points = Given<CGAL::internal_np::vertex_point_t>;
  using Points = std::conditional_t<std::is_same<Given_points, Not_given>::value,
                                    typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::type, Given_points>;

  static constexpr bool HAS_TAG = is_concurrency_tag<ConcurrencyTag>();
  static_assert(HAS_TAG, "isotropic_remeshing(): the first template argument must be CGAL::Sequential_tag, CGAL::Parallel_tag or "
                         "CGAL::Parallel_if_available_tag.");
  static constexpr bool CAN_RUN = HAS_THREADS || !std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value;
  static_assert(CAN_RUN, "isotropic_remeshing(): CGAL::Parallel_tag was asked for, but TBB is not linked: link CGAL::TBB_support, "
                         "or use CGAL::Parallel_if_available_tag.");
  static constexpr bool HAS_FACES = Is_range_of<FaceRange, Face>::value;
  static_assert(HAS_FACES, "isotropic_remeshing(): the range must be one of faces of the mesh, with begin() and end().");
  static constexpr bool HAS_POINTS = is_map_of_points<Points, Vertex>();
  static_assert(HAS_POINTS, "vertex_point_map: expected a property map that can be written, with vertices of the mesh as keys and "
                            "points as values: x(), y(), z(), made from three coordinates.");
  static constexpr bool HAS_EDGE_MARKS = is_map_of_marks<Given<CGAL::internal_np::edge_is_constrained_t>, Edge>();
  static_assert(HAS_EDGE_MARKS, "edge_is_constrained_map: expected a property map with edges of the mesh as keys and bool as value "
                                "type.");
  static constexpr bool HAS_VERTEX_MARKS = is_map_of_marks<Given<CGAL::internal_np::vertex_is_constrained_t>, Vertex>();
  static_assert(HAS_VERTEX_MARKS, "vertex_is_constrained_map: expected a property map with vertices of the mesh as keys and bool "
                                  "as value type.");
  static constexpr bool HAS_PATCHES = is_map_of_patches<Given<CGAL::internal_np::face_patch_t>, Face>();
  static_assert(HAS_PATCHES, "face_patch_map: expected a property map with faces of the mesh as keys and values that can be copied "
                             "and compared by ==.");

  static constexpr bool HAS_SPLITS = is_rule<Given<CGAL::internal_np::do_split_t>, Vertex>();
  static_assert(HAS_SPLITS, "do_split: expected a bool or a policy `template <class Profile> bool operator()(const Profile&) "
                            "const`.");
  static constexpr bool HAS_COLLAPSES = is_rule<Given<CGAL::internal_np::do_collapse_t>, Vertex>();
  static_assert(HAS_COLLAPSES, "do_collapse: expected a bool or a policy `template <class Profile> bool operator()(const Profile&) "
                               "const`.");
  static constexpr bool HAS_FLIPS = is_rule<Given<CGAL::internal_np::do_flip_t>, Vertex>();
  static_assert(HAS_FLIPS, "do_flip: expected a bool or a policy `template <class Profile> bool operator()(const Profile&) "
                           "const`.");

  static constexpr bool HAS_MOVES = is_move_functor<Given<CGAL::internal_np::allow_move_functor_t>, Vertex, Points>();
  static_assert(HAS_MOVES, "allow_move_functor: expected a functor `bool operator()(vertex_descriptor, const Point_3&, const Point_3&)`: "
                           "whether the vertex may move from the first point to the second. One that cannot be copied is handed "
                           "over by std::ref().");

  static constexpr bool HAS_CALLBACK = is_callback<Given<CGAL::internal_np::callback_t>>();
  static_assert(HAS_CALLBACK, "callback: expected a functor `bool operator()(double)`: progress in, whether to go on out.");
  static constexpr bool HAS_VISITOR = Is_visitor<Given<CGAL::internal_np::visitor_t>>::value;
  static_assert(HAS_VISITOR, "visitor: expected a model of RemeshingVisitor, such as a class that is derived from "
                             "Default_visitor.");

  static constexpr bool HAS_BOOLS =
    are_bools<Given<CGAL::internal_np::do_project_t>, Given<CGAL::internal_np::protect_constraints_t>,
              Given<CGAL::internal_np::collapse_constraints_t>, Given<CGAL::internal_np::relax_constraints_t>,
              Given<CGAL::internal_np::verbose_t>>();
  static_assert(HAS_BOOLS, "do_project, protect_constraints, collapse_constraints, relax_constraints, verbose: expected a bool.");
  static constexpr bool HAS_COUNTS =
    are_counts<Given<CGAL::internal_np::number_of_iterations_t>, Given<CGAL::internal_np::number_of_relaxation_steps_t>>();
  static_assert(HAS_COUNTS, "number_of_iterations, number_of_relaxation_steps: expected a number.");
  static constexpr bool HAS_ANGLE = is_angle<Given<CGAL::internal_np::sharpness_angle_t>>();
  static_assert(HAS_ANGLE, "sharpness_angle: expected a number, in degrees.");
  static constexpr bool HAS_PROJECTOR = is_projector<Given<CGAL::internal_np::projection_functor_t>, Vertex, Points>();
  static_assert(HAS_PROJECTOR, "projection_functor: expected a functor `Point_3 operator()(vertex_descriptor) const`, as in "
                               "Polygon_mesh_processing, or `Point_3 operator()(const Point_3&) const`.");
  static constexpr bool HAS_LENGTH = is_length<Length, Vertex, TriangleMesh, Points>();
  static_assert(HAS_LENGTH, "isotropic_remeshing(): the length must be a number, Face_count(n), a sizing field with `at(vertex, "
                            "mesh)`, a function `FT operator()(const Point_3&) const`, or one of these two in "
                            "Face_count::scaling().");

public:
  static constexpr bool IS_PASSED = HAS_TAG && CAN_RUN && HAS_FACES && HAS_LENGTH && HAS_POINTS && HAS_EDGE_MARKS &&
                                    HAS_VERTEX_MARKS && HAS_PATCHES && HAS_SPLITS && HAS_COLLAPSES && HAS_FLIPS && HAS_MOVES &&
                                    HAS_PROJECTOR && HAS_CALLBACK && HAS_VISITOR && HAS_BOOLS && HAS_COUNTS && HAS_ANGLE;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_ARGUMENT_CHECK_H
