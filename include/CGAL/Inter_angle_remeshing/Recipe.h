// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_RECIPE_H
#define CGAL_INTER_ANGLE_REMESHING_RECIPE_H

#include <CGAL/Named_function_parameters.h>

#include <limits>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
\ingroup PkgInterAngleRemeshingRef

@brief everything about a remeshing run that `CGAL::Polygon_mesh_processing::isotropic_remeshing()` has no named
parameter for.

A value type: take the default, `Recipe::closest()` or `Recipe::paper()`, change members, and hand it over by `recipe()`. The default
values are those that were measured best, see the ablation tables of the benchmark.
*/
struct Recipe
{
  /// how the neighbors of a vertex are weighted in the centre that relaxation moves it to
  enum class Weights
  {
    uniform,    ///< all alike
    area,       ///< by the area of the faces beside the edge to the neighbor; for `relaxation` up to 1: with its default, sweeps diverge
    cotangent   ///< by the cotangents of the angles opposite to that edge; negative weights count as zero. For comparison: faces keep
                ///< their shapes, and the average of their least angles is 4 to 5 degrees less.
  };

  /// which policies rule where the user hands none over
  enum class Policies
  {
    measured,   ///< the rules of the paper that were measured to do good
    paper       ///< all rules, as printed
  };

  /// which surface the result approximates where the user hands no projector over
  enum class Surface
  {
    measured,   ///< facets, or the surface of `MLS_projector` where they are much longer than the target
    paper       ///< that of `Point_set_MLS_projector` on the `Upsampled_point_set` of the range; needs Eigen. For organic models: features
                ///< are not looked for, sharp edges become round, and edges that are long beside a part's walls and corners make a wreck.
  };

  /// edges longer than this many target lengths are split; in (1, 2]. The classic value is 4/3; with 1.3 the mean edge
  /// of the result lies as far under the target as that of %Polygon_mesh_processing's function does.
  double split_ratio = 1.3;
  /// edges shorter than this many target lengths are collapsed; in [0, 1), and at most `split_ratio` / 1.2
  double collapse_ratio = 0.8;
  /// λ, the factor on the tangential step towards the centre of the neighbors: 1 goes there, more than 1
  /// over-relaxes. In (0, 1.6]; sweeps with more than that diverge, and with other weights than uniform ones those with less, too.
  double relaxation = 1.5;
  /// the weights of the centre
  Weights weights = Weights::uniform;
  /// sweeps of relaxation in an iteration; the named parameter `number_of_relaxation_steps` rules over both counts. With 0 there are
  /// no fit, polish, repair, lowering of distances and coarser levels, either: all of them move vertices. Flips then see to the angles,
  /// and there are no glides.
  unsigned sweeps = 3;
  /// sweeps in each of the last two iterations
  unsigned last_sweeps = 8;
  /// rounds of flips, each followed by glides, in each of the last two iterations; before, one is enough
  unsigned flip_rounds = 2;
  /// the largest number of flips in a glide: a sequence of flips that moves an irregular vertex until it meets
  /// another one and both become regular. 0 turns glides off, at most 16.
  unsigned glide_depth = 6;
  /// how much the sum of squared valence deviations may rise on a glide's way before it falls; below 0 it has to fall at once
  int glide_slack = 2;
  /// whether, from the second half of the iterations on, an inner vertex with less or more than six edges is measured against what its
  /// angles ask for, one edge for 60 degrees, instead of against six: at tips and saddles that are small beside the edges irregular
  /// vertices belong, and would be chased away otherwise
  bool curvature_valences = true;
  /// how far from the new surface the vertex that a collapse removes may lie, in target lengths; twice, then four times as far where
  /// the spikes of a noisy input would keep half as many faces again as its area asks for, or as are wanted
  double collapse_tolerance = 0.15;
  /// whether, where the target length is well under that of the input's edges, the iterations run on a coarser level, whose faces
  /// are then cut into four until they have the target length: several times faster, and the vertices are more regular. Levels
  /// are chosen such that they resolve the input; where none does, where most of the mesh would lie near protected edges, or where a
  /// policy, also the paper's, a `false` in its place, or a grading rules the edges, or a functor the moves, the iterations run on the
  /// target length all the same.
  bool multi_level = true;
  /// whether edges that the range shares with faces outside of it may be split, as `CGAL::Polygon_mesh_processing::isotropic_remeshing()`
  /// does; those faces are then divided into triangles. It is meant for meshes that are remeshed part by part, where the faces outside
  /// have their turn, too: with short edges in the range the divided faces are needles, and without it the faces inside are poor. Such
  /// edges are never collapsed; with `protect_constraints(true)`, or next to a face that is no triangle, they stay as they are.
  bool split_rim = false;
  /// by how much the target length rises with the distance from curves whose edges must be shorter than it is, where details
  /// are small or strips narrow, as a slope: such edges bring the target near them down to their own length, but not below 0.3 of
  /// it. So it is on CAD models, as the dihedral angles tell them, and wherever curves hold details of less than half the target
  /// length: two corners, a ring of three edges, or a round hole whose chords must be that short, one of a radius of less than 0.6 of it;
  /// but not where the target length is less than half of the input's mean edge. Protected edges do not count. So it is, too, on models
  /// that are not CAD around limbs so thin that their last rings of three edges, which nothing can collapse, are shorter than half of the
  /// target length: 1.35 of these is the target there. A sizing field yields only where the edges of curves are shorter than 0.6 of what it
  /// says, and not at limbs. It costs faces; 0 turns it off.
  double grading = 0.2;
  /// the width of fillets, in target lengths, up to which the edges along their middle are features where features are found by
  /// themselves, see `detect_features()`: the edges of a result would cut a narrower fillet off, and leave a serrated rim. 0: none
  /// are, at most 1.
  double fillet_width = 0.45;
  /// the width of crests, in target lengths: where the surface of a thin body turns back within it, by 120 degrees and more, as over the
  /// rounded leading edge of a wing, the rim of a lens or of a leaf, the edges along the middle guide the iterations as features do, so
  /// that no edge leads across and cuts the crest off. They are released before the clean-up: angles beside them are as good as
  /// elsewhere, and neither the report nor an edge map knows them. A body is thin where crests are at least 0.6 times as long as the root
  /// of the area of the range; those that are shorter than two target lengths for each end that leads nowhere do not count. 0: none
  /// guide, at most 2. None does where the input is noisy or stairs of voxels, with length 0, where a policy, or `false` in its place, is
  /// handed over or features may not be collapsed, without projection, and with a projection functor that knows no surface.
  double crest_width = 0.8;
  /// how densely ridges and grooves of CAD models, and smooth curves of others, may lie where features are found by themselves, see
  /// `detect_features()`: where a cube of two target lengths has more than so many target lengths of each, and they are low, they are a
  /// relief that no edges of the target length can follow, as the stairs of voxels, threads and knurls, and no features. Not negative;
  /// infinity keeps them all.
  double relief_density = 5;
  /// the distance, in target lengths, up to which the ends of an edge are merged before the run where both are corners of features
  /// or borders, or where it leads from one of these to another: corners that CAD systems export twice, chamfers as narrow as a
  /// rounding error. They would stay, with needles between them. The visitor is not told, and the report does not count them. Where
  /// chains along the middle of fillets meet, see `fillet_width`, the distance is 0.35.
  /// A plate or slit that is as thin stays, whose sides look to opposite directions within 30 degrees, and so does what would make a
  /// mesh cross itself that does not, and vertices within curves that would touch each other there again and again.
  /// Three times as far apart may be what moves little of the surface: two corners that an edge of a curve joins, and the rims of the
  /// blunt edge of a wedge, as the trailing edge of a wing or the bottom of a groove, where its sides have five times the rims' distance
  /// fifty of these distances (one target length) away from them.
  /// Nothing is merged where `edge_is_constrained_map`, `sharpness_angle`, `face_patch_map`, a policy, a `false` in its place or a
  /// projection functor is handed over, or where features and borders may not be collapsed; vertices that may not move stay. 0 turns
  /// it off, at most 0.1.
  double merging_distance = 0.02;
  /// whether, after the last iteration, valences of 4 and less and angles out of the band are mended, and faces fitted
  bool clean_up = true;
  /// passes that fit the faces to the surface by least squares, as a part of the clean-up: the vertices then lie on both
  /// sides of it, and the mean distance falls by a third and more; a second pass gains a percent. Where the surface has more
  /// than twice the faces of the result, two more are made, which gain two. Vertices on the border and on features stay. With 0, and
  /// `distance_tolerance` 0, every vertex off borders and features lies on the surface, but where it would fold over, as with a projection
  /// functor that is none of this package's. At most 100.
  unsigned fits = 1;
  /// how strongly the fit holds each vertex at the centre of its neighbors, along the surface, beside the distances that it lowers: the
  /// weight of the square of that way. Less brings the faces nearer to the surface, at the cost of their angles; in (0, 1].
  double fit_tangential_weight = 0.3;
  /// the band, in degrees, that the clean-up brings the angles into: its lower bound, in [0, 60). It moves vertices along the
  /// surface first, heading for a band that is narrower by 2 degrees below and 3 above, then see `repair`. Faces that touch
  /// the border or a feature have the band [33, 103] if that is wider. The report tells what is left out of it.
  double lower_angle = 42;
  /// its upper bound, in (60, 180]
  double upper_angle = 88;
  /// whether the clean-up tries flips, collapses and splits where moving vertices does not reach the band, at folds, and where faces
  /// cross others: though the input does not cross itself there, or, where the target length is 1.5 times as long as the edges of
  /// the input or longer, where that is easy; of noisy scans, everywhere
  bool repair = true;
  /// the largest distance between the result and the surface that the clean-up leaves alone, in target lengths. Larger ones,
  /// at tips and in crevices, are lowered as far as the angles allow. 0 turns that off, as do a projector of another surface and a
  /// target length of less than half of the mean altitude of the surface's faces.
  double distance_tolerance = 0.22;
  /// which policies rule where the user hands none over
  Policies policies = Policies::measured;
  /// which surface the result approximates where the user hands no projector over
  Surface surface = Surface::measured;

  /// nearest to the surface: three fits with a tangential weight of 0.03. On organic models the mean distance is less by 1 to 20%, mostly
  /// by 10 to 15, and θ<sub>avg</sub> by 0.1 to 3 degrees; the band is the same.
  static Recipe closest()
  {
    Recipe r;
    r.fits = 3;
    r.fit_tangential_weight = 0.03;
    return r;
  }

  /// the rules of Zheng and Lv (ICIG 2025) as printed: all of their split, collapse and flip conditions, λ = 0.5,
  /// area weights, one sweep an iteration, no glides, no clean-up, and moving least squares on the up-sampled input
  static Recipe paper()
  {
    Recipe r;
    r.split_ratio = 4. / 3;
    r.relaxation = 0.5;
    r.weights = Weights::area;
    r.sweeps = r.last_sweeps = 1;
    r.flip_rounds = 1;
    r.glide_depth = 0;
    r.curvature_valences = false;
    r.multi_level = false;
    r.grading = 0;
    r.fillet_width = 0;
    r.crest_width = 0;
    r.relief_density = std::numeric_limits<double>::infinity();
    r.merging_distance = 0;
    r.clean_up = false;
    r.fits = 0;
    r.repair = false;
    r.distance_tolerance = 0;
    r.policies = Policies::paper;
    r.surface = Surface::paper;
    return r;
  }
};

#ifndef DOXYGEN_RUNNING
namespace internal {
enum recipe_t { recipe_tag };
}
#endif

/*!
\ingroup PkgInterAngleRemeshingRef

@brief hands a recipe over to `isotropic_remeshing()`, alone or at the head of a chain of named parameters.

\code
isotropic_remeshing(faces(mesh), 0.02, mesh, recipe(r));
isotropic_remeshing(faces(mesh), 0.02, mesh, recipe(r, CGAL::parameters::number_of_iterations(5)));
\endcode

@param r the recipe; it is copied
@param np further named parameters
*/
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
auto recipe(const Recipe& r, const NamedParameters& np = CGAL::parameters::default_values())
{
  return CGAL::Named_function_parameters<Recipe, internal::recipe_t, NamedParameters>(r, np);
}

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_RECIPE_H
