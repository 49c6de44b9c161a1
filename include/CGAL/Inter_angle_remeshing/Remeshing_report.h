// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_REMESHING_REPORT_H
#define CGAL_INTER_ANGLE_REMESHING_REMESHING_REPORT_H

#include <cstddef>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
\ingroup PkgInterAngleRemeshingRef

@brief what `isotropic_remeshing()` did.
*/
struct Remeshing_report
{
  /// why the run ended
  enum class Ending
  {
    completed,        ///< all iterations were made
    cancelled,        ///< the callback returned `false`; the mesh holds the result so far
    nothing_to_do     ///< the range is empty, or no iteration was asked for; the mesh is unchanged
  };

  /// which edges were kept as features, beside the border
  enum class Features
  {
    none,             ///< none: found none, or none asked for
    marked,           ///< those marked by `edge_is_constrained_map`, `face_patch_map` or `sharpness_angle`
    all_sharp_edges,  ///< found by themselves: the model is a CAD model, every edge of 40 degrees and more
    outstanding_edges ///< found by themselves: long chains of edges that stand out of their surroundings
  };

  /// the angles of a set of triangles, in degrees
  struct Angles
  {
    /// the smallest angle
    double minimum = 0;
    /// the largest angle
    double maximum = 0;
    /// θ<sub>avg</sub> = 60 − mean |θ − 60|
    double average = 0;
  };

  /// why the run ended
  Ending ending = Ending::nothing_to_do;
  /// the number of iterations made
  unsigned iterations = 0;
  /// the target edge length, in the user's units; with `Face_count`, the one that the run ended with
  double target_edge_length = 0;
  /// which edges were kept as features
  Features features = Features::none;
  /// the number of these edges in the range before
  std::size_t feature_edges = 0;
  /// the number of faces in the range before
  std::size_t input_faces = 0;
  /// the number of faces in the range afterwards
  std::size_t output_faces = 0;
  /// the number of edges split
  std::size_t splits = 0;
  /// the number of edges collapsed
  std::size_t collapses = 0;
  /// the number of edges flipped, those of glides left out
  std::size_t flips = 0;
  /// the number of glides
  std::size_t glides = 0;
  /// the angles of the range before
  Angles angles_before;
  /// the angles of the range afterwards
  Angles angles_after;
};

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_REMESHING_REPORT_H
