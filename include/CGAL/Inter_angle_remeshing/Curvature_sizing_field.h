// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_CURVATURE_SIZING_FIELD_H
#define CGAL_INTER_ANGLE_REMESHING_CURVATURE_SIZING_FIELD_H

#include <CGAL/Inter_angle_remeshing/internal/exchange/constraints.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/flat_copy.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/read_wider_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/features/feature_detection.h>
#include <CGAL/Inter_angle_remeshing/internal/sizing/curvature_lengths.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
\ingroup PkgInterAngleRemeshingRef

@brief a sizing field whose triangles are as far from the surface everywhere: short edges where it is bent, long ones where it
is flat.

Where the largest absolute principal curvature is κ, the target edge length is

\f[ L = \sqrt{6 \varepsilon / \kappa - 3 \varepsilon^2}, \f]

the edge of an equilateral triangle inscribed in a sphere of radius 1/κ whose distance from the sphere is ε (M. Dunyach, D.
Vanderhaeghe, L. Barthe, M. Botsch, <em>Adaptive Remeshing for Real-Time Mesh Deformation</em>, Eurographics Short Papers
2013); with a larger ε than the radius it stays at its largest value, √3/κ. It is clamped to a range, and rises by no more
than the `gradation` with the distance.

Features, the ones of a map or the ones that `detect_features()` finds, and the border bound the smooth parts of the surface: an
edge of a cube is not taken for a large curvature. They are curves themselves, and where these are bent lengths are short.
Curvatures are averaged over neighborhoods of half the target length, of two to six edges of the input, so that noise
cancels out. At the rim of a range, beyond which the mesh goes on, they are told with triangles around it, as features are, see
`detect_features()`, and the rim itself is no curve. The field knows the vertices of the range as it was constructed, and is to be
used before the mesh is changed.

`CGAL::Polygon_mesh_processing::Adaptive_sizing_field` of \cgal 6, of which this one has the arguments, is taken by
`isotropic_remeshing()` as well. Of the concept `PMPSizingField` this class has the member that `isotropic_remeshing()` calls, not those
that %Polygon_mesh_processing calls.

Complexity: linear in the number of faces, with up to about 5000 around a range, times log of it.

@tparam TriangleMesh a model of `FaceGraph`
*/
template <class TriangleMesh>
class Curvature_sizing_field
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

public:
  /// the number type
  using FT = double;

  /*!
  measures the curvature of a range of faces.

  @tparam FaceRange a model of `ConstRange` with the faces of `TriangleMesh` as value type
  @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

  @param tolerance ε, the distance of the result's triangles from the surface that is aimed at, in the units of the mesh
  @param length_range the shortest and the longest target length
  @param faces the range of triangular faces
  @param tmesh the mesh
  @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
  @param gradation by how much the length rises with the distance at most, as a slope

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
      \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
                     as key type and a point type as value type}
      \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
    \cgalParamNEnd
    \cgalParamNBegin{edge_is_constrained_map}
      \cgalParamDescription{the features of the range; at its rim and beyond, those that `detect_features()` finds are taken, too}
      \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor`
                     as key type and `bool` as value type}
      \cgalParamDefault{the features that `detect_features()` finds}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  @throws CGAL::Precondition_exception if a face is not a triangle, a coordinate is not finite, all points are equal, the tolerance
          is not positive, the range of lengths is empty, not positive or not finite, or the gradation is not positive
  */
  template <class FaceRange, class NamedParameters = CGAL::parameters::Default_named_parameters>
  Curvature_sizing_field(FT tolerance, const std::pair<FT, FT>& length_range, const FaceRange& faces, const TriangleMesh& tmesh,
                         const NamedParameters& np = CGAL::parameters::default_values(), FT gradation = 0.3)
    : longest_(length_range.second)
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    constexpr const char* CALLER = "Curvature_sizing_field";
    internal::check_curvature_lengths(CALLER, tolerance, length_range, gradation);
    if (faces.begin() == faces.end()) return;
    const auto vpm = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                      get_const_property_map(CGAL::vertex_point, tmesh));
    const auto ecm = choose_parameter(get_parameter(np, CGAL::internal_np::edge_is_constrained), internal::No_map());
    auto copy = internal::Flat_copy_builder<TriangleMesh, std::decay_t<decltype(vpm)>>(tmesh, vpm, CALLER).build(faces);
    auto wider = internal::read_wider_copy(copy, tmesh, vpm, CALLER);
    const internal::Flat_copy<TriangleMesh>& seen = mark_curves(copy, wider, tmesh, ecm);
    const std::vector<double> lengths = internal::curvature_lengths(seen.mesh, tolerance, length_range, gradation);
    auto table = std::make_shared<Table>(copy.vertices.size());
    copy.mesh.for_each_halfedge([&](Index h) {       // of the same number in both copies
      const Index v = seen.mesh.origin(h);
      const auto [i, is_new] = table->number.insert(seen.vertices[v], Index(table->lengths.size()));
      if (is_new) table->lengths.push_back(lengths[v]);
      else table->lengths[i] = (std::min)(table->lengths[i], lengths[v]);
    });
    table_ = std::move(table);
  }

  /// the target edge length at a vertex of the range; the longest one at other vertices
  FT at(vertex_descriptor v, const TriangleMesh&) const
  {
    const Index i = table_ == nullptr ? -1 : table_->number.find(v);
    return i < 0 ? longest_ : table_->lengths[i];
  }

private:
  using Index = internal::Remeshing_mesh::Index;

  // Marks the features, those of the map or those that are found, and the rim, in the copy that is to be measured, and returns that: the
  // wider one where there is one, unless the range is a part on its own. A map is asked for edges of the range alone; on its rim and beyond
  // those that are found are marked, too.
  template <class EdgeIsConstrainedMap>
  static const internal::Flat_copy<TriangleMesh>& mark_curves(internal::Flat_copy<TriangleMesh>& copy,
                                                              internal::Wider_copy<TriangleMesh>& wider,
                                                              const TriangleMesh& tmesh, const EdgeIsConstrainedMap& map)
  {
    constexpr bool HAS_MAP = !std::is_same<EdgeIsConstrainedMap, internal::No_map>::value;
    internal::Features_around found{{}, true};
    if (!HAS_MAP || !wider.faces.empty()) found = internal::find_features_around(copy.mesh, wider.mesh);
    internal::Flat_copy<TriangleMesh>& seen = found.are_of_range_alone ? copy : wider;
    const auto is_within = [&](Index h) { return h < Index(4 * copy.faces.size()) && !copy.mesh.is_border(h); };
    for (const Index h : found.edges)
      if (!HAS_MAP || !is_within(h)) internal::mark_feature(seen.mesh, h);
    if constexpr (HAS_MAP)
      copy.mesh.for_each_halfedge([&](Index h) {
        if (get(map, edge(copy.halfedge(h), tmesh))) internal::mark_feature(seen.mesh, h);
      });
    seen.mesh.for_each_halfedge([&](Index h) {
      if (seen.is_on_rim(h, tmesh)) seen.mesh.add_flags(h, internal::Remeshing_mesh::ON_RIM);
    });
    return seen;
  }

  struct Table
  {
    explicit Table(std::size_t vertices) : number(vertices) { lengths.reserve(vertices); }

    internal::Descriptor_index<vertex_descriptor> number;
    std::vector<FT> lengths;
  };

  FT longest_;
  std::shared_ptr<const Table> table_;       // copies share it
};

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_CURVATURE_SIZING_FIELD_H
