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
