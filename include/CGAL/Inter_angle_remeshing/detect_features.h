// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_DETECT_FEATURES_H
#define CGAL_INTER_ANGLE_REMESHING_DETECT_FEATURES_H

#include <CGAL/Inter_angle_remeshing/Recipe.h>
#include <CGAL/Inter_angle_remeshing/internal/arguments/refuse.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/flat_copy.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/read_wider_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/features/feature_detection.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
\ingroup PkgInterAngleRemeshingRef

@brief finds the sharp edges of a triangle mesh by themselves, and with a `scale` what `isotropic_remeshing()` keeps at that
length where nothing is marked.

Marks the edges of 40 degrees and more on CAD models, with few exceptions; on others only long curves of edges that stand out of
their surroundings, and the rims of planar parts. A run without marks looks for these edges itself: call the function to see beforehand
what will be kept, or to change it before it is handed over as `edge_is_constrained_map`, and give the target length as `scale`. It takes
.1 to 1.3 microseconds a face, 4 to 9% of a run at the mean edge length (seven models of 2,600 to 75,000 faces). The
rule in full follows.

A face no higher, over its longest edge, than 4 millionths of the diagonal of the bounding box, or a thousandth of the mean edge if that is
less, looks as the face beyond that edge: rounding says where it looks itself, as files have six digits of points, or floats.

The dihedral angles tell what kind of model it is. Let `s` be the length of all edges with a dihedral angle of 40 degrees and more,
`m` that of the edges with 12 to 40 degrees, and `p` that of those among them where both faces go on in their planes, within half a
degree, over another edge: the facets of a cylinder or another surface of revolution. Let `t` be the part of `s` that belongs to
long components: of eight mean edges, of a quarter of the root of the area of what hangs together with them, or rings of nine edges. If
m < s / 2, or m < 1.1 s and more than half of all edges have less than 8 degrees, or m - p < s / 5, and the same with t in place of s, it is
a CAD model; and so it is if m < 3.5 t and the edges of 40 degrees and more form a network, as they do when a part has been remeshed
coarsely: 70% of their length does not lead to a free end, and of its vertices, of which twelve at least are the ends of two of them, at
most 40% are the ends of more, and at most a fifth of the others bend by more than 45 degrees; or at most half are the ends of more, and
at most a tenth of the others bend; or these and those make up at most a third of all. Much of a part is plane: let `a` be the share of
faces that go on in their planes over an edge in the area, that of all or that of the component on which an edge of s or m lies, in the
mean over their lengths, whichever is less. If a is at least 35%, the curved rest may be tessellated more finely, m < 5 t; and as
simplification breaks the edges of a part, with m < 3.5 t it is enough if 35% of the length does not lead to a free end, at most 45% of
the vertices are the ends of more, and at most a fifth of the others bend. A part with many small details, as screws and vents, is a
network, too, if a is at least 22%, m < 2 t, 70% of the length does not lead to a free end, at most 70% of the vertices are the ends of
more, and at most three eighths of the others bend. But unless m - p < s / 5, it is none if at a tenth of the vertices of these edges,
fifty at least, two or more convex ones meet two or more concave ones beside no face that goes on in its plane: noise makes such saddles
everywhere.
What has grown and is as flat as a leaf is none, either: of the vertices of edges of 40 degrees and more, a hundred at least, more than
.5% are free ends, more than 10% are free ends or junctions, and over more than 15% of the length of these edges, and more than the part of
the length of all edges that they have, the surface turns by 120 degrees and more.
Of a part that was simplified to some hundred or thousand faces, hardly an edge is as it was. It is a CAD model, noise or not, if s is at
least 30% of the length of all edges, m < .85 t, a is at least 10%, 90% of s does not lead to a free end, the surface turns by 120 degrees
and more over no more of s than for leaves, and at most 3000 vertices have edges of 40 degrees and more: what has grown, simplified as far,
hardly has planes, but where it was cut.
Robots' links that were simplified to some hundred faces, and the hulls of such parts, have few sharp edges, in pieces. By these rules
none, a model whose faces all hang together is a CAD model, too, if edges of 30 degrees and more have at least .8% of the length of all
edges, s at most 5.5%; faces with an angle of less than 10 degrees have at least a fifth of the area; half of it is in at most 29% of the
faces; and half of it in at most 50 planar polygons. What has grown, or the stairs of a segmentation, is not made of so few.
On a CAD model every edge of 40 degrees and more is a feature. But where two chains of them are the sides of a strip, one face
across and narrower than a twentieth of the length, over which the surface turns to one side by less than 120 degrees, as at a
small bevel, only the sharper one is; unless such a strip lies on the other side of the weaker one, too, and that between both
is at least a twentieth of `scale` wide, as around a slender bar. A chain along such a strip to the border is none. Where the
surface turns there and back over a strip narrower than a twentieth of `scale`, or of the mean edge without one, at a low step,
its groove is none. Sides of a strip have about the same direction, within 45 degrees. A face that is ten times as long as high,
with a dihedral angle of 150 degrees and more at one of its edges, is a sliver folded onto its neighbor: it counts as if it
looked as the face at its longest edge does; unless it goes on, by less than 40 degrees, to others, more than 64 of them or all
with more than a twentieth of the square of their longest edge as area, as beside a knife's edge.

If not, it is an organic model or a noisy one. Each of its components, faces that hang together by edges, that is a CAD model by these
rules on its own, and has an area of at least 24 squares of `scale`, or of the mean edge without one, has the features of one, all the same.
For the rest, around connected edges of 30 degrees and more that are 2.5 times as sharp as
the edges beside them, the face normals are filtered bilaterally, in five passes. An edge stands out if it then has 30
degrees, and three times the median angle around it. Of the chains of such edges, those are features that form components of
at least 12 edges and five lengths, and of 40 for each end that leads nowhere; half of their length must have 45 degrees and
more; of two chains side by side the sharper one stays, and one that runs beside itself, as around a slit, does not. The length
is the mean edge's; of what is found, features are what passes for `scale`, too, where that is longer.

Between the sharp edges of a twisted bar, or around a noisy panel, hardly any edge is flat. Where 90% of the length of all edges of
40 degrees and more are such curves, these are features, too, but for one side of a narrow strip, as above. They lead to no free
end; of the vertices of those that hang together, twelve edges at least, at most 2% of those between two edges bend by more than 45
degrees, at most a fifth are the ends of more edges, and none of more than four; and those of a part have 70 degrees on the average,
and 2.5 times the root of the part's area as length. Those of three edges and less between two others that run on smoothly do not
count, nor does anything in noise.

Parts that are planar within half a degree, of at least 10 faces and the area of a square of the mean edge of their rim, nothing has that
has grown: there a model was cut, or given a base. If half of the rim of such a part has 60 degrees and more, all its edges of
30 degrees and more are features, in components of at least five times `scale`, or the mean edge without one, whatever they meet; but of
two rims beside a narrow strip only the sharper one. Rings are features, too, as around a hole that was drilled: closed curves of edges of
30 degrees and more, half of their length 45, that meet no other such edge, do not run beside themselves, seldom turn by more than 30 degrees,
and have at least 12 edges, five mean edge lengths and three times `scale`; but not where there is an edge of rings for every five faces.

Alpha wraps of parts have jagged chamfers instead of sharp edges. No edge of theirs is longer than 3.5 mean edge lengths;
15% of the edges of 40 degrees and more are rims of chamfers one face wide, of less than 70 degrees; 0.2% turn to and fro, by 15 to
80 degrees; and at most 30% are rims of walls that are one face thick. So it may be with a part that has been remeshed to edges as
long as its details are wide; but fewer than 2% turn to and fro there, fewer than 100 of the vertices, or 3.5%, are the saddles
above, and the faces are better: on a wrap, a quarter of the rims of chamfers are those of a face less than 0.39 of its longest edge high.
Of wraps, taken for CAD models otherwise, the edges that stand out of the filtered normals are features in chains of four lengths for
each free end and components of eight; one side of a chamfer then, as a rule.

The stairs that marching cubes leave around the voxels that are marked in a volume are no features, nor is anything beside them. At
least 98% of the edges of such a mesh are the same few vectors, 64 at most, each of them 16 times on the average. Along each of three axes
that are normal to each other a vector goes by nothing, by half a voxel or by one; by a half along two of them or none, and each pair
of axes has such vectors. Of the edges of 40 degrees and more at least 20% are rims of chamfers one face wide, of less than 70
degrees; and at most 10% are rims of walls that are one face thick, or fewer than 0.2% turn to and fro, by 15 to 80 degrees: noise has
more of both, vessels about as thick as a slice more of the walls alone. Where the flat parts of such stairs were simplified, what would
be a CAD model otherwise has at least 60% of such rims of chamfers, and 7% of edges that turn to and fro; of what is just some voxels
thick fewer do, and its stairs are kept.

A coarse model that is no CAD model, as one simplified to some hundred faces, has creases, which short edges must not cut off:
where edges of 70 degrees and more make up a twentieth of the length of all edges, and the saddles above do not tell noise, those
of them are features, too, that are at least twice as long as `scale`, as are the altitudes of both faces over them.

The edges of a part may be rounded, or beveled in several steps. A fillet that is narrower than w = 0.45 `scale` is as good as a
sharp edge: the chain of edges next to its middle, where the surface has turned half of its way, is a feature. The surface
turns by 40 to 120 degrees across such a fillet, and by three at each edge of the chain; over half of the fillet's width, and w / 4,
no more than two degrees are left on either side of it; and no feature or border lies within 1.2 w. The same is done with w / 2,
also where the surface turns back, as around the rim of a plate. Chains are as long as `scale`, or three times as long if closed;
where they end beside others, as in the round corner of a box, they are joined, and with another free end they have four times the
length. So it is on CAD models, and on others where three quarters of the area are parts of planar polygons, and all features
form a network.

Crests, over which the surface of a thin body turns back, as over the rim of a lens, are no features: they guide the iterations of
`isotropic_remeshing()` (`Recipe::crest_width`), and are released before the end.

With a `scale`, what is too fine for edges of that length is none: of the features of a CAD model, and of one with smooth curves,
those of a relief, as the stairs of voxels, threads, knurls, or the layers of a printed part. There, both faces are less than `scale`
high over the edge, and the cube of two `scale` around it has more than five `scale` of ridges and as much of grooves
(Recipe::relief_density); these are at most 0.4 `scale` apart in height, by their centres along the mean normal of the faces beside
them, and the normals agree so far that their sum is more than half as long as all of them. Thin bars and plates, whose sides face away
from each other, and the teeth of a gear, which are higher, are kept. In components of features most of which are such edges, half
of that density will do; and with them goes what is ragged beside them: what leads on to a corner within 1.5 `scale`, and on from
there where a fifth of the component is such edges, and chains that end after three; but no edge of `scale` and more between faces
as high over it.
What is a relief by this rule with a shorter length in place of `scale`, 0.7, 0.7², ... 0.7⁸ of it, is one, too: it is as well too fine
for `scale`, whose cube may hold a small part as a whole.

Measured: of the edges over 40 degrees of fandisk.off with a noise of 15% of the edge length, 99% are found, and of what is
found 99.7% is right. Of the some seventy models of \cgal that are not taken for CAD models, six have any feature, with at most
0.8% of the edge length. Of ten organic models cut by three planes each, 94 to 100% of the rim are found.

Complexity: linear in the number of faces, with up to about 5000 around a range, where ways across fillets look at two hundred faces
at most, and on CAD models in the length of their sharp edges over `scale`, which are looked at in pieces as short as a fortieth of it;
on other models the square of the faces at a vertex that has thousands.

@tparam FaceRange a model of `ConstRange` with the faces of `TriangleMesh` as value type
@tparam TriangleMesh a model of `FaceGraph`
@tparam EdgeIsFeatureMap a model of `WritablePropertyMap` with the edges of `TriangleMesh` as key type and `bool` as value
        type
@tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

@param faces the range of triangular faces; edges to faces outside of it are no features. What is a feature is told by these together
       with triangles around them, about as many as the range has, at least 1000 and at most about 5000, in whole rings, but no farther away
       than a thousand times the extent of the range. Where all these are no CAD model, nor noise, leaves, a wrap or stairs of voxels, but the
       range alone is a CAD model, with an area of at least 24 squares of `scale`, or without one of its mean edge, it is told by the range
@param tmesh the mesh
@param edge_is_feature set for every edge of the range: whether it is a feature. Edges of the border are not.
@param scale the length of the edges that the mesh is to have: features much shorter than it are none, nor those much shorter than
       the mean edge, nor reliefs too fine for it; 0: that of the mean edge, fillets are none, and reliefs are kept
@param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
                   as key type and a point type as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

@returns the number of features
@throws CGAL::Precondition_exception if a face is not a triangle, a coordinate is not finite, all points are equal, or
        `scale` is negative or not finite
*/
template <class FaceRange, class TriangleMesh, class EdgeIsFeatureMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::size_t detect_features(const FaceRange& faces, const TriangleMesh& tmesh, EdgeIsFeatureMap edge_is_feature,
                            double scale = 0, const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Index = internal::Remeshing_mesh::Index;
  constexpr const char* CALLER = "detect_features()";
  if (!(scale >= 0) || !std::isfinite(scale))
    internal::refuse(CALLER, "the scale is " + internal::to_text(scale) + "; it must be finite and not negative");
  const auto vpm = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                    get_const_property_map(CGAL::vertex_point, tmesh));
  using Vpm = std::decay_t<decltype(vpm)>;
  if (faces.begin() == faces.end()) return 0;
  const auto copy = internal::Flat_copy_builder<TriangleMesh, Vpm>(tmesh, vpm, CALLER).build(faces);
  const std::vector<Index> features = internal::find_features_for(
    copy.mesh, internal::read_wider_copy(copy, tmesh, vpm, CALLER).mesh, scale / copy.mesh.unit(), scale > 0 ? Recipe().fillet_width : 0.,
    scale > 0 ? Recipe().relief_density : std::numeric_limits<double>::infinity());
  for (Index h = 0; h < 4 * Index(copy.faces.size()); ++h)
    if (copy.mesh.corner(h) < 3) put(edge_is_feature, edge(copy.halfedge(h), tmesh), false);
  for (const Index h : features) put(edge_is_feature, edge(copy.halfedge(h), tmesh), true);
  return features.size();
}

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_DETECT_FEATURES_H
