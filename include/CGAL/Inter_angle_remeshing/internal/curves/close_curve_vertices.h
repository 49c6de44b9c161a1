// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_CLOSE_CURVE_VERTICES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_CLOSE_CURVE_VERTICES_H

#include <CGAL/Inter_angle_remeshing/internal/curves/corners.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/curves.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/thin_walls.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

// Merges vertices of curves that are tiny distances apart, before curves are followed. CAD systems export such: two corners where
// one was meant, chamfers and steps as wide as a rounding error. Neither a corner nor a vertex that would have to change its curve
// goes in a run, and the faces between them are needles whatever is done. A vertex within a curve becomes one with another one where their
// curves do, all along. Where these would only touch, and again a tiny way on, as where bores graze each other, slivers would be left.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The two corners of a chamfer turn by 45 degrees each, or by what rounding leaves of that.
constexpr double CHAMFER_COSINE = CORNER_COSINE + 1e-5;

class Close_curve_vertices
{
  using Index = Remeshing_mesh::Index;

  // Where little of the surface moves, as at two corners of a curve and at the rims of a wedge, ends may be so many times as far apart.
  static constexpr double LARGER_TOLERANCE = 3;

public:
  // `is_corner` tells the corners of the curves, those of chamfers, too; `tolerance(v)`, how far the surface may move at a vertex;
  // `stays_apart`, which vertices within curves are not merged.
  template <class Tolerance>
  Close_curve_vertices(Remeshing_mesh& mesh, std::vector<char> is_corner, const Tolerance& tolerance, const std::vector<char>& stays_apart)
    : mesh_(mesh), is_corner_(std::move(is_corner)), stays_apart_(stays_apart), tolerance_(mesh.number_of_vertex_slots(), 0),
      shift_(mesh.number_of_vertex_slots(), 0), became_(mesh.number_of_vertex_slots()), is_zipped_(mesh.number_of_vertex_slots(), 0),
      edges_before_(mesh.number_of_vertex_slots(), 0)
  {
    std::iota(became_.begin(), became_.end(), 0);
    for (Index v = 0; v < Index(mesh.number_of_vertex_slots()); ++v) {
      if (!mesh.is_vertex(v) || !mesh.is_on_curve(v)) continue;
      tolerance_[v] = tolerance(v);
      edges_before_[v] = curve_edges_at(v);
    }
  }

  // Whether there is anything to be merged, perhaps.
  bool are_there() const { return !tiny_edges().empty(); }

  // Merges the closest first, until none is close.
  void merge()
  {
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      for (const auto& [squared_length, h] : tiny_edges())
        if (mesh_.is_face(mesh_.face(h)) && is_tiny(h) && merge_ends(h)) goes_on = true;
    }
  }

  // The vertex that v has become.
  Index became(Index v) const
  {
    while (became_[v] != v) v = became_[v];
    return v;
  }

  // Those that were merged into others, and these, by vertex.
  std::vector<char> are_merged() const
  {
    std::vector<char> result(became_.size(), 0);
    for (Index v = 0; v < Index(became_.size()); ++v)
      if (became_[v] != v) result[v] = result[became(v)] = 1;
    return result;
  }

  // The vertices that were merged, they or what they became a part of within a curve, where curves now touch, and soon again.
  std::vector<Index> touching() const
  {
    std::vector<char> is_touch(is_zipped_.size(), 0);
    for (Index v = 0; v < Index(is_zipped_.size()); ++v)
      if (const Index kept = became(v); is_zipped_[v]) is_touch[kept] = curve_edges_at(kept) > (std::max)(2, edges_before_[kept]);
    std::vector<Index> result;
    for (Index v = 0; v < Index(is_zipped_.size()); ++v)
      if (const Index kept = became(v); is_zipped_[v] && is_touch[kept] && has_close_corner(kept, is_touch)) result.push_back(v);
    return result;
  }

private:
  std::vector<std::pair<double, Index>> tiny_edges() const
  {
    std::vector<std::pair<double, Index>> result;
    mesh_.for_each_edge([&](Index h) { if (is_tiny(h)) result.emplace_back(mesh_.squared_edge_length(h), h); });
    std::sort(result.begin(), result.end());
    return result;
  }

  // Whether the edge is tiny, and joins two corners, or leads from one curve to another; or whether its ends, of which one is on a curve,
  // are the same point but for rounding.
  bool is_tiny(Index h) const
  {
    constexpr double ROUNDING = 1e-4;                // of the tolerance
    const Index a = mesh_.origin(h), b = mesh_.target(h);
    const bool is_a_on_curve = mesh_.is_on_curve(a), is_b_on_curve = mesh_.is_on_curve(b);
    if (!is_a_on_curve && !is_b_on_curve) return false;
    const double tolerance = !is_b_on_curve ? tolerance_[a] : !is_a_on_curve ? tolerance_[b] : (std::min)(tolerance_[a], tolerance_[b]);
    const bool joins_curves = is_a_on_curve && is_b_on_curve &&
                              (mesh_.is_on_curve_edge(h) ? is_corner_[a] && is_corner_[b]
                                                         : (is_corner_[a] && is_corner_[b]) || !(stays_apart_[a] || stays_apart_[b]));
    const auto is_shorter_than = [&](double longest) { return mesh_.squared_edge_length(h) <= longest * longest; };
    return is_shorter_than((joins_curves ? 1 : ROUNDING) * tolerance) ||
           (joins_curves && is_shorter_than(LARGER_TOLERANCE * tolerance) && moves_little(h, sides_across(h)));
  }

  // What the two ends of an edge are the rims of, if the surface looks to opposite sides beside them.
  enum class Sides
  {
    of_neither,
    of_wall,          // a thin plate or a slit, which would become flat
    of_wedge          // as a wing at its trailing edge, or a groove: its sides diverge from the rims on, which are as good as one
  };

  Sides sides_across(Index h) const
  {
    const std::vector<Vector3> normals = normals_beside(h), others = normals_beside(mesh_.opposite(h));
    Sides result = Sides::of_neither;
    for (const Vector3& m : normals)
      for (const Vector3& n : others) {
        if (!look_to_opposite_sides(m, n)) continue;
        if (!do_diverge(h, m, n)) return Sides::of_wall;
        result = Sides::of_wedge;
      }
    return result;
  }

  // For an edge that joins curves.
  bool moves_little(Index h, Sides sides) const { return mesh_.is_on_curve_edge(h) || sides == Sides::of_wedge; }

  // Whether sides with these normals are WIDER times as far from each other as the edge of h is long where they are WAY times the
  // tolerance away from it, a target length by default. What lies between the rims looks away from there.
  bool do_diverge(Index h, const Vector3& m, const Vector3& n) const
  {
    constexpr double WAY = 50, WIDER = 5;
    const Index o = mesh_.opposite(h), a = mesh_.source(h), b = mesh_.source(o);
    const double width = length(mesh_.position(a) - mesh_.position(b)), way = WAY * (std::min)(tolerance_[a], tolerance_[b]);
    const Vector3 away = unit(m) + unit(n);
    const auto is_rim = [&](Index k) {
      if (k < 0) return false;
      const Vector3 &p = mesh_.position(a), &q = mesh_.position(b), &r = mesh_.position(mesh_.apex(k));
      const Vector3 normal = k == h ? triangle_cross(p, q, r) : triangle_cross(q, p, r);
      return !is_degenerate(normal, p, q, r) && way * dot(away, unit(normal)) >= WIDER * width;
    };
    return is_rim(h) || is_rim(o);
  }

  // The cross products of the faces at the source of h, without those at the edge of h and those that look nowhere.
  std::vector<Vector3> normals_beside(Index h) const
  {
    std::vector<Vector3> result;
    const Index a = mesh_.source(h), b = mesh_.source(mesh_.opposite(h));
    mesh_.for_each_around(a, [&](Index k) {
      const Index c = mesh_.target(k), d = mesh_.apex(k);
      if (c == b || d == b) return;
      const Vector3 &p = mesh_.position(a), &q = mesh_.position(c), &r = mesh_.position(d);
      const Vector3 normal = triangle_cross(p, q, r);
      if (!is_degenerate(normal, p, q, r)) result.push_back(normal);
    });
    return result;
  }

  // One of the two ends stays where it is: rather one that may not go, then the corner, then the one on more curves.
  bool merge_ends(Index h)
  {
    Index first = h, second = mesh_.opposite(h);
    if (rank(mesh_.source(first)) > rank(mesh_.source(second))) std::swap(first, second);
    const Sides sides = sides_across(h);
    if (sides == Sides::of_wall) return false;
    const double most = moves_little(h, sides) ? LARGER_TOLERANCE : 1;
    return merge_source(first, most) || merge_source(second, most);
  }

  // Whether one of its curves comes to a corner, or to where curves touch, no farther from v than twice the distance up to which vertices are
  // merged: with five times, curves are kept apart that chords then lead across each other.
  bool has_close_corner(Index v, const std::vector<char>& is_touch) const
  {
    constexpr double CLOSE = 2;
    const double reach = CLOSE * tolerance_[v];
    bool result = false;
    for_each_curve_halfedge(mesh_, v, [&](Index h) {
      walk_along_curve(mesh_, v, mesh_.source(mesh_.opposite(h)), reach, [&](Index, Index u, double way) {
        result = result || (way <= reach && u != v && (is_touch[u] || is_corner_[u]));
        return !result;
      });
    });
    return result;
  }

  int curve_edges_at(Index v) const
  {
    int edges = 0;
    for_each_curve_halfedge(mesh_, v, [&](Index) { ++edges; });
    return edges;
  }

  int rank(Index v) const
  {
    constexpr int CORNER = 1 << 16, LOCKED = 1 << 17;
    return curve_edges_at(v) + (is_corner_[v] ? CORNER : 0) + (mesh_.is_locked(v) ? LOCKED : 0);
  }

  // The vertices that one stands for may be no farther from it than `most` times the tolerance.
  bool merge_source(Index h, double most)
  {
    const Index a = mesh_.source(h), b = mesh_.source(mesh_.opposite(h));
    const double shift = (std::max)(shift_[b], shift_[a] + length(mesh_.position(a) - mesh_.position(b)));
    if (shift > most * tolerance_[b] || !may_go(h) || !turns_no_face(h)) return false;
    if (!is_corner_[a] || !is_corner_[b]) is_zipped_[a] = is_zipped_[b] = 1;
    shift_[b] = shift;
    became_[a] = b;
    is_corner_[b] = is_corner_[b] || is_corner_[a];
    mesh_.add_marks(b, mesh_.marks(a) & Remeshing_mesh::ON_FEATURE);
    const std::vector<Index> tips = tips_of_detours(h);
    mesh_.collapse(h);
    for (const Index c : tips) drop_spur(c);
    forget_features(b);
    return true;
  }

  // Apexes of the faces at the edge of h that a curve leads to from one end of the edge, and back to the other one, a tiny way: when the
  // ends are one, a spur would be left of that, with two corners.
  std::vector<Index> tips_of_detours(Index h) const
  {
    std::vector<Index> result;
    const Index a = mesh_.source(h), b = mesh_.source(mesh_.opposite(h));
    for (const Index k : {h, mesh_.opposite(h)}) {
      if (k < 0) continue;
      const Index c = mesh_.apex(k);
      int edges = 0, edges_beside = 0;
      for_each_curve_halfedge(mesh_, c, [&](Index g) {
        ++edges;
        edges_beside += g >= 0 && (mesh_.target(g) == a || mesh_.target(g) == b);
      });
      if (edges == 2 && edges_beside == 2 && !mesh_.is_border_vertex(c) &&
          squared_distance(mesh_.position(b), mesh_.position(c)) <= tolerance_[c] * tolerance_[c])
        result.push_back(c);
    }
    return result;
  }

  // The one feature edge that ends at c is none.
  void drop_spur(Index c)
  {
    Index spur = -1;
    for_each_curve_halfedge(mesh_, c, [&](Index h) { spur = h; });
    if (spur < 0) return;
    const Index b = mesh_.target(spur);
    mesh_.remove_flags(spur, Remeshing_mesh::CONSTRAINED | Remeshing_mesh::FOUND | Remeshing_mesh::PASSING);
    forget_features(b);
    forget_features(c);
  }

  // Vertex v may have lost the last feature that it was on.
  void forget_features(Index v)
  {
    bool is_on_feature = false;
    for_each_curve_halfedge(mesh_, v, [&](Index h) { is_on_feature = is_on_feature || (h >= 0 && mesh_.is_constrained(h)); });
    if (!is_on_feature) mesh_.remove_marks(v, Remeshing_mesh::ON_FEATURE);
  }

  bool may_go(Index h) const
  {
    constexpr unsigned STAYS =
      Remeshing_mesh::LOCKED | Remeshing_mesh::PINNED | Remeshing_mesh::PINCHED | Remeshing_mesh::NEXT_TO_OUTSIDE;
    const Index a = mesh_.source(h);
    if ((mesh_.marks(a) & STAYS) != 0) return false;
    if (mesh_.is_border_vertex(a) && !mesh_.is_border(h >= 0 ? h : mesh_.opposite(h))) return false;
    return mesh_.keeps_topology(h);
  }

  // Whether every face that moves with the source of h still looks to the side that it did. One without an area looks nowhere.
  bool turns_no_face(Index h) const
  {
    const Vector3 &p = mesh_.position(mesh_.source(h)), &q = mesh_.position(mesh_.source(mesh_.opposite(h)));
    return mesh_.all_faces_of_collapse(h, [&](Index c, Index d) {
      const Vector3 &r = mesh_.position(c), &s = mesh_.position(d);
      const Vector3 before = triangle_cross(p, r, s);
      return dot(before, triangle_cross(q, r, s)) > 0 || is_degenerate(before, p, r, s);
    });
  }

  Remeshing_mesh& mesh_;
  std::vector<char> is_corner_;
  const std::vector<char>& stays_apart_; // by vertex
  std::vector<double> tolerance_;        // by vertex
  std::vector<double> shift_;            // by vertex: how far from it the farthest was that it stands for
  std::vector<Index> became_;            // by vertex: the one that it was merged into, or itself
  std::vector<char> is_zipped_;          // by vertex: whether it was merged, it or the other one within a curve
  std::vector<int> edges_before_;        // of curves, by vertex
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_CURVES_CLOSE_CURVE_VERTICES_H
