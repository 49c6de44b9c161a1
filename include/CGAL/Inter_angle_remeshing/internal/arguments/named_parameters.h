// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_NAMED_PARAMETERS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_NAMED_PARAMETERS_H

#include <CGAL/Inter_angle_remeshing/Recipe.h>
#include <CGAL/Inter_angle_remeshing/internal/Edge_rule.h>
#include <CGAL/Inter_angle_remeshing/internal/Run_visitor.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/numbers.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/refuse.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/target_of_run.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/constraints.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_type_config.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

// From what get_parameter() yields to what the remesher takes. Types have passed Argument_check; a value that is wrong is
// refused in words.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

using Not_given = CGAL::internal_np::Param_not_found;

template <class NamedParameters, class Tag>
constexpr bool has_parameter()
{
  using Given = typename CGAL::internal_np::Get_param<typename NamedParameters::base, Tag>::type;
  return !std::is_same<Given, Not_given>::value;
}

template <class T>
struct Is_named_parameters : std::false_type {};
template <class T, class Tag, class Base>
struct Is_named_parameters<CGAL::Named_function_parameters<T, Tag, Base>> : std::true_type {};

inline No_map or_no_map(const Not_given&) { return {}; }
template <class Map>
Map or_no_map(const Map& map) { return map; }

template <class Preset>
Preset policy_from(const Not_given&, const Preset& preset) { return preset; }

// A policy, or a bool that stands for all edges.
template <class Given, class Preset>
auto policy_from(const Given& given, const Preset&)
{
  if constexpr (Is_choice<Given>::value) return bool(given); else return given;
}

// Whether no rule of the user's was given.
inline bool is_left_to_the_recipe(const Not_given&) { return true; }
template <class Given>
bool is_left_to_the_recipe(const Given& given)
{
  if constexpr (Is_choice<Given>::value) return bool(given);
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
  return callback;
}

template <class Angle>
double sharpness_cosine(const Angle& angle)
{
  const double degrees = number_to_double(angle);
  if (!(degrees >= 0 && degrees <= 180))
    refuse("isotropic_remeshing()", "sharpness_angle is " + to_text(degrees) + "; it must lie in [0, 180]");
  return degrees < 180 ? std::cos(degrees * (CGAL_PI / 180)) : -2;
}

// What a number has behind the point is dropped.
template <class Count>
unsigned count_from(const Count& count, const char* name)
{
  const double x = number_to_double(count);
  if (!(x >= 0 && x <= double((std::numeric_limits<unsigned>::max)())))
    refuse("isotropic_remeshing()", std::string(name) + " is " + to_text(x) +
                                    "; it must be neither negative nor more than an unsigned int holds");
  return static_cast<unsigned>(x);
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

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_NAMED_PARAMETERS_H
