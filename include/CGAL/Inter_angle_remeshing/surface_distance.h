// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_SURFACE_DISTANCE_H
#define CGAL_INTER_ANGLE_REMESHING_SURFACE_DISTANCE_H

#include <CGAL/Inter_angle_remeshing/internal/arguments/refuse.h>
#include <CGAL/Inter_angle_remeshing/internal/measures/Normalized_surface.h>
#include <CGAL/Inter_angle_remeshing/internal/measures/one_sided_distance.h>
#include <CGAL/Inter_angle_remeshing/internal/measures/surface_samples.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
\ingroup PkgInterAngleRemeshingRef

@brief tells how far two surfaces are apart, in both directions. Lengths are in the unit of the coordinates.

The maxima are taken over finitely many points of a surface, so they are lower bounds of the Hausdorff distances.
*/
struct Surface_distance
{
  /// the largest distance from a point of the first surface to the second one
  double hausdorff_1_to_2 = 0;
  /// the largest distance from a point of the second surface to the first one
  double hausdorff_2_to_1 = 0;
  /// the mean distance from the points of the first surface to the second one, every area counting the same
  double mean_1_to_2 = 0;
  /// the mean distance from the points of the second surface to the first one, every area counting the same
  double mean_2_to_1 = 0;
  /// the length of the diagonal of the bounding box of the faces of the first mesh
  double diagonal = 0;

  /// returns the larger of the two Hausdorff distances.
  double hausdorff() const { return (std::max)(hausdorff_1_to_2, hausdorff_2_to_1); }

  /// returns the larger of the two mean distances.
  double mean() const { return (std::max)(mean_1_to_2, mean_2_to_1); }

  /// returns `hausdorff()` as a fraction of `diagonal`; 0 where that is 0.
  double relative_hausdorff() const { return relative(hausdorff()); }

  /// returns `mean()` as a fraction of `diagonal`; 0 where that is 0.
  double relative_mean() const { return relative(mean()); }

private:
  double relative(double length) const { return diagonal == 0 ? 0. : length / diagonal; }
};

namespace internal {
namespace measures {

struct Sampling_options
{
  std::size_t number = 100000;           // the mean is then known to about 1 / sqrt(100000), that is, 0.3% of itself
  std::uint64_t seed = 0;
};

// What `np` says, or else `defaults`.
template <class NamedParameters>
Sampling_options sampling_options(const NamedParameters& np, const Sampling_options& defaults)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto number = choose_parameter(get_parameter(np, internal_np::number_of_points_on_faces), defaults.number);
  const auto seed = choose_parameter(get_parameter(np, internal_np::random_seed), defaults.seed);
  if (!(number >= 1))
    refuse("number_of_points_on_faces >= 1",
           "number_of_points_on_faces is " + internal::to_text(double(number)) + "; it must be at least 1", __FILE__, __LINE__);
  return {std::size_t(number), std::uint64_t(seed)};
}

} // namespace measures
} // namespace internal

/*!
\ingroup PkgInterAngleRemeshingRef

@brief measures how far two surfaces are apart: the Hausdorff distance and the mean distance, in both directions.

From each surface random points are taken, of which every part gets a number in proportion to its area; the mean is
the one of their distances to the other surface. The maximum is also taken over the vertices of the faces, where a
surface often is farthest from the other one. The distances of these points are exact but for rounding.

The result is the same, to the last bit, in every run, for every `ConcurrencyTag` and number of threads; with the
same sampling parameters for both meshes, interchanging the meshes interchanges the two directions (and `diagonal` is
that of the other mesh). The random numbers are the same on every platform.

@tparam ConcurrencyTag `CGAL::Sequential_tag` (the default), `CGAL::Parallel_tag` or
        `CGAL::Parallel_if_available_tag`; `CGAL::Parallel_tag` requires \ref thirdpartyTBB
@tparam TriangleMesh1 a model of `FaceListGraph` and `VertexListGraph`
@tparam TriangleMesh2 a model of `FaceListGraph` and `VertexListGraph`
@tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
@tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"

@param tm1 the first triangulated surface mesh; its bounding box is the one of `Surface_distance::diagonal`
@param tm2 the second triangulated surface mesh
@param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters" for `tm1`, among the ones listed below
@param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters" for `tm2`, among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of the mesh}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a `Point_3` of any kernel
                   as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_points_on_faces}
    \cgalParamDescription{the number of random points on the mesh}
    \cgalParamType{an integer number, positive}
    \cgalParamDefault{`100000` in `np1`; the number for `tm1` in `np2`}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{the seed of the random points on the mesh}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{`0` in `np1`; the seed for `tm1` in `np2`}
  \cgalParamNEnd
\cgalNamedParamsEnd

@throw CGAL::Precondition_exception if a mesh has no face or no area, if a face is not a triangle or has a coordinate
       that is not finite as a `double`, or if a number of points is not positive; the message names the mesh, and
       the face by its place in `faces(tm)`, counted from 0. Release builds check this, too.

Faces without an area are surface, too; vertices without a face are not. Neither a large distance from the origin nor
the scale matters; but a mesh that is no larger than the rounding errors of the other one's coordinates, or of the distance between
them, has no area beside it.

Complexity: the search trees take \f$ O(n \log n) \f$ for *n* faces in both meshes, and the \f$ O(n + s) \f$ queries
for *s* points about \f$ O(\log n) \f$ each where the surfaces are close to one another.
*/
template <class ConcurrencyTag = CGAL::Sequential_tag, class TriangleMesh1, class TriangleMesh2,
          class NamedParameters1 = parameters::Default_named_parameters,
          class NamedParameters2 = parameters::Default_named_parameters>
Surface_distance surface_distance(const TriangleMesh1& tm1, const TriangleMesh2& tm2,
                                  const NamedParameters1& np1 = parameters::default_values(),
                                  const NamedParameters2& np2 = parameters::default_values())
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!std::is_convertible_v<ConcurrencyTag, CGAL::Parallel_tag>,
                "surface_distance(): CGAL::Parallel_tag was asked for, but the program is not linked with TBB. "
                "Link with CGAL::TBB_support, or use CGAL::Parallel_if_available_tag.");
#endif
  using namespace internal::measures;
  const Sampling_options options_1 = sampling_options(np1, Sampling_options());
  const Sampling_options options_2 = sampling_options(np2, options_1);

  const Flat_surface flat_1 = flat_surface(tm1, np1, "the first mesh");
  const Flat_surface flat_2 = flat_surface(tm2, np2, "the second mesh");
  const Bounding_box box_1(flat_1.vertices), box_2(flat_2.vertices);
  const Normalization normalization(box_1, box_2);
  const Normalized_surface surface_1(flat_1, normalization), surface_2(flat_2, normalization);
  const auto samples_1 = sample_surface(surface_1, options_1.number, options_1.seed, "the first mesh");
  const auto samples_2 = sample_surface(surface_2, options_2.number, options_2.seed, "the second mesh");

  const One_sided_distance forth =
    one_sided_distance<ConcurrencyTag>(samples_1, surface_1.vertices, surface_2.triangles);
  const One_sided_distance back =
    one_sided_distance<ConcurrencyTag>(samples_2, surface_2.vertices, surface_1.triangles);
  const double diagonal =
    std::sqrt(CGAL::squared_distance(normalization.apply(box_1.lower), normalization.apply(box_1.upper)));

  Surface_distance result;
  result.hausdorff_1_to_2 = normalization.restore_length(forth.hausdorff);
  result.hausdorff_2_to_1 = normalization.restore_length(back.hausdorff);
  result.mean_1_to_2 = normalization.restore_length(forth.mean);
  result.mean_2_to_1 = normalization.restore_length(back.mean);
  result.diagonal = normalization.restore_length(diagonal);
  return result;
}

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_SURFACE_DISTANCE_H
