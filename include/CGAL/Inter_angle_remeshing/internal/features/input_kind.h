// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_INPUT_KIND_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_INPUT_KIND_H

#include <CGAL/Inter_angle_remeshing/Recipe.h>
#include <CGAL/Inter_angle_remeshing/Remeshing_report.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/target_of_run.h>
#include <CGAL/Inter_angle_remeshing/internal/compiled.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/constraints.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Rounded_edges.h>
#include <CGAL/Inter_angle_remeshing/internal/features/Wider_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// What the dihedral angles tell about the input.
struct Input_kind
{
  bool is_cad;                   // the dihedral angles tell a CAD model
  bool is_faceted;               // so they do, or a wrap, uneven facets, or stairs of voxels: faces are no samples of a smooth surface
  bool searches_features;        // its sharp edges were looked for, and those that were found are constrained
  Remeshing_report::Features features;
  std::size_t feature_edges;
  double saddle_excess;          // how noisy it is, see Model_kind::saddle_excess()
  Rounded_edges rounded_edges;   // among the features
  std::vector<char> is_in_faceted_part;      // by face of the range: of a component that is so alone; empty where none is
};

// The `target` is in the units of the mesh, as is the `mean_length` of its edges. Nothing is found where the input is not looked at, as
// where the run does not keep to its surface: a functor of the user's may lead to any other, a sphere for an icosahedron. Else features are
// found by themselves where nothing is marked, and crests of at most so many target lengths, whatever is marked; as these are there for the
// iterations alone, they are not counted. All that is looked for in the wider mesh, if there is one.
CGAL_INTER_ANGLE_REMESHING_INLINE
Input_kind find_and_mark_features(Remeshing_mesh& mesh, const Wider_mesh& wider, const Target& target, double mean_length,
                                  bool is_looked_at, double crest_width, const Recipe& recipe, const Constraint_settings& settings);

// How rough noise makes the stars of a mesh with edges of the target length: the shorter these are beside the input's, the rougher.
inline double noise(const Input_kind& kind, double mean_length, double target)
{
  return target > 0 ? kind.saddle_excess * (mean_length / target) * (mean_length / target) : 0.;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#ifndef CGAL_INTER_ANGLE_REMESHING_COMPILED
#  include <CGAL/Inter_angle_remeshing/internal/features/input_kind_impl.h>
#endif

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_FEATURES_INPUT_KIND_H
