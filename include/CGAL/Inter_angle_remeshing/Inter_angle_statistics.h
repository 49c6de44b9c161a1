// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTER_ANGLE_STATISTICS_H
#define CGAL_INTER_ANGLE_REMESHING_INTER_ANGLE_STATISTICS_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
\ingroup PkgInterAngleRemeshingRef

@brief tells how close the triangles of a mesh come to equilateral ones. All angles are in degrees.

A *degenerate face* is one whose corners lie on a line, or coincide. Its angles are undefined or meaningless:
they are left out of the mean and of the histogram. In the extremes the face counts as 0 and 180 degrees,
so that a mesh with such a face cannot pass for a good one.

A default constructed object describes no face at all: every member is zero.
*/
struct Inter_angle_statistics
{
  /// the width of a bin of `histogram`, in degrees
  static constexpr double bin_width = 5;
  /// the valence of the vertices of a tiling with equilateral triangles
  static constexpr std::size_t regular_valence = 6;
  /// the number of faces looked at, degenerate ones included
  std::size_t number_of_faces = 0;
  /// the number of faces without an area
  std::size_t number_of_degenerate_faces = 0;
  /// the smallest angle; 0 where there is no face, or a degenerate one
  double minimum_angle = 0;
  /// the largest angle; 0 where there is no face, 180 where there is a degenerate one
  double maximum_angle = 0;
  /// \f$ \theta_{avg} = 60 - \frac{1}{n} \sum_i |\theta_i - 60| \f$ over the angles of the faces that are not
  /// degenerate: 60 for equilateral triangles and smaller for all others; 0 where there is no such face
  double average = 0;
  /// the number of *forced* faces, which no remesher can mend that keeps curves, that is the border and the edges of
  /// `edge_is_constrained_map`: faces with a corner of less than 60 degrees between two edges on curves, and faces with an
  /// edge on a curve between two of its corners (ends, junctions, turns of 45 degrees and more) that is less than half as
  /// long as their other two edges
  std::size_t number_of_forced_faces = 0;
  /// the smallest angle of the faces that are not forced; as `minimum_angle` where there is no such face
  double minimum_unforced_angle = 0;
  /// the largest angle of the faces that are not forced
  double maximum_unforced_angle = 0;
  /// `average` of the faces that are not forced
  double unforced_average = 0;
  /// how many angles lie in [0, 5), [5, 10), ..., [175, 180]; an angle that equals a bound but for rounding may be
  /// counted on either side of it
  std::array<std::size_t, 36> histogram = {};
  /// `valence_histogram[k]` vertices have valence `k`, for `k` up to the largest that occurs (empty if there is none).
  /// Counted are *interior* vertices: those around which every face exists and is in the range.
  std::vector<std::size_t> valence_histogram;

  /// returns the number of interior vertices. Complexity: linear in the largest valence.
  std::size_t number_of_interior_vertices() const
  {
    std::size_t count = 0;
    for (const std::size_t bin : valence_histogram) count += bin;
    return count;
  }

  /// returns the number of interior vertices of valence 6.
  std::size_t number_of_regular_vertices() const
  {
    return regular_valence < valence_histogram.size() ? valence_histogram[regular_valence] : 0;
  }

  /// returns the part of the interior vertices that has valence 6, in [0, 1]; 0 where there is no interior vertex.
  double regular_vertices() const
  {
    const std::size_t all = number_of_interior_vertices();
    return all == 0 ? 0. : double(number_of_regular_vertices()) / double(all);
  }

  /// returns `regular_vertices()` in percent.
  double percentage_of_regular_vertices() const { return 100 * regular_vertices(); }
};

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTER_ANGLE_STATISTICS_H
