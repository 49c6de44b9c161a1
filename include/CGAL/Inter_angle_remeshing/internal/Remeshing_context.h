// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHING_CONTEXT_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHING_CONTEXT_H

#include <CGAL/Inter_angle_remeshing/Recipe.h>
#include <CGAL/Inter_angle_remeshing/internal/Edge_rule.h>
#include <CGAL/Inter_angle_remeshing/internal/Move_rule.h>
#include <CGAL/Inter_angle_remeshing/internal/Run_visitor.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/Input_curves.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Surroundings.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/kept_places.h>
#include <CGAL/Inter_angle_remeshing/internal/sizing/grading.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/projection.h>

#include <CGAL/number_utils.h>

#include <limits>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Smallest cosine between normals before and after an operation that is not taken for a fold: 26 degrees.
constexpr double LITTLE_TURN_COSINE = 0.9;
// The largest number of flips that Recipe::glide_depth may ask for.
constexpr unsigned MAXIMUM_GLIDE_DEPTH = 16;

// What every pass works with: the mesh, the target length, and what the user handed over. It has one type, whatever the types of
// these are, so that the passes are compiled once.
struct Remeshing_context
{
  using Index = Remeshing_mesh::Index;

  Remeshing_context(Remeshing_mesh& mesh, const Surroundings& surroundings, const Recipe& recipe, const Input_curves& curves,
                    const Sizing& sizing, const Projection& projector, Run_visitor& visitor, double target_length)
    : mesh(mesh), surroundings(surroundings), recipe(recipe), curves(curves), sizing(sizing), projector(projector), visitor(visitor),
      target_length(target_length)
  {}

  Remeshing_mesh& mesh;
  const Surroundings& surroundings;
  const Recipe& recipe;
  const Input_curves& curves;
  const Sizing& sizing;
  const Projection& projector;
  Run_visitor& visitor;
  double target_length;                // in the units of the flat mesh
  Edge_rule split_rule = true, collapse_rule = true, flip_rule = true;
  Move_rule move_rule;
  bool keeps_vertices = false;         // nothing is split or collapsed: the target length is a scale, that of the edges that there are
  bool may_collapse_constraints = true;
  bool may_subdivide = true;           // no rule of the user's says which edges are split, collapsed or flipped, or what moves
  double release_distance = 0;         // of corners of features that may be given up, in target lengths; 0: none may
  double grading_rate = 0;             // at curves; 0: their short edges do not lower the target length
  bool may_have_necks = false;         // which lower the target length around them
  bool has_necks = false;
  double noise = 0;                    // of the input, beside the target length; 0: it is clean
  bool moves_spikes = false;           // sweeps do not spare the spikes of the noise
  double spike_factor = 1;             // how many times as far as Recipe::collapse_tolerance says a collapse may reach
  double collapse_reach = 1;           // how many times as long as splits leave edges those may be that collapses make
  const Input_locator* locator = nullptr;  // null where nobody asks for places
  Grading grading;
  Kept_places kept_places;             // while faces and angles are mended

  // Whether the target length differs from place to place.
  bool is_graded() const { return grading_rate > 0 || has_necks || !sizing.is_uniform(); }
  // Whether sweeps follow, in which no functor of the user's has a say.
  bool moves_freely() const { return recipe.sweeps > 0 && !move_rule.is_given(); }
  // Whether there are faces outside of the range; these hold its rim.
  bool has_outside() const { return !surroundings.faces.empty(); }
  // Whether nothing cuts the long edges of needles.
  bool keeps_long_edges() const { return split_rule.is_never(); }
  // Whether needles are held on their sides, by faces outside or by others that nothing cuts or collapses: to be pulled off the surface is
  // their way to grow.
  bool holds_needles() const { return has_outside() || keeps_long_edges() || collapse_rule.is_never(); }
  // The target length that the sizing field has at a vertex, and on an edge.
  double length_at(Index v) const { return grading.has_field() ? target_length * grading.field_part(v) : target_length; }
  double length_at(Index u, Index v) const
  {
    return grading.has_field() ? target_length * grading.field_part(u, v) : target_length;
  }
  double largest_length() const { return target_length * grading.largest_field_part(); }

  // How far a removed vertex may be from what replaces its star, where the target length is that of the run.
  double collapse_tolerance() const { return spike_factor * recipe.collapse_tolerance * target_length; }

  // The longest and the shortest that an edge between u and v, not on a curve, may be; squared.
  double squared_length_limit(Index u, Index v) const
  {
    return grading.is_uniform() ? squared_length_limit() : squared_length_limit() * CGAL::square(grading.part(u, v));
  }
  double squared_shortness_limit(Index u, Index v) const
  {
    return grading.is_uniform() ? squared_shortness_limit() : squared_shortness_limit() * CGAL::square(grading.part(u, v));
  }
  double squared_length_limit() const { return CGAL::square(recipe.split_ratio * target_length); }
  double squared_shortness_limit() const { return CGAL::square(recipe.collapse_ratio * target_length); }

  // Whether the target length is so much less than the mean altitude of the surface's faces that chords are too short to matter.
  bool is_finer_than_surface() const
  {
    constexpr double FINE = 0.5;
    const Reference_surface& surface = *projector.surface;
    double sum = 0;
    for (Index f = 0; f < Index(surface.number_of_faces()); ++f) sum += surface.least_altitude(f);
    return largest_length() < FINE * sum / (double(surface.number_of_faces()) * projector.factor);
  }

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

  // Whether the edge of h, on a curve, may be collapsed: the user may deny that for the border and for what is marked.
  bool may_collapse_along_curve(Index h) const
  {
    return may_collapse_constraints || mesh.has_flag(h < 0 ? ~h : h, Remeshing_mesh::FOUND);
  }
  bool permits_split(Index h) const { return permits(split_rule, h, false); }
  bool permits_collapse(Index h) const { return permits(collapse_rule, h, false); }
  bool permits_flip(Index h, bool is_transient) const { return permits(flip_rule, h, is_transient); }
  // Whether v may move from where it is.
  bool permits_move(Index v, const Vector3& to) const { return move_rule(mesh, v, mesh.position(v), to); }

private:
  bool permits(const Edge_rule& rule, Index h, bool is_transient) const
  {
    const Index side = h >= 0 ? h : ~h;      // of a border side, the other one
    const double length = keeps_vertices ? std::numeric_limits<double>::infinity()
                                         : mesh.unit() * length_at(mesh.origin(side), mesh.target(side));
    return rule(mesh, length, h, is_transient);
  }
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_REMESHING_CONTEXT_H
