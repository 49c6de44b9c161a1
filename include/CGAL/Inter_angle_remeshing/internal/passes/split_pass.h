// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_SPLIT_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_SPLIT_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/curve_edges.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/evaluate_then_apply.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/folds.h>

#include <cmath>
#include <vector>

// Splits edges that are longer than Recipe::split_ratio times the target length at their midpoints (Zheng and Lv, edge splitting);
// those on curves in the middle of their arcs, and also where they leave the curve.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// A vertex that a split made, and the two faces of the surface from which its place on it is looked for.
struct Split_vertex
{
  Remeshing_mesh::Index vertex, hint, other_hint;
};

// An apex's place on the surface is near enough to an edge to begin from if it is no farther than this part of the edge.
constexpr double CLOSE_TO_EDGE = 0.01;

// Before the edge of h is split: where its ends were projected, as far as they are free. One on a curve says nothing about the side of the
// curve; then the apexes are asked, or, where these are from farther away, the input faces that the faces beside descend from: an apex that
// this pass has made has not been projected yet, and along a strip each would hand on where the first one began.
inline Split_vertex split_hints(const Remeshing_context& context, Remeshing_mesh::Index h)
{
  using Index = Remeshing_mesh::Index;
  const Remeshing_mesh& mesh = context.mesh;
  const Projection& projector = context.projector;
  const Index o = mesh.opposite(h), face = mesh.face(h), across = o >= 0 ? mesh.face(o) : face;
  const auto hints = [&](Index u, Index v) {
    const bool has_u = !mesh.is_on_curve(u), has_v = !mesh.is_on_curve(v);
    return Split_vertex{-1, mesh.hint(has_u ? u : v), has_u || has_v ? mesh.hint(has_v ? v : u) : Index(-1)};
  };
  const Split_vertex of_ends = hints(mesh.origin(h), mesh.target(h));
  if (of_ends.other_hint >= 0) return of_ends;
  const Split_vertex of_apexes = hints(mesh.apex(h), mesh.apex(o >= 0 ? o : h));
  const Index source = projector.face_of(mesh.face_record(face).source);
  if (source < 0) return {-1, of_apexes.hint, of_apexes.other_hint >= 0 ? of_apexes.other_hint : of_apexes.hint};
  const Index source_across = projector.face_of(mesh.face_record(across).source);
  if (of_apexes.hint < 0 || of_apexes.other_hint < 0) return {-1, source, source_across};
  const Vector3 middle = 0.5 * (mesh.position(mesh.origin(h)) + mesh.position(mesh.target(h)));
  const double enough = CLOSE_TO_EDGE * CLOSE_TO_EDGE * mesh.squared_edge_length(h);
  const auto start = [&](Index of_apex, Index of_source) {
    const double d = projector.squared_distance_to_face(middle, of_apex);
    return d <= enough || d <= projector.squared_distance_to_face(middle, of_source) ? of_apex : of_source;
  };
  return {-1, start(of_apexes.hint, source), start(of_apexes.other_hint, source_across)};
}

// New vertices that one task projects; a walk takes about 50 ns.
constexpr std::size_t PROJECTION_BLOCK = 256;

// Whether the faces around v keep their orientation when v moves to p: no normal turns by more than 60 degrees.
inline bool keeps_orientation(const Remeshing_mesh& mesh, Remeshing_mesh::Index v, const Vector3& p)
{
  return mesh.all_around(v, [&](Remeshing_mesh::Index h) {
    const Vector3 &a = mesh.position(mesh.target(h)), &b = mesh.position(mesh.apex(h)), &q = mesh.position(v);
    return is_cosine_at_least(triangle_cross(q, a, b), triangle_cross(p, a, b), 0.5);
  });
}

// A walk to the place of a new vertex may end before a fold: where it ends further away than this part of an edge, others are tried.
constexpr double FAR_FROM_SURFACE = 0.05;

// Where on the surface a new vertex belongs: near one of the two places where the ends of its edge were projected, or, where these
// are far, near one of the input faces that the faces around descend from.
inline Vector3 project_split_vertex(const Remeshing_context& context, const Split_vertex& split, Remeshing_mesh::Index& hint)
{
  using Index = Remeshing_mesh::Index;
  const Remeshing_mesh& mesh = context.mesh;
  const Projection& projector = context.projector;
  const Vector3& q = mesh.position(split.vertex);
  hint = split.hint;
  Vector3 result = projector(q, hint);
  const auto look_from = [&](Index start) {
    const Vector3 p = projector(q, start);
    if (!(squared_distance(p, q) < squared_distance(result, q))) return;
    result = p;
    hint = start;
  };
  if (split.other_hint != split.hint) look_from(split.other_hint);
  const double near_by = FAR_FROM_SURFACE * FAR_FROM_SURFACE * mesh.squared_edge_length(mesh.first(split.vertex));
  if (!projector.is_input() || squared_distance(result, q) <= near_by) return result;
  mesh.for_each_around(split.vertex, [&](Index h) { look_from(projector.face_of(mesh.face_record(mesh.face(h)).source)); });
  return result;
}

// Moves the new vertices that do not lie on a curve onto the surface. Where that would fold the surface over, they stay on the edge.
template <class ConcurrencyTag>
void project_split_vertices(Remeshing_context& context, const std::vector<Split_vertex>& split)
{
  using Index = Remeshing_mesh::Index;
  Remeshing_mesh& mesh = context.mesh;
  std::vector<Vector3> projected(split.size());
  for_each_block_if<ConcurrencyTag>(context.projector.is_concurrent, split.size(), PROJECTION_BLOCK,
                                    [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i)
      projected[i] = project_split_vertex(context, split[i], mesh.hint(split[i].vertex));
  });
  for (std::size_t i = 0; i < split.size(); ++i) {
    const Index v = split[i].vertex;
    if (mesh.is_free(v) && keeps_orientation(mesh, v, projected[i])) mesh.position(v) = projected[i];
  }
}

// Whether a triangle at the edge of h has an edge more than 1.5 times as long. That one goes first, or needles would
// multiply; where it is protected, to halve the others would only make the triangle flat.
inline bool is_beside_much_longer_edge(const Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  const double bound = 2.25 * mesh.squared_edge_length(h);
  for (const Remeshing_mesh::Index side : {h, mesh.opposite(h)})
    if (side >= 0 && (mesh.squared_edge_length(mesh.next(side)) > bound ||
                      mesh.squared_edge_length(mesh.prev(side)) > bound)) return true;
  return false;
}

// Where a split puts its vertex before it is projected.
inline Vector3 split_point(const Remeshing_context& context, Remeshing_mesh::Index h)
{
  const Remeshing_mesh& mesh = context.mesh;
  return mesh.has_place(h) ? middle_on_curve(context, h)
                           : 0.5 * (mesh.position(mesh.origin(h)) + mesh.position(mesh.target(h)));
}

// Splits the edge of h; the new vertex is yet to be projected.
inline Split_vertex split_edge(Remeshing_context& context, Remeshing_mesh::Index h)
{
  Remeshing_mesh& mesh = context.mesh;
  Split_vertex made = split_hints(context, h);
  const Remeshing_mesh::Index a = mesh.origin(h), b = mesh.target(h);
  made.vertex = mesh.split(h, split_point(context, h));
  context.grading.inherit(made.vertex, a, b);
  mesh.hint(made.vertex) = made.hint;
  return made;
}

// The same; the visitor is told.
inline Split_vertex split(Remeshing_context& context, Remeshing_mesh::Index h)
{
  context.visitor.before_split(Mesh_halfedge(h), context.mesh);
  const Split_vertex made = split_edge(context, h);
  context.visitor.after_split(Mesh_vertex(made.vertex), context.mesh);
  return made;
}

// Whether a face at the edge of h is a needle along it: the edge is longer than that many target lengths, and the face is lower
// than one, but not by far. Divided all along at once, such faces are not many more than the run will need; as long ones,
// turned a little, they would cut through thin walls.
inline bool is_beside_needle(const Remeshing_context& context, Remeshing_mesh::Index h, double target_lengths)
{
  constexpr double THIN = 0.05;                     // altitude, in target lengths
  const Remeshing_mesh& mesh = context.mesh;
  const double length = context.length_at(mesh.origin(h)), edge = std::sqrt(mesh.squared_edge_length(h));
  if (edge < target_lengths * length) return false;
  for (const Remeshing_mesh::Index side : {h, mesh.opposite(h)}) {
    if (side < 0) continue;
    const double altitude = internal::length(mesh.cross_product(mesh.face(side))) / edge;
    if (altitude < length && altitude > THIN * length) return true;
  }
  return false;
}

// Splits the edges of `long_edges` as far as they are still too long, and what is left of needles; appends short edges at new vertices to
// `short_edges`. Edges to which a split has given other half-edges are left to the next pass. Returns the number of splits.
template <class ConcurrencyTag>
std::size_t split_pass(Remeshing_context& context, std::vector<Remeshing_mesh::Index>& long_edges,
                       std::vector<Remeshing_mesh::Index>& short_edges)
{
  using Index = Remeshing_mesh::Index;
  Remeshing_mesh& mesh = context.mesh;
  const auto is_too_long = [&](Index h) {
    return mesh.has_place(h) ? is_too_long_on_curve(context, h)
                             : mesh.squared_edge_length(h) > context.squared_length_limit(mesh.origin(h), mesh.target(h));
  };
  // Those at the ends of strips before what leads across: what lies between the halves of that is no strip any more.
  std::vector<Index> curve_edges = long_curve_edges<ConcurrencyTag>(context);
  const auto others = std::stable_partition(curve_edges.begin(), curve_edges.end(), [&](Index h) { return is_at_end_of_strip(context, h); });
  long_edges.insert(long_edges.end(), others, curve_edges.end());
  long_edges.insert(long_edges.begin(), curve_edges.begin(), others);

  // Of needles: how long a part is split at once, and an edge beside it, in target lengths.
  constexpr double LONG_PART = 2, LONG_NEIGHBOR = 4;
  const auto append_needle = [&](Index h, double target_lengths) {
    if (is_too_long(h) && is_beside_needle(context, h, target_lengths)) long_edges.push_back(h);
  };

  std::vector<Split_vertex> made_vertices;
  evaluate_then_apply<ConcurrencyTag>(mesh, long_edges,
    [&](Index h) -> bool {
      if (!is_too_long(h) || !mesh.is_split_legal(h) || is_beside_much_longer_edge(mesh, h)) return false;
      const Vector3 p = split_point(context, h);
      return p != mesh.position(mesh.origin(h)) && p != mesh.position(mesh.target(h)) && context.permits_split(h);
    },
    [&](Index h, bool is_to_split) {
      if (!is_to_split) return;
      const Split_vertex made = internal::split(context, h);
      made_vertices.push_back(made);
      mesh.for_each_around(made.vertex, [&](Index k) {
        if (mesh.squared_edge_length(k) < context.squared_shortness_limit(made.vertex, mesh.target(k))) short_edges.push_back(k);
        append_needle(k, LONG_PART);
        append_needle(mesh.next(k), LONG_NEIGHBOR);
      });
    });
  project_split_vertices<ConcurrencyTag>(context, made_vertices);
  return made_vertices.size();
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_SPLIT_PASS_H
