// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_NAMED_PARAMETERS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_NAMED_PARAMETERS_H

#include <CGAL/Inter_angle_remeshing/Face_count.h>
#include <CGAL/Inter_angle_remeshing/Recipe.h>
#include <CGAL/Inter_angle_remeshing/internal/Edge_rule.h>
#include <CGAL/Inter_angle_remeshing/internal/Run_visitor.h>
#include <CGAL/Inter_angle_remeshing/internal/constraints.h>
#include <CGAL/Inter_angle_remeshing/internal/refuse.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

// From what get_parameter() yields to what the remesher takes. What does not fit is refused in words: by a
// static_assert where the type is wrong, by an exception where the value is.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

using Not_given = CGAL::internal_np::Param_not_found;

template <class Length>
constexpr void check_length_type()
{
  using Category = typename CGAL::Algebraic_structure_traits<Length>::Algebraic_category;
  static_assert(std::is_same<Length, Face_count>::value || !std::is_same<Category, CGAL::Null_tag>::value,
                "isotropic_remeshing(): the length must be a number or Face_count(n). Sizing fields and functions of "
                "the position are not supported yet.");
}

// Whether the functions that change a mesh exist for the type. A mesh that is const, or a view of another one as
// Face_filtered_graph is, has none.
template <class Mesh, class = void>
struct Is_mutable_face_graph : std::false_type {};
template <class Mesh>
struct Is_mutable_face_graph<Mesh, std::void_t<
  decltype(add_vertex(std::declval<Mesh&>())), decltype(add_edge(std::declval<Mesh&>())), decltype(add_face(std::declval<Mesh&>())),
  decltype(set_next(halfedge(*faces(std::declval<Mesh&>()).begin(), std::declval<Mesh&>()),
                    halfedge(*faces(std::declval<Mesh&>()).begin(), std::declval<Mesh&>()), std::declval<Mesh&>()))>>
  : std::true_type {};

template <class TriangleMesh>
constexpr void check_mesh_type()
{
  static_assert(Is_mutable_face_graph<TriangleMesh>::value,
                "isotropic_remeshing(): the mesh must be a model of MutableFaceGraph, and not const. Of a part of a mesh, as "
                "Face_filtered_graph is, hand over the mesh and the faces of the part: "
                "isotropic_remeshing(faces(part), length, mesh).");
}

template <class NamedParameters, class Tag>
constexpr bool has_parameter()
{
  using Given = typename CGAL::internal_np::Get_param<typename NamedParameters::base, Tag>::type;
  return !std::is_same<Given, Not_given>::value;
}

// Parameters of PMP's function, or of its siblings, that a user may expect to work.
template <class NamedParameters>
constexpr void refuse_unsupported()
{
  static_assert(!has_parameter<NamedParameters, CGAL::internal_np::allow_move_functor_t>(),
                "isotropic_remeshing(): allow_move_functor is not supported; constrain vertices by "
                "vertex_is_constrained_map.");
}

inline No_map or_no_map(const Not_given&) { return {}; }
template <class Map>
Map or_no_map(const Map& map) { return map; }

template <class Vertex, class Preset>
Preset policy_from(const Not_given&, const Preset& preset) { return preset; }

// A policy, or a bool that stands for all edges.
template <class Vertex, class Given, class Preset>
auto policy_from(const Given& given, const Preset&)
{
  if constexpr (std::is_arithmetic<Given>::value)
    return bool(given);
  else {
    static_assert(std::is_invocable_r<bool, const Given&, const Run_profile<Vertex>&>::value,
                  "do_split, do_collapse, do_flip: expected a bool or a policy "
                  "`template <class Profile> bool operator()(const Profile&) const`.");
    return given;
  }
}

// Whether no rule of the user's was given.
inline bool is_left_to_the_recipe(const Not_given&) { return true; }
template <class Given>
bool is_left_to_the_recipe(const Given& given)
{
  if constexpr (std::is_arithmetic<Given>::value) return bool(given);
  else { (void)given; return false; }
}

inline Run_visitor visitor_from(Not_given&) { return {}; }
template <class Visitor>
User_visitor<Visitor> visitor_from(std::reference_wrapper<Visitor>& given) { return User_visitor<Visitor>(given.get()); }
template <class Visitor>
User_visitor<Visitor> visitor_from(Visitor& given) { return User_visitor<Visitor>(given); }

inline std::function<bool(double)> callback_from(const Not_given&) { return {}; }
template <class Callback>
std::function<bool(double)> callback_from(const Callback& callback)
{
  static_assert(std::is_convertible<Callback, std::function<bool(double)>>::value,
                "callback: expected a functor `bool operator()(double)`: progress in, whether to go on out.");
  return callback;
}

template <class Angle>
double sharpness_cosine(const Angle& angle)
{
  const double degrees = CGAL::to_double(angle);
  if (!(degrees >= 0 && degrees <= 180))
    refuse("isotropic_remeshing()", "sharpness_angle is " + std::to_string(degrees) + "; it must lie in [0, 180]");
  return degrees < 180 ? std::cos(degrees * (CGAL_PI / 180)) : -2;
}

template <class Count>
unsigned count_from(const Count& count, const char* name)
{
  static_assert(std::is_integral<Count>::value, "number_of_iterations, number_of_relaxation_steps: expected an integer.");
  if (count < Count(0) || static_cast<unsigned long long>(count) > (std::numeric_limits<unsigned>::max)())
    refuse("isotropic_remeshing()", std::string(name) + " is " + std::to_string(count) +
                                    "; it must be neither negative nor more than an unsigned int holds");
  return static_cast<unsigned>(count);
}

inline void set_sweeps(Recipe&, const Not_given&) {}
template <class Count>
void set_sweeps(Recipe& recipe, const Count& sweeps)
{
  recipe.sweeps = recipe.last_sweeps = count_from(sweeps, "number_of_relaxation_steps");
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_NAMED_PARAMETERS_H
