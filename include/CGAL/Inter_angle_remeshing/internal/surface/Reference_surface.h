// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_REFERENCE_SURFACE_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_REFERENCE_SURFACE_H

#include <CGAL/Inter_angle_remeshing/internal/compatibility.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Remeshing_mesh.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/surface_walk.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The surface that the result approximates: a const, flat copy of the input. Queries run concurrently.
class Reference_surface
  : public Corner_table
{
public:
  // A copy of a mesh that has no free slots.
  explicit Reference_surface(const Remeshing_mesh& mesh)
    : Corner_table(mesh), position_(mesh.positions()), unit_(mesh.unit())
  {
    for (Index v = 0; v < Index(position_.size()); ++v)
      if (mesh.is_pinched(v)) pinched_.push_back(v);
  }

  // The user's length that is 1 here.
  double unit() const { return unit_; }
  std::size_t number_of_faces() const { return number_of_face_slots(); }
  std::size_t number_of_vertices() const { return position_.size(); }
  const Vector3& position(Index v) const { return position_[v]; }
  bool is_pinched(Index v) const { return std::binary_search(pinched_.begin(), pinched_.end(), v); }

  // Twice the area times the unit normal of face f.
  Vector3 cross_product(Index f) const
  {
    const Face& t = face_record(f);
    return triangle_cross(position_[t.vertex[0]], position_[t.vertex[1]], position_[t.vertex[2]]);
  }

  // Whether face f has no normal, up to rounding.
  bool is_degenerate(Index f) const
  {
    const Face& t = face_record(f);
    return internal::is_degenerate(cross_product(f), position_[t.vertex[0]], position_[t.vertex[1]], position_[t.vertex[2]]);
  }

  // The altitude of face f over its longest edge.
  double least_altitude(Index f) const
  {
    const Face& t = face_record(f);
    const Vector3 &a = position_[t.vertex[0]], &b = position_[t.vertex[1]], &c = position_[t.vertex[2]];
    const double longest = (std::max)({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
    return longest > 0 ? length(triangle_cross(a, b, c)) / std::sqrt(longest) : 0.;
  }

  // Walks from face f over the surface to the closest point; f becomes the face it ends on.
  Point_on_triangle closest_point_near(const Vector3& q, Index& f) const { return walk_to_closest_point(*this, q, f); }
  Vector3 walk(const Vector3& q, Index& f) const { return closest_point_near(q, f).point; }

  // The closest point where nothing is known about q. Where `normal` is not zero, the closest point whose face
  // looks the same way (the angle between the normals is under 90 degrees) wins over the closest one of all,
  // if there is one not further than twice as far away plus an edge length.
  Vector3 locate(const Vector3& q, Index& f, const Vector3& normal = Vector3()) const;
  // The same by looking at every face: for a few queries that is cheaper than to build a search structure.
  Vector3 locate_by_scan(const Vector3& q, Index& f, const Vector3& normal) const;

private:
  using Kernel = CGAL::Simple_cartesian<double>;

  // A face of the surface, as AABB_tree wants it.
  class Face_primitive
  {
  public:
    using Id = Index;
    using Point = Kernel::Point_3;
    using Datum = Kernel::Triangle_3;
    using Datum_reference = Kernel::Triangle_3;
    using Shared_data = const Reference_surface*;

    Face_primitive() = default;
    Face_primitive(std::vector<Index>::const_iterator f, Shared_data) : id_(*f) {}
    static Shared_data construct_shared_data(Shared_data surface) { return surface; }

    Id id() const { return id_; }
    Datum_reference datum(Shared_data surface) const
    {
      const Face& t = surface->face_record(id_);
      return Datum(surface->point(t.vertex[0]), surface->point(t.vertex[1]), surface->point(t.vertex[2]));
    }
    Point reference_point(Shared_data surface) const { return surface->point(surface->face_record(id_).vertex[0]); }

  private:
    Id id_ = -1;
  };

  using Tree = CGAL::AABB_tree<AABB_traits<Kernel, Face_primitive>>;

  // Of the faces that look to the side of a normal, the one that is closest to q and less than a radius away.
  class Closest_compatible
  {
  public:
    Closest_compatible(const Reference_surface& surface, const Vector3& q, const Vector3& normal, double radius)
      : surface_(surface), q_(q), normal_(normal), least_(radius * radius)
    {}

    bool go_further() const { return incompatible_ < MOST_INCOMPATIBLE; }
    void intersection(const Kernel::Point_3&, const Face_primitive& face)
    {
      const Index f = face.id();
      if (!(dot(surface_.cross_product(f), normal_) > 0)) { ++incompatible_; return; }
      const Vector3 p = closest_point_on_face(surface_, q_, f).point;
      const double d = squared_distance(q_, p);
      if (d > least_ || (d == least_ && (face_ < 0 || f > face_))) return;
      least_ = d;
      face_ = f;
      point_ = p;
    }
    template <class Node>
    bool do_intersect(const Kernel::Point_3&, const Node& node) const
    {
      const CGAL::Bbox_3 box = node.bbox();
      const auto outside = [](double x, double low, double high) { return (std::max)({low - x, x - high, 0.}); };
      return squared_length(Vector3{outside(q_.x, box.xmin(), box.xmax()), outside(q_.y, box.ymin(), box.ymax()),
                                    outside(q_.z, box.zmin(), box.zmax())}) <= least_;
    }

    Index face() const { return face_; }         // negative: none
    const Vector3& point() const { return point_; }

  private:
    // A surface that is far away, and looks elsewhere all over, is given up.
    static constexpr int MOST_INCOMPATIBLE = 4096;

    const Reference_surface& surface_;
    Vector3 q_, normal_, point_;
    double least_;
    Index face_ = -1;
    int incompatible_ = 0;               // faces that were looked at in vain
  };

  // How far away from q a face may be that looks the right way and wins over f, on which the closest point lies.
  double compatible_radius(const Vector3& q, const Vector3& closest, Index f) const
  {
    return 2 * std::sqrt(squared_distance(q, closest)) + std::sqrt(std::sqrt(squared_length(cross_product(f))));
  }
  Kernel::Point_3 point(Index v) const { return {position_[v].x, position_[v].y, position_[v].z}; }
  const Tree& tree() const;

  std::vector<Vector3> position_;
  std::vector<Index> pinched_;           // vertices that are one of several fans of the user's, sorted
  double unit_;
  // Built by the first query that needs it: warm starts, which are all but a few, do without.
  mutable std::once_flag tree_is_built_;
  mutable std::unique_ptr<Tree> tree_;
};

// The surface's faces by the input faces that they are; negative for those of the input that it does not have.
inline std::vector<Remeshing_mesh::Index> faces_by_source(const Reference_surface& surface)
{
  std::vector<Remeshing_mesh::Index> result;
  for (Remeshing_mesh::Index f = 0; f < Remeshing_mesh::Index(surface.number_of_faces()); ++f) {
    const std::size_t source = std::size_t(surface.face_record(f).source);
    if (source >= result.size()) result.resize((std::max)(source + 1, surface.number_of_faces()), -1);
    result[source] = f;
  }
  return result;
}

inline const Reference_surface::Tree& Reference_surface::tree() const
{
  std::call_once(tree_is_built_, [this]() {
    std::vector<Index> ids;
    ids.reserve(number_of_faces());
    for (Index f = 0; f < Index(number_of_faces()); ++f)
      if (squared_length(cross_product(f)) > 0) ids.push_back(f);
    auto tree = std::make_unique<Tree>();
    tree->insert(ids.cbegin(), ids.cend(), this);
    tree->build();
    if (!tree->empty()) tree->accelerate_distance_queries();
    tree_ = std::move(tree);
  });
  return *tree_;
}

inline Vector3 Reference_surface::locate_by_scan(const Vector3& q, Index& f, const Vector3& normal) const
{
  struct Best { Vector3 point; Index face = 0; double distance = (std::numeric_limits<double>::infinity)(); };
  Best closest, compatible;
  for (Index g = 0; g < Index(number_of_faces()); ++g) {
    const Vector3 c = cross_product(g);
    if (!(squared_length(c) > 0)) continue;
    const Vector3 p = closest_point_on_face(*this, q, g).point;
    const double d = squared_distance(q, p);
    if (d < closest.distance) closest = {p, g, d};
    if (d < compatible.distance && dot(c, normal) > 0) compatible = {p, g, d};
  }
  if (closest.distance == (std::numeric_limits<double>::infinity)()) return locate(q, f, normal);
  const double radius = compatible_radius(q, closest.point, closest.face);
  const bool is_compatible_near = normal != Vector3() && compatible.distance < radius * radius;
  const Best& best = is_compatible_near ? compatible : closest;
  f = best.face;
  return best.point;
}

inline Vector3 Reference_surface::locate(const Vector3& q, Index& f, const Vector3& normal) const
{
  if (tree().empty()) { // nothing but degenerate faces
    f = 0;
    return walk(q, f);
  }
  const Kernel::Point_3 query(q.x, q.y, q.z);
  f = tree().closest_point_and_primitive(query).second;
  const Vector3 closest = closest_point_on_face(*this, q, f).point;
  if (normal == Vector3() || dot(cross_product(f), normal) > 0) return closest;

  Closest_compatible compatible(*this, q, normal, compatible_radius(q, closest, f));
  tree().traversal(query, compatible);
  if (compatible.face() < 0) return closest;
  f = compatible.face();
  return compatible.point();
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_REFERENCE_SURFACE_H
