// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_RUN_WITH_PROJECTOR_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_RUN_WITH_PROJECTOR_H

#include <CGAL/Inter_angle_remeshing/Recipe.h>
#include <CGAL/Inter_angle_remeshing/Remeshing_report.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/projector_traits.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/referred.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/target_of_run.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/constraints.h>
#include <CGAL/Inter_angle_remeshing/internal/features/input_kind.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/projection.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/run_on_surface.h>

#include <boost/property_map/property_map.hpp>

#include <functional>
#include <type_traits>

// What the named parameter `projection_functor` stands for.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Runs the remesher with a functor of the user's.
template <class Run>
Remeshing_report run_with_rule(double unit, bool is_concurrent, const std::function<Vector3(const Vector3&)>& rule, const Run& run)
{
  Projection projection;
  projection.factor = unit;
  projection.rule = &rule;
  projection.is_concurrent = is_concurrent;
  projection.may_be_elsewhere = true;
  return run(projection);
}

// Calls `run(projection)` with the projector that the functor asks for, or `run(projection, restore)` where the user's mesh must be
// restored after the passes. A wanted number of faces is one of the surface that the result lies on: the target length follows its area.
template <class Parameters, class Exchange, class Run>
Remeshing_report run_with_projector(const Parameters& parameters, const Exchange& exchange, Remeshing_mesh& mesh,
                                    const Input_kind& kind, Input_curves& curves, Target& target, const Run& run)
{
  using Vertex = std::decay_t<decltype(exchange.input_vertices()[0])>;
  using Point_3 = typename boost::property_traits<decltype(parameters.vertex_point_map)>::value_type;
  const auto& functor = referred(parameters.projection_functor);
  using Functor = std::decay_t<decltype(functor)>;
  if (!parameters.does_project) return run(Projection());
  if constexpr (std::is_same<Functor, No_map>::value)
    return run_on_own_surface(mesh, parameters.recipe, kind, curves, target, run);
  else if constexpr (Has_reference_surface<Functor>::value) {
    const Mls_surface* mls = nullptr;
    if constexpr (Has_mls_surface<Functor>::value) mls = &functor.mls_surface();
    return run_on_handed_surface(functor.reference_surface(), mls, mesh, run);
  } else if constexpr (std::is_invocable_r<Point_3, const Functor&, const Point_3&>::value)
    return run_with_rule(mesh.unit(), true, [&](const Vector3& p) {
      return internal::to_vector3(Point_3(functor(Point_3(p.x, p.y, p.z)))); }, run);
  else {
    const Carrier_vertex<Functor, Vertex, decltype(parameters.vertex_point_map)> carrier(
      functor, exchange.input_vertices().front(), parameters.vertex_point_map);
    return run_with_rule(mesh.unit(), false, std::cref(carrier), [&](const Projection& projection) {
      return run(projection, [&]() { carrier.restore(); }); });
  }
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_ARGUMENTS_RUN_WITH_PROJECTOR_H
