// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_RUN_WITH_PROJECTOR_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_RUN_WITH_PROJECTOR_H

#include <CGAL/Inter_angle_remeshing/Recipe.h>
#include <CGAL/Inter_angle_remeshing/Remeshing_report.h>
#include <CGAL/Inter_angle_remeshing/internal/Default_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/constraints.h>
#include <CGAL/Inter_angle_remeshing/internal/edge_lengths.h>
#include <CGAL/Inter_angle_remeshing/internal/input_kind.h>
#include <CGAL/Inter_angle_remeshing/internal/paper_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/projection.h>
#include <CGAL/Inter_angle_remeshing/internal/projector_traits.h>
#include <CGAL/Inter_angle_remeshing/internal/referred.h>
#include <CGAL/Inter_angle_remeshing/internal/starting_places.h>
#include <CGAL/Inter_angle_remeshing/internal/target_of_run.h>

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

// A surface that the user handed over. Where it is a copy of the input, walks over it keep to the patches of the run, and
// begin where the vertices are.
class Handed_surface
{
public:
  using Index = Remeshing_mesh::Index;

  Handed_surface(const Reference_surface& surface, const Remeshing_mesh& mesh)
    : surface_(surface), factor_(mesh.unit() / surface.unit())
  {
    if (mesh.number_of_face_slots() != surface.number_of_faces()) return;
    face_of_source_ = faces_by_source(surface);
    if (!is_copy_of(mesh)) { face_of_source_.clear(); return; }
    std::vector<Index> barriers;
    mesh.for_each_halfedge([&](Index h) { if (mesh.is_constrained(h)) barriers.push_back(halfedge_of(mesh, h)); });
    if (!barriers.empty()) patched_.emplace(surface, barriers);
  }

  Projection projection() const
  {
    Projection result{patched_ ? &*patched_ : &surface_, factor_};
    if (!face_of_source_.empty()) result.face_of_source = &face_of_source_;
    return result;
  }

  void start(Remeshing_mesh& mesh) const
  {
    if (face_of_source_.empty()) { find_hints(mesh, projection()); return; }
    for (Index v = 0; v < Index(mesh.number_of_vertex_slots()); ++v)
      mesh.hint(v) = surface_.face(halfedge_of(mesh, mesh.first(v)));
  }

private:
  // The half-edge of the surface that is the mesh's.
  Index halfedge_of(const Remeshing_mesh& mesh, Index h) const
  {
    return 4 * face_of_source_[mesh.face_record(mesh.face(h)).source] + mesh.corner(h);
  }
  bool is_copy_of(const Remeshing_mesh& mesh) const
  {
    bool result = true;
    mesh.for_each_halfedge([&](Index h) {
      const Index v = surface_.origin(halfedge_of(mesh, h));
      result = result && factor_ * mesh.position(mesh.origin(h)) == surface_.position(v);
    });
    return result;
  }

  const Reference_surface& surface_;
  double factor_;                              // from the units of the run to those of the surface
  std::optional<Reference_surface> patched_;
  std::vector<Index> face_of_source_;          // empty: the surface is another one
};

// Runs the remesher with a functor of the user's.
template <class Run>
Remeshing_report run_with_rule(double unit, bool is_concurrent, const std::function<Vector3(const Vector3&)>& rule, const Run& run)
{
  Projection projection;
  projection.factor = unit;
  projection.rule = &rule;
  projection.is_concurrent = is_concurrent;
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
    const Handed_surface surface(functor.reference_surface(), mesh);
    surface.start(mesh);
    Projection projection = surface.projection();
    if constexpr (Has_mls_surface<Functor>::value) projection.mls = &functor.mls_surface();
    return run(projection);
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

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_RUN_WITH_PROJECTOR_H
