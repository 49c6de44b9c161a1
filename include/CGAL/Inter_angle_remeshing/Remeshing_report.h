// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_REMESHING_REPORT_H
#define CGAL_INTER_ANGLE_REMESHING_REMESHING_REPORT_H

#include <array>
#include <cstddef>
#include <vector>

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
    completed,        ///< all iterations were made, or the mesh had settled before
    cancelled,        ///< the callback returned `false`; the mesh holds the result so far, or is unchanged if that was
                      ///< before the finest level of a run with several, see `Recipe::multi_level`
    nothing_to_do     ///< the range is empty, or no iteration was asked for; the mesh is unchanged, and neither features nor bands
                      ///< were looked at
  };

  /// which edges were kept as features, beside the border
  enum class Features
  {
    none,             ///< none: found none, or none asked for
    marked,           ///< those marked by `edge_is_constrained_map`, `face_patch_map` or `sharpness_angle`
    all_sharp_edges,  ///< found by themselves, beside the borders of patches: the model is a CAD model, every edge of 40
                      ///< degrees and more, but for reliefs too fine for the target length, which `sharpness_angle(40)` keeps,
                      ///< and narrow fillets
    outstanding_edges ///< found by themselves, beside the borders of patches: long chains of edges that stand out of their
                      ///< surroundings, sharp edges that are smooth curves as a whole, creases of coarse models, narrow fillets of
                      ///< parts without a sharp edge, the sharp edges of components that are CAD models
  };

  /// the angles of a set of triangles, in degrees; a triangle with two equal corners counts in the extremes as of 0 and 180
  struct Angles
  {
    /// the smallest angle
    double minimum = 0;
    /// the largest angle
    double maximum = 0;
    /// θ<sub>avg</sub> = 60 − mean |θ − 60|
    double average = 0;
  };

  /// why an angle of a face is out of the band of `Recipe::lower_angle` and `Recipe::upper_angle`
  enum class Reason
  {
    input_corner,     ///< its angles out of the band are all too small, and lie between two border or feature edges: they are the input's
    border_or_feature,///< the face touches a border or a feature, which leave it no room
    no_operation      ///< no move, flip, collapse or split near it that policies and geometry allow mends it
  };

  /// a face of the result with an angle out of the band
  struct Face_out_of_band
  {
    /// its centroid, in the user's units
    std::array<double, 3> centroid;
    /// by how much the angle is out of the band, in degrees
    double violation;
    /// why
    Reason reason;
  };

  /// why the run ended
  Ending ending = Ending::nothing_to_do;
  /// the number of iterations made
  unsigned iterations = 0;
  /// the target edge length, in the user's units; with `Face_count`, the one that the run ended with; with a sizing field, the one
  /// length with which the range would have as many faces
  double target_edge_length = 0;
  /// which edges were kept as features
  Features features = Features::none;
  /// the number of these edges in the range before, marked ones and those that were found
  std::size_t feature_edges = 0;
  /// the number of faces in the range before
  std::size_t input_faces = 0;
  /// the number of faces in the range afterwards; those outside that `Recipe::split_rim` has divided do not count
  std::size_t output_faces = 0;
  /// the number of edges split; those of the repair count in `repairs`, those that lower distances in none
  std::size_t splits = 0;
  /// the number of edges collapsed, without those of the repair
  std::size_t collapses = 0;
  /// the number of edges flipped, without those of glides and of the clean-up's passes that move vertices, which flip single edges
  /// beside borders and features, and where they lower distances
  std::size_t flips = 0;
  /// the number of glides
  std::size_t glides = 0;
  /// the number of operations that mended angles out of the band, folds, and faces that crossed others
  std::size_t repairs = 0;
  /// the number of faces of the range that cross others of it in the end, or faces outside that are joined to its rim, as many do where
  /// the input crosses itself; two that share an edge do not; 0 where they were not looked for
  std::size_t crossing_faces = 0;
  /// whether they were looked for: `Recipe::clean_up` and `Recipe::repair` are on, vertices may move, and the target length is not
  /// much less than the altitudes of the surface's faces, or a face is out of the band, or there are faces outside of the range, or the
  /// projector knows no faces
  bool are_crossing_faces_known = false;
  /// the angles of the range before
  Angles angles_before;
  /// the angles of the range afterwards, as what follows in double precision: before points are rounded to those of the mesh, whose
  /// numbers may be of type `float`
  Angles angles_after;
  /// the number of faces with an angle out of the band; those whose angle is the input's count, too
  std::size_t number_of_faces_out_of_band = 0;
  /// the worst of them, at most 1000, the worst one first
  std::vector<Face_out_of_band> faces_out_of_band;
  /// whether the band holds: no angle is out of it but those that are the input's
  bool band_holds = false;
};

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_REMESHING_REPORT_H
