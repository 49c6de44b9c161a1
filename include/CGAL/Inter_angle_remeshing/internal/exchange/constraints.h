// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_CONSTRAINTS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_CONSTRAINTS_H

#include <CGAL/Inter_angle_remeshing/internal/curves/curves.h>
#include <CGAL/Inter_angle_remeshing/internal/exchange/mesh_exchange.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/cross_products.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <type_traits>
#include <vector>

// Carries the user's marks over to the flat mesh, and back.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// Stands for a property map that the user did not hand over.
struct No_map {};

struct Constraint_settings
{
  double sharpness_cosine;    // edges with a smaller dihedral cosine are features; under -1: none
  bool protect;
  bool slides;                // whether input vertices on the border and on features move along these
  bool finds_features;        // whether sharp edges are found by themselves
};

// Whether the dihedral angle at h is larger than the bound; faces no higher than `altitude` look as those beyond them.
inline bool is_sharp(const Remeshing_mesh& mesh, Remeshing_mesh::Index h, double cosine, double altitude = 0)
{
  if (cosine < -1 || mesh.is_border(h)) return false;
  const Vector3 m = cross_product_of_surface(mesh, mesh.face(h), altitude),
                n = cross_product_of_surface(mesh, mesh.face(mesh.opposite(h)), altitude);
  const double product = squared_length(m) * squared_length(n);
  return product > 0 && dot(m, n) < cosine * std::sqrt(product);
}

inline void mark_ends(Remeshing_mesh& mesh, Remeshing_mesh::Index h, unsigned marks)
{
  mesh.add_marks(mesh.origin(h), marks);
  mesh.add_marks(mesh.target(h), marks);
}

inline void mark_feature(Remeshing_mesh& mesh, Remeshing_mesh::Index h)
{
  mesh.add_flags(h, Remeshing_mesh::CONSTRAINED);
  mark_ends(mesh, h, Remeshing_mesh::ON_FEATURE);
}

// As one that the user marked, but for what only the user may ask for: protection, and that it stays straight.
inline void mark_found_feature(Remeshing_mesh& mesh, Remeshing_mesh::Index h, const Constraint_settings& settings)
{
  if (!mesh.is_constrained(h)) mesh.add_flags(h, Remeshing_mesh::FOUND);
  mark_feature(mesh, h);
  if (!settings.slides) mark_ends(mesh, h, Remeshing_mesh::PINNED);
}

template <class Exchange, class EdgeIsConstrainedMap, class VertexIsConstrainedMap, class PatchMap, class TriangleMesh>
void mark_constraints(Exchange& exchange, const TriangleMesh& tmesh, const EdgeIsConstrainedMap& ecm,
                      const VertexIsConstrainedMap& vcm, const PatchMap& fpm, const Constraint_settings& settings)
{
  using Index = Remeshing_mesh::Index;
  Remeshing_mesh& mesh = exchange.mesh();
  const double altitude = altitude_by_rounding(mesh);
  exchange.for_each_edge([&](Index h, auto user) {
    bool is_constrained = is_sharp(mesh, h, settings.sharpness_cosine, altitude);
    if constexpr (!std::is_same<EdgeIsConstrainedMap, No_map>::value)
      is_constrained = is_constrained || get(ecm, edge(user, tmesh));
    if constexpr (!std::is_same<PatchMap, No_map>::value) {
      const auto across = face(opposite(user, tmesh), tmesh);
      const bool is_seam = !is_constrained && across != boost::graph_traits<TriangleMesh>::null_face() &&
                           !(get(fpm, face(user, tmesh)) == get(fpm, across));
      if (is_seam) mesh.add_flags(h, Remeshing_mesh::SEAM);
      is_constrained = is_constrained || is_seam;
    }
    if (is_constrained) mark_feature(mesh, h);
    if ((is_constrained || mesh.is_border(h)) && !settings.slides) mark_ends(mesh, h, Remeshing_mesh::PINNED);
    if (settings.protect && (is_constrained || mesh.is_border(h))) mesh.add_flags(h, Remeshing_mesh::PROTECTED);
  });
  if constexpr (!std::is_same<VertexIsConstrainedMap, No_map>::value)
    for (Index v = 0; v < Index(mesh.number_of_vertex_slots()); ++v)
      if (get(vcm, exchange.input_vertices()[v])) mesh.add_marks(v, Remeshing_mesh::LOCKED);
}

// Boost's tag of maps that return references says that they can be written, of references to what is const, too.
template <class Map>
constexpr bool is_writable()
{
  using Traits = boost::property_traits<Map>;
  using Category = typename Traits::category;
  constexpr bool refers_to_const = std::is_convertible<Category, boost::lvalue_property_map_tag>::value &&
                                   std::is_const<std::remove_reference_t<typename Traits::reference>>::value;
  return std::is_convertible<Category, boost::writable_property_map_tag>::value && !refers_to_const;
}

// No edge that is about to be removed stays constrained: its descriptor may name another one some day. Those that were are noted in
// `forgotten`. Maps are taken by value here and below, as put() may change them.
template <class EdgeIsConstrainedMap, class Edge>
void forget_constraint(EdgeIsConstrainedMap ecm, const Edge& edge, std::vector<Edge>& forgotten)
{
  (void)ecm; (void)edge; (void)forgotten;
  if constexpr (!std::is_same<EdgeIsConstrainedMap, No_map>::value)
    if constexpr (is_writable<EdgeIsConstrainedMap>()) {
      if (get(ecm, edge)) forgotten.push_back(edge);
      put(ecm, edge, false);
    }
}

// The mesh stays as it was, and so do these edges, as far as their map lets them.
template <class EdgeIsConstrainedMap, class Edge>
void remember_constraints(EdgeIsConstrainedMap ecm, const std::vector<Edge>& forgotten)
{
  (void)ecm; (void)forgotten;
  if constexpr (!std::is_same<EdgeIsConstrainedMap, No_map>::value)
    if constexpr (is_writable<EdgeIsConstrainedMap>())
      for (const Edge& edge : forgotten)
        try { put(ecm, edge, true); } catch (...) {}      // of two exceptions, the one that is under way counts
}

// Makes the user's maps right for every edge and face of the result. `patches` are the patches of the input faces.
template <class Exchange, class EdgeIsConstrainedMap, class PatchMap, class Patches, class TriangleMesh>
void write_constraints(const Exchange& exchange, const Remeshing_mesh& mesh, const TriangleMesh& tmesh,
                       EdgeIsConstrainedMap ecm, PatchMap fpm, const Patches& patches)
{
  using Index = Remeshing_mesh::Index;
  (void)tmesh; (void)ecm; (void)fpm; (void)patches;
  if constexpr (!std::is_same<EdgeIsConstrainedMap, No_map>::value)
    if constexpr (is_writable<EdgeIsConstrainedMap>())
    {
      mesh.for_each_edge([&](Index h) { put(ecm, edge(exchange.written_halfedge(h), tmesh), mesh.is_constrained(h)); });
      for (const auto& h : exchange.outside_faces().new_edges()) put(ecm, edge(h, tmesh), false);
    }
  if constexpr (!std::is_same<PatchMap, No_map>::value)
    if constexpr (is_writable<PatchMap>())
    {
      for (Index f = 0; f < Index(mesh.number_of_live_faces()); ++f)
        put(fpm, exchange.written_face(f), patches[mesh.face_record(f).source]);
      exchange.outside_faces().for_each_new_face([&](auto old_face, auto new_face) { put(fpm, new_face, get(fpm, old_face)); });
    }
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_EXCHANGE_CONSTRAINTS_H
