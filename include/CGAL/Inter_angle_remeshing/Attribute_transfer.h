// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_ATTRIBUTE_TRANSFER_H
#define CGAL_INTER_ANGLE_REMESHING_ATTRIBUTE_TRANSFER_H

#include <CGAL/Inter_angle_remeshing/Default_visitor.h>
#include <CGAL/Inter_angle_remeshing/internal/linear_combination.h>

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
`CGAL::Point_3`, too.
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

@brief a visitor that carries attributes of vertices and faces over from the input to the result.

A vertex of the result lies at a point of a face of the input, the one that the projector leaves it at; its attributes are
interpolated from that face's corners. A face of the result takes the attributes of the face of the input at its centroid, in the
same patch. Vertices that have not moved keep their values to the last bit.

\code
Attribute_transfer<Mesh> transfer;
transfer.add_vertex_map(colours);
transfer.add_face_map(materials);
isotropic_remeshing(faces(mesh), 0.02, mesh, parameters::visitor(transfer));
\endcode

Values are read before the mesh is changed, and written when the result stands: an exception from a map or an interpolation while
reading leaves everything as it was. The maps must stay valid while elements are added to the mesh; so do the property maps
of `Surface_mesh`, and dynamic property maps. At a seam, where an attribute has two values at one vertex, as texture
coordinates have, this does not help, and there is no map for half-edges: mark seams as constrained edges, which keeps them in their
places, carry the number of the chart as an attribute of faces, and look up what corners need in that chart of the input.

A copy shares the attributes and what is read of them with the original: that one may be handed over as it is, or by `std::ref()`,
but not to two runs at a time.

Complexity: linear in the size of the result.

\cgalModels `RemeshingVisitor`

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
  /// the faces
  typedef unspecified_type face_descriptor;
#else
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
#endif

  /// adds an attribute of the vertices.
  /// @tparam VertexMap a class model of `ReadWritePropertyMap` with the vertices of `TriangleMesh` as key type
  /// @tparam Interpolation a functor `Value operator()(const std::array<Value, 3>&, const std::array<double, 3>&) const` of the
  ///         values at the corners of a face and the barycentric coordinates of a point on it, not negative and with sum 1
  template <class VertexMap, class Interpolation = Linear_interpolation>
  void add_vertex_map(VertexMap map, Interpolation interpolation = Interpolation())
  {
    vertex_maps_.push_back(std::make_shared<Vertex_carrier<VertexMap, Interpolation>>(map, std::move(interpolation)));
  }

  /// adds an attribute of the faces.
  /// @tparam FaceMap a class model of `ReadWritePropertyMap` with the faces of `TriangleMesh` as key type
  template <class FaceMap>
  void add_face_map(FaceMap map) { face_maps_.push_back(std::make_shared<Face_carrier<FaceMap>>(map)); }

  /// \name Called by the remesher
  /// @{

  /// reads what vertex number `i` of the result is to have.
  void read_vertex(std::size_t i, const std::array<vertex_descriptor, 3>& corners, const std::array<double, 3>& coordinates)
  {
    for (const auto& map : vertex_maps_) map->read(i, corners, coordinates);
  }
  /// reads what face number `i` of the result is to have.
  void read_face(std::size_t i, face_descriptor f)
  {
    for (const auto& map : face_maps_) map->read(i, f);
  }
  /// writes the attributes of vertex number `i`.
  void write_vertex(std::size_t i, vertex_descriptor v)
  {
    for (const auto& map : vertex_maps_) map->write(i, v);
  }
  /// writes the attributes of face number `i`.
  void write_face(std::size_t i, face_descriptor f)
  {
    for (const auto& map : face_maps_) map->write(i, f);
  }
  /// @}

private:
  struct Vertex_carrier_base
  {
    virtual ~Vertex_carrier_base() = default;
    virtual void read(std::size_t i, const std::array<vertex_descriptor, 3>&, const std::array<double, 3>&) = 0;
    virtual void write(std::size_t i, vertex_descriptor v) = 0;
  };
  struct Face_carrier_base
  {
    virtual ~Face_carrier_base() = default;
    virtual void read(std::size_t i, face_descriptor f) = 0;
    virtual void write(std::size_t i, face_descriptor f) = 0;
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

  template <class Map, class Interpolation>
  class Vertex_carrier final : public Vertex_carrier_base
  {
    using Value = typename boost::property_traits<Map>::value_type;

  public:
    Vertex_carrier(Map map, Interpolation interpolation) : map_(map), interpolation_(std::move(interpolation)) {}
    void read(std::size_t i, const std::array<vertex_descriptor, 3>& corners, const std::array<double, 3>& coordinates) override
    {
      if (coordinates[0] == 1) values_.set(i, get(map_, corners[0]));
      else
        values_.set(i, interpolation_(std::array<Value, 3>{get(map_, corners[0]), get(map_, corners[1]), get(map_, corners[2])},
                                      coordinates));
    }
    void write(std::size_t i, vertex_descriptor v) override { put(map_, v, values_.get(i)); }

  private:
    Map map_;
    Interpolation interpolation_;
    Values<Value> values_;
  };

  template <class Map>
  class Face_carrier final : public Face_carrier_base
  {
  public:
    explicit Face_carrier(Map map) : map_(map) {}
    void read(std::size_t i, face_descriptor f) override { values_.set(i, get(map_, f)); }
    void write(std::size_t i, face_descriptor f) override { put(map_, f, values_.get(i)); }

  private:
    Map map_;
    Values<typename boost::property_traits<Map>::value_type> values_;
  };

  std::vector<std::shared_ptr<Vertex_carrier_base>> vertex_maps_;
  std::vector<std::shared_ptr<Face_carrier_base>> face_maps_;
};

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_ATTRIBUTE_TRANSFER_H
