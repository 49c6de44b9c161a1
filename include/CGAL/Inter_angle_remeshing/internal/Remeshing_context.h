// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHING_CONTEXT_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHING_CONTEXT_H

#include <CGAL/Inter_angle_remeshing/Default_visitor.h>
#include <CGAL/Inter_angle_remeshing/Edge_profile.h>
#include <CGAL/Inter_angle_remeshing/Recipe.h>
#include <CGAL/Inter_angle_remeshing/internal/Input_curves.h>
#include <CGAL/Inter_angle_remeshing/internal/grading.h>
#include <CGAL/Inter_angle_remeshing/internal/Remeshing_mesh_graph.h>

#include <CGAL/tags.h>

#include <type_traits>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The profile that policies are asked with during a run.
template <class InputVertex>
using Run_profile = Edge_profile<Remeshing_mesh, Mesh_point_map, Mesh_edge_is_constrained_map,
                                 Mesh_input_vertex_map<InputVertex>>;

// A bool in place of a policy.
struct Constant_policy
{
  bool value = true;

  template <class Profile>
  bool operator()(const Profile&) const { return value; }
};

template <class Policy>
bool is_never(const Policy&) { return false; }
inline bool is_never(const Constant_policy& policy) { return !policy.value; }

// Smallest cosine between normals before and after an operation that is not taken for a fold: 26 degrees.
constexpr double LITTLE_TURN_COSINE = 0.9;

// What every pass works with: the mesh, the target length, and the user's functors.
template <class InputVertex, class SplitPolicy, class CollapsePolicy, class FlipPolicy, class Projector, class Visitor>
struct Remeshing_context
{
  using Index = Remeshing_mesh::Index;
  // Passes that call the projector run sequentially where it can be called by one thread only.
  template <class ConcurrencyTag>
  using Projection_tag = std::conditional_t<Projector::IS_CONCURRENT, ConcurrencyTag, CGAL::Sequential_tag>;

  Remeshing_mesh& mesh;
  const Recipe& recipe;
  const Input_curves& curves;
  const std::vector<InputVertex>& input_vertices;
  InputVertex null_vertex;
  const SplitPolicy& split_policy;
  const CollapsePolicy& collapse_policy;
  const FlipPolicy& flip_policy;
  const Projector& projector;
  Visitor& visitor;
  bool may_collapse_constraints;
  double target_length;                // in the units of the flat mesh; 0: nothing is split or collapsed

  bool may_subdivide;                  // no rule of the user's says which edges are split, collapsed or flipped
  double grading_rate;                 // 0: the target length is uniform
  Grading grading;

  // The longest and the shortest that an edge between u and v, not on a curve, may be; squared.
  double squared_length_limit(Index u, Index v) const
  {
    return grading.is_uniform() ? squared_length_limit() : squared_length_limit() * squared(grading.part(u, v));
  }
  double squared_shortness_limit(Index u, Index v) const
  {
    return grading.is_uniform() ? squared_shortness_limit() : squared_shortness_limit() * squared(grading.part(u, v));
  }
  double squared_length_limit() const { return squared(recipe.split_ratio * target_length); }
  double squared_shortness_limit() const { return squared(recipe.collapse_ratio * target_length); }

  // Whether a face with these corners turns its back on the surface at one of them: a fold, or soon to be one. On a
  // curve the surface looks several ways.
  bool is_turned_over(Index a, Index b, Index c) const
  {
    const Vector3 normal = triangle_cross(mesh.position(a), mesh.position(b), mesh.position(c));
    const auto is_opposite_at = [&](Index v) {
      return !mesh.is_on_curve(v) && projector.is_opposite(mesh.hint(v), normal);
    };
    return is_opposite_at(a) || is_opposite_at(b) || is_opposite_at(c);
  }

  bool permits_split(Index h) const { return permits(split_policy, h, false); }
  bool permits_collapse(Index h) const { return permits(collapse_policy, h, false); }
  bool permits_flip(Index h, bool is_transient) const { return permits(flip_policy, h, is_transient); }

private:
  static double squared(double x) { return x * x; }

  bool permits(const Constant_policy& policy, Index, bool) const { return policy.value; }

  template <class Policy>
  bool permits(const Policy& policy, Index h, bool is_transient) const
  {
    return policy(Run_profile<InputVertex>(Mesh_halfedge(h), mesh, Mesh_point_map{&mesh}, mesh.unit() * target_length,
                                           is_transient, Mesh_edge_is_constrained_map{&mesh},
                                           Mesh_input_vertex_map<InputVertex>{&mesh, &input_vertices, null_vertex},
                                           1 / mesh.unit()));
  }
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHING_CONTEXT_H
