// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_ATTRIBUTE_TRANSFER_H
#define CGAL_INTER_ANGLE_REMESHING_ATTRIBUTE_TRANSFER_H

#include <CGAL/Inter_angle_remeshing/Default_visitor.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/linear_combination.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/Quadratic_weights.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
\ingroup PkgInterAngleRemeshingRef

@brief interpolates values at three points linearly: the default of `Attribute_transfer`.

For floating point numbers, `std::array`s of these, and types with a product with `double` and a sum, such as `CGAL::Vector_3`; for
`CGAL::Point_2` and `CGAL::Point_3`, too, and for `CGAL::IO::Color`, whose channels are rounded. A combination of unit vectors is shorter
than these.
*/
struct Linear_interpolation
{
  /// returns the sum of the values, weighted by the coordinates.
  template <class Value>
  Value operator()(const std::array<Value, 3>& values, const std::array<double, 3>& coordinates) const
  {
    return internal::linear_combination(values, coordinates);
  }
};

/*!
\ingroup PkgInterAngleRemeshingRef

@brief takes the value of the nearest of three points: for ids, labels and other values that cannot be mixed.
*/
struct Nearest_value
{
  /// returns the value with the largest coordinate.
  template <class Value>
  Value operator()(const std::array<Value, 3>& values, const std::array<double, 3>& coordinates) const
  {
    return values[std::size_t(std::max_element(coordinates.begin(), coordinates.end()) - coordinates.begin())];
  }
};

/*!
\ingroup PkgInterAngleRemeshingRef

@brief a visitor that carries attributes of vertices, corners and faces over from the input to the result.

A vertex of the result lies at a point of a face of the input, the one that the projector leaves it at; its attributes are
interpolated from that face's corners, in the patch of a face around it. A face of the result takes the attributes of the face of the
input at its centroid, in the patch of the face that it descends from. Vertices that have not moved keep their values to the last bit.

Attributes of corners are those that may have several values at a vertex, as texture coordinates have at a seam, or normals at a
sharp edge: their maps have half-edges as keys, and h stands for the corner of its face at its target. A corner of the result is
interpolated from the corners of a face of the input on the same side of the curves (borders, constrained edges, borders of patches,
features) on which its vertex lies. All corners between two curves have the same value to the last bit, and so have those at a
vertex on no curve: an attribute stays discontinuous at curves, and nowhere else. So its seams must be curves: `mark_seams()` marks
them.

\code
Attribute_transfer<Mesh> transfer;
transfer.add_vertex_map(colours);
transfer.add_smooth_vertex_map(temperatures, mesh);
transfer.add_face_map(materials);
isotropic_remeshing(faces(mesh), 0.02, mesh, parameters::visitor(transfer));
\endcode

Values are read before the mesh is changed, and written when the result stands: an exception from a map or an interpolation while
reading leaves everything as it was. The maps must stay valid while elements are added to the mesh; so do the property maps
of `Surface_mesh`, and dynamic property maps. Nothing is written to half-edges of the border.

A copy shares the attributes and what is read of them with the original: that one may be handed over as it is, or by `std::ref()`,
but not to two runs at a time.

Complexity: linear in the size of the result.

\cgalModels{RemeshingVisitor}

@tparam TriangleMesh the type of the mesh
*/
template <class TriangleMesh>
class Attribute_transfer
  : public Default_visitor
{
public:
#ifdef DOXYGEN_RUNNING
  /// the vertices
  typedef unspecified_type vertex_descriptor;
  /// the half-edges
  typedef unspecified_type halfedge_descriptor;
  /// the faces
  typedef unspecified_type face_descriptor;
#else
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
#endif

  /// adds an attribute of the vertices.
  /// @tparam VertexMap a class model of `ReadWritePropertyMap` with the vertices of `TriangleMesh` as key type
  /// @tparam Interpolation a functor `Value operator()(const std::array<Value, 3>&, const std::array<double, 3>&) const` of the
  ///         values at the corners of a face and the barycentric coordinates of a point on it, not negative and with sum 1
  template <class VertexMap, class Interpolation = Linear_interpolation>
  void add_vertex_map(VertexMap map, Interpolation interpolation = Interpolation())
  {
    using Evaluation = At_corners<Interpolation>;
    vertex_maps_.push_back(std::make_shared<Carrier<vertex_descriptor, VertexMap, Evaluation>>(map, Evaluation{std::move(interpolation)}));
  }

  /// adds an attribute of the vertices that is a smooth function on the surface, as a temperature or a displacement is.
  ///
  /// It is interpolated by quadratics, whose gradients at the corners of a face are fitted to the values around these: far nearer than
  /// linearly, and what is carried over again and again does not wear off. Values between those at the corners are not promised: an
  /// extremum between vertices comes out higher, and by a jump some values are beyond both sides. Where the surface is not smooth (at a
  /// vertex with a face that is turned by more than 60 degrees from its normal), its faces are too thin, or more than 50 vertices are
  /// around one of the corners, interpolation is linear.
  ///
  /// Complexity: constant for each vertex of the result. An exception from the map is passed on, as with `add_vertex_map()`.
  /// @tparam VertexMap a class model of `ReadWritePropertyMap` with the vertices of `TriangleMesh` as key type and a type of values that
  ///         `Linear_interpolation` can interpolate
  /// @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  /// @param map the attribute
  /// @param tmesh the mesh that is to be remeshed; it must outlive the transfer's use
  /// @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{vertex_point_map}
  ///     \cgalParamDescription{a property map that associates points to the vertices of `tmesh`}
  ///     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type
  ///                    and `%Point_3` as value type}
  ///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  template <class VertexMap, class NamedParameters = parameters::Default_named_parameters>
  void add_smooth_vertex_map(VertexMap map, const TriangleMesh& tmesh, const NamedParameters& np = parameters::default_values())
  {
    const auto vpm = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                  get_const_property_map(CGAL::vertex_point, tmesh));
    using Evaluation = Around_corners<internal::Quadratic_weights<TriangleMesh, std::decay_t<decltype(vpm)>>>;
    vertex_maps_.push_back(std::make_shared<Carrier<vertex_descriptor, VertexMap, Evaluation>>(map, Evaluation{{tmesh, vpm}}));
  }

  /// adds an attribute of the corners.
  /// @tparam HalfedgeMap a class model of `ReadWritePropertyMap` with the half-edges of `TriangleMesh` as key type; its values can be
  ///         compared by `==`
  /// @tparam Interpolation as for `add_vertex_map()`
  template <class HalfedgeMap, class Interpolation = Linear_interpolation>
  void add_corner_map(HalfedgeMap map, Interpolation interpolation = Interpolation())
  {
    using Evaluation = At_corners<Interpolation>;
    corner_maps_.push_back(std::make_shared<Corner_carrier<HalfedgeMap, Evaluation>>(map, Evaluation{std::move(interpolation)}));
  }

  /// marks the edges at which an attribute of corners that was added has other values on one side than on the other one. Handed over
  /// as `edge_is_constrained_map`, they keep their places; `detect_features()` adds the features, which are not looked for then.
  /// @tparam EdgeMap a class model of `WritablePropertyMap` with the edges of `TriangleMesh` as key type and `bool` as value type;
  ///         `true` is put for seams, nothing for other edges
  /// @returns the number of these edges. Complexity: linear in the number of edges; maps and their comparison may throw
  template <class EdgeMap>
  std::size_t mark_seams(const TriangleMesh& mesh, EdgeMap is_seam) const
  {
    std::size_t n = 0;
    for (const auto& e : edges(mesh)) {
      const halfedge_descriptor h = halfedge(e, mesh), o = opposite(h, mesh);
      if (is_border(h, mesh) || is_border(o, mesh)) continue;
      const halfedge_descriptor before_h = prev(h, mesh), before_o = prev(o, mesh);
      if (std::none_of(corner_maps_.begin(), corner_maps_.end(), [&](const auto& map) {
            return map->differs(h, before_o) || map->differs(o, before_h); })) continue;
      put(is_seam, e, true);
      ++n;
    }
    return n;
  }

  /// adds an attribute of the faces.
  /// @tparam FaceMap a class model of `ReadWritePropertyMap` with the faces of `TriangleMesh` as key type
  template <class FaceMap>
  void add_face_map(FaceMap map)
  {
    using Evaluation = At_corners<Nearest_value>;
    face_maps_.push_back(std::make_shared<Carrier<face_descriptor, FaceMap, Evaluation>>(map, Evaluation()));
  }

  /// \name Called by the remesher
  /// @{

  /// reads what vertex number `i` of the result is to have.
  void read_vertex(std::size_t i, const std::array<vertex_descriptor, 3>& corners, const std::array<double, 3>& coordinates)
  {
    for (const auto& map : vertex_maps_) map->read(i, corners, coordinates);
  }
  /// reads what the corners of number `i` are to have.
  void read_corner(std::size_t i, const std::array<halfedge_descriptor, 3>& corners, const std::array<double, 3>& coordinates)
  {
    for (const auto& map : corner_maps_) map->read(i, corners, coordinates);
  }
  /// reads what face number `i` of the result is to have.
  void read_face(std::size_t i, face_descriptor f)
  {
    for (const auto& map : face_maps_) map->read(i, {f, f, f}, {1, 0, 0});
  }
  /// writes the attributes of vertex number `i`.
  void write_vertex(std::size_t i, vertex_descriptor v)
  {
    for (const auto& map : vertex_maps_) map->write(i, v);
  }
  /// writes the attributes of a corner of number `i`.
  void write_corner(std::size_t i, halfedge_descriptor h)
  {
    for (const auto& map : corner_maps_) map->write(i, h);
  }
  /// writes the attributes of face number `i`.
  void write_face(std::size_t i, face_descriptor f)
  {
    for (const auto& map : face_maps_) map->write(i, f);
  }
  /// @}

private:
  // The value between three elements, by a functor of theirs.
  template <class Interpolation>
  struct At_corners
  {
    Interpolation interpolation;

    template <class Map, class Element>
    auto operator()(const Map& map, const std::array<Element, 3>& corners, const std::array<double, 3>& coordinates)
    {
      using Value = typename boost::property_traits<Map>::value_type;
      return interpolation(std::array<Value, 3>{get(map, corners[0]), get(map, corners[1]), get(map, corners[2])}, coordinates);
    }
  };

  // The value between three elements, from theirs and those around.
  template <class Weights>
  struct Around_corners
  {
    Weights weights;

    template <class Map, class Element>
    auto operator()(const Map& map, const std::array<Element, 3>& corners, const std::array<double, 3>& coordinates)
    {
      const auto& terms = weights.at(corners, coordinates);
      return internal::linear_combination<typename boost::property_traits<Map>::value_type>(
        terms.size(), [&](std::size_t i) { return get(map, terms[i].first); }, [&](std::size_t i) { return terms[i].second; });
    }
  };

  // What is evaluated between three elements; of a face, which stands for all three, it is taken as it is.
  template <class Element>
  struct Carrier_base
  {
    virtual ~Carrier_base() = default;
    virtual void read(std::size_t i, const std::array<Element, 3>&, const std::array<double, 3>&) = 0;
    virtual void write(std::size_t i, Element e) = 0;
  };
  struct Corner_carrier_base : Carrier_base<halfedge_descriptor>
  {
    virtual bool differs(halfedge_descriptor h, halfedge_descriptor g) const = 0;
  };

  // The value of each element of the result, in the order in which they are read.
  template <class Value>
  class Values
  {
  public:
    void set(std::size_t i, Value value)
    {
      if (i == 0) values_.clear();               // another run
      values_.push_back(std::move(value));
    }
    const Value& get(std::size_t i) const { return values_[i]; }

  private:
    std::deque<Value> values_;                   // whose elements are bools, too, can be referred to
  };

  template <class Element, class Map, class Evaluation, class Base = Carrier_base<Element>>
  class Carrier : public Base
  {
  public:
    Carrier(Map map, Evaluation evaluation) : map_(map), evaluation_(std::move(evaluation)) {}
    void read(std::size_t i, const std::array<Element, 3>& corners, const std::array<double, 3>& coordinates) override
    {
      if (coordinates[0] == 1) values_.set(i, get(map_, corners[0]));
      else values_.set(i, evaluation_(map_, corners, coordinates));
    }
    void write(std::size_t i, Element e) override { put(map_, e, values_.get(i)); }

  protected:
    Map map_;

  private:
    Evaluation evaluation_;
    Values<typename boost::property_traits<Map>::value_type> values_;
  };

  template <class Map, class Evaluation>
  struct Corner_carrier final : Carrier<halfedge_descriptor, Map, Evaluation, Corner_carrier_base>
  {
    using Carrier<halfedge_descriptor, Map, Evaluation, Corner_carrier_base>::Carrier;
    bool differs(halfedge_descriptor h, halfedge_descriptor g) const override
    {
      return !(get(this->map_, h) == get(this->map_, g));
    }
  };

  std::vector<std::shared_ptr<Carrier_base<vertex_descriptor>>> vertex_maps_;
  std::vector<std::shared_ptr<Corner_carrier_base>> corner_maps_;
  std::vector<std::shared_ptr<Carrier_base<face_descriptor>>> face_maps_;
};

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_ATTRIBUTE_TRANSFER_H
