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
#include <CGAL/Inter_angle_remeshing/internal/mesh/edge_lengths.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Default_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Part_of_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/paper_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/projection.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/starting_places.h>

#include <cmath>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

// What the named parameter `projection_functor` stands for.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A surface that the user handed over. Where the mesh is a part of it, all of it or a range of its faces, the projection is onto a copy of
// that part: walks keep to it and to the patches of the run, and begin where the vertices are.
class Handed_surface
{
public:
  using Index = Remeshing_mesh::Index;

  // `mls`, if there is one, smooths the surface and knows no other.
  Handed_surface(const Reference_surface& surface, const Mls_surface* mls, Remeshing_mesh& mesh)
    : projection_{&surface, mesh.unit() / surface.unit(), mls}
  {
    const Part_of_surface part(mesh, surface, projection_.factor);
    if (!part.is_part()) {
      projection_.may_be_elsewhere = true;
      if (looks_to_other_side(mesh, surface, projection_.factor)) projection_.side = -1;
      find_hints(mesh, projection_);
      return;
    }
    copy_.emplace(mesh);
    if (mls != nullptr) mls_.emplace(*mls, *copy_, 1 / projection_.factor, [&](Index h) { return part.halfedge(h); });
    projection_ = Projection{&*copy_, 1, mls_ ? &*mls_ : nullptr};
    face_of_source_ = faces_by_source(*copy_);
    projection_.face_of_source = &face_of_source_;
    start_where_vertices_are(mesh);
  }
  Handed_surface(const Handed_surface&) = delete;            // the projection refers to what it holds
  Handed_surface& operator=(const Handed_surface&) = delete;

  const Projection& projection() const { return projection_; }

private:
  Projection projection_;
  std::optional<Reference_surface> copy_;
  std::optional<Mls_surface> mls_;
  std::vector<Index> face_of_source_;
};

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
  if constexpr (std::is_same<Functor, No_map>::value) {
    if (parameters.recipe.surface == Recipe::Surface::paper) {
      const Reference_surface facets(mesh);
      const std::vector<Remeshing_mesh::Index> face_of_source = faces_by_source(facets);
      const auto rule = paper_surface(facets, find_features(mesh));
      start_where_vertices_are(mesh);
      Projection projection{&facets};
      projection.face_of_source = &face_of_source;
      if (rule) projection.rule = &rule;
      return run(projection);
    }
    const Default_surface surface(mesh, target.length, target.sizing, kind);
    start_where_vertices_are(mesh);
    surface.bend(curves, mean_edge_length(mesh), mesh);
    if (target.faces > 0) target.length *= std::sqrt(surface.area_ratio());
    return run(surface.projection());
  } else if constexpr (Has_reference_surface<Functor>::value) {
    const Mls_surface* mls = nullptr;
    if constexpr (Has_mls_surface<Functor>::value) mls = &functor.mls_surface();
    return run(Handed_surface(functor.reference_surface(), mls, mesh).projection());
  } else if constexpr (std::is_invocable_r<Point_3, const Functor&, const Point_3&>::value)
    return run_with_rule(mesh.unit(), true, [&](const Vector3& p) {
      return to_vector3(Point_3(functor(Point_3(p.x, p.y, p.z)))); }, run);
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
